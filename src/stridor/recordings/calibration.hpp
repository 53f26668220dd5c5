#pragma once

#include "stridor/signal/source.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::recordings {

/// The quantity that the number 1 of a file stands for. In a file of whole numbers, 1 is the largest magnitude they can
/// hold.
///
/// Until somebody calibrates it, it is 1 "FS", and no figure from it may be called a pressure.
struct FullScale {
    double value = 1.0;                     // [unit]
    std::string unit = signal::full_scale;  // in SI: "Pa", "m/s^2", "m/s", "N", "V", ...
    bool operator==(const FullScale&) const = default;
};

/// Reads a full scale: "2 Pa", "50 m/s^2", "10 g" (of gravity), "300 mN", "1 FS".
///
/// Throws `Error` (input) for a missing or unknown unit, and for a number that is not positive.
FullScale parse_full_scale(std::string_view text);

/// Returns a unit of laboratories in SI: "mm/s" is 0.001 m/s, "g" 9.80665 m/s^2 (a signal is not a mass), "m/sec2" 1
/// m/s^2, "Newtons" 1 N, "msec" 0.001 s. This is the only table of spellings, also for times.
///
/// An empty text and "-" are "FS", as is "FS"; an unknown word stays as it is, with the factor 1.
FullScale unit_of_label(std::string_view label);

/// Returns the unit of a label in Stridor's own letters: "m/sec2" is m/s^2. An unknown unit stays as it is.
std::string unit_as_written(std::string_view label);

/// Says whether Stridor can convert this unit.
bool is_known_unit(std::string_view label);

/// Returns the calibration in the text of a recording (a WAV's bext description, a comment), or `std::nullopt`.
///
/// It understands "full scale = 2 Pa" and "0dBFS = 109.7 dBSPL" (also "-20 dBFS = 94 dB SPL"). 0 dBFS is the level of a
/// sine whose peaks reach full scale (AES17), so the number 1 is sqrt(2) * 20 uPa * 10^(x/20). The first kind has
/// priority, since it is exact. `std::nullopt` if neither is found or the numbers make no sense.
std::optional<FullScale> calibration_in(std::string_view description);

/// Returns the full scales in the calibration of a noise library's entry, of all channels or of each ("full scale = 2
/// Pa; full scale = 50 N"), else the one of `calibration_in`; empty if there is neither.
std::vector<FullScale> full_scales_in(const std::string& calibration);

/// Returns `parse_full_scale` of each text.
std::vector<FullScale> parse_full_scales(std::span<const std::string> texts);

/// Returns the text that `calibration_in` reads, for a WAV's description; empty for "FS".
std::string calibration_text(const FullScale& full_scale);

}  // namespace stridor::recordings
