#pragma once

#include "stridor/base/error.hpp"
#include "stridor/parameters/rules/check.hpp"

#include <optional>
#include <string_view>
#include <vector>

/// Starts of the user's own (`Initial::given`): what a contact may do at one.
namespace stridor::parameters {

/// A contact at the start. Sizes are what rounding works on: the sums of the sizes of the terms, and those of the
/// tangential motion, since a rest of it is in all others.
struct StartingContact {
    std::string_view name;  // empty for the only one
    ContactStart state = ContactStart::by_motion;
    double gap = 0.0, gap_size = 0.0;    // [m]
    double rate = 0.0, rate_size = 0.0;  // [m/s] of the gap
    double slip = 0.0, slip_size = 0.0;  // [m/s] over the surface
};

/// Returns what the contact does: stick, slip or separation. A gap or a velocity of rounding is none.
ContactStart state_of(const StartingContact& contact);

/// Returns why no motion begins so: surfaces that are in each other, or move into each other, or a state that its gap
/// and velocities do not have. Nothing for a lawful start.
std::optional<base::Problem> unlawful(const StartingContact& contact);

/// Returns the velocity of the surface when the run begins [m/s].
double velocity_at_start(const Drive& drive);

/// Adds what is wrong with the given start of a joint.
void check_start(CaseView at, std::vector<Finding>& found);

}  // namespace stridor::parameters
