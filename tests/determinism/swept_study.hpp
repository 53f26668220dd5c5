#pragma once

#include "unit/sweep/small_study.hpp"

namespace stridor::sweep {

/// 8 by 8 points in two directions, simulated to the end of a second: some hundredths of a second, and several categories.
inline Study swept_study() {
    Study study = small_study();
    study.base.run.duration = 1.0;
    study.base.run.early_ending = parameters::EarlyEnding::never;
    study.x.points = 8;
    study.y.points = 8;
    return study;
}

}  // namespace stridor::sweep
