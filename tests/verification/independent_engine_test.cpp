// beta_2 against an engine that shares no code with it (support/event_driven): the same equations, another method.

#include "stridor/analysis/rates.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "support/constant_case.hpp"
#include "support/effort.hpp"
#include "support/oracles/event_driven.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace stridor {
namespace {

using parameters::Case;
using parameters::PaperCase;
using support::constant_case;

struct Distance {
    double largest = 0.0;   // [m] between the engines
    double movement = 0.0;  // [m] largest displacement
};

Distance distance(Case c, double h) {
    c.run.engine = parameters::Engine::beta_2;
    c.run.step = h;
    constexpr double interval = 1e-5;
    const auto exact = support::event_driven(c, 1e-6, 10);
    const record::Trace trace =
        integration::simulate(c, {record::KeepHistory::no, {0.0, c.run.duration, interval}}).record.trace;
    Distance result;
    const std::size_t samples = std::min(exact.time.size(), trace.time.size());
    EXPECT_GE(samples, static_cast<std::size_t>(c.run.duration / interval) - 1);
    for (std::size_t k = 0; k < samples; ++k)
        for (std::size_t dof = 0; dof < 3; ++dof) {
            const double x = exact.position[k][dof];
            result.largest = std::max(result.largest, std::abs(trace.displacement[dof][k] - x));
            result.movement = std::max(result.movement, std::abs(x));
        }
    return result;
}

// Before chaos parts neighbouring motions, the engines differ by the scheme's error alone. An impact or a change
// of state is up to one step late, at velocities of some 0.1 m/s: 0.1 m/s h each; 20 ms hold a few of them. 1e-8 m
// of 1e-4 m at 1e-7 s.
TEST(IndependentEngine, MovesAsBeta2DoesInASqueal) {
    const Distance found = distance(constant_case(PaperCase::squeal, 0.1257, 0.02), 1e-7);
    EXPECT_LT(found.largest, 5.0 * 0.1257 * 1e-7);
    EXPECT_GT(found.movement, 1e-4);
}

TEST(IndependentEngine, MovesAsBeta2DoesInASqueak) {
    const Distance found = distance(constant_case(PaperCase::squeak, 0.1257, 0.004), 1e-7);
    EXPECT_LT(found.largest, 5.0 * 0.1257 * 1e-7);
    EXPECT_GT(found.movement, 5e-5);
}

// first order at changes of state: a tenth of the step, a tenth of the distance, to a factor of two
TEST(IndependentEngine, IsWhatBeta2ConvergesTo) {
    const Case c = constant_case(PaperCase::squeal, 0.1257, 0.01);
    const double ratio = distance(c, 1e-6).largest / distance(c, 1e-7).largest;
    EXPECT_GT(ratio, 5.0);
    EXPECT_LT(ratio, 20.0);
}

// rates of an irregular squeak and of a regular squeal over many periods
void expect_same_rates(const Case& c, double tolerance) {
    std::array<double, model::contact_states> time{};
    for (const record::ContactInterval& interval : support::event_driven(c, 2e-6, 1 << 30).history)
        time[model::index_of(interval.state)] += interval.to - interval.from;
    const analysis::Rates exact = analysis::rates(time);
    const analysis::Rates found = analysis::rates(integration::simulate(c).record.phases.front().contacts.front().time);
    EXPECT_NEAR(found.slip, exact.slip, tolerance);
    EXPECT_NEAR(found.stick, exact.stick, tolerance);
    EXPECT_NEAR(found.separation, exact.separation, tolerance);
}

// regular: two changes a period of 2.3 ms, each known to a step or two; the start is irregular for some periods
TEST(IndependentEngine, GivesTheRatesOfASqueal) {
    expect_same_rates(constant_case(PaperCase::squeal, 0.1257, support::effort(1.0, 0.1)), 2e-3);
}

// irregular: over 1 s some 500 beats; two neighbouring motions differ by 1/sqrt(500) of a beat's scatter
TEST(IndependentEngine, GivesTheRatesOfASqueak) {
    expect_same_rates(constant_case(PaperCase::squeak, 0.1257, support::effort(1.0, 0.25)),
                      support::effort(0.02, 0.04));
}

}  // namespace
}  // namespace stridor
