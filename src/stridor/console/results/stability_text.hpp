#pragma once

#include "stridor/analysis/stability_scan.hpp"
#include "stridor/sweep/cell.hpp"
#include "stridor/sweep/run.hpp"
#include "stridor/sweep/study.hpp"

#include <string>

namespace stridor::console {

/// Returns modes of steady sliding in both directions; along a parameter its boundaries and a table, too.
std::string stability_text(const analysis::StabilityScan& scan);

/// Returns "from 3 starts: agree 60  quiet unless disturbed 4": whether the starts agree, if there are any.
std::string starts_text(const sweep::SweepResult& result);

/// Returns "the design lies outside of the chart: contact.preload = 50 N, contact.kinetic_friction = 0.6"
std::string outside_text(const sweep::Study& study);

/// Returns which cells have no result, with the command that runs the first of them alone, without a line end; empty if
/// all have one.
std::string failures_text(const sweep::SweepResult& result, const std::string& chart_file);

/// Returns how many cells a chart has, computed and of each category.
std::string cells_text(const sweep::SweepResult& result);

}  // namespace stridor::console
