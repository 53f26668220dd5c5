#pragma once

#include "stridor/parameters/case.hpp"

namespace stridor::integration {

/// What a run costs and the limits it must keep, known before it starts.
struct Cost {
    double steps = 0.0;       // [1] number of time steps, of all runs; exact: of whole steps if nothing happened
    double seconds = 0.0;     // [s] of one core
    double step_limit = 0.0;  // [s] largest stable time step; exact: infinite
};

/// Returns the cost of a case, from the fastest natural frequency of its system while separated. Its time is measured
/// within a factor of three of the ready cases, run to their end, and of strings and chains of 2 to 41 rows with and
/// without springs. It is less where a proof ends the run, and more where springs push much more than the stiffness
/// beside them. The case must have no `parameters::findings`.
Cost cost(const parameters::Case& c);

}  // namespace stridor::integration
