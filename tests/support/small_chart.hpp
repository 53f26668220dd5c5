#pragma once

#include "stridor/parameters/case.hpp"
#include "stridor/sweep/study.hpp"

namespace stridor::sweep {

/// 4 by 3 points in two directions, 20 ms each; preloads from 2 to 400 N meet several categories.
inline Study small_study() {
    Study study;
    study.base.drive.kind = parameters::DriveKind::constant;
    study.base.drive.velocity = 0.1;
    study.base.run.duration = 0.02;
    study.base.run.window = 0.01;
    study.x = {"contact.preload", 2.0, 400.0, 4, sweep::Scale::logarithmic};
    study.y = {"contact.kinetic_friction", 0.1, 0.8, 3, sweep::Scale::linear};
    return study;
}

}  // namespace stridor::sweep
