#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace stridor::noise_library {

/// The value of a quantity that was never written down.
inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// A number that describes a sound: "level", 62.4, "dB".
struct Figure {
    std::string name;    // [a-z0-9_], unique within its entry
    std::string unit;    // "1" when dimensionless
    double value = 0.0;  // [unit]
    bool operator==(const Figure&) const = default;
};

/// The figures from which `sensitivity` tells how a noise changes, if an entry has them.
inline constexpr const char* level_figure = "level";
inline constexpr const char* frequency_figure = "dominant_frequency";

/// One noise of the library. Text that is empty and quantities that are `unknown` were never written down.
///
/// The meaning of each member, its name for users and its unit stand in `fields()`.
struct Entry {
    std::int64_t id = 0;  // [1] given by the library, never used twice; 0 outside of one

    std::string system{};
    std::string parts{};
    std::string materials{};
    std::string operation{};
    std::string recorded{};
    std::string denomination{};

    double preload = unknown;   // [N]
    double velocity = unknown;  // [m/s]
    std::string velocity_profile{};
    double temperature = unknown;  // [degC]
    double humidity = unknown;     // [%]

    std::string sensor{};
    std::string calibration{};
    std::string date{};  // YYYY-MM-DD
    std::string author{};
    std::string licence{};
    std::string notes{};
    std::string case_text{};  // TOML

    std::string file{};         // name before it came into the library
    std::string format{};       // extension, "wav"
    double duration = unknown;  // [s]
    double rate = unknown;      // [Hz]
    double channels = unknown;  // [1]
    std::string audio{};        // SHA-256 of the file's bytes

    std::string category{};         // of Stridor's verdict
    std::string verdict{};          // JSON
    std::vector<Figure> figures{};  // sorted by name
};

}  // namespace stridor::noise_library
