#include "stridor/parameters/start.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/base/text.hpp"
#include "stridor/parameters/system.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>

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
    const std::string who = contact.name.empty() ? "the contact" : "contact \"" + contact.name + "\"";
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
            who + " is said to begin in contact, and is separated",
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

namespace {

// along one after the other, normal one, and the plate last
CaseStart start_of_joints(const Case& c, double surface_velocity) {
    CaseStart all;
    for (const PlateJoint& joint : c.joints) {
        const JointStart& start = joint.start;
        const bool sticks = start.contact == ContactStart::stick;
        all.displacement.insert(all.displacement.end(), {start.tangential, start.normal});
        all.velocity.insert(all.velocity.end(),
                            {sticks ? surface_velocity : start.tangential_velocity, start.normal_velocity});
        all.contacts.push_back(start.contact);
        all.friction_states.push_back(start.friction_state);
    }
    all.displacement.push_back(c.plate.initial_normal);
    all.velocity.push_back(c.plate.initial_normal_velocity);
    return all;
}

std::vector<double> filled(const std::vector<double>& numbers, std::size_t rows) {
    if (numbers.empty()) return std::vector<double>(rows, 0.0);
    STRIDOR_EXPECT(numbers.size() == rows);
    return numbers;
}

CaseStart start_of_structure(const OwnStructure& own) {
    CaseStart all;
    all.displacement = filled(own.initial_displacement, own.row.size());
    all.velocity = filled(own.initial_velocity, own.row.size());
    all.contacts.assign(own.contacts.size(), ContactStart::by_motion);
    for (const OwnContact& contact : own.contacts)
        all.friction_states.push_back(contact.initial_friction_state);
    return all;
}

void set_start_of_joints(Case& c, const CaseStart& all) {
    c.plate.initial_normal = all.displacement.back();
    c.plate.initial_normal_velocity = all.velocity.back();
    for (std::size_t k = 0; k < c.joints.size(); ++k) {
        JointStart& start = c.joints[k].start;
        start = {all.displacement[2 * k], all.displacement[2 * k + 1], all.velocity[2 * k], all.velocity[2 * k + 1]};
        if (!all.rested.empty()) c.joints[k].contact.rested = all.rested[k];
        if (!all.friction_states.empty()) start.friction_state = all.friction_states[k];
        if (all.contacts[k] == ContactStart::separation) {
            start.normal = std::max(start.normal, c.plate.initial_normal);
            continue;
        }
        start.normal = c.plate.initial_normal;
        start.normal_velocity = c.plate.initial_normal_velocity;
        if (all.contacts[k] == ContactStart::stick) start.contact = ContactStart::stick;
    }
}

void set_start_of_structure(OwnStructure& own, const CaseStart& all) {
    own.initial_displacement = all.displacement;
    own.initial_velocity = all.velocity;
    for (std::size_t k = 0; k < all.rested.size(); ++k)
        own.contacts[k].rested = all.rested[k];
    for (std::size_t k = 0; k < all.friction_states.size(); ++k)
        own.contacts[k].initial_friction_state = all.friction_states[k];
}

}  // namespace

CaseStart start_of(const Case& c, double surface_velocity) {
    return c.own_structure ? start_of_structure(*c.own_structure) : start_of_joints(c, surface_velocity);
}

void set_start(Case& c, const CaseStart& start) {
    STRIDOR_EXPECT(start.displacement.size() == coordinate_count(c) && start.velocity.size() == coordinate_count(c));
    c.run.initial = Initial::given;
    if (!c.own_structure) return set_start_of_joints(c, start);
    OwnStructure own = *c.own_structure;
    set_start_of_structure(own, start);
    c.own_structure = std::make_shared<const OwnStructure>(std::move(own));
}

void check_start(CaseView at, std::vector<Finding>& found) {
    if (at.c.run.initial != Initial::given || !has_plate(at.c)) return;
    const JointStart& start = at.own().start;
    const Plate& plate = at.c.plate;
    const double V = velocity_at_start(at.c.drive);
    const bool sticks = start.contact == ContactStart::stick;
    const double slip_size = std::abs(sticks ? V : start.tangential_velocity) + std::abs(V);
    const StartingContact contact{
        .name = told_name(at.c, at.joint),
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
