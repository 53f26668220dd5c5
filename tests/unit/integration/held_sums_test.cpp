#include "stridor/integration/series/held_sums.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace stridor::integration {
namespace {

double sum(const HeldSum& held, const std::vector<double>& x) {
    double value = held.offset;
    for (std::size_t j = 0; j < x.size(); ++j)
        value += held.row[j] * x[j];
    return value;
}

Eigen::MatrixXd products_of(const std::vector<HeldSum>& sums) {
    const auto count = static_cast<Eigen::Index>(sums.size());
    Eigen::MatrixXd products(count, count);
    for (const HeldSum& a : sums)
        for (const HeldSum& b : sums)
            products(a.number, b.number) = sum({a.row, 0.0}, {b.row.begin(), b.row.end()});
    return products;
}

TEST(HeldSums, MovesAtRightAngles) {
    const std::vector<double> row{3.0, 4.0, 0.0};
    std::vector<double> x{1.0, 1.0, 7.0};
    const std::vector<HeldSum> sums{{row, 3.0, 0}};
    hold_at_zero(sums, products_of(sums), x);
    // the sum was 10: 10/25 of the row
    EXPECT_NEAR(x[0], 1.0 - 0.4 * 3.0, 1e-15);
    EXPECT_NEAR(x[1], 1.0 - 0.4 * 4.0, 1e-15);
    EXPECT_EQ(x[2], 7.0);
}

TEST(HeldSums, LeavesRoundingWhereRowsNearlyDependOnEachOther) {
    const std::vector<double> a{1.0, 0.0, 0.3}, b{1.0, 1e-5, 0.3}, c{0.1, 1.0, -0.7};
    std::vector<double> x{0.9, -0.4, 0.2};
    const std::vector<HeldSum> sums{{a, 0.1, 0}, {b, -0.2, 1}, {c, 0.0, 2}};
    hold_at_zero(sums, products_of(sums), x);
    for (const HeldSum& held : sums)
        EXPECT_LT(std::abs(sum(held, x)), 1e-10);  // x is 3e4: eps of that, some terms
}

// 0.1 + 0.2 - 0.3 is zero but for rounding of its own terms, which is more than that of the other sum
TEST(HeldSums, LeavesAloneWhatIsHeldAlready) {
    const std::vector<double> large{0.1, 0.2, -0.3}, small{1e-9, -1e-9, 0.0};
    std::vector<double> x{1.0, 1.0, 1.0};
    const std::vector<HeldSum> sums{{large, 0.0, 0}, {small, 0.0, 1}};
    ASSERT_NE(sum(sums.front(), x), 0.0);
    const std::vector<double> before = x;
    hold_at_zero(sums, products_of(sums), x);
    EXPECT_EQ(x, before);
}

TEST(HeldSums, HoldsNothingWithoutSums) {
    std::vector<double> x{1.0};
    hold_at_zero({}, {}, x);
    EXPECT_EQ(x[0], 1.0);
}

}  // namespace
}  // namespace stridor::integration
