// The event that fires makes a quantity zero, and the next state is built on that zero, not on its rounding: after
// lift-off g = g' = g'' = 0 and g''' decides; after an impact with N < 0 g = g' = 0 and g'' decides; where slip begins
// or turns w = 0 and w' decides (w'' where mu_s = mu_d). The order of the zero goes with the state.
//
// Impact: the law gives P_n and P_t, and P_t changes x' by P_t / m_x. Kinetic energy goes into g', into friction and to
// the drive.

#include "stridor/integration/exact/contact_transition.hpp"

#include "stridor/integration/exact/flow.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace stridor::integration {

namespace {

// a rebound that flies for less than this ends in contact: the sum of all later flights is e/(1-e) of it
constexpr double shortest_flight = 1e-9;  // [s]

const Flow& flow_of(const Flows& flows, ContactMode mode) {
    return flows.flow[static_cast<int>(mode)];
}

// |T| <= mu_s N, half of what rounding may make of it allowed: the other half keeps the stick from ending at once
bool holds(const Flows& flows, const Lanes& closed_state) {
    const Flow& stick = flow_of(flows, ContactMode::stick);
    return std::all_of(std::begin(stick.test), std::end(stick.test), [&](const EventFunction& test) {
        return dot(test.row, closed_state) >= -0.5 * force_rounding(test.row, closed_state);
    });
}

// lanes of a structure
struct Places {
    int speed, surface, gap, gap_speed;

    explicit Places(const Flows& flows)
        : speed(velocity_lane(flows.dofs - 1, 0)),
          surface(surface_lane(flows.dofs - 1)),
          gap(gap_lane(flows.dofs - 1)),
          gap_speed(gap + 1) {}
};

// g = g' = 0 from here on
Transition open_contact(const Flows& flows, const Lanes& closed_state, int multiplicity) {
    const Places at(flows);
    Transition next{ContactMode::open, multiplicity, closed_state};
    next.slip_velocity = closed_state.at[at.speed] - closed_state.at[at.surface];
    next.state.at[at.gap] = next.state.at[at.gap_speed] = 0.0;
    return next;
}

Transition land(const Flows& flows, const model::ContactPoint& contact, const Lanes& open_state,
                const SurfaceNumbers& surface) {
    const Places at(flows);
    const double closing = open_state.at[at.gap_speed];
    const double before = open_state.at[at.speed];
    const double w = before - surface.velocity;
    const double m_g = flows.mass[flows.dofs - 1];
    const model::Impulses P =
        model::impulses(contact.impact, {m_g, flows.mass[0], flows.tangent_on_gap}, contact.friction, {closing, w});
    const double speed = P.stops ? surface.velocity : before + P.tangential / flows.mass[0];

    Lanes closed_state = open_state;
    closed_state.at[at.speed] = speed;
    closed_state.at[at.surface] = surface.velocity;
    closed_state.at[at.surface + 1] = surface.partner;
    double normal_loss = 0.5 * m_g * closing * closing * (1.0 - P.restitution * P.restitution);

    Transition next;
    const double rebound = -P.restitution * closing;
    const double N = dot(flow_of(flows, ContactMode::stick).normal_force, closed_state);
    const bool flies = rebound > 0.0 && (N <= 0.0 || 2.0 * rebound * m_g > shortest_flight * N);
    if (flies) {
        next = open_contact(flows, closed_state, 1);
        next.state.at[at.gap_speed] = rebound;
    } else {
        next = close_contact(flows, closed_state, speed - surface.velocity);
        normal_loss += 0.5 * m_g * rebound * rebound;
    }
    next.closing_speed = closing;
    next.impact_loss = normal_loss;
    next.friction_loss = -0.5 * P.tangential * (w + (speed - surface.velocity));
    next.drive_work = P.tangential * surface.velocity;
    return next;
}

}  // namespace

double dot(const Lanes& row, const Lanes& s) {
    double sum = 0.0;
    for (int i = 0; i < lanes; ++i)
        sum += row.at[i] * s.at[i];
    return sum;
}

double force_rounding(const Lanes& row, const Lanes& s) {
    double size = 0.0;
    for (int i = 0; i < lanes; ++i)
        size += std::abs(row.at[i] * s.at[i]);
    return 0x1p-43 * size;
}

Transition close_contact(const Flows& flows, const Lanes& closed_state, double slip_velocity) {
    double direction = slip_velocity;
    if (slip_velocity == 0.0) {
        const double N = dot(flow_of(flows, ContactMode::stick).normal_force, closed_state);
        if (N >= 0.0 && holds(flows, closed_state)) return {ContactMode::stick, 0, closed_state};
        direction = -dot(flow_of(flows, ContactMode::stick).friction_force, closed_state);
    }
    const ContactMode mode = slip_mode(model::slip_of(direction));
    if (dot(flow_of(flows, mode).normal_force, closed_state) < 0.0) return open_contact(flows, closed_state, 2);
    Transition next{mode, slip_velocity == 0.0 ? 1 : 0, closed_state};
    next.slip_velocity = slip_velocity;
    return next;
}

Transition follow(const Flows& flows, const model::ContactPoint& contact, ContactMode mode, int test,
                  const Lanes& state, const SurfaceNumbers& surface) {
    if (mode == ContactMode::open) return land(flows, contact, state, surface);
    if (is_slip(mode) && test == 0) return open_contact(flows, state, 3);
    const Places at(flows);
    Lanes stuck = state;
    stuck.at[at.speed] = stuck.at[at.surface];  // w = 0
    if (is_slip(mode)) return close_contact(flows, stuck, 0.0);
    const model::Slip way = test == 0 ? model::Slip::backward : model::Slip::forward;
    const bool force_drops = stick_limit(contact.friction, way) > std::abs(slip_ratio(contact.friction, way));
    return {slip_mode(way), force_drops ? 1 : 2, stuck};
}

}  // namespace stridor::integration
