#pragma once

#include "stridor/io/case/complaints.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/parameters/case.hpp"

#include <string>
#include <string_view>
#include <vector>

/// The table in [temperature]: `at` and a list for each property that follows the temperature, by a name of its field.
///
///     [temperature]
///     value = "-10 degC"
///     at = ["-30 degC", "23 degC", "80 degC"]
///     joint.axial_stiffness = ["60 N/mm", "25 N/mm", "12 N/mm"]
///     mu_d = [0.7, 0.9, 1.1]
namespace stridor::io {

/// Does a key stand in the table? temperature.value is a field of its own.
bool is_temperature_list(std::string_view key);

/// Does a document have a table, whole or not?
bool has_temperature_list(const TomlDocument& document);

/// The list that a property follows; nullptr if it follows none.
const TomlEntry* find_temperature_list(const TomlDocument& document, std::string_view key);

/// Gives a case the table of its document, if that has one; complains of what is wrong with it. Returns the keys of the
/// properties that are told of there but could not be read.
std::vector<std::string> read_temperature_table(const TomlDocument& document, parameters::Case& c,
                                                Complaints& complaints);

}  // namespace stridor::io
