#pragma once

#include "stridor/parameters/case.hpp"
#include "stridor/parameters/fields/field.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Friction coefficients of a pair of materials, and other numbers of its law of friction, over the temperature, the
/// humidity of the air and the load.
///
/// Rigs measure a full plan: each temperature with each humidity and each load. So the points form a grid, and between
/// them a number is linear in each of the three; at a point it is the table's own. Outside of the grid nothing is
/// known, and such a case is refused. The load is the preload of the contact. The law itself is the case's.
namespace stridor::parameters {

/// One point of a pair as measured.
struct PairRow {
    std::optional<double> temperature{};        // [degC]
    std::optional<double> humidity{};           // [1] relative
    std::optional<double> load{};               // [N]
    std::optional<double> static_friction{};    // [1] mu_s; each row has both
    std::optional<double> kinetic_friction{};   // [1] mu_d
    std::optional<double> friction_slope{};     // [s/m] numbers of a law, as those of Contact
    std::optional<double> stribeck_velocity{};  // [m/s]
    std::optional<double> stribeck_exponent{};  // [1]
    std::optional<double> viscous_friction{};   // [s/m]
    std::optional<double> rest_growth{};        // [1]
};

/// A column of the rows of a pair: a condition, or a number that the case has at it.
struct PairColumn {
    std::string_view name;
    std::string_view unit;
    std::string_view field;
    std::vector<double> MaterialPair::*values;
    std::optional<double> PairRow::*in_row;
    double Contact::*follows = nullptr;  // null: a condition
};

/// Returns what numbers may depend on: temperature, humidity and load.
std::span<const PairColumn> pair_conditions();

/// Returns the numbers of a pair: the two coefficients, which each has, and then those of laws.
std::span<const PairColumn> pair_coefficients();

/// Makes the grid of a pair out of its rows, in any order. Throws `Error` (input) without a place for rows that say
/// other conditions or numbers than the first, for a point that is there twice, and for one that is missing.
MaterialPair pair_of_rows(std::span<const PairRow> rows);

/// Returns "temperature: 23, 80; static_friction: 0.8, 0.7; kinetic_friction: 0.6, 0.5", the whole table; "pairs.toml:
/// EPDM on glass" where the file is not read yet.
std::string material_pair_text(const MaterialPair& pair);

/// Reads the whole table as text. A text without a semicolon names a file and a pair in it, which is not opened here.
/// Throws `Error` (input) without a place for a table that is no grid or has negative numbers.
MaterialPair parse_material_pair(std::string_view text);

/// Says whether this is the text of a whole table, which needs no file.
bool is_whole_pair(std::string_view text);

/// A file, and a pair in it.
struct NamedPair {
    std::string file;
    std::string name;
};

/// Returns what a text names: "pairs.toml: EPDM on glass". Throws `Error` (input) without a place for
/// a text that names none.
NamedPair named_pair(std::string_view text);

/// Says whether a field of a case follows a table, of a pair or of the temperature. Such a number cannot be set.
bool follows_table(CaseView at, const Field& field);
bool follows_table(const Case& c, std::string_view key);

/// Says whether a field follows the table of a pair.
bool follows_pair(CaseView at, const Field& field);

/// Returns the nodes of a pair over a field: temperature.value, contact.humidity or contact.preload; empty for others,
/// and where the pair does not depend on it.
std::span<const double> pair_nodes(const MaterialPair& pair, const Field& field);

/// Sets the coefficients of each joint that has a pair, and the other numbers that the pair has, to their values at the
/// present conditions. A condition outside of the grid counts as its nearer end; `findings` refuses it.
void keep_pairs(Case& c);

}  // namespace stridor::parameters
