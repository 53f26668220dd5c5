#pragma once

#include "stridor/hearing/cell_sound.hpp"
#include "stridor/hearing/hearing.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What was heard as text, to be kept while a long evaluation or search goes on: read back it is the same, bit for bit.
namespace stridor::hearing {

/// The text of one sound.
std::string packed(const CellSound& sound);

/// The text of several.
std::string packed(std::span<const HeardSound> sounds);

/// The sound of such a text; nothing for text that is none.
std::optional<CellSound> unpacked_cell_sound(std::string_view text);

/// Likewise, of several.
std::optional<std::vector<HeardSound>> unpacked_heard_sounds(std::string_view text);

}  // namespace stridor::hearing
