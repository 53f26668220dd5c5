#include "stridor/integration/proofs/lyapunov.hpp"

namespace stridor::integration {

Lyapunov::Lyapunov(const Eigen::MatrixXd& a) : schur_(a) {}

// A = U T U*, X = U Y U*: T* Y + Y T = -U* Q U, column by column from the left
Eigen::MatrixXd Lyapunov::solve(const Eigen::MatrixXd& q) const {
    const Eigen::MatrixXcd& t = schur_.matrixT();
    const Eigen::MatrixXcd& u = schur_.matrixU();
    const Eigen::Index n = t.rows();
    const Eigen::MatrixXcd right = -(u.adjoint() * q * u);
    Eigen::MatrixXcd y(n, n);
    Eigen::MatrixXcd lower = t.adjoint();
    for (Eigen::Index j = 0; j < n; ++j) {
        Eigen::VectorXcd column = right.col(j);
        if (j > 0) column -= y.leftCols(j) * t.col(j).head(j);
        lower.diagonal() = t.diagonal().conjugate().array() + t(j, j);
        y.col(j) = lower.triangularView<Eigen::Lower>().solve(column);
    }
    const Eigen::MatrixXd x = (u * y * u.adjoint()).real();
    return 0.5 * (x + x.transpose());
}

}  // namespace stridor::integration
