#pragma once

#include "stridor/io/case/complaints.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/parameters/case.hpp"

#include <cstddef>
#include <optional>
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

/// Says whether a key stands in the table. temperature.value is a field of its own.
bool is_temperature_list(std::string_view key);

/// Says whether a document has a table, whole or not.
bool has_temperature_list(const TomlDocument& document);

/// Returns the list that a property follows; nullptr if it follows none.
const TomlEntry* find_temperature_list(const DocumentView& document, std::string_view key);

/// A property of which something is not known: of one of several joints, or of what all share.
struct Untold {
    std::string key;                     // "joint.mass", "plate.damping"
    std::optional<std::size_t> joint{};  // nothing: shared
};

/// Gives a case the table of its document, if that has one; complains of what is wrong with it. Returns the properties
/// that are told of there but could not be read.
std::vector<Untold> read_temperature_table(const TomlDocument& document, parameters::Case& c, Complaints& complaints);

}  // namespace stridor::io
