#pragma once

#include <Eigen/Core>

namespace stridor::model {

/// Returns orthonormal columns that span the space orthogonal to all columns of `blocked`: the motions that constraints
/// leave free. Shape [size, size - columns]; the columns of `blocked` must be linearly independent.
Eigen::MatrixXd orthogonal_complement(const Eigen::MatrixXd& blocked);

/// Returns leftᵀ A right, a matrix of the motion in the coordinates of the free motions; shape [columns of left,
/// columns of right].
Eigen::MatrixXd reduced(const Eigen::MatrixXd& left, const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

}  // namespace stridor::model
