#include "stridor/parameters/system.hpp"

#include "stridor/base/check.hpp"
#include "stridor/parameters/fields/contact_field.hpp"
#include "stridor/parameters/joints.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <variant>

namespace stridor::parameters {

bool has_plate(const Case& c) {
    return !c.own_structure;
}

bool has_one_joint(const Case& c) {
    return has_plate(c) && !has_several_joints(c);
}

std::vector<std::string> coordinate_names(const Case& c) {
    if (c.own_structure) return c.own_structure->row;
    if (has_one_joint(c)) return {"x1", "y1", "y2"};
    std::vector<std::string> names;
    for (std::size_t k = 0; k < c.joints.size(); ++k)
        for (const std::string_view direction : {"x_", "y_"})
            names.push_back(std::string(direction) + joint_name(c, k));
    names.emplace_back("y_plate");
    return names;
}

std::size_t coordinate_count(const Case& c) {
    return c.own_structure ? c.own_structure->row.size() : 2 * c.joints.size() + 1;
}

std::size_t channel_count(const Case& c) {
    return c.own_structure ? 2 * contact_count(c) : coordinate_count(c);
}

std::vector<double> weight_of_one(const Case& c, std::size_t coordinate) {
    STRIDOR_EXPECT(coordinate < coordinate_count(c));
    std::vector<double> weights(coordinate_count(c), 0.0);
    weights[coordinate] = 1.0;
    return weights;
}

std::vector<double> point_weights(const Case& c, std::size_t contact, PointAxis axis) {
    STRIDOR_EXPECT(contact < contact_count(c));
    const bool is_along = axis == PointAxis::sliding;
    if (!c.own_structure) return weight_of_one(c, 2 * contact + (is_along ? 0U : 1U));
    const OwnContact& own = c.own_structure->contacts[contact];
    return is_along ? own.tangent : own.normal;
}

double drive_share_at(const Case& c, std::size_t contact) {
    STRIDOR_EXPECT(contact < contact_count(c));
    return c.own_structure ? c.own_structure->contacts[contact].drive_share : 1.0;
}

bool is_preloaded(const Case& c) {
    return !c.own_structure || std::any_of(c.own_structure->contacts.begin(), c.own_structure->contacts.end(),
                                           [](const OwnContact& contact) { return contact.preload_share > 0.0; });
}

std::size_t contact_count(const Case& c) {
    return c.own_structure ? c.own_structure->contacts.size() : c.joints.size();
}

bool has_named_contacts(const Case& c) {
    return !has_one_joint(c);
}

std::string contact_name(const Case& c, std::size_t contact) {
    STRIDOR_EXPECT(contact < contact_count(c));
    return c.own_structure ? c.own_structure->contacts[contact].name : joint_name(c, contact);
}

std::string told_name(const Case& c, std::size_t contact) {
    return has_named_contacts(c) ? contact_name(c, contact) : "";
}

Contact contact_of(const Case& c, std::size_t contact) {
    STRIDOR_EXPECT(contact < contact_count(c));
    if (!c.own_structure) return c.joints[contact].contact;
    const OwnContact& own = c.own_structure->contacts[contact];
    double all = 0.0;
    for (const OwnContact& each : c.own_structure->contacts)
        all += each.preload_share;
    Contact laws = c.contact();
    for (const ContactField& field : contact_fields())
        if (const auto* number = std::get_if<std::optional<double> OwnContact::*>(&field.member);
            number != nullptr && field.in_place_of != nullptr && own.**number)
            laws.*field.in_place_of = *(own.**number);
    laws.preload = all > 0.0 ? c.contact().preload * (own.preload_share / all) : 0.0;
    return laws;
}

std::vector<double> contact_places(const Case& c) {
    return c.own_structure ? places_along_line(*c.own_structure) : std::vector<double>();
}

void share_friction(Case& c) {
    if (!c.own_structure) return;
    OwnStructure structure = *c.own_structure;
    for (OwnContact& contact : structure.contacts) {
        contact.static_friction.reset();
        contact.kinetic_friction.reset();
    }
    c.own_structure = std::make_shared<const OwnStructure>(std::move(structure));
}

std::vector<std::string> names_of_springs(const Case& c) {
    std::vector<std::string> names;
    if (c.own_structure) {
        for (const OwnSpring& spring : c.own_structure->springs)
            if (kind_of(spring) != SpringKind::linear) names.push_back(spring.name);
        return names;
    }
    for (const PlateJoint& each : c.joints)
        for (const JointSpring spring : stiffening_springs(each.joint))
            names.push_back((has_several_joints(c) ? each.name + "." : "") +
                            std::string(joint_spring_names[static_cast<std::size_t>(spring)]));
    return names;
}

std::span<const OwnOutput> outputs_of(const Case& c) {
    return c.own_structure ? std::span<const OwnOutput>(c.own_structure->outputs) : std::span<const OwnOutput>();
}

std::vector<std::vector<double>> output_weights(const Case& c) {
    std::vector<std::vector<double>> weights;
    for (const OwnOutput& output : outputs_of(c))
        weights.push_back(output.weights);
    return weights;
}

std::span<const OutlinePoint> outline_of(const Case& c) {
    return c.own_structure ? std::span<const OutlinePoint>(c.own_structure->outline) : std::span<const OutlinePoint>();
}

std::string origin_of(const Case& c) {
    if (c.own_structure) return c.own_structure->origin;
    return (has_one_joint(c) ? "joint" : std::to_string(c.joints.size()) + " joints") + std::string(" on a plate");
}

}  // namespace stridor::parameters
