#pragma once

#include "stridor/advice/design_space.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/io/chart/toml_study.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/sweep/study.hpp"

namespace stridor::report {

/// The chart of a report: over the axes asked for, else those of the file, else preload and kinetic friction (or the
/// temperature that it follows) within their usual ranges. No axis has more than so many points; it has categories
/// alone, of the same directions and starts as the design is judged by.
///
/// Throws `Error` (input) for one axis alone, and what reading a study and `advice::design_space` throw.
sweep::Study chart_to_report(const io::TomlSource& source, const parameters::Case& c, io::AxisTexts axes, int points,
                             const advice::AskedRuns& runs = {});

/// Gives a chart the directions and starts by which a design is judged.
void judge_alike(sweep::Study& study, const advice::DesignSpace& space);

}  // namespace stridor::report
