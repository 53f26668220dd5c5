#pragma once

#include <string>
#include <vector>

namespace stridor::io {

/// Returns the names of the files that the program brings along: the cases of Table 1, the ready charts, "two-lips", a
/// case with several joints, and "schema", the JSON Schema of case files.
std::vector<std::string> ready_file_names();

/// Returns the text of such a file, with comments; the name is one of them.
std::string ready_file(const std::string& name);

/// Throws `Error` (input) for a file that holds what somebody wrote: neither nothing nor a ready file.
void spare_written(const std::string& file);

}  // namespace stridor::io
