#pragma once

#include "stridor/integration/modal/modal_structure.hpp"
#include "stridor/integration/rules/contact_mode.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace stridor::integration {

/// Contacts that touch while others meet: what their velocities are, and what each is taken to do first.
struct Meeting {
    std::vector<double> gap_velocity;   // [m/s] g' before, shape [contact]
    std::vector<double> slip_velocity;  // [m/s] w before, shape [contact]
    std::vector<ContactMode> mode;      // shape [contact]; open: no impulse as long as g' >= 0 afterwards
    std::vector<bool> touches;          // shape [contact]; the others take no part
    // [1] what rest has added to the limits of those that stick, shape [contact]; empty: nothing
    std::vector<double> grown{};
};

/// Impulses of all touching contacts at once, and what they leave.
struct ContactImpulses {
    std::vector<ContactMode> mode;      // after it; open where g' > 0
    std::vector<double> normal;         // [N*s] P_n on the structure, shape [contact]
    std::vector<double> tangential;     // [N*s] P_t, shape [contact]
    std::vector<double> gap_velocity;   // [m/s] g' after it, shape [contact]
    std::vector<double> slip_velocity;  // [m/s] w after it, shape [contact]
};

/// Returns the impulses of a plastic impact of several contacts:
///
///     (g', w)+ = (g', w) + W (P_n, P_t);   P_n >= 0, g'+ >= 0, one of them 0;
///     w+ = 0 with |P_t| <= limit P_n, or P_t = ratio(w+) P_n against w+
///
/// Begins with the modes given: least change decides between several solutions (set_search.hpp). Empty if no set obeys
/// the laws, and if the contacts depend on each other.
std::optional<ContactImpulses> contact_impulses(const ModalStructure& structure, const Meeting& meeting);

}  // namespace stridor::integration
