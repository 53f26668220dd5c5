#include "stridor/parameters/joints.hpp"

#include "stridor/base/check.hpp"

#include <algorithm>

namespace stridor::parameters {

namespace {

constexpr std::string_view joint_opening = "joint.";
constexpr std::string_view contact_opening = "contact.";

}  // namespace

std::string joint_name(const Case& c, std::size_t joint) {
    STRIDOR_EXPECT(joint < c.joints.size());
    return has_several_joints(c) ? c.joints[joint].name : "joint";
}

bool is_of_joint(const Field& field) {
    return field.section == "joint" || field.section == "contact";
}

Case two_lips() {
    Case c;
    c.title = "two lips on one pane";
    c.contact().preload = 200.0;
    c.contact().kinetic_friction = 0.2;
    c.drive.kind = DriveKind::constant;
    c.drive.velocity = -0.1;
    c.run.duration = 2.0;
    c.run.initial = Initial::stuck;
    c.joints.push_back(c.joints.front());
    c.joints[0].name = "upper";
    c.joints[1].name = "lower";
    c.joints[1].joint.incidence_angle = 60.0;
    return c;
}

std::vector<JointSpring> stiffening_springs(const Joint& joint) {
    const bool is_cubic = joint.stiffening == Stiffening::cubic;
    std::vector<JointSpring> springs;
    if (joint.stiffening == Stiffening::table || (is_cubic && joint.axial_cubic != 0.0))
        springs.push_back(JointSpring::axial);
    if (is_cubic && joint.flexural_cubic != 0.0) springs.push_back(JointSpring::flexural);
    return springs;
}

std::optional<JointKey> joint_key(std::string_view key) {
    if (!key.starts_with(joint_opening)) return std::nullopt;
    const std::string_view rest = key.substr(joint_opening.size());
    const std::size_t point = rest.find('.');
    if (point == std::string_view::npos || point == 0) return std::nullopt;
    const std::string_view inner = rest.substr(point + 1);
    const bool is_of_contact = inner.starts_with(contact_opening);
    return JointKey{std::string(rest.substr(0, point)),
                    is_of_contact ? std::string(inner) : std::string(joint_opening) + std::string(inner)};
}

std::string key_of_joint(const JointKey& key) {
    const std::string_view inner = key.key;
    const bool is_of_contact = inner.starts_with(contact_opening);
    return std::string(joint_opening) + key.joint + "." +
           std::string(is_of_contact ? inner : inner.substr(joint_opening.size()));
}

std::string key_of_joint(const Field& field, std::string_view joint) {
    STRIDOR_EXPECT(is_of_joint(field));
    return key_of_joint({std::string(joint), key_of(field)});
}

bool has_key_of_joint(const Case& c, const Field& field) {
    return has_several_joints(c) && is_of_joint(field);
}

std::string key_at(CaseView at, const Field& field) {
    return has_key_of_joint(at.c, field) ? key_of_joint(field, joint_name(at.c, at.joint)) : key_of(field);
}

bool names_a_joint(std::string_view name) {
    const auto fits = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    };
    constexpr std::size_t longest = 64;
    return !name.empty() && name.size() <= longest && std::all_of(name.begin(), name.end(), fits) &&
           name != "contact" && name != "name" && find_field(std::string(joint_opening) + std::string(name)) == nullptr;
}

}  // namespace stridor::parameters
