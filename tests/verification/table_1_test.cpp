// Table 1 of Elmaian et al. (2012): the four columns under their sinusoidal drive, 1 s, by both engines.
//
// Irregular motions depend on every rounding and every step, so there are three measures:
//   the exact engine repeats its own digits, whatever the compiler and the instruction set;
//   beta_2 stays as near to them as its own error lets it;
//   both stay near what independent event-driven and beta_2 programs found.

#include "stridor/analysis/evidence.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "support/effort.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace stridor {
namespace {

using classification::Category;
using parameters::Engine;
using parameters::PaperCase;

struct Way {
    analysis::Rates stored;       // the exact engine's, whole phase
    analysis::Rates independent;  // other programs'
    Category category;
};

struct Column {
    PaperCase which;
    double beta_2_error;      // [1] of a share of time; see BetaTwo below
    std::array<Way, 2> ways;  // going, coming
};

// coming, stick and slip of the squeak alternate regularly: a squeal of this model at 950 Hz, on which the paper is
// silent
const std::array<Column, 4> columns{{
    {PaperCase::quiet,
     0.0150,
     {{{{.slip = 0.8807455, .stick = 0.0731810, .separation = 0.0460735},
        {.slip = 0.881, .stick = 0.073, .separation = 0.046},
        Category::none},
       {{.slip = 0.9491487, .stick = 0.0502807, .separation = 0.0005706},
        {.slip = 0.949, .stick = 0.050, .separation = 0.001},
        Category::none}}}},
    {PaperCase::squeal,
     0.0205,
     {{{{.slip = 0.1487222, .stick = 0.1726952, .separation = 0.6785826},
        {.slip = 0.142, .stick = 0.180, .separation = 0.678},
        Category::squeal},
       {{.slip = 0.8492444, .stick = 0.0565966, .separation = 0.0941591},
        {.slip = 0.852, .stick = 0.059, .separation = 0.090},
        Category::none}}}},
    {PaperCase::squeak,
     0.0151,
     {{{{.slip = 0.4280422, .stick = 0.4367432, .separation = 0.1352146},
        {.slip = 0.428, .stick = 0.445, .separation = 0.128},
        Category::squeak},
       {{.slip = 0.5641435, .stick = 0.4358565, .separation = 0.0},
        {.slip = 0.567, .stick = 0.433, .separation = 0.000},
        Category::squeal}}}},
    {PaperCase::creak,
     0.0071,
     {{{{.slip = 0.1294289, .stick = 0.8687976, .separation = 0.0017736},
        {.slip = 0.132, .stick = 0.865, .separation = 0.004},
        Category::creak},
       {{.slip = 0.0772079, .stick = 0.9227921, .separation = 0.0},
        {.slip = 0.074, .stick = 0.926, .separation = 0.000},
        Category::creak}}}},
}};

// the digits are stored to 7 places
constexpr double exact_error = 1e-6;

// irregular motions differ by so much from program to program over 1 s
constexpr double reproducible = 0.03;

class Table1 : public testing::TestWithParam<Column> {
protected:
    static void expect_rates(const analysis::Rates& rates, const analysis::Rates& expected, double tolerance) {
        EXPECT_NEAR(rates.stick, expected.stick, tolerance);
        EXPECT_NEAR(rates.slip, expected.slip, tolerance);
        EXPECT_NEAR(rates.separation, expected.separation, tolerance);
    }

    // within `tolerance` of the stored digits, named as in the table, and near the other programs
    static void expect_column(const parameters::Case& c, double tolerance) {
        const integration::Motion motion = integration::simulate(c);
        ASSERT_EQ(motion.outcome.reason, integration::Reason::completed);
        ASSERT_EQ(motion.record.phases.size(), 2U);
        for (std::size_t k = 0; k < 2; ++k) {
            SCOPED_TRACE(k == 0 ? "going" : "coming");
            const Way& way = GetParam().ways.at(k);
            const auto verdict = classification::classify(analysis::evidence(motion.record.phases[k], 0), c.verdict);
            expect_rates(verdict.evidence.rates, way.stored, tolerance);
            expect_rates(verdict.evidence.rates, way.independent, reproducible);
            EXPECT_EQ(verdict.category, way.category);
        }
    }
};

TEST_P(Table1, ExactEngineRepeatsItsDigits) {
    parameters::Case c = parameters::paper_case(GetParam().which);
    c.run.engine = Engine::exact;
    expect_column(c, exact_error);
}

// The error was measured against the exact engine at h = 1, 1/2, 1/4 and 1/8 us; the column's number is the largest of
// them all. It does not fall with h: a step moves the instants of impacts, irregular motion forgets them within
// milliseconds, and what is left is the spread of shares over 1 s. Halving h changes the shares by up to 0.0150 (quiet,
// which takes one of two courses), 0.0064 (squeal), 0.0128 (squeak) and 0.0105 (creak). A quarter more is allowed.
TEST_P(Table1, BetaTwoStaysWithinItsOwnError) {
    parameters::Case c = parameters::paper_case(GetParam().which);
    c.run.engine = Engine::beta_2;
    // checked builds, which are some twenty times slower, leave out the half step
    for (const double step : support::effort(std::vector{1e-6, 5e-7}, std::vector{1e-6})) {
        SCOPED_TRACE(step);
        c.run.step = step;
        expect_column(c, 1.25 * GetParam().beta_2_error);
    }
}

INSTANTIATE_TEST_SUITE_P(Columns, Table1, testing::ValuesIn(columns), [](const auto& instance) {
    return std::string(parameters::paper_case_names.at(static_cast<std::size_t>(instance.param.which)));
});

}  // namespace
}  // namespace stridor
