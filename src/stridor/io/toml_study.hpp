#pragma once

#include "stridor/io/toml_document.hpp"
#include "stridor/sweep/study.hpp"

#include <string>
#include <vector>

namespace stridor::io {

/// Reads a chart: a case and a section [chart] with the axes x and y, the directions and what to draw.
///
///     [chart]
///     x = { parameter = "contact.preload", from = "1 N", to = "3 kN", points = 40, scale = "log" }
///     y = { parameter = "contact.kinetic_friction", from = 0.0, to = 0.8, points = 40 }
///     directions = ["going", "coming"]
///     quantities = ["category"]
///     refine = 3
///     starts = ["rest", "sliding"]
///
/// `parameter`, `from`, `to` and `points` of both axes must be there. Ends are in the unit of the axis's parameter, or
/// text with a unit. The case's own sections must be complete, the axes' keys included: they are its base values.
/// Any of it may be overridden ("chart.x.points=5", "chart.directions=going"). Throws what `read_case` throws.
sweep::Study read_study(const TomlSource& source);

/// The same from a file; "-" is standard input.
sweep::Study read_study(const std::string& path, std::vector<std::string> overrides = {});

}  // namespace stridor::io
