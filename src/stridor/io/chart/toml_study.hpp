#pragma once

#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/sweep/study.hpp"

#include <string>
#include <vector>

namespace stridor::io {

/// The axes that a command line gives (`read_axis_text`). Both empty: as the file has them. x alone: a diagram over x,
/// whatever the file's y. y alone: beside the file's x.
struct AxisTexts {
    std::string x;
    std::string y;
};

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
/// `parameter`, in any spelling of `parameters::key_called`, `from`, `to` and `points` of both axes must be there;
/// without any of y it is a diagram over x alone (`sweep::resting_axis`). Ends are in the unit of the axis's
/// parameter, or text with a unit. The case's own sections must be complete, the axes' keys included: they are its base
/// values. Any of it may be overridden ("chart.x.points=5", "chart.directions=going"). Axes given beside it take the
/// place of the file's, which then needs no [chart]. Throws what `read_case` throws.
sweep::Study read_study(const TomlSource& source, const AxisTexts& axes = {});

/// The same of a document that is parsed already.
sweep::Study read_study(const TomlDocument& document, const AxisTexts& axes = {}, const CaseReaders& readers = {});

/// The same from a file; "-" is standard input.
sweep::Study read_study(const std::string& path, std::vector<std::string> overrides = {});

}  // namespace stridor::io
