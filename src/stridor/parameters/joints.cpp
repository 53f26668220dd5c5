#include "stridor/parameters/joints.hpp"

#include "stridor/base/check.hpp"

#include <algorithm>
#include <utility>

namespace stridor::parameters {

namespace {

constexpr std::string_view joint_opening = "joint.";
constexpr std::string_view contact_opening = "contact.";

bool is_key_of_joint(std::string_view key) {
    return key.starts_with(joint_opening) || key.starts_with(contact_opening);
}

// the table as if this joint were the only one: its own columns, and what is nobody's
void keep_columns_of(Case& only, std::string_view name) {
    std::vector<TemperatureColumn> columns;
    for (TemperatureColumn& column : only.temperature.columns) {
        const std::optional<JointKey> named = joint_key(column.key);
        if (named && named->joint != name) continue;
        if (named) column.key = named->key;
        columns.push_back(std::move(column));
    }
    if (columns.empty()) only.temperature.at.clear();
    only.temperature.columns = std::move(columns);
}

// what a joint's quantities follow, each column with its name
std::vector<TemperatureColumn> named_columns(const Case& only, const std::string& name) {
    std::vector<TemperatureColumn> columns;
    for (TemperatureColumn column : only.temperature.columns) {
        if (!is_key_of_joint(column.key)) continue;
        column.key = key_of_joint({name, column.key});
        columns.push_back(std::move(column));
    }
    return columns;
}

}  // namespace

std::size_t joint_count(const Case& c) {
    return 1 + c.further_joints.size();
}

std::string joint_name(const Case& c, std::size_t joint) {
    STRIDOR_EXPECT(joint < joint_count(c));
    if (c.further_joints.empty()) return "joint";
    return joint == 0 ? c.joint_name : c.further_joints[joint - 1].name;
}

bool is_of_joint(const Field& field) {
    return field.section == "joint" || field.section == "contact";
}

Case alone(const Case& c, std::size_t joint) {
    STRIDOR_EXPECT(joint < joint_count(c));
    Case only = c;
    only.joint_name.clear();
    only.further_joints.clear();
    if (!c.further_joints.empty()) keep_columns_of(only, joint_name(c, joint));
    if (joint == 0) return only;
    const FurtherJoint& further = c.further_joints[joint - 1];
    only.joint = further.joint;
    only.contact = further.contact;
    only.damping_ratios.axial = further.axial_ratio;
    only.damping_ratios.flexural = further.flexural_ratio;
    return only;
}

void add_joint(Case& c, std::string name, const Case& only) {
    std::vector<TemperatureColumn>& columns = c.temperature.columns;
    if (c.further_joints.empty()) {
        const std::vector<TemperatureColumn> first = named_columns(c, c.joint_name);
        std::erase_if(columns, [](const TemperatureColumn& column) { return is_key_of_joint(column.key); });
        columns.insert(columns.begin(), first.begin(), first.end());
    }
    if (c.temperature.at.empty()) {
        c.temperature.at = only.temperature.at;
        c.temperature.value = only.temperature.value;
    }
    const std::vector<TemperatureColumn> further = named_columns(only, name);
    const auto of_plate = std::find_if(columns.begin(), columns.end(),
                                       [](const TemperatureColumn& column) { return !is_key_of_joint(column.key); });
    columns.insert(of_plate, further.begin(), further.end());
    c.further_joints.push_back(
        {std::move(name), only.joint, only.contact, only.damping_ratios.axial, only.damping_ratios.flexural});
}

void exchange_joints(Case& c, std::size_t joint) {
    STRIDOR_EXPECT(joint < joint_count(c));
    if (joint == 0) return;
    FurtherJoint& other = c.further_joints[joint - 1];
    std::swap(c.joint, other.joint);
    std::swap(c.contact, other.contact);
    std::swap(c.damping_ratios.axial, other.axial_ratio);
    std::swap(c.damping_ratios.flexural, other.flexural_ratio);
}

Case two_lips() {
    Case c;
    c.contact.preload = 200.0;
    c.contact.kinetic_friction = 0.2;
    c.drive.kind = DriveKind::constant;
    c.drive.velocity = -0.1;
    c.run.duration = 2.0;
    c.run.initial = Initial::stuck;
    Case lower = c;
    lower.joint.incidence_angle = 60.0;
    c.title = "two lips on one pane";
    c.joint_name = "upper";
    add_joint(c, "lower", lower);
    return c;
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

bool names_a_joint(std::string_view name) {
    const auto fits = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    };
    constexpr std::size_t longest = 64;
    return !name.empty() && name.size() <= longest && std::all_of(name.begin(), name.end(), fits) &&
           name != "contact" && name != "name" && find_field(std::string(joint_opening) + std::string(name)) == nullptr;
}

}  // namespace stridor::parameters
