#pragma once

#include "stridor/base/error.hpp"
#include "stridor/parameters/rules/check.hpp"

#include <optional>
#include <string>
#include <vector>

/// Starts of the user's own (`Initial::given`): what a contact may do at one.
namespace stridor::parameters {

/// A contact at the start. Sizes are what rounding works on: the sums of the sizes of the terms, and those of the
/// tangential motion, since a rest of it is in all others.
struct StartingContact {
    std::string name;  // empty for the only one
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

/// A start in the coordinates of a case (`coordinate_names`).
struct CaseStart {
    std::vector<double> displacement{};     // [m] from the preloaded rest, shape [coordinate]
    std::vector<double> velocity{};         // [m/s] shape [coordinate]
    std::vector<ContactStart> contacts{};   // what each does there, shape [contact]
    std::vector<double> friction_states{};  // [1] of laws that have one, shape [contact]
    std::vector<double> rested{};           // [s] for which each has stuck, shape [contact]; empty: as the case says
};

/// Returns the start that a case states, over a surface that moves with V [m/s]. Joints that stick move with it. Where
/// a structure has no given start it is what is added to its rest, with velocities per V.
CaseStart start_of(const Case& c, double surface_velocity);

/// Makes a state the given start of a case: contacts that are closed are closed to the last bit.
void set_start(Case& c, const CaseStart& start);

/// Adds what is wrong with the given start of a joint.
void check_start(CaseView at, std::vector<Finding>& found);

}  // namespace stridor::parameters
