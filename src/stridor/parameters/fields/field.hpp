#pragma once

#include "stridor/parameters/case.hpp"

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// The field table: each thing a user can set stands here once. TOML keys, `--set`, chart axes, help, files and
/// the canonical text of a case are all generated from it.
namespace stridor::parameters {

/// Which values of a quantity make sense; both ends belong to it unless they are open.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    /// Does the lower end belong to it?
    enum class Low { closed, open } low_end = Low::closed;
    /// Does zero? Where it does not, a chart may run through it: the cell is refused, as `findings` says, not the axis.
    enum class Zero { allowed, excluded } zero = Zero::allowed;
};

/// How the values of an axis are spaced.
enum class Scale { linear, logarithmic };

inline constexpr std::array<std::string_view, 2> scale_names{"linear", "log"};

/// Between which values a designer looks for a better one, and on which scale steps there are alike.
///
/// Much narrower than what `Range` allows: the spans of the published charts (Elmaian et al. 2012, Figures 6 and 8)
/// where there are any, else about a factor of ten to both sides of Table 1, whose four cases lie within. Of an imposed
/// velocity it is the magnitude; its sign says which way the plate moves.
struct UsualRange {
    double from = 0.0;  // in the quantity's unit, below `to`, above 0 if logarithmic
    double to = 1.0;
    Scale scale = Scale::linear;
};

/// A number with a unit.
struct Quantity {
    std::string_view unit;  // SI, angles in deg, "1" when dimensionless
    Range range;
    double (*get)(CaseView);
    void (*set)(CaseToSet, double value);
    std::optional<UsualRange>
        usual{};  // of what a designer may vary; nothing for settings of the computation or verdict
};

/// One name out of a list.
struct Choice {
    std::span<const std::string_view> names;
    int (*get)(CaseView);
    void (*set)(CaseToSet, int index);
    // `unless_first`: a later choice is left out of the canonical text if it is the first name, so that cases from
    // before it keep their hash
    enum class Canonical { always, unless_first } canonical = Canonical::always;
};

/// Free text.
struct Text {
    std::string (*get)(CaseView);
    void (*set)(CaseToSet, std::string_view text);
    // a file is opened: who is not trusted may not name one; numbers decide the motion
    enum class Means { words, file, numbers } means = Means::words;
    std::string_view example{};  // of what a case without one may say; empty: none
};

/// One settable thing.
struct Field {
    std::string_view section;   // "contact"; empty for the title
    std::string_view name;      // "kinetic_friction"
    std::string_view symbol;    // "mu_d", as in the paper; may be empty
    std::string_view sentence;  // what it is, one line
    std::variant<Quantity, Choice, Text> kind;
    bool (*belongs)(CaseView);  // does it mean anything for this case? (drive.velocity only with a constant drive)
};

/// Returns all fields, sections together, in the order files list them.
std::span<const Field> fields();

/// Says whether it is a number from which a builder makes a structure. A case file has it among the lines of
/// [structure].
bool is_of_builder(const Field& field);

/// Says whether it is a part of a given start, which is 0 where it is not said.
bool is_of_start(const Field& field);

/// Returns the field with key "section.name" (or "title"); nothing if there is none.
const Field* find_field(std::string_view key);

/// Returns "section.name", or the name alone for a field without a section.
std::string key_of(const Field& field);

/// Returns keys of the fields that are quantities, i.e. can be an axis.
std::vector<std::string> quantity_keys();

/// Returns the key most like a misspelt one; empty if none is near.
std::string nearest_key(std::string_view key);

/// Returns the unit of a quantity; "1" for a field without one.
std::string_view unit_of(const Field& field);
/// Returns the unit of the quantity with that key, also of a joint ("joint.lip2.mass"); "1" for an unknown key.
std::string_view unit_of(std::string_view key);

/// One choice that gives a field a meaning: the field of it, and which of its names.
struct Home {
    const Field* choice;
    std::string_view name;
};

/// Returns the choices of which each alone would give a field a meaning in a case that is otherwise as this.
std::vector<Home> homes_of(CaseView at, const Field& field);

/// Returns these choices in words: "drive.kind = "sinusoidal" or "sampled""; empty if there are none
/// (temperature.value).
std::string home_of(CaseView at, const Field& field);

/// Says whether its value is the name of a file that is opened.
bool names_file(const Field& field);

/// Returns the value of a quantity in its unit. The field must be a quantity.
double get_quantity(CaseView at, const Field& field);

/// Returns what a quantity may be in this case: the field's range; for a temperature that has a table, the table's.
Range range_of(CaseView at, const Field& field);

/// Throws `Error` (input) without a place for a value that a quantity may not be.
void expect_in_range(CaseView at, const Field& field, double value);

/// Says whether a field is a choice that was added later and has its first value: stored cases leave it out.
bool goes_without_saying(CaseView at, const Field& field);

/// Sets a quantity, in its unit. With the temperature it sets what follows it by table, and with any of these the
/// dampings that are shares of critical (`PlateJoint`); a damping that is set itself is a share no more. Throws
/// `Error` (input) without a place for a value out of range, and for a quantity that follows the temperature.
void set_quantity(CaseToSet at, const Field& field, double value);

/// Sets a field from what a user wrote ("20 N", "0.6", "sinusoidal"); throws `Error` (input) without a place. Of the
/// three dampings that may be "15 %" or "damping ratio 0.15", a share of critical, or "loss factor 0.3", which is twice
/// that.
void set_from_text(CaseToSet at, const Field& field, std::string_view text);

/// Returns the share of critical that a damping is known as [1]; nothing for other fields and dampings in N*s/m.
std::optional<double> damping_ratio(CaseView at, const Field& field);

/// Returns the value as a user would write it, with its unit: "20 N", "sinusoidal", "damping ratio 0.15".
std::string value_text(CaseView at, const Field& field);

/// Returns every field that belongs to this case as "section.key = value unit", a line each, shortest round-trip
/// numbers. Of several joints each has lines of its own, "joint.lip2.contact.preload = 20 N". Two cases that would run
/// alike have the same text, whatever files they came from; a sampled drive and an own structure are named by a hash.
/// What follows the temperature is its whole table: "temperature.at = -30 degC, 80 degC",
/// "temperature.joint.axial_stiffness = 60000 N/m, 12000 N/m".
std::string canonical_text(const Case& c);

}  // namespace stridor::parameters
