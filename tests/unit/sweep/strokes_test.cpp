#include "stridor/sweep/strokes.hpp"

#include "stridor/base/error.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/tables/temperature_table.hpp"
#include "support/constant_case.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace stridor::sweep {
namespace {

using parameters::Case;

constexpr double mu = 0.3, preload = 10.0, velocity = 0.2;

// a mass that slides steadily on a belt; the joint lies along it, so that its normal force is the preload
Case steady_sliding() {
    Case c;
    c.joint().incidence_angle = 0.0;
    c.contact().preload = preload;
    c.contact().static_friction = c.contact().kinetic_friction = mu;
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = velocity;
    c.run.initial = parameters::Initial::sliding;
    c.run.perturbation = 0.0;
    c.run.duration = c.run.window = 0.02;
    return c;
}

// mu_d at 0 degC and at 100 degC
Case over_temperature(Case c, double cold, double hot) {
    c.temperature.value = 20.0;
    c.contact().static_friction = 0.8;
    parameters::set_temperature_table(
        c, {0.0, 100.0}, {{"contact.kinetic_friction", {cold, hot}, parameters::TemperatureColumn::Holds::quantity}});
    return c;
}

Case squealing_when_hot() {
    return over_temperature(support::constant_case(parameters::PaperCase::squeal, 0.1, 0.3), 0.3, 0.6);
}

TEST(Strokes, HeatAsTheirRecursionSays) {
    const StrokePlan plan{400, 0.5, 0.25, Heating{60.0, 30.0}, {}};
    const StrokeHistory history = run_strokes(over_temperature(steady_sliding(), mu, mu), plan);
    EXPECT_EQ(history.ended, "");
    ASSERT_GT(history.strokes.size(), 10U);
    const double rise = plan.heating->resistance * mu * preload * velocity;
    double warmth = 0.0;
    std::int64_t number = 1;
    for (const ComputedStroke& stroke : history.strokes) {
        for (; number < stroke.number; ++number) {
            warmth += (rise - warmth) * (1.0 - std::exp(-plan.duration / plan.heating->time));
            warmth *= std::exp(-plan.pause / plan.heating->time);
        }
        EXPECT_NEAR(stroke.friction_power, mu * preload * velocity, 1e-12);
        EXPECT_NEAR(stroke.temperature, 20.0 + warmth, 1e-9) << stroke.number;
        EXPECT_EQ(stroke.preload_share, 1.0);
    }
    EXPECT_EQ(history.strokes.back().number, 400);
}

TEST(Strokes, WearThePreloadDownGeometrically) {
    const StrokePlan plan{2000, 1.0, 0.0, {}, Wear{1e-12, 1e-6, 1e-3}};
    const double lost = plan.wear->rate * mu * preload * velocity * plan.duration / plan.wear->area /
                        plan.wear->interference;  // of the preload, by the first stroke
    for (const double step : {0.01, 0.0025}) {
        const StrokeHistory history = run_strokes(steady_sliding(), plan, {.wear_step = step});
        EXPECT_EQ(history.ended, "");
        ASSERT_EQ(history.strokes.back().number, plan.strokes);
        ASSERT_LT(history.strokes.back().preload_share, 0.5);
        for (const ComputedStroke& stroke : history.strokes) {
            const double share = std::pow(1.0 - lost, static_cast<double>(stroke.number - 1));
            // second order: the first power has none before it
            EXPECT_NEAR(stroke.preload_share, share, 2.0 * step * step) << stroke.number;
        }
    }
}

TEST(Strokes, AreOneByOneWhereEachChangesMuch) {
    const StrokePlan plan{12, 1.0, 0.0, {}, Wear{1e-10, 1e-6, 1e-3}};
    const double lost = plan.wear->rate * mu * preload * velocity / plan.wear->area / plan.wear->interference;
    const StrokeHistory history = run_strokes(steady_sliding(), plan);
    ASSERT_EQ(history.strokes.size(), 12U);
    for (const ComputedStroke& stroke : history.strokes)
        EXPECT_NEAR(stroke.worn_depth, plan.wear->interference * (1.0 - stroke.preload_share), 1e-18);
    EXPECT_NEAR(history.strokes[1].preload_share, 1.0 - lost, 1e-12);
}

TEST(Strokes, BeginWithTheCaseItself) {
    const Case c = squealing_when_hot();
    const StrokeHistory history = run_strokes(c, {1, 1.0, 0.0, Heating{1.0, 10.0}, {}});
    ASSERT_EQ(history.strokes.size(), 1U);
    Case whole = c;
    whole.run.early_ending = parameters::EarlyEnding::never;
    EXPECT_EQ(history.strokes[0].friction_power, integration::simulate(whole).energy.friction_loss / c.run.duration);
    EXPECT_EQ(history.strokes[0].temperature, c.temperature.value);
}

// the power of a run that ends with a proof is that of the same run to its end
TEST(Strokes, HaveThePowerOfAWholeRun) {
    Case c = support::constant_case(parameters::PaperCase::squeal, 0.1, 0.2);
    const StrokePlan plan{1, 1.0, 0.0, {}, Wear{1e-12, 1e-6, 1e-3}};
    const double proven = run_strokes(c, plan).strokes[0].friction_power;
    c.run.early_ending = parameters::EarlyEnding::never;
    EXPECT_NEAR(run_strokes(c, plan).strokes[0].friction_power, proven, 1e-6 * proven);
}

TEST(Strokes, FindTheFirstThatSounds) {
    const Case c = squealing_when_hot();
    const StrokePlan plan{40, 1.0, 0.0, Heating{24.0, 10.0}, {}};
    const StrokeHistory history = run_strokes(c, plan, {.heating_step = 5.0});
    const StrokeHistory each = run_strokes(c, plan, {.heating_step = 1e-9});
    ASSERT_EQ(each.strokes.size(), 40U);
    EXPECT_LT(history.strokes.size(), each.strokes.size());
    const std::vector<StrokeStretch> found = stretches_of(history, 0);
    ASSERT_GE(found.size(), 2U);
    const ComputedStroke& last_quiet = history.strokes[found[0].last];
    EXPECT_EQ(last_quiet.cells[0].category, classification::Category::none);
    EXPECT_EQ(history.strokes.back().cells[0].category, classification::Category::squeal);
    EXPECT_NEAR(static_cast<double>(last_quiet.number),
                static_cast<double>(each.strokes[stretches_of(each, 0)[0].last].number), 1.0);
    // neighbours were both run: each change lies between them
    for (std::size_t k = 1; k < found.size(); ++k)
        EXPECT_EQ(history.strokes[found[k].first].number, history.strokes[found[k - 1].last].number + 1);
}

TEST(Strokes, EndWhereTheTemperatureIsUnknown) {
    const StrokeHistory history =
        run_strokes(over_temperature(steady_sliding(), mu, mu), {10000, 1.0, 0.0, Heating{1000.0, 50.0}, {}});
    EXPECT_NE(history.ended.find("temperature"), std::string::npos) << history.ended;
    EXPECT_LE(history.strokes.back().temperature, 100.0);
    EXPECT_LT(history.strokes.back().number, 100);
}

TEST(Strokes, EndWhereTheInterferenceIsWornOff) {
    const StrokeHistory history = run_strokes(steady_sliding(), {5, 1.0, 0.0, {}, Wear{1e-8, 1e-6, 1e-3}});
    EXPECT_EQ(history.ended, "stroke 2: the interference is worn off");
    EXPECT_EQ(history.strokes.size(), 1U);
}

TEST(Strokes, ChangeThePreloadOfEachJoint) {
    Case c = steady_sliding();
    c.joints.resize(2);
    c.joints[0].name = "a";
    c.joints[1].name = "b";
    c.joints[1].contact.preload = 4.0;
    const Case worn = case_of_stroke(c, c.temperature.value, 0.5);
    EXPECT_EQ(worn.joints[0].contact.preload, 5.0);
    EXPECT_EQ(worn.joints[1].contact.preload, 2.0);
}

support::Thrown refusal(const Case& c, const StrokePlan& plan) {
    return support::thrown_by([&] { run_strokes(c, plan); });
}

TEST(Strokes, RefuseAPlanThatChangesNothing) {
    const Case c = steady_sliding();
    const Wear wear{1e-12, 1e-6, 1e-3};
    EXPECT_TRUE(refusal(c, {10, 1.0, 0.0, {}, {}}).says("neither heating nor wear"));
    EXPECT_TRUE(refusal(c, {10, 1.0, 0.0, Heating{1.0, 1.0}, {}}).says("follows the temperature"));
    EXPECT_TRUE(refusal(c, {0, 1.0, 0.0, {}, wear}).says("number of strokes is 0"));
    EXPECT_TRUE(refusal(c, {10, -1.0, 0.0, {}, wear}).says("time of a stroke is -1"));
    EXPECT_TRUE(refusal(c, {10, 1.0, -1.0, {}, wear}).says("pause after a stroke is -1"));
    EXPECT_TRUE(refusal(c, {10, 1.0, 0.0, {}, Wear{1e-12, 0.0, 1e-3}}).says("worn area is 0"));
}

}  // namespace
}  // namespace stridor::sweep
