#pragma once

#include "stridor/parameters/case.hpp"

#include <string>

namespace stridor::io {

/// Reads the coefficients of a pair of materials from a TOML file: its rows are the `[[pair]]` tables of that name.
///
/// A row has name, source, static_friction and kinetic_friction, and what it was measured at of temperature, humidity
/// and load; numbers are degC, shares, N; text carries its unit. Other rows are not looked at. Throws `Error` (input)
/// with file, line and column for a file without such a row, a key that a row does not have, a value that is none, and
/// rows that make no grid (`parameters::pair_of_rows`); `Error` (io) for a file that cannot be read.
parameters::MaterialPair read_material_pair(const std::string& path, const std::string& name);

}  // namespace stridor::io
