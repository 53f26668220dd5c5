#include "stridor/integration/run/end_state.hpp"

#include "stridor/parameters/start.hpp"

#include <cmath>

namespace stridor::integration {

namespace {

parameters::ContactStart start_in(model::ContactState state) {
    using parameters::ContactStart;
    if (state == model::ContactState::separation) return ContactStart::separation;
    return state == model::ContactState::stick ? ContactStart::stick : ContactStart::slip;
}

}  // namespace

parameters::Case begun_at(parameters::Case c, const EndState& state) {
    const double periods = parameters::turns_at_start(parameters::drive_of_run(c)) + c.drive.frequency * state.time;
    parameters::CaseStart start{state.displacement, state.velocity, {}, state.friction_states, state.rested};
    for (const model::ContactState contact : state.contacts)
        start.contacts.push_back(start_in(contact));
    parameters::set_start(c, start);
    c.drive.phase = 360.0 * (periods - std::floor(periods));
    return c;
}

}  // namespace stridor::integration
