#pragma once

#include "stridor/report/design_results.hpp"
#include "stridor/report/html.hpp"

namespace stridor::report {

/// Verdict, sound, chart, what to change, motion, stability, the case, and how to get it all again; what was not
/// computed is left out.
///
/// Throws `Error` (io) where a picture cannot be drawn: no font is installed.
Report design_report(const DesignResults& results);

}  // namespace stridor::report
