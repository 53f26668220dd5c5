#pragma once

#include "unit/sweep/small_study.hpp"

namespace stridor::sweep {

/// 8 by 8 points in two directions, 5000 steps each: some hundredths of a second, and several categories.
inline Study swept_study() {
    Study study = small_study();
    study.base.run.step = 4e-6;
    study.x.points = 8;
    study.y.points = 8;
    return study;
}

}  // namespace stridor::sweep
