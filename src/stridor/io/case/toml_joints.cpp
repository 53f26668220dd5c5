#include "stridor/io/case/toml_joints.hpp"

#include "stridor/base/escapes.hpp"
#include "stridor/base/text.hpp"
#include "stridor/parameters/joints.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

namespace stridor::io {

namespace {

constexpr std::string_view list_key = "joint";

// "joint.2" of a list; its own entry says where the table opens
std::string table_key(std::size_t number) {
    return std::string(list_key) + "." + std::to_string(number);
}

bool is_below(std::string_view key, std::string_view section) {
    return key.size() > section.size() && key.starts_with(section) && key[section.size()] == '.';
}

std::string name_of_joint(const TomlDocument& document, std::size_t number, const TomlEntry& table,
                          Complaints& complaints) {
    const TomlEntry* entry = document.find(table_key(number) + ".name");
    const auto* name = entry == nullptr ? nullptr : std::get_if<std::string>(&entry->value);
    if (name == nullptr) {
        complaints.add({ErrorKind::input,
                        {"this joint has no name", "each of several joints is called by one",
                         "Write for example name = \"lip" + std::to_string(number) + "\"."},
                        entry == nullptr ? table.key_place : entry->value_place});
        return {};
    }
    if (!parameters::names_a_joint(*name))
        complaints.add({ErrorKind::input,
                        {"\"" + base::visible(*name) + "\" cannot name a joint",
                         "a name has letters, digits, _ and - only, and is no key of [joint]", ""},
                        entry->value_place});
    return *name;
}

// an entry as the file of one joint has it; nothing if it is another's
std::optional<TomlEntry> entry_for(const TomlEntry& entry, std::size_t number, const std::string& name) {
    TomlEntry own = entry;
    if (entry.origin == TomlOrigin::override) {
        const auto key = parameters::joint_key(entry.key);
        if (!key) return own;
        own.key = key->key;
        return key->joint == name ? std::optional(own) : std::nullopt;
    }
    if (entry.key == list_key) return std::nullopt;
    if (!is_below(entry.key, list_key)) return own;
    const std::string table = table_key(number);
    if (entry.key == table) {
        own.key = list_key;
        return own;
    }
    if (!is_below(entry.key, table)) return std::nullopt;
    const std::string inner = entry.key.substr(table.size() + 1);
    if (inner == "name") return std::nullopt;
    const bool is_of_contact = inner == "contact" || is_below(inner, "contact");
    own.key = is_of_contact ? inner : std::string(list_key) + "." + inner;
    return own;
}

void check_overrides(const TomlDocument& document, const std::vector<JointDocument>& joints, Complaints& complaints) {
    std::vector<std::string_view> names;
    for (const JointDocument& joint : joints)
        names.emplace_back(joint.name);
    for (const TomlEntry& entry : document.entries) {
        const auto key = entry.origin == TomlOrigin::override ? parameters::joint_key(entry.key) : std::nullopt;
        if (!key || std::find(names.begin(), names.end(), key->joint) != names.end()) continue;
        const std::string near(base::nearest_name(key->joint, names));
        complaints.add({ErrorKind::input,
                        {"there is no joint \"" + base::visible(key->joint) + "\"", "",
                         near.empty() ? "" : "Did you mean joint." + near + "?"},
                        entry.key_place});
    }
}

}  // namespace

bool lists_joints(const TomlDocument& document) {
    return document.find(table_key(1)) != nullptr;
}

std::vector<JointDocument> joint_documents(const TomlDocument& document, Complaints& complaints) {
    std::vector<JointDocument> joints;
    const TomlEntry* common = document.find("contact");
    if (common != nullptr && common->origin == TomlOrigin::file)
        complaints.add({ErrorKind::input,
                        {"[contact] stands beside [[joint]]", "each of several joints has a contact of its own",
                         "Move its keys to [joint.contact] below each joint."},
                        common->key_place});
    for (std::size_t number = 1; const TomlEntry* table = document.find(table_key(number)); ++number) {
        if (number > parameters::most_joints) {
            complaints.add({ErrorKind::input,
                            {"there are more than " + std::to_string(parameters::most_joints) + " joints",
                             "the motion between events is solved for all of them at once", ""},
                            table->key_place});
            break;
        }
        JointDocument joint{name_of_joint(document, number, *table, complaints), {document.name, {}}};
        const bool is_taken = std::any_of(joints.begin(), joints.end(),
                                          [&](const JointDocument& other) { return other.name == joint.name; });
        if (is_taken && !joint.name.empty())
            complaints.add(
                {ErrorKind::input,
                 {"two joints are called \"" + base::visible(joint.name) + "\"", "", "Give each a name of its own."},
                 document.find(table_key(number) + ".name")->value_place});
        for (const TomlEntry& entry : document.entries)
            if (auto own = entry_for(entry, number, joint.name)) joint.document.entries.push_back(std::move(*own));
        joints.push_back(std::move(joint));
    }
    check_overrides(document, joints, complaints);
    return joints;
}

}  // namespace stridor::io
