#pragma once

#include "stridor/drawing/scene.hpp"
#include "stridor/sweep/study.hpp"

namespace stridor::pictures {

/// Marks the design a chart was made from, its case's own values of the two axes, in every panel and in the legend: by
/// a diamond, or over one axis by a line. Where it lies outside of the axes, the caption says so instead.
void mark_design(drawing::Scene& scene, const sweep::Study& study);

}  // namespace stridor::pictures
