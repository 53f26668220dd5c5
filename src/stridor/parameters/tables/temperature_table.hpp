#pragma once

#include "stridor/parameters/case.hpp"
#include "stridor/parameters/fields/field.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Properties that follow the temperature by table: a rubber is several times as stiff in the cold as in the heat.
///
/// Between two nodes a property is linear in the temperature, at a node it is the table's own number. Outside of the
/// table nothing is known, and such a temperature is refused.
namespace stridor::parameters {

/// Returns keys of the quantities that may follow the temperature, in the order of the field table: stiffnesses,
/// dampings and friction coefficients.
std::span<const std::string_view> keys_over_temperature();

/// Says whether anything of this case follows the temperature.
bool has_temperature_table(const Case& c);

/// Returns the column of a key; nullptr if that quantity does not follow the temperature. Of several joints each has
/// columns of its own, "joint.lip2.axial_stiffness"; "joint.axial_stiffness" is the first of them there.
const TemperatureColumn* temperature_column(const Case& c, std::string_view key);

/// Returns the column of a field, of several joints that of this one.
const TemperatureColumn* temperature_column(CaseView at, const Field& field);

/// Returns a column out of texts as `set_from_text` takes them: "60 N/mm", "0.7"; a damping may be "15 %" at all nodes.
/// Throws `Error` (input) without a place for a value the field does not take, and for shares among other dampings.
TemperatureColumn read_temperature_column(const Field& field, std::span<const std::string> texts);

/// Nodes out of texts: "-30 degC". Throws `Error` (input) without a place for fewer than two, and for nodes that do not
/// rise.
std::vector<double> read_temperature_nodes(std::span<const std::string> texts);

/// Throws `Error` (input) without a place for a column that has not one value at each node.
void check_length(const TemperatureColumn& column, std::size_t nodes);

/// Gives a case its table. Of several joints columns have keys with names and stand joint by joint, the plate's behind
/// them. A temperature outside of it becomes that of its nearer end.
/// Throws `Error` (input) without a place for columns that are not as long as there are nodes, for a table without
/// columns, and for two columns of one quantity.
void set_temperature_table(Case& c, std::vector<double> at, std::vector<TemperatureColumn> columns);

/// Sets the properties that follow the temperature, of each joint, to their values at the present one. Dampings that
/// are given as shares of critical follow later (`keep_damping_ratios`).
void keep_temperature_table(Case& c);

/// Returns the nodes as a user would write them: "-30 degC".
std::vector<std::string> node_texts(const Case& c);
/// Returns the values of a column as a user would write them: "60000 N/m", "damping ratio 0.15".
std::vector<std::string> value_texts(const TemperatureColumn& column);

}  // namespace stridor::parameters
