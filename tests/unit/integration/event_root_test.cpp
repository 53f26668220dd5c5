#include "stridor/integration/exact/event_root.hpp"

#include "support/property.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace stridor::integration {
namespace {

using Polynomial = std::vector<double>;  // coefficients over tau, lowest first

Polynomial times(const Polynomial& a, const Polynomial& b) {
    Polynomial product(a.size() + b.size() - 1, 0.0);
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j)
            product[i + j] += a[i] * b[j];
    return product;
}

// scale (tau - root) (tau - root) ...
Polynomial with_roots(double scale, const std::vector<double>& roots) {
    Polynomial p{scale};
    for (const double root : roots)
        p = times(p, {-root, 1.0});
    return p;
}

double value(const Polynomial& p, double tau) {
    double sum = 0.0;
    for (std::size_t k = p.size(); k-- > 0;)
        sum = sum * tau + p[k];
    return sum;
}

// tau^multiplicity quotient; a quotient up to degree 7 is its Bernstein form exactly:
// b_j = sum over k of C(j,k)/C(7,k) c_k
double crossing(const Polynomial& quotient, int multiplicity = 0) {
    Lanes series[term_blocks]{};
    for (int k = 0; k < static_cast<int>(quotient.size()); ++k)
        series[(k + multiplicity) / lanes].at[(k + multiplicity) % lanes] = quotient[static_cast<std::size_t>(k)];
    Lanes bernstein{};
    for (int j = 0; j < lanes; ++j) {
        double ratio = 1.0;
        for (int k = 0; k <= j && k < static_cast<int>(quotient.size()); ++k) {
            bernstein.at[j] += ratio * quotient[static_cast<std::size_t>(k)];
            ratio *= static_cast<double>(j - k) / static_cast<double>(7 - k);
        }
    }
    return first_crossing(series, multiplicity, bernstein, kernel(InstructionSet::baseline, 3));
}

TEST(FirstCrossing, FindsASimpleRootToRounding) {
    for (const double root : {1e-12, 1e-6, 0.1, 0.5, 0.731, 0.999999, 1.0})
        EXPECT_NEAR(crossing(with_roots(-2.0, {root})), root, 2e-16) << root;
}

TEST(FirstCrossing, FindsTheFirstOfTwoRootsOfADip) {
    for (const double width : {0.3, 1e-2, 1e-4, 1e-6})
        EXPECT_NEAR(crossing(with_roots(1.0, {0.4, 0.4 + width})), 0.4, 1e-15 / width) << width;  // rounding over slope
}

TEST(FirstCrossing, FindsTheFirstOfSevenRoots) {
    EXPECT_NEAR(crossing(with_roots(-1.0, {0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8})), 0.2, 1e-12);
}

TEST(FirstCrossing, IgnoresADipThatStaysPositive) {
    for (const double height : {1e-2, 1e-5, 1e-8})
        EXPECT_EQ(crossing({0.16 + height, -0.8, 1.0}), no_crossing) << height;
}

// a tangent from above touches zero to rounding: either answer is true, but a touch is where it touches
TEST(FirstCrossing, TakesATangentForATouchOrForNothing) {
    for (const double root : {0.25, 0.4, 0.5, 0.9}) {
        const double found = crossing(with_roots(1.0, {root, root}));
        EXPECT_TRUE(found == no_crossing || std::abs(found - root) < 1e-7) << root;  // square root of rounding
    }
}

TEST(FirstCrossing, LooksNeitherBehindNorAheadOfTheStep) {
    EXPECT_EQ(crossing(with_roots(1.0, {-1e-9})), no_crossing);
    EXPECT_EQ(crossing(with_roots(-1.0, {1.0 + 1e-9})), no_crossing);
    EXPECT_NEAR(crossing(with_roots(-1.0, {1.0 - 1e-15})), 1.0 - 1e-15, 2e-16);
    EXPECT_EQ(crossing(with_roots(1.0, {-1e-9, -0.5})), no_crossing);
}

TEST(FirstCrossing, IsAtOnceWhereTheFunctionBeginsNegative) {
    EXPECT_EQ(crossing({-1e-300, 1.0}), 0.0);
    EXPECT_EQ(crossing({-1.0}), 0.0);
}

TEST(FirstCrossing, JudgesAZeroAtTheBeginningByItsDerivative) {
    EXPECT_EQ(crossing({0.0, -1.0}), 0.0);
    EXPECT_EQ(crossing({0.0, 0.0, -1.0, 5.0}), 0.0);
    EXPECT_EQ(crossing({0.0, 1.0}), no_crossing);
    EXPECT_NEAR(crossing({0.0, 1.0, -2.0}), 0.5, 2e-16);
}

TEST(FirstCrossing, DividesTheRootOutThatHasJustFired) {
    for (int multiplicity = 1; multiplicity <= most_multiplicity; ++multiplicity) {
        EXPECT_EQ(crossing({1.0}, multiplicity), no_crossing) << multiplicity;
        EXPECT_EQ(crossing({-1.0}, multiplicity), 0.0) << multiplicity;
        EXPECT_NEAR(crossing(with_roots(-1.0, {0.3}), multiplicity), 0.3, 2e-16) << multiplicity;
        EXPECT_NEAR(crossing(with_roots(-1.0, {1e-9}), multiplicity), 1e-9, 0x1p-70) << multiplicity;
    }
}

TEST(FirstCrossing, ForgetsTheRoundingInDividedCoefficients) {
    Lanes series[term_blocks]{};
    series[0] = {{-1e-17, 1e-18, 1.0, 0.5}};
    EXPECT_EQ(
        first_crossing(series, 2, {{1.0, 1.1, 1.1, 1.2, 1.2, 1.3, 1.4, 1.5}}, kernel(InstructionSet::baseline, 3)),
        no_crossing);
}

TEST(FirstCrossing, NeverCrossesWhatIsZeroThroughout) {
    EXPECT_EQ(crossing({0.0}), no_crossing);
    EXPECT_EQ(crossing({0.0}, 3), no_crossing);
}

// damping of 1e308 made coefficients that are no numbers, and 2^27 intervals of which none could be decided
TEST(FirstCrossing, GivesUpOnWhatIsNoNumber) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const double odd : {nan, infinity, -infinity}) {
        Lanes series[term_blocks]{};
        series[0] = {{1.0, odd}};
        for (int at = 0; at < lanes; ++at) {
            Lanes bernstein{{1.0, 0.5, 0.1, -0.1, 0.1, -0.1, 0.1, 0.5}};
            bernstein.at[at] = odd;
            EXPECT_EQ(first_crossing(series, 0, bernstein, kernel(InstructionSet::baseline, 3)), no_number) << at;
        }
    }
}

// against 4096 samples: nothing negative lies before the crossing, and the crossing is a zero
RC_GTEST_PROP(FirstCrossing, IsThatOfADenseSampling, ()) {
    constexpr int samples = 4096;
    // dips that the form's slack of 1e-9 may hide, and rounding of eight terms up to 2
    constexpr double depth = 2e-8, rounding = 1e-14;
    Polynomial p(8);
    for (double& coefficient : p)
        coefficient = 2.0 * *support::signed_fraction();
    // half of the polynomials dip to near zero somewhere
    if (*support::whole_between(0, 1) == 0) {
        double least = 1e300;
        for (int k = 0; k <= samples; ++k)
            least = std::min(least, value(p, static_cast<double>(k) / samples));
        p[0] -= least + 1e-6 * *support::signed_fraction();
    }
    const int multiplicity = *support::whole_between(0, 3);
    const double found = crossing(p, multiplicity);
    if (p[0] < 0.0) {
        RC_ASSERT(found == 0.0);
        return;
    }
    for (int k = 0; k <= samples; ++k) {
        const double tau = static_cast<double>(k) / samples;
        if (tau < found) RC_ASSERT(value(p, tau) > -depth);
    }
    if (found != no_crossing) {
        RC_ASSERT(found >= 0.0 && found <= 1.0);
        RC_ASSERT(std::abs(value(p, found)) < rounding);
    }
}

}  // namespace
}  // namespace stridor::integration
