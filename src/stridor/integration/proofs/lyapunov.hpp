#pragma once

#include "stridor/base/decompositions.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

/// Lyapunov's direct method, by which a contact state is proven to last: with e' = A e and A'P + P A <= 0 the number
/// e.P e never grows, so that each linear functional c of e stays below sqrt(c.P⁻¹c) sqrt(e.P e) for ever.
namespace stridor::integration {

/// What a number e.P e that never grows bounds.
template <typename Matrix>
class LastingBound {
public:
    LastingBound() = default;
    explicit LastingBound(const Matrix& p) : p_(p), factor_(p) {}

    /// Returns whether P is positive definite; else it bounds nothing.
    bool is_definite() const { return p_.allFinite() && factor_.info() == Eigen::Success; }

    /// Returns sqrt(e.P e).
    template <typename Vector>
    double size(const Vector& e) const {
        return std::sqrt(std::max(0.0, e.dot(p_ * e)));
    }

    /// Returns sqrt(c.P⁻¹c): times the size of e the largest that c.e will be.
    template <typename Vector>
    double gain(const Vector& c) const {
        return std::sqrt(std::max(0.0, c.dot(factor_.solve(c))));
    }

private:
    Matrix p_;
    Eigen::LLT<Matrix> factor_;
};

/// Solves A'X + X A = -Q for many symmetric Q by one Schur decomposition of A, at O(n³) each. Source: Bartels and
/// Stewart (1972), Comm. ACM 15, 820.
class Lyapunov {
public:
    explicit Lyapunov(const Eigen::MatrixXd& a);

    /// Returns X, symmetric. It is not finite where two eigenvalues of A add up to zero.
    Eigen::MatrixXd solve(const Eigen::MatrixXd& q) const;

private:
    Eigen::ComplexSchur<Eigen::MatrixXd> schur_;
};

/// Solves A'X + X A = -Q of few coordinates, Q symmetric: a linear system for the entries above the diagonal, in
/// matrices of bounded size that allocate nothing.
template <typename Matrix>
Matrix lyapunov_of_few(const Matrix& a, const Matrix& q) {
    constexpr int most = Matrix::MaxRowsAtCompileTime;
    constexpr int most_unknowns = most * (most + 1) / 2;
    const auto n = a.rows();
    const auto unknowns = n * (n + 1) / 2;
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, most_unknowns, most_unknowns> system;
    Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, most_unknowns, 1> right(unknowns);
    system.setZero(unknowns, unknowns);
    const auto place = [](Eigen::Index i, Eigen::Index j) {
        return i <= j ? j * (j + 1) / 2 + i : i * (i + 1) / 2 + j;
    };
    for (Eigen::Index j = 0; j < n; ++j)
        for (Eigen::Index i = 0; i <= j; ++i) {
            for (Eigen::Index k = 0; k < n; ++k) {
                system(place(i, j), place(k, j)) += a(k, i);
                system(place(i, j), place(i, k)) += a(k, j);
            }
            right(place(i, j)) = -q(i, j);
        }
    const auto solution = system.partialPivLu().solve(right).eval();
    Matrix x(n, n);
    for (Eigen::Index j = 0; j < n; ++j)
        for (Eigen::Index i = 0; i < n; ++i)
            x(i, j) = solution(place(i, j));
    return x;
}

}  // namespace stridor::integration
