#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string_view>
#include <vector>

namespace stridor::signal {

/// Window functions. What each is good for: rectangular, transients that lie wholly inside; hann, everything else;
/// blackman_harris, weak lines beside strong ones (side lobes -92 dB); flat_top, the height of a line (error 0.01 dB).
enum class Window { rectangular, hann, blackman_harris, flat_top };

inline constexpr std::array<std::string_view, 4> window_names{"rectangular", "hann", "blackman-harris", "flat-top"};

/// A window of `size` samples, periodic (its next sample would be its first), as transforms want it: sums of cosines,
/// w[n] = Σ (-1)^j a_j cos(2π j n / size). Source: Harris (1978); flat top: ISO 18431-2.
std::vector<double> window(Window kind, std::size_t size);

/// Windows of one kind, each made once: the many stretches of a long recording have few sizes.
class Windows {
public:
    /// None is made yet.
    explicit Windows(Window kind) : kind_(kind) {}

    /// Stays good until the next call.
    const std::vector<double>& of(std::size_t size);

private:
    Window kind_;
    std::map<std::size_t, std::vector<double>> made_{};
};

/// Width of the band whose white noise passes as much as through the window [bins]: N Σw² / (Σw)²; hann: 1.5.
double noise_bandwidth(const std::vector<double>& window);

}  // namespace stridor::signal
