#pragma once

#include "stridor/verification/check.hpp"

#include <array>
#include <vector>

namespace stridor::verification {

/// Stick-slip of Table 1's squeak on a plate that moves with -0.1257 m/s, started stuck: a periodic motion, whose exact
/// piecewise linear solution converged to all digits that stand here (docs/methods/physics.md).
struct StickSlip {
    double preload = 0.0;         // [N]
    double stick_fraction = 0.0;  // [1] between 1 s and 2 s, no whole number of periods
    double period = 0.0;          // [s]
};

inline constexpr std::array<StickSlip, 3> stick_slips{{
    {200.0, .247471, 1.0374406e-3},
    {1000.0, .749445, 2.4849233e-3},
    {2000.0, .880442, 5.2618757e-3},
}};

/// Shares and periods of the exact engine.
std::vector<Check> constant_drive_checks();

}  // namespace stridor::verification
