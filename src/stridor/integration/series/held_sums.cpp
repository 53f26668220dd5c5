#include "stridor/integration/series/held_sums.hpp"

#include "stridor/base/decompositions.hpp"
#include "stridor/integration/modal/modal_structure.hpp"

#include <cmath>
#include <cstddef>

namespace stridor::integration {

namespace {

constexpr double least_sum = 0x1p-52;    // [1] of its terms: a sum this small may as well be zero
constexpr double held_rounding = 1e-14;  // [1] likewise: what passes come down to
constexpr int most_passes = 4;

// are they zero but for `rounding` of their terms? also notes how far each is from it
bool are_zero(const std::vector<HeldSum>& sums, std::span<const double> x, double rounding, Eigen::VectorXd& error) {
    bool all = true;
    for (std::size_t a = 0; a < sums.size(); ++a) {
        const HeldSum& sum = sums[a];
        const double here = error(static_cast<Eigen::Index>(a)) = dot(sum.row, x) + sum.offset;
        if (!(std::abs(here) <= rounding * (dot_of_sizes(sum.row, x) + std::abs(sum.offset)))) all = false;
    }
    return all;
}

Eigen::MatrixXd gram(const std::vector<HeldSum>& sums, const Eigen::MatrixXd& products) {
    const auto n = static_cast<Eigen::Index>(sums.size());
    Eigen::MatrixXd matrix(n, n);
    for (Eigen::Index a = 0; a < n; ++a)
        for (Eigen::Index b = 0; b < n; ++b)
            matrix(a, b) = products(sums[static_cast<std::size_t>(a)].number, sums[static_cast<std::size_t>(b)].number);
    return matrix;
}

}  // namespace

Eigen::VectorXd hold_at_zero(const std::vector<HeldSum>& sums, const Eigen::MatrixXd& products, std::span<double> x) {
    const auto n = static_cast<Eigen::Index>(sums.size());
    Eigen::VectorXd error(n), moved = Eigen::VectorXd::Zero(n);
    if (are_zero(sums, x, least_sum, error)) return moved;
    const Eigen::LDLT<Eigen::MatrixXd> factor = gram(sums, products).ldlt();
    // rows that nearly depend on each other leave more than rounding the first time
    for (int pass = 0; pass < most_passes; ++pass) {
        const Eigen::VectorXd share = factor.solve(error);
        moved -= share;
        for (Eigen::Index a = 0; a < n; ++a)
            for (std::size_t j = 0; j < x.size(); ++j)
                x[j] -= share(a) * sums[static_cast<std::size_t>(a)].row[j];
        if (are_zero(sums, x, held_rounding, error)) break;
    }
    return moved;
}

}  // namespace stridor::integration
