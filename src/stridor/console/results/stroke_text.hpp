#pragma once

#include "stridor/sweep/strokes.hpp"

#include <string>

namespace stridor::console {

/// Returns a history of strokes as text: its stretches of one verdict with what heats and wears meanwhile, and why it
/// ended before its last stroke.
std::string stroke_text(const sweep::StrokeHistory& history);

}  // namespace stridor::console
