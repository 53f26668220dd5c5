#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace stridor::model {

/// The two ways in which a closed contact slips.
enum class Slip {
    forward,   // w > 0: the rubbed mass is ahead of the surface, T <= 0
    backward,  // w < 0: it lags behind, T >= 0; steady sliding over a surface that moves going
};

inline constexpr std::array<Slip, 2> slips{Slip::forward, Slip::backward};
inline constexpr std::array<std::string_view, 2> slip_names{"forward", "backward"};

/// The way's place in arrays of shape [slip].
constexpr std::size_t index_of(Slip way) {
    return static_cast<std::size_t>(way);
}

/// The way a slip velocity [m/s] other than zero has.
constexpr Slip slip_of(double slip_velocity) {
    return slip_velocity > 0.0 ? Slip::forward : Slip::backward;
}

/// The way in which a stuck contact gives in to the friction force [N] that holds it: against it.
constexpr Slip slip_against(double friction_force) {
    return friction_force > 0.0 ? Slip::backward : Slip::forward;
}

}  // namespace stridor::model
