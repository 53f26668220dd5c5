#pragma once

#include "stridor/analysis/stability_scan.hpp"
#include "stridor/drawing/scene.hpp"

namespace stridor::pictures {

/// Frequencies and growth rates of the sliding modes over the quantity that the scan follows, a column per direction:
/// where two frequencies meet and one growth rate turns positive, modes couple. The ground under unstable sliding is
/// tinted and the path's boundaries are named.
drawing::Scene stability(const analysis::StabilityScan& scan);

}  // namespace stridor::pictures
