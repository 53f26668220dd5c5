#pragma once

#include "stridor/io/structure/part_files.hpp"
#include "stridor/reduction/reduction.hpp"

#include <string>
#include <string_view>

namespace stridor::io {

/// Writes a reduced part (schema stridor.structure/1): rows with node and component, matrices, places, sets, recovery
/// rows, in SI. `origin` tells the files it was made from. Throws `Error` (io).
void write_reduced_part(const std::string& path, const reduction::Reduction& reduction, const std::string& origin);

/// Does a file begin as netCDF-4, which is HDF5?
bool is_netcdf(std::string_view beginning);

/// Do these name one file alone, and that a reduced part's? Throws `Error` (io) where it cannot be opened.
bool is_reduced_part(const PartFiles& files);

/// Reads such a file. The library works in a process of its own that may do nothing else (base/child_process); what
/// it answers is checked. Throws `Error` (input) for a file that is no reduced part, or is damaged.
reduction::Reduction read_reduced_part(const std::string& path);

}  // namespace stridor::io
