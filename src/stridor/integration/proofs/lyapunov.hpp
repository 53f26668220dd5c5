#pragma once

#include "stridor/base/decompositions.hpp"

#include <Eigen/Core>

namespace stridor::integration {

/// Solves A'X + X A = -Q for many symmetric Q by one Schur decomposition of A, at O(n³) each. Source: Bartels and
/// Stewart (1972), Comm. ACM 15, 820.
class Lyapunov {
public:
    explicit Lyapunov(const Eigen::MatrixXd& a);

    /// X, symmetric. Not finite where two eigenvalues of A add up to zero.
    Eigen::MatrixXd solve(const Eigen::MatrixXd& q) const;

private:
    Eigen::ComplexSchur<Eigen::MatrixXd> schur_;
};

}  // namespace stridor::integration
