#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string_view>
#include <vector>

namespace stridor::signal {

/// Window functions and their uses: rectangular for transients that lie wholly inside; hann for everything else;
/// blackman_harris for weak lines beside strong ones (side lobes -92 dB); flat_top for the height of a line (error 0.01
/// dB).
enum class Window { rectangular, hann, blackman_harris, flat_top };

inline constexpr std::array<std::string_view, 4> window_names{"rectangular", "hann", "blackman-harris", "flat-top"};

/// Returns a window of `size` samples, periodic (its next sample would be its first) as transforms need it: sums of
/// cosines, w[n] = Σ (-1)^j a_j cos(2π j n / size). Source: Harris (1978); flat top: ISO 18431-2.
std::vector<double> window(Window kind, std::size_t size);

/// Windows of one kind, each made once: the many stretches of a long recording have few different sizes.
class Windows {
public:
    /// Begins without windows.
    explicit Windows(Window kind) : kind_(kind) {}

    /// Returns the window of `size` samples, valid until the next call.
    const std::vector<double>& of(std::size_t size);

private:
    Window kind_;
    std::map<std::size_t, std::vector<double>> made_{};
};

/// Returns the width of the band [bins] that passes as much white noise as the window: N Σw² / (Σw)²; hann: 1.5.
double noise_bandwidth(const std::vector<double>& window);

}  // namespace stridor::signal
