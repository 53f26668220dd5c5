#include "stridor/integration/simulate.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "support/belt_run.hpp"
#include "support/effort.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stridor {
namespace {

using parameters::PaperCase;

parameters::Case table_1(PaperCase which) {
    parameters::Case c = parameters::paper_case(which);
    c.run.duration = c.run.window = 0.3;
    c.run.engine = parameters::Engine::beta_2;
    c.run.step = support::effort(1e-7, 1e-6);
    return c;
}

// 3e6 steps round forces to 1e-16 each at random: 1e-16 sqrt(3e6) of a turnover that elastic energy
// enters many times over
TEST(EnergyBalance, OfTheCentralDifferenceIsRounding) {
    for (const PaperCase which : {PaperCase::squeal, PaperCase::squeak, PaperCase::creak, PaperCase::quiet})
        EXPECT_LT(std::abs(integration::simulate(table_1(which)).energy.relative_residual()), 2e-12);
}

// above 1/2 the scheme takes energy out of every vibration: here up to 3 % of all that is turned over, at h = 1e-6 s
TEST(EnergyBalance, OfADampingSchemeIsALoss) {
    for (const PaperCase which : {PaperCase::squeal, PaperCase::squeak, PaperCase::creak}) {
        parameters::Case c = table_1(which);
        c.run.engine = parameters::Engine::beta_2;
        c.run.step = 1e-6;
        c.run.beta_2 = 0.6;
        const double share = integration::simulate(c).energy.relative_residual();
        EXPECT_LT(share, -1e-6);
        EXPECT_GT(share, -0.05);
    }
}

// A sliding mode of amplitude v loses the share 1 - rho^2 = (beta_2 - 1/2) (w0 h)^2 of its energy each step: over a
// time t with w0 h << 1 the residual is -(m v^2 / 2) (1 - exp(-(beta_2 - 1/2) w0^2 h t)).
TEST(EnergyBalance, LosesWhatTheSpectralRadiusSays) {
    constexpr double w0 = 500.0, h = 1e-5, beta_2 = 0.6, end = 0.4;
    support::BeltRun run;
    run.belt = {1.0, w0 * w0, 0.0, 100.0, {0.8, 0.3}};
    run.drive = support::constant_drive(100.0);
    run.start = {parameters::Initial::sliding, 1.0};
    run.settings = {h, beta_2};
    run.duration = end;
    const double loss = 0.5 * (1.0 - std::exp(-(beta_2 - 0.5) * w0 * w0 * h * end));
    // the energy itself oscillates by w0 h of its size within a cycle
    EXPECT_NEAR(integrate(run).energy.residual, -loss, w0 * h * 0.5);
}

}  // namespace
}  // namespace stridor
