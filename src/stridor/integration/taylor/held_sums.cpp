#include "stridor/integration/taylor/held_sums.hpp"

#include "stridor/base/decompositions.hpp"
#include "stridor/integration/modal_structure.hpp"

#include <cmath>
#include <cstddef>

namespace stridor::integration {

namespace {

constexpr double held_rounding = 1e-14;  // [1] of the terms of a sum
constexpr int most_passes = 4;

}  // namespace

void hold_at_zero(const std::vector<HeldSum>& sums, const Eigen::MatrixXd& products, std::span<double> x) {
    if (sums.empty()) return;
    const auto n = static_cast<Eigen::Index>(sums.size());
    Eigen::MatrixXd gram(n, n);
    for (Eigen::Index a = 0; a < n; ++a)
        for (Eigen::Index b = 0; b < n; ++b)
            gram(a, b) = products(sums[static_cast<std::size_t>(a)].number, sums[static_cast<std::size_t>(b)].number);
    const Eigen::LDLT<Eigen::MatrixXd> factor = gram.ldlt();
    Eigen::VectorXd error(n);
    // rows that nearly depend on each other leave more than rounding the first time
    for (int pass = 0; pass < most_passes; ++pass) {
        bool is_held = pass > 0;
        for (Eigen::Index a = 0; a < n; ++a) {
            const HeldSum& sum = sums[static_cast<std::size_t>(a)];
            error(a) = dot(sum.row, x) + sum.offset;
            if (is_held && !(std::abs(error(a)) <= held_rounding * (dot_of_sizes(sum.row, x) + std::abs(sum.offset))))
                is_held = false;
        }
        if (is_held) return;
        const Eigen::VectorXd share = factor.solve(error);
        for (Eigen::Index a = 0; a < n; ++a)
            for (std::size_t j = 0; j < x.size(); ++j)
                x[j] -= share(a) * sums[static_cast<std::size_t>(a)].row[j];
    }
}

}  // namespace stridor::integration
