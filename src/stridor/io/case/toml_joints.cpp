#include "stridor/io/case/toml_joints.hpp"

#include "stridor/base/escapes.hpp"
#include "stridor/base/text.hpp"
#include "stridor/parameters/case_key.hpp"
#include "stridor/parameters/joints.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

namespace stridor::io {

namespace {

constexpr std::string_view list_key = "joint";
constexpr std::string_view table_opening = "temperature.";

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

// "temperature.joint.lip2.axial_stiffness": a list of one joint, or the table that opens its lists
std::optional<parameters::JointKey> joint_over_temperature(const TomlEntry& entry) {
    if (!entry.key.starts_with(table_opening)) return std::nullopt;
    const std::string_view key = std::string_view(entry.key).substr(table_opening.size());
    if (const auto named = parameters::joint_key(key)) return named;
    const bool opens = std::holds_alternative<TomlTable>(entry.value) && is_below(key, list_key);
    return opens ? std::optional(parameters::JointKey{std::string(key.substr(list_key.size() + 1)), ""}) : std::nullopt;
}

// its list, called as that of the only joint
std::optional<TomlEntry> list_for(const TomlEntry& entry, const parameters::JointKey& key, const std::string& name) {
    if (key.joint != name || std::holds_alternative<TomlTable>(entry.value)) return std::nullopt;
    TomlEntry own = entry;
    try {
        const std::string called = parameters::key_called(parameters::key_of_joint(key));
        own.key = std::string(table_opening) + parameters::joint_key(called)->key;
    } catch (const Error& error) {
        throw Error(error.kind(), error.problem(), entry.key_place);
    }
    return own;
}

// an entry as the file of one joint has it; nothing if it is another's
std::optional<TomlEntry> entry_for(const TomlEntry& entry, std::size_t number, const std::string& name) {
    TomlEntry own = entry;
    if (const auto named = joint_over_temperature(entry)) return list_for(entry, *named, name);
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

// "joint.preload": a key of the contact that stands with those of the joint itself
bool is_misplaced(const TomlEntry& own) {
    return is_below(own.key, list_key) && parameters::find_field(own.key) == nullptr &&
           parameters::find_field("contact." + own.key.substr(list_key.size() + 1)) != nullptr;
}

// a joint of which nothing follows the temperature has no table: another one's may have taken all lists
void drop_empty_table(TomlDocument& own, const TomlDocument& document) {
    const bool has_other = std::any_of(document.entries.begin(), document.entries.end(), [](const TomlEntry& entry) {
        return joint_over_temperature(entry).has_value();
    });
    const bool has_own = std::any_of(own.entries.begin(), own.entries.end(), [](const TomlEntry& entry) {
        return entry.key.starts_with(table_opening) && entry.key != "temperature.at" &&
               entry.key != "temperature.value" && !std::holds_alternative<TomlTable>(entry.value);
    });
    if (!has_other || has_own) return;
    std::erase_if(own.entries, [](const TomlEntry& entry) {
        return entry.key == "temperature" || entry.key.starts_with(table_opening);
    });
}

void check_names(const TomlDocument& document, const std::vector<JointDocument>& joints, Complaints& complaints) {
    std::vector<std::string_view> names;
    for (const JointDocument& joint : joints)
        names.emplace_back(joint.name);
    for (const TomlEntry& entry : document.entries) {
        const auto over_temperature = joint_over_temperature(entry);
        const auto key = over_temperature                       ? over_temperature
                         : entry.origin == TomlOrigin::override ? parameters::joint_key(entry.key)
                                                                : std::nullopt;
        if (!key || std::holds_alternative<TomlTable>(entry.value)) continue;
        if (std::find(names.begin(), names.end(), key->joint) != names.end()) continue;
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
            complaints.keep([&] {
                auto own = entry_for(entry, number, joint.name);
                if (own && is_misplaced(*own))
                    complaints.add({ErrorKind::input,
                                    {"unknown key " + own->key, "what presses and rubs has a section in each joint",
                                     "Write it below [joint.contact] of this joint."},
                                    own->key_place});
                else if (own)
                    joint.document.entries.push_back(std::move(*own));
            });
        drop_empty_table(joint.document, document);
        joints.push_back(std::move(joint));
    }
    check_names(document, joints, complaints);
    return joints;
}

}  // namespace stridor::io
