#include "stridor/model/laws/friction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

namespace stridor::model {
namespace {

constexpr RateAndState granite{parameters::FrictionKind::dieterich, 0.4, 0.02, 0.03, 1e-4, 1e-3};

// a arsinh(u) by the library: u from far below 1e-2, up to which a series stands for it, to e^40
TEST(RateAndState, ResistsByTheArsinhOfItsSpeedAndState) {
    for (double exponent = -30.0; exponent < 40.0; exponent += 0.37)
        for (const double state : {-3.0, 0.0, 2.0}) {
            const double hold =
                std::exp((granite.coefficient + granite.evolution_effect * state) / granite.direct_effect);
            const double speed = 2.0 * granite.velocity * std::exp(exponent) / hold;
            const double wanted = granite.direct_effect * std::asinh(speed / (2.0 * granite.velocity) * hold);
            EXPECT_NEAR(granite.state_resistance(speed, state), wanted, 1e-13 * wanted) << exponent;
        }
}

// mu_0 + (a - b) ln(V/V_0) where a arsinh is a ln: the textbook's steady slip
TEST(RateAndState, OfASteadySlipIsTheLogarithmOfItsSpeed) {
    for (const double speed : {1e-5, 1e-3, 0.1}) {
        EXPECT_NEAR(granite.steady_state(speed), -std::log(speed / granite.velocity), 1e-12);
        const double wanted =
            granite.coefficient + (granite.direct_effect - granite.evolution_effect) * std::log(speed / 1e-3);
        EXPECT_NEAR(granite.resistance(Slip::forward, speed), wanted, 1e-8);
    }
}

}  // namespace
}  // namespace stridor::model
