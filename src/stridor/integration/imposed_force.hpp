#pragma once

#include "stridor/parameters/drive.hpp"

namespace stridor::integration {

/// The force of a drive by force at time t [s], in N: F cos(2 pi f t), which grows by half a cosine over the ramp from
/// the start on, so that nothing jumps. 0 of any other drive.
double imposed_force(const parameters::Drive& drive, double time);

}  // namespace stridor::integration
