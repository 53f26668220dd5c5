#pragma once

#include "stridor/sweep/study.hpp"

namespace stridor::sweep {

/// Figure 8: categories over preload (2 to 4000 N, log) and kinetic friction (0 to 0.8), going and coming, at a
/// constant velocity of 0.1 m/s, started at rest; 40 by 40 cells. The paper prints no ranges; these show all its areas.
Study figure_8();

/// Figure 6: contact-state rates over velocity (0.01 to 1 m/s, log) and preload (2 to 4000 N, log), going, for an
/// incidence angle of 70 or 150 deg; 30 by 30 cells.
Study figure_6(double incidence_angle);

}  // namespace stridor::sweep
