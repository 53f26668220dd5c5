// Friction that changes with the slip velocity, by Taylor series: an independent integrator, published numbers, and the
// engines that go by steps.

#include "stridor/integration/series/taylor.hpp"
#include "stridor/model/built/mass_on_belt.hpp"
#include "support/error_text.hpp"
#include "support/many_contacts.hpp"
#include "support/oracles/belt_by_runge_kutta.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace stridor {
namespace {

using integration::Motion;
using model::ContactState;
using parameters::Initial;

struct LawOnBelt {
    std::string name;
    model::Belt belt;
    model::FrictionLaw law;
    double V = 0.0;                 // [m/s]
    double duration = 0.0;          // [s]
    std::vector<double> corners{};  // [m/s] of the law
};

// k = m = F_s = 1, F = -F_s sgn(w)/(1 + 3 |w|): R. I. Leine and others 1998
const model::FrictionLaw leine =
    model::Stribeck{1.0, 0.0, 1.0 / 3.0, 1.0, 0.0, parameters::FrictionKind::stribeck_rational};

const std::vector<double> rows{0.0, 0.05, 0.2, 0.6, 1.5};  // [m/s]

model::FrictionLaw measured(parameters::Interpolation interpolation) {
    auto curve = std::make_shared<const model::MeasuredCurve>(
        model::measured_curve(rows, {0.9, 0.7, 0.5, 0.42, 0.45}, interpolation));
    return model::Measured{0.9, std::move(curve), {-4.0, 0.1}};
}

std::vector<LawOnBelt> laws_on_belts() {
    return {
        {"linear", {1.0, 1.0, 0.0, 1.0, {}}, model::Linear{1.0, 0.9, 0.5}, 0.2, 60.0},
        {"linear, stiff and damped", {2.0, 3e5, 5.0, 80.0, {}}, model::Linear{0.8, 0.8, 1.5}, 0.05, 0.15},
        {"Leine's block", {1.0, 1.0, 0.0, 1.0, {}}, leine, 0.2, 60.0},
        {"Stribeck, exponential", {1.0, 1.0, 0.0, 1.0, {}}, model::Stribeck{0.9, 0.4, 0.15, 1.0, 0.02}, 0.1, 60.0},
        {"Stribeck, Gaussian", {2.0, 3e5, 5.0, 80.0, {}}, model::Stribeck{0.8, 0.5, 0.04, 2.0, 0.0}, 0.05, 0.15},
        {"Stribeck, third power", {1.0, 1.0, 0.0, 1.0, {}}, model::Stribeck{0.9, 0.4, 0.3, 3.0, 0.0}, 0.1, 60.0},
        {"rational, square",
         {1.0, 1.0, 0.01, 1.0, {}},
         model::Stribeck{0.8, 0.3, 0.2, 2.0, 0.05, parameters::FrictionKind::stribeck_rational},
         0.1,
         60.0},
        {"measured, cubic", {1.0, 1.0, 0.0, 1.0, {}}, measured(parameters::Interpolation::cubic), 0.1, 60.0, rows},
        {"measured from 0.03 m/s on",
         {1.0, 1.0, 0.0, 1.0, {}},
         model::Measured{0.9,
                         std::make_shared<const model::MeasuredCurve>(model::measured_curve(
                             {0.03, 0.1, 0.5}, {0.8, 0.6, 0.5}, parameters::Interpolation::linear)),
                         {-3.0, 0.0}},
         0.1,
         60.0,
         {0.03, 0.1, 0.5}},
        {"measured, linear", {1.0, 1.0, 0.0, 1.0, {}}, measured(parameters::Interpolation::linear), 0.1, 60.0, rows},
    };
}

model::Structure belt_of(const LawOnBelt& given) {
    model::Structure structure = model::mass_on_belt(given.belt);
    structure.contacts[0].friction = given.law;
    return structure;
}

// with the belt's velocity turned round, too
Motion moved(const LawOnBelt& given, double sign = 1.0) {
    return support::run_taylor(belt_of(given), sign * given.V, Initial::stuck, {given.duration, given.duration});
}

TEST(FrictionSeries, HasTheEventsOfAnIndependentIntegrator) {
    for (const LawOnBelt& given : laws_on_belts()) {
        const Motion motion = moved(given);
        const record::ContactHistory& history = motion.record.histories.front();
        const std::vector<support::BeltEvent> events =
            support::belt_by_runge_kutta(given.belt, given.law, given.V, given.duration, given.corners);
        ASSERT_EQ(history.size(), events.size() + 1) << given.name;
        EXPECT_GT(events.size(), 5U) << given.name;
        for (std::size_t n = 0; n < events.size(); ++n) {
            EXPECT_EQ(history[n + 1].state == ContactState::stick, events[n].sticks) << given.name;
            EXPECT_NEAR(history[n + 1].from, events[n].time, 1e-12 * given.duration) << given.name << " " << n;
        }
    }
}

TEST(FrictionSeries, TakesEnergyByFrictionAndAccountsForAll) {
    for (const LawOnBelt& given : laws_on_belts()) {
        const Motion motion = moved(given);
        EXPECT_EQ(motion.outcome.reason, integration::Reason::completed) << given.name;
        EXPECT_GT(motion.energy.friction_loss, 0.0) << given.name;
        EXPECT_LT(std::abs(motion.energy.relative_residual()), 1e-13) << given.name;
    }
}

TEST(FrictionSeries, MirrorsBitForBit) {
    for (const LawOnBelt& given : laws_on_belts()) {
        const Motion here = moved(given), there = moved(given, -1.0);
        const record::ContactHistory& a = here.record.histories.front();
        const record::ContactHistory& b = there.record.histories.front();
        ASSERT_EQ(a.size(), b.size()) << given.name;
        for (std::size_t n = 0; n < a.size(); ++n) {
            EXPECT_EQ(a[n].state, b[n].state);
            EXPECT_EQ(a[n].from, b[n].from);
            EXPECT_EQ(a[n].slip_velocity, -b[n].slip_velocity);
        }
        EXPECT_EQ(here.energy.friction_loss, there.energy.friction_loss);
    }
}

struct StickSlip {
    double period = 0.0, slip = 0.0;  // [s]
    double stick_share = 0.0;         // [1]
    double largest = 0.0;             // [m] displacement
    double sticks_at = 0.0;           // [m]
};

// the last whole period of a block that starts stuck
StickSlip stick_slip(const model::FrictionLaw& law, double V) {
    constexpr double duration = 100.0;  // [s]
    model::Structure block = model::mass_on_belt({1.0, 1.0, 0.0, 1.0, {}});
    block.contacts[0].friction = law;
    const parameters::Case c = support::watched_case(V, {duration, duration});
    const Motion motion = integration::integrate_taylor(
        block, c.drive, integration::initial_state(block, {Initial::stuck, 0.0}, V), {},
        record::Recorder(record::schedule(c), {record::KeepHistory::yes, {0.0, duration, 1e-4}}, 2));
    const record::ContactHistory& history = motion.record.histories.front();
    const std::size_t last = history.size() - 1 - (history.back().state == ContactState::stick ? 0 : 1);
    const record::ContactInterval& slip = history[last - 1];
    const record::ContactInterval& stick = history[last - 2];
    const std::vector<double>& x = motion.record.trace.displacement[0];
    const double rest = slip.from - stick.from;
    return {slip.to - stick.from, slip.to - slip.from, rest / (slip.to - stick.from),
            *std::max_element(x.begin(), x.end()), 1.0 - V * rest};
}

// computed anew by others (SciPy with events): all digits that are given
TEST(FrictionSeries, MovesLeinesBlockAsPublished) {
    const StickSlip fast = stick_slip(leine, 0.2);
    EXPECT_NEAR(fast.period, 12.001031, 5e-7);
    EXPECT_NEAR(fast.slip, 4.296000, 5e-7);
    EXPECT_NEAR(fast.stick_share, 0.64203, 5e-6);
    EXPECT_NEAR(fast.largest, 1.133945, 5e-7);
    EXPECT_NEAR(fast.sticks_at, -0.541006, 5e-7);
    const StickSlip slow = stick_slip(leine, 0.1);
    EXPECT_NEAR(slow.period, 17.865990, 5e-7);
    EXPECT_NEAR(slow.stick_share, 0.76076, 5e-6);
}

TEST(FrictionSeries, RefusesALawWithoutASeriesByName) {
    LawOnBelt given = laws_on_belts().front();
    for (const model::FrictionLaw& law : {model::FrictionLaw(model::Stribeck{0.9, 0.4, 0.3, 1.5, 0.0}),
                                          model::FrictionLaw(model::Regularised{0.5, 1e-3})}) {
        given.law = law;
        EXPECT_TRUE(support::thrown_by([&] {
                        moved(given);
                    }).says("the Taylor engine has no power series of this law of friction"));
    }
}

// Table 1's joints with friction that falls with the slip velocity
std::vector<model::Structure> joints() {
    std::vector<model::Structure> all{
        support::plate_of({support::plate_joint(2000.0, 0.2)}),
        support::plate_of({support::plate_joint(2000.0, 0.2), support::plate_joint(1500.0, 0.3, 75.0)})};
    for (model::Structure& structure : all)
        for (model::ContactPoint& contact : structure.contacts)
            contact.friction = model::Linear{0.8, 0.6, 0.2};
    return all;
}

// small differences grow from event to event where two joints move: the first ones tell
TEST(FrictionSeries, HasTheEventsOfSmallSteps) {
    constexpr support::Watched watched{0.03, 0.03};
    constexpr double step = 2e-7;  // [s]
    constexpr std::size_t compared = 8;
    for (const model::Structure& structure : joints()) {
        const Motion motion = support::run_taylor(structure, -0.1257, Initial::stuck, watched);
        const Motion steps = support::run_moreau(structure, -0.1257, Initial::stuck, step, watched);
        EXPECT_EQ(motion.outcome.reason, integration::Reason::completed);
        for (std::size_t k = 0; k < structure.contacts.size(); ++k) {
            const record::ContactHistory& found = motion.record.histories[k];
            const record::ContactHistory& wanted = steps.record.histories[k];
            ASSERT_GE(std::min(found.size(), wanted.size()), compared);
            for (std::size_t n = 0; n < compared; ++n) {
                EXPECT_EQ(found[n].state, wanted[n].state) << "contact " << k << ", event " << n;
                EXPECT_NEAR(found[n].from, wanted[n].from, 40.0 * step) << "contact " << k << ", event " << n;
            }
        }
    }
}

}  // namespace
}  // namespace stridor
