#pragma once

#include "stridor/noise_library/entry.hpp"

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// The field table of the noise library: each statement of an entry stands here once. Options of `add` and `edit`,
/// filters, columns of the database, JSON keys, CSV columns and completion are all generated from it.
namespace stridor::noise_library {

/// Words. A document is text of many lines that tables leave out.
struct EntryText {
    std::string Entry::*member;
    /// The number of lines, and whether tables show it.
    enum class Shape { line, lines, document } shape = Shape::line;
    std::span<const std::string_view> suggestions{};  // words that others write here; any other word is allowed
};

/// One word from a list, or none.
struct EntryChoice {
    std::string Entry::*member;
    std::span<const std::string_view> names;
};

/// A day, YYYY-MM-DD, or its month or year alone.
struct EntryDate {
    std::string Entry::*member;
};

/// A number with a unit.
struct EntryQuantity {
    double Entry::*member;
    std::string_view unit;  // "1" when dimensionless
    double lowest = -std::numeric_limits<double>::infinity();
    double highest = std::numeric_limits<double>::infinity();
};

/// Who writes a field: the user of the library, or Stridor from the sound itself.
enum class Writer { user, stridor };

/// One statement of an entry.
struct EntryField {
    std::string_view name;      // "velocity_profile"; as an option --velocity-profile
    std::string_view sentence;  // what it is, one line
    std::variant<EntryText, EntryChoice, EntryDate, EntryQuantity> kind;
    Writer writer = Writer::user;
};

/// Returns all fields, in the order in which an entry is shown.
std::span<const EntryField> fields();

/// Returns the field of this name, or null if there is none.
const EntryField* find_field(std::string_view name);

/// Returns "--velocity-profile"
std::string option_of(const EntryField& field);

/// Returns the unit of a field; empty for words.
std::string_view unit_of(const EntryField& field);

/// Says whether a field is text of many lines.
bool is_document(const EntryField& field);

/// Returns the member of a field of words, or of a quantity.
std::string& words_in(Entry& entry, const EntryField& field);
const std::string& words_in(const Entry& entry, const EntryField& field);
double& quantity_in(Entry& entry, const EntryField& field);
double quantity_in(const Entry& entry, const EntryField& field);

/// Returns the quantity that a text means in `unit`: "20 N", "0.02 kN", "-40 degF", "293 K"; `unknown` for "unknown"
/// and an empty text.
///
/// Throws `Error` (input) for any other text.
double parse_value(std::string_view text, std::string_view unit);

/// Sets a field from a user's text; an empty text or "unknown" clears it. Throws `Error` (input) that names the field.
void set_from_text(Entry& entry, const EntryField& field, std::string_view text);

/// Sets a quantity from a number in its unit; throws `Error` (input) if it is out of range.
void set_quantity(Entry& entry, const EntryField& field, double value);

/// Returns the value as a user would write it, with its unit; empty if it is unknown.
std::string value_text(const Entry& entry, const EntryField& field);

/// Says whether a figure may have this name: letters a-z, digits and _, at most 64, and not the name of a field.
bool is_figure_name(std::string_view name);

/// Returns a figure from "name=value unit"; throws `Error` (input).
Figure parse_figure(std::string_view text);

/// Adds a figure, or replaces the one of that name.
void set_figure(Entry& entry, const Figure& figure);

/// Sets a figure from "name=value unit", or clears it by "name=unknown". Throws `Error` (input).
void set_figure_from_text(Entry& entry, const std::string& text);

/// Sets the case that a sound came from. The sound counts as simulated unless the entry says where it was recorded.
void set_case(Entry& entry, std::string_view text);

/// Returns the value of a figure or a quantity by its name; `unknown` if the entry has none.
double number_of(const Entry& entry, std::string_view name);

/// Returns the names of all fields that a predicate accepts.
std::vector<std::string> field_names(bool (*wanted)(const EntryField&));

/// Returns the SHA-256 over the content of an entry without its id: equal for equal entries in any library.
std::string digest(const Entry& entry);

}  // namespace stridor::noise_library
