#pragma once

#include "stridor/parameters/fields/field.hpp"

#include <string>
#include <string_view>
#include <vector>

/// What users call fields. Wherever a key is taken, it is taken in any of three spellings and shown in the first: the
/// key ("contact.kinetic_friction"), its last part ("kinetic_friction"), the symbol ("mu_d"). The last part of
/// temperature.value is "temperature".
namespace stridor::parameters {

/// Returns the last part of a key; of temperature.value, which is the value of its section, "temperature".
std::string_view short_name(const Field& field);

/// Returns the fields a name may mean: the one with that key, else all whose last part or symbol it is, those of
/// builders only where there are no others; none if it is unknown.
std::vector<const Field*> fields_called(std::string_view name);

/// Returns the field a name means. Throws `Error` (input) without a place for a name that none has, with the most
/// similar key, and for one that several have ("mass"), with their keys.
const Field& field_named(std::string_view name);

/// Returns the quantity a name means. Throws `Error` (input) as `field_named` does, and for a field that is no
/// quantity.
const Field& quantity_named(std::string_view name);

/// Returns the key or keys ("a or b") a misspelt name was meant to be: of its own section those that end alike, else
/// the one whose last part or symbol the name ends in, else the nearest key or last part; empty if none is near.
std::string similar_key(std::string_view name);

}  // namespace stridor::parameters
