#pragma once

#include "stridor/report/design_results.hpp"
#include "stridor/report/html.hpp"

namespace stridor::report {

/// Returns the report: verdict, sound, chart, advice, motion, stability, the case, and how to repeat it all; parts that
/// were not computed are left out.
///
/// Throws `Error` (io) if a picture cannot be drawn: no font is installed.
Report design_report(const DesignResults& results);

}  // namespace stridor::report
