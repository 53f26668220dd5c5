#pragma once

#include <cstddef>

namespace stridor::base {

/// Returns the whole part of a value, from 0 to `most`, and 0 for what is no number.
///
/// Indices and lengths that are computed from samples or from what a user typed go through here: the conversion of a
/// double beyond the whole numbers, or of NaN, has no meaning in C++.
constexpr std::size_t whole_below(double value, std::size_t most) {
    if (!(value > 0.0)) return 0;
    return value < static_cast<double>(most) ? static_cast<std::size_t>(value) : most;
}

/// Returns the whole number nearest to a value, half a step upwards; from 0 to `most`, and 0 for what is no number.
constexpr std::size_t whole_near(double value, std::size_t most) {
    return whole_below(value + 0.5, most);
}

}  // namespace stridor::base
