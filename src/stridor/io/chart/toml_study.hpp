#pragma once

#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/sweep/study.hpp"

#include <string>
#include <vector>

namespace stridor::io {

/// The axes on a command line (`read_axis_text`). Both empty: those of the file. x alone: a diagram over x, whatever
/// the file's y. y alone: beside the file's x.
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
/// without any of y it is a diagram over x alone (`sweep::resting_axis`). Ends are in the unit of the axis's parameter,
/// or text with a unit. The case's own sections must be complete, the axes' keys included: they are its base values.
/// Every value may be overridden ("chart.x.points=5", "chart.directions=going"). Axes given beside the file replace its
/// own; then it needs no [chart]. Throws what `read_case` throws.
sweep::Study read_study(const TomlSource& source, const AxisTexts& axes = {});

/// Reads a chart from a parsed document. Throws what `read_case` throws.
sweep::Study read_study(const TomlDocument& document, const AxisTexts& axes = {}, const CaseReaders& readers = {});

/// Reads a chart from a file; "-" is standard input. Throws what `read_case` throws.
sweep::Study read_study(const std::string& path, std::vector<std::string> overrides = {});

}  // namespace stridor::io
