#pragma once

#include <Eigen/Core>

namespace stridor::model {

/// Orthonormal columns that span what is orthogonal to all columns of `blocked`: the motions that constraints leave free.
/// Shape [size, size - columns]; the columns are linearly independent.
Eigen::MatrixXd orthogonal_complement(Eigen::MatrixXd blocked);

}  // namespace stridor::model
