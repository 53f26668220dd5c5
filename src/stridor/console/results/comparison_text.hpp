#pragma once

#include "stridor/classification/compared_sound.hpp"

#include <span>
#include <string>

namespace stridor::console {

/// A row per figure, a column per sound, and the distances of all from the first.
std::string comparison_text(std::span<const classification::ComparedSound> sounds);

}  // namespace stridor::console
