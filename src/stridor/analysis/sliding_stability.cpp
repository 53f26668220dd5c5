#include "stridor/analysis/sliding_stability.hpp"

namespace stridor::analysis {

namespace {

constexpr double two_pi = 6.283185307179586476925;
// an undamped mode's real part comes out as rounding: growth below this share of the largest eigenvalue is none
constexpr double rounding = 1e-9;

bool slower(const Mode& a, const Mode& b) {
    return a.frequency != b.frequency ? a.frequency < b.frequency : a.growth < b.growth;
}

}  // namespace

SlidingStability classify_modes(const std::vector<std::complex<double>>& eigenvalues, double normal_force) {
    SlidingStability result;
    result.normal_force = normal_force;
    for (const std::complex<double>& value : eigenvalues)
        if (value.imag() >= 0.0) result.modes.push_back({value.real(), value.imag() / two_pi});
    std::sort(result.modes.begin(), result.modes.end(), slower);
    const auto fastest = std::max_element(result.modes.begin(), result.modes.end(),
                                          [](const Mode& a, const Mode& b) { return a.growth < b.growth; });
    if (fastest == result.modes.end()) return result;
    result.growth = fastest->growth;
    result.frequency = fastest->frequency;
    double largest = 0.0;
    for (const std::complex<double>& value : eigenvalues)
        largest = std::max(largest, std::abs(value));
    if (!(normal_force > 0.0))
        result.kind = StabilityKind::locked;
    else if (fastest->growth > rounding * largest)
        result.kind = fastest->frequency > 0.0 ? StabilityKind::flutter : StabilityKind::divergence;
    return result;
}

}  // namespace stridor::analysis
