#include "stridor/parameters/start.hpp"

#include "stridor/base/elementary.hpp"
#include "stridor/base/text.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/own_structure.hpp"

#include <cmath>
#include <string>

namespace stridor::parameters {

namespace {

using base::shortest;

constexpr double start_rounding = 1e-9;  // [1] of the terms: closed, and sticking

bool is_open(const StartingContact& contact) {
    return contact.gap > start_rounding * contact.gap_size ||
           (std::abs(contact.gap) <= start_rounding * contact.gap_size &&
            contact.rate > start_rounding * contact.rate_size);
}

bool slips(const StartingContact& contact) {
    return std::abs(contact.slip) > start_rounding * contact.slip_size;
}

}  // namespace

ContactStart state_of(const StartingContact& contact) {
    if (is_open(contact)) return ContactStart::separation;
    return slips(contact) ? ContactStart::slip : ContactStart::stick;
}

std::optional<base::Problem> unlawful(const StartingContact& contact) {
    const std::string who = contact.name.empty() ? "the contact" : "contact \"" + std::string(contact.name) + "\"";
    if (contact.gap < -start_rounding * contact.gap_size)
        return base::Problem{who + " begins with a gap of " + shortest(contact.gap) + " m",
                             "surfaces are never in each other", "Let them touch, or begin with an open gap."};
    const bool is_closed = contact.gap <= start_rounding * contact.gap_size;
    if (is_closed && contact.rate < -start_rounding * contact.rate_size)
        return base::Problem{who + " is closed, and begins to close at " + shortest(-contact.rate) + " m/s",
                             "no contact state has surfaces that move into each other",
                             "Give both the same normal velocity, or begin with an open gap: they meet then."};
    const ContactStart state = state_of(contact);
    if (contact.state == ContactStart::by_motion || contact.state == state) return std::nullopt;
    if (contact.state == ContactStart::separation)
        return base::Problem{who + " is said to begin separated, and is closed", "its gap is 0 and does not open",
                             "Give it a gap or a velocity that opens it."};
    if (state == ContactStart::separation)
        return base::Problem{
            who + " is said to begin in contact, and is open",
            "its gap is " + shortest(contact.gap) + " m, opening at " + shortest(contact.rate) + " m/s",
            "Close the gap, or let the state follow from the motion."};
    if (contact.state == ContactStart::stick)
        return base::Problem{who + " is said to stick, and slips at " + shortest(contact.slip) + " m/s", "",
                             "Give it the velocity of its surface, or let the state follow from the motion."};
    return base::Problem{who + " is said to slip, and moves with its surface", "its slip velocity is 0",
                         "Give it another tangential velocity, or let the state follow from the motion."};
}

double velocity_at_start(const Drive& drive) {
    const VelocityProfile profile = velocity_profile(drive);
    if (profile.frequency > 0.0) return profile.velocity * base::sine_cosine_of_turns(profile.turns).cosine;
    return profile.velocities.empty() ? profile.velocity : profile.velocities.front();
}

void check_start(CaseView at, std::vector<Finding>& found) {
    if (at.c.run.initial != Initial::given || at.c.own_structure) return;
    const JointStart& start = at.own().start;
    const Plate& plate = at.c.plate;
    const double V = velocity_at_start(at.c.drive);
    const bool sticks = start.contact == ContactStart::stick;
    const double slip_size = std::abs(sticks ? V : start.tangential_velocity) + std::abs(V);
    const std::string name = has_several_joints(at.c) ? joint_name(at.c, at.joint) : "";
    const StartingContact contact{
        .name = name,
        .state = start.contact,
        .gap = start.normal - plate.initial_normal,
        .gap_size = std::abs(start.normal) + std::abs(plate.initial_normal) + std::abs(start.tangential),
        .rate = start.normal_velocity - plate.initial_normal_velocity,
        .rate_size = std::abs(start.normal_velocity) + std::abs(plate.initial_normal_velocity) + slip_size,
        .slip = sticks ? 0.0 : start.tangential_velocity - V,
        .slip_size = slip_size};
    const std::optional<base::Problem> problem = unlawful(contact);
    if (!problem) return;
    const bool is_of_gap = contact.gap < 0.0;
    const bool is_of_rate = !is_of_gap && contact.rate < 0.0 && contact.gap == 0.0;
    found.push_back({is_of_gap    ? "joint.initial_normal"
                     : is_of_rate ? "joint.initial_normal_velocity"
                                  : "contact.initial_state",
                     *problem,
                     {"plate.initial_normal", "plate.initial_normal_velocity", "joint.initial_tangential_velocity"}});
}

}  // namespace stridor::parameters
