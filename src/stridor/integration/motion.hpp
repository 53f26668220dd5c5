#pragma once

#include "stridor/integration/energy_balance.hpp"
#include "stridor/integration/outcome.hpp"
#include "stridor/model/contact_state.hpp"
#include "stridor/record/recorder.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace stridor::integration {

/// A proof that a motion slips for ever: bounds that hold from `time` on.
struct Silence {
    double time = 0.0;           // [s]
    double normal_force = 0.0;   // [N] N never falls below this
    double slip_velocity = 0.0;  // [m/s] |w| never falls below this
};

/// A motion that repeats itself: from `time` on it is continued by whole periods.
struct LimitCycle {
    double time = 0.0;      // [s] when the second of two equal periods ended
    double period = 0.0;    // [s]
    double residual = 0.0;  // [1] distance of the states one period apart, as a share of the velocities
    int events = 0;         // [1] changes of contact state or of the slip's direction, and impacts, per period
};

/// The same run with contacts that have no inertia, to compare.
struct MasslessTwin {
    Outcome outcome;
    std::vector<record::Tally> phases;
};

/// A run: how it ended, its energy balance and what was kept of it.
struct Motion {
    Outcome outcome;
    EnergyBalance energy;
    record::Record record;
    std::optional<Silence> silence = std::nullopt;   // why it ended early, if it settled
    std::optional<LimitCycle> cycle = std::nullopt;  // likewise
    // of a run of the Taylor engine without a result: what each contact did where it ended, shape [contact]
    std::vector<model::ContactState> last_set{};
    std::vector<std::size_t> pressed{};  // of one that ended as `painleve`: contacts that friction presses without end
    std::optional<MasslessTwin> massless = std::nullopt;  // where both formulations were asked for
};

}  // namespace stridor::integration
