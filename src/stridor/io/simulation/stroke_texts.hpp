#pragma once

#include "stridor/sweep/strokes.hpp"

#include <string>

namespace stridor::io {

/// Returns the computed strokes of a history as a table: a row for each stroke and direction, with all figures of a
/// cell.
std::string strokes_csv(const sweep::StrokeHistory& history);

/// Returns them as one JSON document, "stridor.strokes/1".
std::string strokes_json(const sweep::StrokeHistory& history);

}  // namespace stridor::io
