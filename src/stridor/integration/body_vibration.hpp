#pragma once

#include "stridor/model/structure.hpp"
#include "stridor/record/tally.hpp"

#include <Eigen/Core>

#include <vector>

namespace stridor::integration {

/// Adds velocities [m/s], shape [channel], that stand for a stretch of time [s]. Peaks are of whole bodies, whose
/// channels stand one after the other.
void add_vibration(const model::Structure& structure, const Eigen::Ref<const Eigen::VectorXd>& speed, double duration,
                   std::vector<record::Vibration>& vibration);

}  // namespace stridor::integration
