#pragma once

#include "stridor/io/sound/json_listen.hpp"

#include <string>

namespace stridor::console {

/// What was made audible of which motion, and how loud it is.
std::string listening_text(const io::SoundInfo& info);

}  // namespace stridor::console
