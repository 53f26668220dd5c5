#pragma once

#include "stridor/chart/scene.hpp"
#include "stridor/sweep/study.hpp"

namespace stridor::chart {

/// Marks the design a chart was made from, its case's own values of the two axes, in every panel and in the legend: by
/// a diamond, or over one axis by a line. Where it lies outside of the axes, the caption says so instead.
void mark_design(Scene& scene, const sweep::Study& study);

}  // namespace stridor::chart
