#pragma once

#include "stridor/model/structure.hpp"
#include "stridor/record/tally.hpp"

#include <vector>

namespace stridor::integration {

/// The run under a constant drive that left a record behind.
struct SteadyRun {
    double surface_velocity = 0.0;  // [m/s] V
    double end = 0.0;               // [s] of the run
    double least_slip = 1.0;        // [1] share of the judged time: who slips less is not asked about
};

/// Says of contacts that slide whether their sliding grows, in the outlook of each, the same for all engines.
///
/// A run ends long before a small growth shows: all of it may be sliding, and no sliding lasts. So the motion near the
/// states in which the contacts spent most of the judged time (`model::SlidingMotion`) is asked for eigenvalues that
/// grow. Contacts that are proven to slide or stick for ever stay so. Nothing is said of friction in a plane, of states
/// that leave a motion without inertia, and where no contact slips so much. Costs as `analysis::sliding_stability`.
void tell_growth(const model::Structure& structure, const SteadyRun& run, std::vector<record::Tally>& phases);

}  // namespace stridor::integration
