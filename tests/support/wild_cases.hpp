#pragma once

#include "stridor/parameters/case.hpp"

#include <cstdint>

namespace stridor::support {

/// A case far from any sensible one: masses, stiffness, damping, preload and velocity over many decades, every
/// angle, friction, drive, start and impact law, with a taste for the values at which something vanishes. Case k is
/// the same in every run.
///
/// It lasts at most twenty of its slowest vibrations and at most some thousand of its fastest time scale.
parameters::Case wild_case(std::uint64_t number);

/// A bound of the fastest rate of the case's motion [1/s]: vibration, damping or drive.
double fastest_rate(const parameters::Case& c);

}  // namespace stridor::support
