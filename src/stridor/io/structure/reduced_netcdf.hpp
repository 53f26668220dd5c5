#pragma once

#include "stridor/io/structure/part_files.hpp"
#include "stridor/reduction/reduction.hpp"

#include <string>
#include <string_view>

namespace stridor::io {

/// Writes a reduced part (schema stridor.structure/1): rows with node and component, matrices, places, sets, recovery
/// rows, in SI. `origin` names its source files. Throws `Error` (io).
void write_reduced_part(const std::string& path, const reduction::Reduction& reduction, const std::string& origin);

/// Says whether a file begins as netCDF-4, which is HDF5.
bool is_netcdf(std::string_view beginning);

/// Says whether these files are a single one that holds a reduced part. Throws `Error` (io) if it cannot be opened.
bool is_reduced_part(const PartFiles& files);

/// Reads such a file. The library works in a process of its own that may do nothing else (base/child_process); what
/// it answers is checked. Throws `Error` (input) for a file that is no reduced part, or is damaged.
reduction::Reduction read_reduced_part(const std::string& path);

}  // namespace stridor::io
