// Table 1 of Elmaian et al. (2012): the four columns under their sinusoidal drive, 1 s, by both engines.
//
// Irregular motions depend on every rounding and every step, so there are three measures:
//   the exact engine repeats its own digits, whatever the compiler and the instruction set;
//   beta_2 stays as near to them as its own error lets it;
//   both stay near what independent event-driven and beta_2 programs found.

#include "stridor/verification/table_1.hpp"

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

// coming, stick and slip of the squeak alternate regularly: a squeal of this model at 950 Hz, on which the paper is
// silent
struct Way {
    analysis::Rates independent;  // other programs', whole phase
    Category category;
};

struct Column {
    const verification::Table1Column* stored;
    std::array<Way, 2> ways;  // going, coming
};

const std::array<Column, 4> columns{{
    {&verification::table_1[0],
     {{{{.slip = 0.881, .stick = 0.073, .separation = 0.046}, Category::none},
       {{.slip = 0.949, .stick = 0.050, .separation = 0.001}, Category::none}}}},
    {&verification::table_1[1],
     {{{{.slip = 0.142, .stick = 0.180, .separation = 0.678}, Category::squeal},
       {{.slip = 0.852, .stick = 0.059, .separation = 0.090}, Category::none}}}},
    {&verification::table_1[2],
     {{{{.slip = 0.428, .stick = 0.445, .separation = 0.128}, Category::squeak},
       {{.slip = 0.567, .stick = 0.433, .separation = 0.000}, Category::squeal}}}},
    {&verification::table_1[3],
     {{{{.slip = 0.132, .stick = 0.865, .separation = 0.004}, Category::creak},
       {{.slip = 0.074, .stick = 0.926, .separation = 0.000}, Category::creak}}}},
}};

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
            expect_rates(verdict.evidence.rates, GetParam().stored->rates.at(k), tolerance);
            expect_rates(verdict.evidence.rates, way.independent, reproducible);
            EXPECT_EQ(verdict.category, way.category);
        }
    }
};

TEST_P(Table1, ExactEngineRepeatsItsDigits) {
    parameters::Case c = parameters::paper_case(GetParam().stored->which);
    c.run.engine = Engine::exact;
    expect_column(c, verification::table_1_exact_tolerance);
}

TEST_P(Table1, BetaTwoStaysWithinItsOwnError) {
    parameters::Case c = parameters::paper_case(GetParam().stored->which);
    c.run.engine = Engine::beta_2;
    // checked builds, which are some twenty times slower, leave out the half step
    for (const double step : support::effort(std::vector{1e-6, 5e-7}, std::vector{1e-6})) {
        SCOPED_TRACE(step);
        c.run.step = step;
        expect_column(c, beta_2_tolerance(*GetParam().stored));
    }
}

INSTANTIATE_TEST_SUITE_P(Columns, Table1, testing::ValuesIn(columns), [](const auto& instance) {
    return std::string(parameters::paper_case_names.at(static_cast<std::size_t>(instance.param.stored->which)));
});

}  // namespace
}  // namespace stridor
