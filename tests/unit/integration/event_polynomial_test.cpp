#include "stridor/integration/series/event_polynomial.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace stridor::integration {
namespace {

// with these zeros, positive at first; of degree 24 as those of a block
std::vector<double> polynomial_with(const std::vector<double>& zeros) {
    std::vector<double> c{1.0};
    for (const double zero : zeros) {
        c.push_back(0.0);
        for (std::size_t k = c.size() - 1; k > 0; --k)
            c[k] -= c[k - 1] / zero;
    }
    c.resize(25, 0.0);
    return c;
}

TEST(EventPolynomial, FindsTheOnlyZero) {
    EXPECT_NEAR(first_zero(polynomial_with({0.25}), 0, 1.0), 0.25, 1e-15);
    EXPECT_NEAR(first_zero(polynomial_with({0.99}), 0, 1.0), 0.99, 1e-15);
    EXPECT_EQ(first_zero(polynomial_with({1.25}), 0, 1.0), no_zero);
    EXPECT_EQ(first_zero(polynomial_with({0.75}), 0, 0.5), no_zero);
}

TEST(EventPolynomial, FindsTheFirstOfTwoThatNearlyTouch) {
    EXPECT_NEAR(first_zero(polynomial_with({0.5, 0.5 + 1e-6}), 0, 1.0), 0.5, 1e-9);
    EXPECT_NEAR(first_zero(polynomial_with({0.875, 0.3, 0.300001}), 0, 1.0), 0.3, 1e-9);
}

TEST(EventPolynomial, PassesADipThatStaysPositive) {
    std::vector<double> c = polynomial_with({0.5, 0.5});
    c[0] += 1e-9;
    EXPECT_EQ(first_zero(c, 0, 1.0), no_zero);
}

TEST(EventPolynomial, DividesOutWhatItBeginsWith) {
    // x² (0.5 - x), with rounding where it is zero
    std::vector<double> c{1e-19, -1e-19, 0.5, -1.0};
    EXPECT_NEAR(first_zero(c, 2, 1.0), 0.5, 1e-15);
    // -x³ is below zero at once
    EXPECT_EQ(first_zero(std::vector<double>{0.0, 0.0, 0.0, -1.0}, 3, 1.0), 0.0);
    EXPECT_EQ(first_zero(std::vector<double>{-1.0, 2.0}, 0, 1.0), 0.0);
}

TEST(EventPolynomial, TellsWhereANumberIsNone) {
    std::vector<double> c = polynomial_with({0.5});
    c[7] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(first_zero(c, 0, 1.0), no_polynomial);
}

TEST(EventPolynomial, LooksBehindCoefficientsThatAreRounding) {
    std::vector<double> c(25, 0.0);
    EXPECT_EQ(late_zero(c, 1e-12, 1.0), no_zero);
    c[1] = -1e-13;
    EXPECT_EQ(late_zero(c, 1e-12, 1.0), no_zero);
    // falls from zero on, as the fifth power
    c[5] = -1.0;
    const double place = late_zero(c, 1e-12, 1.0);
    EXPECT_LE(std::pow(place, 5.0), 1e-12);
    EXPECT_GT(std::pow(2.0 * place, 5.0), 1e-12);
    EXPECT_EQ(late_zero(c, 1e-12, 1e-3), no_zero);
    // rises, and falls behind
    c[5] = 1.0;
    c[6] = -4.0;
    EXPECT_NEAR(late_zero(c, 1e-12, 1.0), 0.25, 1e-15);
}

RC_GTEST_PROP(EventPolynomial, FindsTheFirstOfManyZeros, ()) {
    const auto count = *rc::gen::inRange(1, 7);
    std::vector<double> zeros;
    for (int k = 0; k < count; ++k)
        zeros.push_back(0.02 * (1 + *rc::gen::inRange(0, 120)));
    const double first = *std::min_element(zeros.begin(), zeros.end());
    const auto times = std::count(zeros.begin(), zeros.end(), first);
    const double found = first_zero(polynomial_with(zeros), 0, 1.0);
    // a zero of even order is a touch, which rounding may turn into none; of order 3 a third of its digits are known
    if (times == 1 && first < 1.0)
        RC_ASSERT(std::abs(found - first) < 1e-9);
    else if (first > 1.0)
        RC_ASSERT(found == no_zero);
}

}  // namespace
}  // namespace stridor::integration
