#pragma once

#include "stridor/analysis/stability_scan.hpp"
#include "stridor/classification/verdict.hpp"
#include "stridor/integration/motion.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/report/html.hpp"
#include "stridor/sweep/advice.hpp"
#include "stridor/sweep/cell.hpp"

#include <optional>
#include <string>
#include <vector>

namespace stridor::report {

/// What a report on one design is made from; what was not computed is left out.
struct DesignResults {
    parameters::Case design;
    std::string command{};                            // that prints the verdict again
    integration::Motion motion{};                     // with trace and history for the figure
    std::vector<classification::Verdict> verdicts{};  // by phase
    std::optional<sweep::SweepResult> chart{};
    std::optional<analysis::StabilityScan> stability{};
    std::optional<sweep::Advice> advice{};
};

/// Verdict, motion, chart, stability, what keeps it quiet, the parameters, and how to get it all again.
///
/// Throws `Error` (io) where gnuplot is missing.
Report design_report(const DesignResults& results);

}  // namespace stridor::report
