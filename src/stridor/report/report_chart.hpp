#pragma once

#include "stridor/io/case/toml_document.hpp"
#include "stridor/io/chart/toml_study.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/sweep/study.hpp"

namespace stridor::report {

/// The chart of a report: over the axes asked for, else those of the file, else preload and kinetic friction (or the
/// temperature that it follows). No axis has more than so many points; it has categories alone, and no starts.
///
/// Throws `Error` (input) for one axis alone, and what reading a study throws.
sweep::Study chart_to_report(const io::TomlSource& source, const parameters::Case& c, io::AxisTexts axes, int points);

}  // namespace stridor::report
