#pragma once

#include <Eigen/Core>

#include <span>
#include <vector>

namespace stridor::integration {

/// A sum that is to be zero: row x + offset.
struct HeldSum {
    std::span<const double> row;
    double offset = 0.0;
    Eigen::Index number = 0;  // of the row in the table of products
};

/// Moves x by as little as makes all sums zero, to rounding of their terms; where they are it stays. The rows are
/// independent of each other; `products` holds those of each row with each, shape [number][number]. Returns how much of
/// each row x was moved by, shape [sum]: of velocities, the impulses that do it.
Eigen::VectorXd hold_at_zero(const std::vector<HeldSum>& sums, const Eigen::MatrixXd& products, std::span<double> x);

}  // namespace stridor::integration
