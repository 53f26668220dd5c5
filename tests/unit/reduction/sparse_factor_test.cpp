#include "stridor/reduction/sparse_factor.hpp"

#include "stridor/reduction/least_fill.hpp"
#include "stridor/reduction/lowest_modes.hpp"
#include "support/structures/lattice_part.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace stridor::reduction {
namespace {

using support::lattice_part;
using support::LatticeSupport;

std::vector<int> order_of(const SparseMatrix& matrix) {
    LeastFill::PermutationType order;
    LeastFill()(matrix, order);
    return {order.indices().data(), order.indices().data() + order.size()};
}

TEST(LeastFill, OrdersEachRowOnceAndAlwaysTheSame) {
    // on either side of the size from which nested dissection takes over
    for (const int layers : {3, 19}) {
        const ElasticPart part = lattice_part({10, 10, layers}, LatticeSupport::free);
        const std::vector<int> order = order_of(part.stiffness);
        EXPECT_EQ(order, order_of(part.stiffness));
        std::vector<int> sorted = order;
        std::sort(sorted.begin(), sorted.end());
        std::vector<int> rows(static_cast<std::size_t>(rows_of(part)));
        std::iota(rows.begin(), rows.end(), 0);
        EXPECT_EQ(sorted, rows);
    }
}

// the order of a machine is that of every other: these are Debian's METIS 5.1 and Eigen 3.4
TEST(LeastFill, HasTheOrderThatItEverHad) {
    const auto fingerprint = [](const SparseMatrix& matrix) {
        std::uint64_t hash = 14695981039346656037U;  // FNV-1a
        for (const int row : order_of(matrix))
            hash = (hash ^ static_cast<std::uint64_t>(row)) * 1099511628211U;
        return hash;
    };
    EXPECT_EQ(fingerprint(lattice_part({6, 6, 6}, LatticeSupport::free).stiffness), 5471184207972409485U);
    EXPECT_EQ(fingerprint(lattice_part({12, 12, 13}, LatticeSupport::free).stiffness), 16182519947640513123U);
}

TEST(SparseFactor, OfALargePartSolvesAndCounts) {
    const ElasticPart part = lattice_part({12, 12, 14}, LatticeSupport::top_held);
    ASSERT_GT(rows_of(part), LeastFill::few_rows);
    const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(rows_of(part), -1.0, 2.0);
    const SparseFactor held(part.stiffness, part.mass, 0.0);
    EXPECT_EQ(held.negative_pivots(), 0);
    EXPECT_LT((part.stiffness * held.solve(load) - load).norm(), 1e-10 * load.norm());
    const Modes modes = lowest_modes(part.stiffness, part.mass, 4);
    const double between = 0.5 * (modes.squared[2] + modes.squared[3]);
    EXPECT_EQ(SparseFactor(part.stiffness, part.mass, between).negative_pivots(), 3);
}

TEST(WithoutZeros, LeavesTheRest) {
    SparseMatrix matrix(2, 2);
    const std::vector<Eigen::Triplet<double>> entries{{0, 0, 2.0}, {1, 0, 0.0}, {0, 1, -0.0}, {1, 1, 1e-300}};
    matrix.setFromTriplets(entries.begin(), entries.end());
    EXPECT_EQ(without_zeros(matrix).nonZeros(), 2);
    EXPECT_EQ(Eigen::MatrixXd(without_zeros(matrix)), Eigen::MatrixXd(matrix));
}

}  // namespace
}  // namespace stridor::reduction
