#pragma once

#include "stridor/integration/kernels/row_kernel.hpp"
#include "stridor/integration/run/end_state.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace stridor::integration {

/// A linear relation y = b + W x in which any y_k may change places with its x_k: principal pivoting.
///
///     y_k kept at 0, x_k follows   (k is exchanged)         x_k kept at 0, y_k follows   (it is not)
///
/// What follows is one product away for any b. An exchange costs as much as that product, so the solution of one set of
/// states is kept for the next step and changed in place for another set. Source: R. W. Cottle, J.-S. Pang, R. E.
/// Stone, The Linear Complementarity Problem (1992), section 2.3.
class ExchangeTableau {
public:
    explicit ExchangeTableau(const Eigen::MatrixXd& relation, InstructionSet set = widest_instruction_set());

    std::size_t size() const { return size_; }
    bool is_exchanged(std::size_t k) const { return is_exchanged_[k]; }

    /// Begins with this b, shape [size], with the exchanges that were made.
    void set(const std::vector<double>& b);

    /// Returns x_k where k is exchanged, else y_k.
    double follows(std::size_t k) const { return follows_[k]; }

    /// Returns the diagonal entry by which an exchange would divide: that of W, or its inverse, with all exchanges so
    /// far.
    double pivot(std::size_t k) const { return matrix_[k * stride_ + k]; }

    /// Exchanges y_k and x_k.
    void exchange(std::size_t k);

    /// Returns the entry of what follows at `row` per unit of what is kept at `column`: of W, or with all exchanges so
    /// far.
    double entry(std::size_t row, std::size_t column) const { return matrix_[column * stride_ + row]; }

    /// Shears: x_to = share x_from + a new x_to from now on. Where x_to alone is exchanged that has no meaning. Costs
    /// an exchange where x_from alone is, else next to nothing.
    void shear(std::size_t from, std::size_t to, double share);

    /// Passes all of it: exchanges leave their rounding behind.
    void pass(Memory& pass) { pass(matrix_), pass(follows_), pass(is_exchanged_), pass(exchanges_); }

    /// Exchanges since all began with W.
    long exchanges() const { return exchanges_; }

private:
    void shear_kept(std::size_t from, std::size_t to, double share);

    const RowKernel* kernel_;
    std::size_t size_;
    std::size_t stride_;
    std::vector<double> matrix_;  // shape [column][stride]
    std::vector<double> follows_;
    std::vector<char> is_exchanged_;
    long exchanges_ = 0;
};

}  // namespace stridor::integration
