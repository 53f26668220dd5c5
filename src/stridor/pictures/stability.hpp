#pragma once

#include "stridor/analysis/stability_scan.hpp"
#include "stridor/drawing/scene.hpp"

namespace stridor::pictures {

/// Draws frequencies and growth rates of the sliding modes over the quantity of the scan, a column per direction. Modes
/// couple where two frequencies meet and one growth rate turns positive. The ground under unstable sliding is tinted,
/// and the path's boundaries are named.
drawing::Scene stability(const analysis::StabilityScan& scan);

}  // namespace stridor::pictures
