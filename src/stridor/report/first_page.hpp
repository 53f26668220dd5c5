#pragma once

#include "stridor/report/design_results.hpp"
#include "stridor/report/html.hpp"

namespace stridor::report {

/// Returns the sheet that is handed over alone: the particulars, the headline, the verdict of each direction with the
/// nearest change that ends it, the chart with the design's mark, and the advised change. All else of the report is
/// empty.
///
/// Throws `Error` (io) if a picture cannot be drawn: no font is installed.
Report first_page(const DesignResults& results);

}  // namespace stridor::report
