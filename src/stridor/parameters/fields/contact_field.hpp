#pragma once

#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/own_structure.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// What a contact of an own structure has: each thing stands here once. The keys of [[structure.contact]], the columns
/// of a table of contacts, their checks, the schema, packed cases, documents and Python are made from it.
namespace stridor::parameters {

/// Where a contact keeps one thing: text, a number, a number that may be missing, a direction over the rows, a place.
using ContactMember =
    std::variant<std::string OwnContact::*, double OwnContact::*, std::optional<double> OwnContact::*,
                 std::vector<double> OwnContact::*, std::optional<std::array<double, 3>> OwnContact::*>;

/// One thing that a contact has. What it is without its key stands in `OwnContact`.
struct ContactField {
    std::string_view key;       // "initial_gap"
    std::string_view unit;      // SI, "1" when dimensionless, empty for text
    std::string_view sentence;  // what it is, one line
    ContactMember member;
    Range range{};  // of a number; its lower end is none or 0
    enum class Need { required, optional } need = Need::optional;
    double Contact::*in_place_of = nullptr;  // the number of [contact] whose place it takes at this contact
    std::string_view only_beside{};          // key of the direction without which it means nothing
};

/// Returns all of them, in the order files list them.
std::span<const ContactField> contact_fields();
/// Those that came later stand behind them: what was kept of a contact without any keeps its hash and its bytes.
inline constexpr std::size_t first_contact_fields = 12;

/// Returns the one with this key; it must be there.
const ContactField& contact_field(std::string_view key);

/// Says whether documents show a field: neither directions nor what belongs to one.
bool is_shown(const ContactField& field);

/// Says whether a value is what a contact has that does not name it.
bool is_usual(const OwnContact& contact, const ContactField& field);

/// What a contact has of it: nothing, text, a number, or several.
using ContactValue = std::variant<std::monostate, std::string, double, std::vector<double>>;
ContactValue value_of(const OwnContact& contact, const ContactField& field);

}  // namespace stridor::parameters
