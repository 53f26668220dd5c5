#include "stridor/parameters/fields/case_key.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/escapes.hpp"
#include "stridor/base/text.hpp"
#include "stridor/parameters/fields/field_name.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/tables/temperature_table.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace stridor::parameters {

namespace {

std::string visible_in_quotes(std::string_view text) {
    return "\"" + base::visible(std::string(text)) + "\"";
}

std::vector<std::string> joint_names(const Case& c) {
    std::vector<std::string> names;
    for (const PlateJoint& joint : c.joints)
        names.push_back(joint.name);
    return names;
}

// which joint a key names; nothing if it names none
std::optional<std::size_t> joint_of(const Case& c, std::string_view key) {
    const std::optional<JointKey> named = joint_key(key);
    if (!named) return std::nullopt;
    const std::vector<std::string> names = joint_names(c);
    const auto found = std::find(names.begin(), names.end(), named->joint);
    STRIDOR_EXPECT(found != names.end());
    return static_cast<std::size_t>(found - names.begin());
}

// the joints that a key is about; the first for what all of them share
std::vector<std::size_t> joints_of(const Case& c, std::string_view key) {
    if (const std::optional<std::size_t> joint = joint_of(c, key)) return {*joint};
    std::vector<std::size_t> all{0};
    const Field* field = field_of(key);
    if (field != nullptr && is_of_joint(*field))
        for (std::size_t joint = 1; joint < c.joints.size(); ++joint)
            all.push_back(joint);
    return all;
}

const Field& expected_field(std::string_view key) {
    const Field* field = field_of(key);
    STRIDOR_EXPECT(field != nullptr);
    return *field;
}

// fields of a joint that the last part of a joint's key may mean: "mass", "contact.preload", "F"
std::vector<const Field*> joint_fields_called(const JointKey& key) {
    const std::string_view inner = key.key.starts_with("joint.") ? std::string_view(key.key).substr(6) : key.key;
    std::vector<const Field*> called;
    for (const Field& field : fields())
        if (is_of_joint(field) && (key_of(field) == key.key || short_name(field) == inner || field.symbol == inner))
            called.push_back(&field);
    return called;
}

std::string unknown_of_joint(const JointKey& key) {
    std::vector<std::string> keys;
    for (const Field& field : fields())
        if (is_of_joint(field)) keys.push_back(key_of_joint(field, key.joint));
    const std::vector<std::string_view> views(keys.begin(), keys.end());
    return std::string(base::nearest_name(key_of_joint(key), views));
}

}  // namespace

const Field* field_of(std::string_view key) {
    if (const Field* field = find_field(key)) return field;
    const std::optional<JointKey> named = joint_key(key);
    const Field* field = named ? find_field(named->key) : nullptr;
    return field != nullptr && is_of_joint(*field) ? field : nullptr;
}

std::string key_called(std::string_view name) {
    const std::optional<JointKey> named = joint_key(name);
    if (!named) return key_of(field_named(name));
    const std::vector<const Field*> called = joint_fields_called(*named);
    if (called.size() == 1) return key_of_joint(*called.front(), named->joint);
    const std::string near = unknown_of_joint(*named);
    throw Error(ErrorKind::input, {visible_in_quotes(name) + " is no key of a joint", "",
                                   near.empty() ? "" : "Did you mean " + near + "?"});
}

std::string quantity_key_called(std::string_view name) {
    std::string key = key_called(name);
    if (std::holds_alternative<Quantity>(field_of(key)->kind)) return key;
    throw Error(ErrorKind::input,
                {visible_in_quotes(name) + " is no quantity", "it has names or text instead of numbers", ""});
}

void expect_joint_of(const Case& c, std::string_view key) {
    const std::optional<JointKey> named = joint_key(key);
    if (!named) return;
    const std::vector<std::string> names = joint_names(c);
    if (std::find(names.begin(), names.end(), named->joint) != names.end()) return;
    const std::vector<std::string_view> views(names.begin(), names.end());
    const std::string_view near = base::nearest_name(named->joint, views);
    throw Error(ErrorKind::input, {"there is no joint " + visible_in_quotes(named->joint),
                                   names.size() == 1 ? "this case has one joint" : "",
                                   names.size() == 1 ? "Write " + named->key + "."
                                   : near.empty()    ? "The joints are " + base::listed(names) + "."
                                                     : "Did you mean joint." + std::string(near) + "?"});
}

std::vector<std::string> single_keys(const Case& c, std::string_view key) {
    const Field& field = expected_field(key);
    if (!has_key_of_joint(c, field)) return {key_of(field)};
    std::vector<std::string> keys;
    for (const std::size_t joint : joints_of(c, key))
        keys.push_back(key_at({c, joint}, field));
    return keys;
}

bool overlap(const Case& c, std::string_view a, std::string_view b) {
    const std::vector<std::string> of_a = single_keys(c, a);
    const std::vector<std::string> of_b = single_keys(c, b);
    return std::find_first_of(of_a.begin(), of_a.end(), of_b.begin(), of_b.end()) != of_a.end();
}

std::vector<FieldOfCase> fields_of(const Case& c) {
    std::vector<FieldOfCase> all;
    for (std::size_t joint = 0; joint < c.joints.size(); ++joint)
        for (const Field& field : fields())
            if (has_key_of_joint(c, field)) all.push_back({field, {c, joint}, key_at({c, joint}, field)});
    for (const Field& field : fields())
        if (!has_key_of_joint(c, field)) all.push_back({field, c, key_of(field)});
    return all;
}

std::vector<std::string> keys_of(const Case& c) {
    std::vector<std::string> keys;
    for (const auto& [field, at, key] : fields_of(c))
        if (field.belongs(at)) keys.push_back(key);
    return keys;
}

std::vector<std::string> quantity_keys(const Case& c) {
    std::vector<std::string> keys = keys_of(c);
    std::erase_if(keys, [](const std::string& key) { return !std::holds_alternative<Quantity>(field_of(key)->kind); });
    return keys;
}

bool belongs(const Case& c, std::string_view key) {
    const Field& field = expected_field(key);
    const std::vector<std::size_t> joints = joints_of(c, key);
    return std::any_of(joints.begin(), joints.end(), [&](std::size_t joint) { return field.belongs({c, joint}); });
}

double get_quantity(const Case& c, std::string_view key) {
    const Field& field = expected_field(key);
    return get_quantity({c, joints_of(c, key).front()}, field);
}

namespace {

// the values of each joint that the key is about, as texts
std::vector<std::string> value_texts_of(const Case& c, std::string_view key) {
    const Field& field = expected_field(key);
    std::vector<std::string> texts;
    for (const std::size_t joint : joints_of(c, key))
        texts.push_back(value_text({c, joint}, field));
    return texts;
}

bool are_alike(const std::vector<std::string>& texts) {
    return std::all_of(texts.begin(), texts.end(), [&](const std::string& text) { return text == texts.front(); });
}

}  // namespace

bool has_one_value(const Case& c, std::string_view key) {
    return are_alike(value_texts_of(c, key));
}

void set_quantity(Case& c, std::string_view key, double value) {
    const Field& field = expected_field(key);
    for (const std::string& single : single_keys(c, key))
        if (has_several_joints(c) && temperature_column(c, single) != nullptr)
            throw Error(ErrorKind::input, {single + " cannot be set", "it follows the temperature by a table",
                                           "Set temperature.value instead, or take it out of [temperature]."});
    for (const std::size_t joint : joints_of(c, key)) {
        try {
            set_quantity({c, joint}, field, value);
        } catch (const Error& error) {
            base::Problem problem = error.problem();
            if (problem.what.starts_with(key_of(field)))
                problem.what.replace(0, key_of(field).size(), std::string(key));
            throw Error(error.kind(), std::move(problem));
        }
    }
}

Range range_of(const Case& c, std::string_view key) {
    return range_of(c, expected_field(key));
}

std::string value_text(const Case& c, std::string_view key) {
    const std::vector<std::string> texts = value_texts_of(c, key);
    return are_alike(texts) ? texts.front() : base::listed(texts);
}

}  // namespace stridor::parameters
