#pragma once

#include <span>
#include <vector>

namespace stridor::integration {

/// A sum that is to be zero: row x + offset.
struct HeldSum {
    std::span<const double> row;
    double offset = 0.0;
};

/// Moves x by as little as makes all sums zero, to rounding of their terms. The rows are independent of each other.
void hold_at_zero(const std::vector<HeldSum>& sums, std::span<double> x);

}  // namespace stridor::integration
