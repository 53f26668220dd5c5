#pragma once

#include "stridor/explorer/world.hpp"
#include "stridor/io/case/toml_document.hpp"

#include <filesystem>

namespace stridor::explorer {

/// Returns the preset of a file that was named when the program started; what the file names is read beside it. Throws
/// `Error` for a file that is not a case.
Preset preset_of(const io::TomlSource& source);

/// Returns the cases of Table 1 and a noise library: the named one, or the user's own if there is one. Throws `Error`
/// for a named one that cannot be opened.
World world_of(const std::filesystem::path& library);

}  // namespace stridor::explorer
