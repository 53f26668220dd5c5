#pragma once

#include "stridor/sweep/cell.hpp"

#include <string>

namespace stridor::io {

/// Returns an axis with its unit and its values: {"parameter": "contact.preload", "unit": "N", ..., "values": [...]}.
std::string axis_json(const sweep::Axis& axis);

/// Returns "stridor.chart/1": case, axes with their values, and an array per figure in the order direction, y, x (x
/// fastest). Only done cells have a category, and only computed ones figures; the others have null, and a message if
/// they are not done. Then come the lines between the categories.
std::string chart_json(const sweep::SweepResult& result);

}  // namespace stridor::io
