// The mass on a belt by beta_2 (verification/single_mass.hpp has the closed form). With damping zeta it leaves the
// stick at D - 2 zeta V/w0 above the sliding equilibrium; stick-slip survives if the damped oscillation from there
// reaches V again.

#include "stridor/verification/single_mass.hpp"
#include "support/belt_run.hpp"
#include "support/effort.hpp"
#include "support/periods.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace stridor {
namespace {

using model::ContactState;
using support::whole_periods;

constexpr double w0 = 500.0;       // [rad/s]
constexpr double distance = 2e-4;  // [m] D
constexpr double h = 1e-6;         // [s]
constexpr model::Coulomb friction{0.8, 0.3};

support::BeltRun belt_run(double lambda, double damping_ratio) {
    support::BeltRun run;
    run.belt = {1.0, w0 * w0, 2.0 * damping_ratio * w0, 100.0, friction};
    run.drive = support::constant_drive(w0 * distance / lambda);
    run.start = {parameters::Initial::stuck, 0.0};
    run.settings = {h, 0.5};
    run.request = {record::KeepHistory::yes, {}};
    return run;
}

TEST(Belt, SticksForTheShareOfTheClosedForm) {
    for (const double lambda : {0.5, 1.0, 2.0, 5.0}) {
        support::BeltRun run = belt_run(lambda, 0.0);
        run.duration = support::effort(1.0, 0.25);
        const support::Periods periods =
            whole_periods(integrate(run).record.histories.front(), ContactState::stick, 0.05);
        const double exact = verification::belt_period(lambda, w0);
        ASSERT_GE(periods.count, 5);
        // the stick trial captures a slip velocity of mu_s N h/m, reached at (mu_s - mu_d) N/m: mu_s / (mu_s - mu_d) =
        // 1.6 steps early; each change of state is known to one step
        const double tolerance = (1.6 + 2.0) * h / exact;
        EXPECT_NEAR(periods.shares[model::index_of(ContactState::stick)], verification::belt_stick_fraction(lambda),
                    tolerance)
            << lambda;
        EXPECT_NEAR(periods.period, exact, 2.0 * h) << lambda;
        EXPECT_EQ(periods.shares[model::index_of(ContactState::separation)], 0.0);
        EXPECT_LT(tolerance, 1e-3);
    }
}

// does it still stick after the first cycles?
bool survives(double lambda, double damping_ratio) {
    support::BeltRun run = belt_run(lambda, damping_ratio);
    run.duration = support::effort(0.3, 0.15);
    // captured velocities, mu_s N h/m = 8e-6 m/s, must be small beside the 2e-4 m/s by which the cycle misses V
    run.settings.step = 1e-7;
    const record::ContactHistory history = integrate(run).record.histories.front();
    return history.back().state == ContactState::stick || history.back().from > 0.5 * run.duration;
}

// the thresholds of lambda are .112445 at zeta = .001 and .694115 at .032
TEST(Belt, DampingEndsStickSlipBelowTheThreshold) {
    for (const auto& [damping_ratio, threshold] : {std::pair{0.001, 0.112445}, {0.032, 0.694115}}) {
        EXPECT_TRUE(survives(1.01 * threshold, damping_ratio)) << damping_ratio;
        EXPECT_FALSE(survives(0.99 * threshold, damping_ratio)) << damping_ratio;
    }
}

}  // namespace
}  // namespace stridor
