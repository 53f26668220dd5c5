#pragma once

#include <string>
#include <vector>

namespace stridor::signal {

/// The unit of samples that nobody has calibrated: 1 is the largest magnitude their file can hold.
inline constexpr const char* full_scale = "FS";

/// One channel of sampled data, uniform in time: a recorded sound, a measured force, a simulated velocity.
struct Signal {
    double rate = 0.0;              // [Hz] samples per second
    std::string unit = full_scale;  // of the samples: "Pa", "m/s^2", "m/s", "N", or "FS"
    std::vector<double> samples{};  // [unit] shape [frame]
};

/// The time a signal lasts [s].
inline double duration(const Signal& signal) {
    return static_cast<double>(signal.samples.size()) / signal.rate;
}

}  // namespace stridor::signal
