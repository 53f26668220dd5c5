#pragma once

#include "stridor/parameters/fields/field.hpp"

#include <limits>

/// What values fields may have, and which ones are usual. Private to this folder.
namespace stridor::parameters {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr Range any{};
inline constexpr Range not_zero{.zero = Range::Zero::excluded};
inline constexpr Range positive{0.0, infinity, Range::Low::open};
inline constexpr Range not_negative{0.0, infinity, Range::Low::closed};
inline constexpr Range share{0.0, 1.0, Range::Low::closed};
// from absolute zero to where no rubber or plastic is left
inline constexpr Range temperatures{-273.15, 2000.0, Range::Low::closed};
// a bow at the far end would move nothing
inline constexpr double most_position = 0.999;
inline constexpr Range before_the_end{0.0, 0.99, Range::Low::closed};

constexpr UsualRange between(double from, double to) {
    return {from, to, Scale::linear};
}
constexpr UsualRange octaves(double from, double to) {
    return {from, to, Scale::logarithmic};
}

// ten times less and more than Table 1, but for damping: its 1 N*s/m is a thousandth of critical, a rubber has a tenth
inline constexpr UsualRange usual_damping = octaves(0.1, 300.0);
// any mu_d up to what dry rubber on glass reaches; mu_s lies above it
inline constexpr UsualRange usual_kinetic_friction = between(0.0, 1.0);
inline constexpr UsualRange usual_static_friction = between(0.0, 1.2);
// the abscissa of Figure 8 and the axes of Figure 6
inline constexpr UsualRange usual_preload = octaves(2.0, 4000.0);
inline constexpr UsualRange usual_velocity = octaves(0.01, 1.0);
// Figure 6 has 70 and 150 deg; flatter than 20 deg the joint lies on the plate
inline constexpr UsualRange usual_angle = between(20.0, 160.0);
// a window of 1 s holds the one and a half periods that are needed from 1.5 Hz on
inline constexpr UsualRange usual_frequency = octaves(2.0, 50.0);

}  // namespace stridor::parameters
