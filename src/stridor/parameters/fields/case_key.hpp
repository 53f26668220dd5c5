#pragma once

#include "stridor/parameters/fields/field.hpp"

#include <string>
#include <string_view>
#include <vector>

/// Keys of a case. "joint.lip2.contact.preload" is a field of one of several joints; "contact.preload" is that of all
/// of them at once, and of the only joint where there is one.
namespace stridor::parameters {

/// Returns the field that a key is about, whosever it is: of "joint.lip2.contact.preload" that of "contact.preload";
/// nothing for no key.
const Field* field_of(std::string_view key);

/// Returns the full key that a name means, in any spelling of `field_named`; below a joint's name too: "joint.lip2.F"
/// is "joint.lip2.contact.preload". Whether a case has that joint is not asked. Throws as `field_named` does.
std::string key_called(std::string_view name);

/// Returns the full key of the quantity that a name means. Throws `Error` (input) as `key_called` does, and for a field
/// that is no quantity.
std::string quantity_key_called(std::string_view name);

/// Throws `Error` (input) without a place for a key of a joint that the case does not have.
void expect_joint_of(const Case& c, std::string_view key);

/// Returns the keys that this one sets, as `canonical_text` writes them: of a key of [joint] or [contact] where there
/// are several joints, that of each; else one. The joint must be there (`expect_joint_of`).
std::vector<std::string> single_keys(const Case& c, std::string_view key);

/// Says whether two keys set something in common.
bool overlap(const Case& c, std::string_view a, std::string_view b);

/// A field as a case has it: each of several joints has its own.
struct FieldOfCase {
    const Field& field;
    CaseView at;
    std::string key;  // "joint.lip2.contact.preload"
};

/// Returns all fields of a case, whether they mean anything for it or not: joint by joint, then those that are shared.
std::vector<FieldOfCase> fields_of(const Case& c);

/// Returns keys of what belongs to a case, each of several joints with its own.
std::vector<std::string> keys_of(const Case& c);
/// Returns the keys of its quantities.
std::vector<std::string> quantity_keys(const Case& c);

/// Says whether a key means anything for this case, or for one of the joints that it is about.
bool belongs(const Case& c, std::string_view key);

/// Returns the value of a quantity in its unit; of several joints with different ones that of the first
/// (`has_one_value`).
double get_quantity(const Case& c, std::string_view key);

/// Says whether the value is the same for all joints that the key is about.
bool has_one_value(const Case& c, std::string_view key);

/// Sets a quantity as the other `set_quantity` does, of each joint that the key is about.
void set_quantity(Case& c, std::string_view key, double value);

/// Returns `range_of` by key.
Range range_of(const Case& c, std::string_view key);

/// Returns `value_text` by key; of joints with different values all of them, in the order of the joints.
std::string value_text(const Case& c, std::string_view key);

}  // namespace stridor::parameters
