#include "stridor/integration/run/end_state.hpp"

#include "stridor/base/check.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/parameters/start.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace stridor::integration {

namespace {

using model::ContactState;
using parameters::Case;
using parameters::ContactStart;

void put_joints(Case& c, const EndState& state) {
    const std::size_t last = 2 * c.joints.size();
    c.plate.initial_normal = state.displacement[last];
    c.plate.initial_normal_velocity = state.velocity[last];
    for (std::size_t k = 0; k < c.joints.size(); ++k) {
        parameters::JointStart& start = c.joints[k].start;
        start = {state.displacement[2 * k], state.displacement[2 * k + 1], state.velocity[2 * k],
                 state.velocity[2 * k + 1]};
        if (!state.rested.empty()) c.joints[k].contact.rested = state.rested[k];
        if (!state.friction_states.empty()) start.friction_state = state.friction_states[k];
        if (state.contacts[k] == ContactState::separation) {
            start.normal = std::max(start.normal, c.plate.initial_normal);
            continue;
        }
        start.normal = c.plate.initial_normal;
        start.normal_velocity = c.plate.initial_normal_velocity;
        if (state.contacts[k] == ContactState::stick) start.contact = ContactStart::stick;
    }
}

}  // namespace

Case begun_at(Case c, const EndState& state) {
    const double periods = parameters::turns_at_start(parameters::drive_of_run(c)) + c.drive.frequency * state.time;
    c.run.initial = parameters::Initial::given;
    c.drive.phase = 360.0 * (periods - std::floor(periods));
    if (!c.own_structure) {
        STRIDOR_EXPECT(state.displacement.size() == 2 * c.joints.size() + 1);
        put_joints(c, state);
        return c;
    }
    parameters::OwnStructure own = *c.own_structure;
    own.initial_displacement = state.displacement;
    own.initial_velocity = state.velocity;
    for (std::size_t k = 0; k < state.rested.size(); ++k)
        own.contacts[k].rested = state.rested[k];
    for (std::size_t k = 0; k < state.friction_states.size(); ++k)
        own.contacts[k].initial_friction_state = state.friction_states[k];
    c.own_structure = std::make_shared<const parameters::OwnStructure>(std::move(own));
    return c;
}

}  // namespace stridor::integration
