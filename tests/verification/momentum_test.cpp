// The momentum of every body: over the judged time its change is what springs, dashpots, loads and contacts push.

#include "support/momentum.hpp"

#include "stridor/integration/simulate.hpp"
#include "support/effort.hpp"
#include "support/massless_feet.hpp"
#include "support/random_structures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace stridor {
namespace {

using integration::Motion;
using parameters::Case;
using parameters::Engine;
using parameters::Formulation;
using support::Balance;

Case judged_late(std::uint64_t number, Engine engine, Formulation formulation = Formulation::standard) {
    Case c = support::random_structure(number);
    c.run.engine = engine;
    c.run.formulation = formulation;
    c.run.step = 1e-6;
    c.run.duration = 0.16;
    c.run.window = 0.08;
    return c;
}

// the balance of a run that must have a result
Balance momentum(const Case& c, double interval, std::uint64_t number) {
    const Motion motion = integration::simulate(c, support::request_of_balance(c, interval));
    EXPECT_TRUE(integration::has_result(motion.outcome)) << number;
    return integration::has_result(motion.outcome) ? support::balance_of(c, motion, interval) : Balance{};
}

TEST(Momentum, OfEveryBodyIsWhatItsContactsPushByEvents) {
    int separating = 0;
    for (std::uint64_t number = 0; number < support::effort<std::uint64_t>(60, 6); ++number) {
        const Balance balance = momentum(judged_late(number, Engine::exact), 1e-6, number);
        EXPECT_LT(balance.residual, support::trapezoids * balance.impulses) << number;
        separating += balance.separates ? 1 : 0;
    }
    EXPECT_GT(separating, support::effort(10, 0));
}

TEST(Momentum, OfEveryBodyIsWhatItsContactsPushBySteps) {
    int separating = 0;
    for (std::uint64_t number = 0; number < support::effort<std::uint64_t>(30, 3); ++number) {
        const Balance balance = momentum(judged_late(number, Engine::moreau), 1e-6, number);
        EXPECT_LT(balance.residual, support::trapezoids * balance.impulses) << number;
        separating += balance.separates ? 1 : 0;
    }
    EXPECT_GT(separating, support::effort(10, 0));
}

TEST(Momentum, OfEveryBodyIsWhatItsContactsWithoutInertiaPush) {
    for (std::uint64_t number = 0; number < support::effort<std::uint64_t>(30, 3); ++number) {
        const Balance balance = momentum(
            support::on_massless_feet(judged_late(number, Engine::moreau, Formulation::massless)), 1e-6, number);
        EXPECT_LT(balance.residual, support::trapezoids * balance.impulses) << number;
    }
}

// a run that ends early is filled by its period, impacts included
TEST(Momentum, OfACycleIsThatOfTheWholeRun) {
    int cycles = 0;
    for (std::uint64_t number = 0; number < support::effort<std::uint64_t>(200, 6); ++number) {
        Case c = judged_late(number, Engine::exact);
        c.run.early_ending = parameters::EarlyEnding::proven;
        const Motion early = integration::simulate(c);
        if (!early.cycle) continue;
        ++cycles;
        c.run.early_ending = parameters::EarlyEnding::never;
        const Motion whole = integration::simulate(c);
        const double part = 2.0 * early.cycle->period / c.run.window;
        for (std::size_t k = 0; k < c.own_structure->contacts.size(); ++k) {
            const record::Load& a = early.record.phases.front().contacts[k].load;
            const record::Load& b = whole.record.phases.front().contacts[k].load;
            EXPECT_NEAR(a.normal_impulse, b.normal_impulse, part * b.normal_impulse) << number;
            EXPECT_NEAR(a.friction_loss, b.friction_loss, part * b.friction_loss) << number;
        }
    }
    EXPECT_GE(cycles, support::effort(4, 0));
}

}  // namespace
}  // namespace stridor
