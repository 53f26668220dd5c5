#pragma once

#include "support/effort.hpp"
#include "support/small_study.hpp"

namespace stridor::sweep {

/// 8 by 8 points in two directions, simulated to the end of a second (a tenth in checked builds): some hundredths of a
/// second, and several categories. Refined it has 25 by 25, and computes some of them in rounds.
inline Study swept_study(int refine) {
    Study study = small_study();
    study.base.run.duration = support::effort(1.0, 0.1);
    study.base.run.early_ending = parameters::EarlyEnding::never;
    study.x.points = refine == 0 ? 8 : 25;
    study.y.points = study.x.points;
    study.refine = refine;
    return study;
}

}  // namespace stridor::sweep
