#pragma once

#include "stridor/integration/run/initial_state.hpp"
#include "stridor/integration/run/motion.hpp"
#include "stridor/integration/series/block_order.hpp"
#include "stridor/model/structure.hpp"
#include "stridor/parameters/case.hpp"

#include <stop_token>

namespace stridor::integration {

/// Settings of the Taylor engine.
struct Taylor {
    parameters::EarlyEnding early_ending = parameters::EarlyEnding::proven;
    int order = block_order;  // [1] of the power series, at most this; with a lower one blocks are shorter
};

/// Solves the motion of a structure of any size with any number of contacts from event to event, without
/// time-discretisation error.
///
/// Between events the motion is a power series in the coordinates of the free eigenmodes; the instants at which a
/// contact changes are zeros of polynomials, found with certainty and to rounding. What happens there is the same rule
/// for any number of contacts (`Settling`). Friction may change with the slip velocity, and springs need not be linear:
/// both are expanded, too, and nothing is then proven to last but a cycle. See docs/methods/many-contacts.md and
/// docs/methods/friction-series.md.
///
/// Costs: some 25 (4 n a + a²) operations a block of 2/Omega, a the closed and stuck contacts, and three blocks an
/// event. Returns `diverged`, `chattering`, `painleve` or `no_forces` with the time, `cancelled` soon after a stop
/// request. Throws `Error` (input) as `expect_solvable` and for what `modal_structure` refuses.
Motion integrate_taylor(const model::Structure& structure, const parameters::Drive& drive, const InitialState& start,
                        const Taylor& settings, record::Recorder recorder, const std::stop_token& stop = {});

}  // namespace stridor::integration
