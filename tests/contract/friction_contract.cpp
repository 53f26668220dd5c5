#include "contract/friction_contract.hpp"

#include "stridor/integration/beta_2/beta_2.hpp"
#include "stridor/integration/exact/exact.hpp"
#include "stridor/integration/series/taylor.hpp"
#include "stridor/model/built/mass_on_belt.hpp"
#include "stridor/model/laws/friction_jet.hpp"
#include "support/belt_run.hpp"
#include "support/error_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

namespace stridor::contract {
namespace {

using model::Slip;
using model::slips;

constexpr double speeds[] = {0.0, 1e-3, 0.05, 0.7, 1e3};  // [m/s] of slip

double sign_of(Slip way) {
    return way == Slip::forward ? 1.0 : -1.0;
}

TEST_P(FrictionContract, OpposesTheSlip) {
    for (const Slip way : slips)
        for (const double speed : speeds)
            EXPECT_LE(sign_of(way) * slip_ratio(law(), way, sign_of(way) * speed), 0.0) << speed;
}

TEST_P(FrictionContract, SlipsWithNoMoreThanItSticksWith) {
    for (const Slip way : slips)
        for (const double speed : speeds)
            EXPECT_LE(std::abs(slip_ratio(law(), way, sign_of(way) * speed)),
                      stick_limit(law(), way) + GetParam().rise * speed)
                << speed;
}

TEST_P(FrictionContract, BeginsASlipWithNoMoreThanItSticksWith) {
    for (const Slip way : slips)
        EXPECT_LE(std::abs(slip_ratio(law(), way)), stick_limit(law(), way));
}

TEST_P(FrictionContract, StaysWithinItsSlopes) {
    const model::SlopeRange range = slope_range(law());
    EXPECT_LE(range.least, 0.0);
    EXPECT_GE(range.most, 0.0);
    const double rounding = 1e-12 * (range.most - range.least);
    for (const Slip way : slips)
        for (const double speed : speeds) {
            const double slope = -slip_ratio_slope(law(), way, sign_of(way) * speed);
            EXPECT_GE(slope, range.least - rounding) << speed;
            EXPECT_LE(slope, range.most + rounding) << speed;
        }
}

TEST_P(FrictionContract, HasTheSlopeOfItsRatio) {
    for (const Slip way : slips)
        for (const double speed : speeds) {
            const double w = sign_of(way) * (speed + 1e-4), step = 1e-6;
            const double difference =
                (slip_ratio(law(), way, w + step) - slip_ratio(law(), way, w - step)) / (2.0 * step);
            EXPECT_NEAR(slip_ratio_slope(law(), way, w), difference, 1e-6) << w;  // rounding of 1e-16 / step
        }
}

TEST_P(FrictionContract, IsStateWiseWhereTheVelocityOfSlipChangesNothing) {
    bool changes = has_friction_state(law());  // it follows the past
    for (const Slip way : slips)
        for (const double speed : speeds)
            changes = changes || slip_ratio(law(), way, sign_of(way) * speed) != slip_ratio(law(), way);
    EXPECT_EQ(is_state_wise(law()), !changes);
}

// along a speed of slip that is a cubic of time, at a fifth of the way to where the next power counts
TEST_P(FrictionContract, HasAJetThatFollowsItsResistance) {
    if (!has_jet(law())) return;  // engines refuse to expand it
    if (has_friction_state(law())) return;
    constexpr std::size_t count = 25;
    for (const Slip way : slips)
        for (const double speed : speeds)
            for (const double rise : {0.1, -0.1}) {
                if (speed == 0.0 && rise < 0.0) continue;
                std::array<double, count> motion{speed, rise * std::max(speed, 1e-3), 0.02 * rise * speed,
                                                 0.01 * speed};
                const auto side = rise > 0.0 ? model::CornerSide::above : model::CornerSide::below;
                const model::SmoothStretch stretch = model::speed_stretch(law(), way, speed, 0.0, side);
                model::FrictionJet jet(law(), way);
                jet.choose(stretch);
                std::array<double, count> resistance{};
                for (std::size_t m = 0; m < count; ++m)
                    resistance[m] = jet.next({motion.data(), m + 1});
                for (const double time : {0.0, 0.01, 0.1}) {
                    double there = 0.0, wanted = 0.0;
                    for (std::size_t m = count; m-- > 0;) {
                        there = there * time + motion[m];
                        wanted = wanted * time + resistance[m];
                    }
                    if (there < stretch.from || there > stretch.to) continue;
                    EXPECT_NEAR(wanted, std::abs(slip_ratio(law(), way, sign_of(way) * there)), 1e-14 * (1.0 + wanted))
                        << speed << " " << time;
                }
            }
}

TEST_P(FrictionContract, TakesASlipTheOtherWayForOneThatBegins) {
    for (const Slip way : slips)
        EXPECT_EQ(slip_ratio(law(), way, -sign_of(way)), slip_ratio(law(), way));
}

TEST_P(FrictionContract, HasFiniteCoefficients) {
    for (const Slip way : slips) {
        EXPECT_TRUE(std::isfinite(slip_ratio(law(), way)));
        EXPECT_TRUE(std::isfinite(stick_limit(law(), way)));
    }
}

TEST_P(FrictionContract, HoldsUpToTheLimitOfTheSideThatGivesIn) {
    for (const double N : {1e-9, 1.0, 3e4})
        for (const double sign : {-1.0, 1.0}) {
            const double limit = stick_limit(law(), model::slip_against(sign)) * N;
            EXPECT_TRUE(holds(law(), N, sign * limit * (1.0 - 1e-12)));
            EXPECT_FALSE(
                holds(law(), N, sign * std::nextafter(limit, std::numeric_limits<double>::infinity()) + sign * 1e-12));
        }
}

TEST_P(FrictionContract, HoldsNothingThatIsPulled) {
    for (const double T : {-1.0, 0.0, 1.0})
        EXPECT_FALSE(holds(law(), -1.0, T));
}

TEST_P(FrictionContract, IsItsOwnEqualAndNoOther) {
    EXPECT_EQ(law(), model::FrictionLaw(law()));
    EXPECT_NE(law(), model::FrictionLaw(model::Coulomb{123.0, 45.0}));
}

// The engines know no law: in the motion that they compute the law's own numbers stand.
void expect_law_in_motion(const model::FrictionLaw& law, const record::Trace& trace) {
    for (std::size_t k = 0; k < trace.time.size(); ++k) {
        const double N = trace.contacts.front().normal_force[k], T = trace.contacts.front().friction_force[k];
        const double w = trace.velocity[0][k] - trace.surface_velocity[k];
        const double slipping = slip_ratio(law, model::slip_of(w), w) * N;
        const double limit = stick_limit(law, model::slip_against(T)) * N;
        if (trace.contacts.front().state[k] == model::ContactState::slip && std::abs(w) > 1e-6) {
            EXPECT_NEAR(T, slipping, 1e-9) << trace.time[k];
        } else if (trace.contacts.front().state[k] == model::ContactState::stick) {
            EXPECT_LE(std::abs(T), limit + 1e-9) << trace.time[k];
        }
    }
}

TEST_P(FrictionContract, StandsInTheMotionOfTheEnginesThatKnowIt) {
    for (const double velocity : {-0.1, 0.1}) {
        parameters::Case c;
        c.drive = support::constant_drive(velocity);
        c.run.duration = c.run.window = 0.2;
        model::Structure belt = model::mass_on_belt({1.0, 1e4, 5.0, 50.0, {}});
        belt.contacts[0].friction = law();
        const record::Request request{record::KeepHistory::no, {0.0, 0.2, 1e-4}};
        const auto recorder = [&] { return record::Recorder(record::schedule(c), request, 2); };
        const integration::Start start{parameters::Initial::stuck, 0.0};
        const auto by_steps = [&] {
            return integration::integrate_beta_2(belt, c.drive, start, {1e-5, 0.5}, recorder());
        };
        if (has_friction_state(law())) {
            EXPECT_TRUE(support::thrown_by(by_steps).says("the beta_2 engine knows no friction with a state"));
            return;
        }
        std::vector<integration::Motion> motions{by_steps()};
        if (has_jet(law()))
            motions.push_back(integration::integrate_taylor(
                belt, c.drive, integration::initial_state(belt, start, velocity), {}, recorder()));
        const auto by_events = [&] { return integration::integrate_exact(belt, c.drive, start, {}, recorder()); };
        if (is_state_wise(law()))
            motions.push_back(by_events());
        else
            EXPECT_TRUE(support::thrown_by(by_events).says("the exact engine knows no friction that changes"));
        for (const integration::Motion& motion : motions) {
            EXPECT_EQ(motion.outcome.reason, integration::Reason::completed);
            expect_law_in_motion(law(), motion.record.trace);
        }
    }
}

// What a law with a friction state promises besides.
struct StateUnderTest {
    std::string name;
    model::FrictionLaw law;
    double speed = 1.0;  // [m/s] around which it changes
};

void PrintTo(const StateUnderTest& friction, std::ostream* out) {
    *out << friction.name;
}

class FrictionStateContract : public testing::TestWithParam<StateUnderTest> {
protected:
    // calls a function with the law as it is
    template <typename Function>
    void with_law(Function function) const {
        std::visit(
            [&]<typename Law>(const Law& each) {
                if constexpr (model::HasFrictionState<Law>) function(each);
            },
            GetParam().law);
    }
    std::array<double, 3> speeds() const { return {0.2 * GetParam().speed, GetParam().speed, 5.0 * GetParam().speed}; }
};

TEST_P(FrictionStateContract, IsAtRestInASteadySlip) {
    with_law([&](const auto& law) {
        for (const double speed : speeds()) {
            const double state = law.steady_state(speed);
            EXPECT_NEAR(law.state_rate(speed, state), 0.0, 1e-12 * std::abs(law.state_slopes(speed).rate_by_state));
            for (const Slip way : slips)
                EXPECT_NEAR(law.state_resistance(speed, state), law.resistance(way, speed), 1e-14);
        }
    });
}

TEST_P(FrictionStateContract, HasTheSlopesOfItsRateAndResistance) {
    with_law([&](const auto& law) {
        for (const double speed : speeds()) {
            const double state = law.steady_state(speed);
            const model::StateSlopes slopes = law.state_slopes(speed);
            const double ds = 1e-5 * std::max(std::abs(state), GetParam().speed), dv = 1e-5 * speed;
            const auto by_state = [&](auto of) { return (of(speed, state + ds) - of(speed, state - ds)) / (2.0 * ds); };
            const auto by_speed = [&](auto of) { return (of(speed + dv, state) - of(speed - dv, state)) / (2.0 * dv); };
            const auto rate = [&](double v, double z) { return law.state_rate(v, z); };
            const auto resistance = [&](double v, double z) { return law.state_resistance(v, z); };
            const auto is_near = [](double found, double wanted, double size) {
                EXPECT_NEAR(found, wanted, 1e-5 * (std::abs(wanted) + size));
            };
            is_near(slopes.rate_by_state, by_state(rate), 0.0);
            is_near(slopes.rate_by_speed, by_speed(rate), std::abs(slopes.rate_by_state) * ds / dv);
            is_near(slopes.resistance_by_state, by_state(resistance), 0.0);
            is_near(slopes.resistance_by_speed, by_speed(resistance), 1e-3 / speed);
        }
    });
}

// along a speed that is a parabola of time, by Runge and Kutta's method with steps whose error is below 1e-13
TEST_P(FrictionStateContract, HasAJetThatFollowsItsState) {
    constexpr std::size_t count = 25;
    with_law([&](const auto& law) {
        for (const double speed : speeds())
            for (const double change : {0.5, -0.5}) {
                const double rate = std::abs(law.state_slopes(speed).rate_by_state), span = 0.1 / rate;
                const auto speed_at = [&](double t) { return speed * (1.0 + change * t / span * (1.0 + t / span)); };
                const double begin = 0.7 * law.steady_state(speed) + 1e-3 * law.steady_state(2.0 * speed);
                std::array<double, count> motion{speed, change * speed, change * speed};
                model::FrictionJet jet(GetParam().law, Slip::forward, begin, span);
                std::array<double, count> resistance{}, states{};
                for (std::size_t m = 0; m < count; ++m) {
                    resistance[m] = jet.next({motion.data(), m + 1});
                    states[m] = jet.state();
                }
                constexpr int steps = 4000;
                const double end = 0.1, h = end * span / steps;
                double z = begin;
                for (int n = 0; n < steps; ++n) {
                    const double t = n * h;
                    const double k1 = law.state_rate(speed_at(t), z);
                    const double k2 = law.state_rate(speed_at(t + 0.5 * h), z + 0.5 * h * k1);
                    const double k3 = law.state_rate(speed_at(t + 0.5 * h), z + 0.5 * h * k2);
                    const double k4 = law.state_rate(speed_at(t + h), z + h * k3);
                    z += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
                }
                double state = 0.0, found = 0.0;
                for (std::size_t m = count; m-- > 0;) {
                    state = state * end + states[m];
                    found = found * end + resistance[m];
                }
                EXPECT_NEAR(state, z, 1e-12 * std::abs(z)) << speed;
                EXPECT_NEAR(found, law.state_resistance(speed_at(end * span), z), 1e-12 * std::abs(found)) << speed;
            }
    });
}

TEST_P(FrictionStateContract, HasTheSteadyStateOfItsWay) {
    const model::FrictionLaw& law = GetParam().law;
    EXPECT_TRUE(has_friction_state(law));
    EXPECT_EQ(steady_friction_state(law, 0.0), 0.0);
    for (const double speed : speeds())
        EXPECT_EQ(steady_friction_state(law, -speed),
                  state_sign(law, Slip::backward) * steady_friction_state(law, speed));
}

INSTANTIATE_TEST_SUITE_P(
    States, FrictionStateContract,
    testing::Values(
        StateUnderTest{"lugre", model::LuGre{{1.5, 1.0, 1e-3, 2.0, 0.4}, 1e5, 316.0}, 1e-3},
        StateUnderTest{"dahl", model::LuGre{{0.6, 0.6, 1.0, 1.0, 0.0}, 1e4, 0.0}, 0.1},
        StateUnderTest{"dieterich",
                       model::RateAndState{parameters::FrictionKind::dieterich, 0.6, 0.01, 0.015, 1e-5, 1e-3}, 1e-3},
        StateUnderTest{"ruina", model::RateAndState{parameters::FrictionKind::ruina, 0.6, 0.01, 0.015, 1e-5, 1e-3},
                       1e-2},
        // so slow that its arsinh is no logarithm
        StateUnderTest{"at_rest", model::RateAndState{parameters::FrictionKind::dieterich, 0.1, 0.1, 0.05, 1e-5, 1e-3},
                       1e-3}),
    testing::PrintToStringParamName());

INSTANTIATE_TEST_SUITE_P(LuGre, FrictionContract,
                         testing::Values(FrictionUnderTest{"bristles",
                                                           model::LuGre{{0.8, 0.6, 0.1, 2.0, 0.01}, 1e5, 10.0}, 0.01},
                                         FrictionUnderTest{"dahl", model::LuGre{{0.5, 0.5, 1.0, 1.0, 0.0}, 1e4, 0.0}}),
                         testing::PrintToStringParamName());

INSTANTIATE_TEST_SUITE_P(Coulomb, FrictionContract,
                         testing::Values(FrictionUnderTest{"two_coefficients", model::Coulomb{0.8, 0.6}},
                                         FrictionUnderTest{"one_coefficient", model::Coulomb{0.4, 0.4}},
                                         FrictionUnderTest{"none", model::Coulomb{0.0, 0.0}}),
                         testing::PrintToStringParamName());

INSTANTIATE_TEST_SUITE_P(
    Directional, FrictionContract,
    testing::Values(FrictionUnderTest{"rough_backward", model::Directional{{0.3, 0.8}, {0.2, 0.6}}},
                    FrictionUnderTest{"rough_forward", model::Directional{{0.9, 0.4}, {0.7, 0.4}}}),
    testing::PrintToStringParamName());

INSTANTIATE_TEST_SUITE_P(Linear, FrictionContract,
                         testing::Values(FrictionUnderTest{"falling", model::Linear{0.8, 0.6, 0.5}},
                                         FrictionUnderTest{"falling_to_none", model::Linear{0.5, 0.2, 7.0}}),
                         testing::PrintToStringParamName());

INSTANTIATE_TEST_SUITE_P(
    Stribeck, FrictionContract,
    testing::Values(FrictionUnderTest{"exponential", model::Stribeck{0.8, 0.6, 0.05, 1.0, 0.0}},
                    FrictionUnderTest{"gaussian", model::Stribeck{0.8, 0.2, 0.1, 2.0, 0.0}},
                    FrictionUnderTest{"of_another_power", model::Stribeck{0.8, 0.2, 0.1, 3.5, 0.0}},
                    FrictionUnderTest{"viscous", model::Stribeck{0.5, 0.3, 0.05, 1.0, 0.01}, 0.01}),
    testing::PrintToStringParamName());

INSTANTIATE_TEST_SUITE_P(
    RationalStribeck, FrictionContract,
    testing::Values(FrictionUnderTest{"of_leine", model::Stribeck{1.0, 0.0, 1.0 / 3.0, 1.0, 0.0,
                                                                  parameters::FrictionKind::stribeck_rational}},
                    FrictionUnderTest{
                        "of_hess_and_soom",
                        model::Stribeck{0.5, 0.3, 0.1, 2.0, 0.02, parameters::FrictionKind::stribeck_rational}, 0.02}),
    testing::PrintToStringParamName());

model::FrictionLaw measured(parameters::Interpolation interpolation) {
    parameters::Contact contact;
    contact.friction = parameters::FrictionKind::table;
    contact.static_friction = 0.9;
    contact.friction_table = {"", {0.0, 0.02, 0.1, 0.8, 2.0}, {0.85, 0.7, 0.5, 0.55, 0.6}};
    contact.interpolation = interpolation;
    return model::friction_law(contact);
}

// wide steps, so that the slopes of this suite resolve them
INSTANTIATE_TEST_SUITE_P(
    Regularised, FrictionContract,
    testing::Values(FrictionUnderTest{"tanh", model::Regularised{0.5, 0.1}, 5.0},
                    FrictionUnderTest{"arctan", model::Regularised{0.5, 0.1, parameters::FrictionKind::arctan}, 5.0}),
    testing::PrintToStringParamName());

INSTANTIATE_TEST_SUITE_P(Table, FrictionContract,
                         testing::Values(FrictionUnderTest{"cubic", measured(parameters::Interpolation::cubic)},
                                         FrictionUnderTest{"linear", measured(parameters::Interpolation::linear)}),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace stridor::contract
