#include "stridor/integration/rules/expect_solvable.hpp"

#include "stridor/base/error.hpp"
#include "stridor/model/laws/friction_jet.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace stridor::integration {

namespace {

using model::ContactPoint;
using parameters::Asked;
using parameters::Demand;

std::vector<Asked> demands_of(const model::Structure& structure) {
    const auto has = [&](auto is_so) {
        return std::any_of(structure.contacts.begin(), structure.contacts.end(), is_so);
    };
    const auto is_plane = [](const ContactPoint& contact) { return has_two_tangents(contact); };
    const auto has_slope = [](const ContactPoint& contact) { return !is_state_wise(contact.friction); };
    const auto is_other_cone = [&](const ContactPoint& contact) {
        return is_plane(contact) && kind_of(contact.friction) != parameters::FrictionKind::coulomb;
    };
    const int dofs = model::dofs_of(structure);
    std::vector<Asked> asked;
    if (structure.contacts.size() != 1)
        asked.push_back({Demand::several_contacts, std::to_string(structure.contacts.size()) + " contacts are given"});
    if (dofs != 2 && dofs != 3)
        asked.push_back({Demand::any_size, std::to_string(dofs) + " degrees of freedom are given"});
    if (has(is_plane)) asked.push_back({Demand::two_tangents});
    if (has(is_other_cone) || (has(is_plane) && has(has_slope))) asked.push_back({Demand::other_cone});
    if (structure.shaken.size() != 0) asked.push_back({Demand::imposed_force});
    if (has([](const ContactPoint& contact) { return !std::holds_alternative<model::Plastic>(contact.impact); }))
        asked.push_back({Demand::other_impacts});
    if (has(has_slope)) asked.push_back({Demand::other_friction});
    if (has([](const ContactPoint& contact) { return !has_jet(contact.friction); }))
        asked.push_back({Demand::unexpanded_friction});
    if (has([](const ContactPoint& contact) { return grows(contact.rest); }))
        asked.push_back({Demand::growing_friction});
    if (has([](const ContactPoint& contact) { return has_friction_state(contact.friction); }))
        asked.push_back({Demand::friction_state});
    if (!structure.springs.empty()) asked.push_back({Demand::other_springs});
    return asked;
}

}  // namespace

void expect_solvable(const model::Structure& structure, parameters::Method method) {
    for (const Asked& asked : demands_of(structure))
        if (const auto problem = refusal(method, asked)) throw Error(ErrorKind::input, *problem);
}

}  // namespace stridor::integration
