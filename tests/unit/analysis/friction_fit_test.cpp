// Traces of known laws: steady sliding at seven speeds, or a sweep, with white noise, slow fluctuations of friction and
// a rig that rings. STRIDOR_FIT_TRACES in the environment says how many of each law.

#include "friction_fit_support.hpp"
#include "stridor/analysis/friction/fit.hpp"
#include "stridor/model/laws/friction.hpp"
#include "support/counter_random.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::analysis {
namespace {

using parameters::FrictionKind;

constexpr double trace_rate = 1000.0, trace_preload = 10.0;  // [Hz], [N]

parameters::Contact true_contact(FrictionKind kind) {
    parameters::Contact contact;
    contact.friction = kind;
    contact.static_friction = 0.5;
    contact.kinetic_friction = kind == FrictionKind::coulomb || kind == FrictionKind::linear ? 0.5 : 0.3;
    contact.friction_slope = 1.5;
    contact.stribeck_velocity = 0.02;
    return contact;
}

// Recorded forces: friction of a law at the speeds, its fluctuations (1 %, over 30 ms) through a rig of 20 Hz with 5 %
// of critical damping, and noise of 0.02 N
struct RigTrace {
    std::vector<double> force, speed;
};

RigTrace trace_of(const model::FrictionLaw& law, const std::vector<double>& speed, support::CounterRandom& random) {
    constexpr double w0 = 2.0 * std::numbers::pi * 20.0, zeta = 0.05, h = 1.0 / trace_rate;
    RigTrace trace{{}, speed};
    double slow = 0.0, x = 0.0, v = 0.0;
    for (long k = -200; k < static_cast<long>(speed.size()); ++k) {
        slow += -slow / 30.0 + normal(random) * std::sqrt(2.0 / 30.0);
        v += h * (w0 * w0 * (slow - x) - 2.0 * zeta * w0 * v);
        x += h * v;
        if (k < 0) continue;
        const double friction = -slip_ratio(law, model::Slip::forward, speed[static_cast<std::size_t>(k)]);
        trace.force.push_back(trace_preload * (friction + 0.01 * x) + 0.02 * normal(random));
    }
    return trace;
}

std::vector<RigTrace> seven_runs(const model::FrictionLaw& law, support::CounterRandom& random) {
    std::vector<RigTrace> traces;
    for (const double speed : {0.002, 0.004, 0.008, 0.015, 0.03, 0.06, 0.12})
        traces.push_back(trace_of(law, std::vector<double>(4000, speed), random));
    return traces;
}

std::vector<FrictionRun> runs_of(const std::vector<RigTrace>& traces) {
    std::vector<FrictionRun> runs;
    for (const RigTrace& trace : traces) {
        FrictionRun run;
        run.name = "run " + std::to_string(runs.size() + 1);
        run.measurement = {trace_rate, trace.force, {}, {}, trace_preload};
        run.velocity = trace.speed.front();
        runs.push_back(run);
    }
    return runs;
}

FrictionFit fit_of_law(FrictionKind kind, std::uint64_t seed) {
    support::CounterRandom random(seed);
    const std::vector<RigTrace> traces = seven_runs(model::friction_law(true_contact(kind)), random);
    return friction_fit(friction_points(runs_of(traces)));
}

TEST(FrictionFit, CoversTheTruthAndTellsTheLaw) {
    const std::size_t traces = fitted_traces(12);
    std::size_t intervals = 0, covering = 0, told = 0;
    for (std::size_t kind = 0; kind < 4; ++kind) {
        const parameters::Contact truth = true_contact(fitted_kinds[kind]);
        for (std::size_t trace = 0; trace < traces; ++trace) {
            const FrictionFit fit = fit_of_law(fitted_kinds[kind], 10 * trace + kind + 1);
            told += fit.laws[fit.best].kind == kind && fit.rivals.empty() ? 1 : 0;
            for (const FittedNumber& number : fit.laws[law_called(fit, fitted_names[kind])].numbers) {
                if (number.field->symbol == "delta" || number.field->symbol == "k_v") continue;
                const double value = true_value(truth, number.field->symbol);
                intervals += 1;
                covering += number.from <= value && value <= number.to ? 1 : 0;
            }
        }
    }
    const double coverage = static_cast<double>(covering) / static_cast<double>(intervals);
    const double share_told = static_cast<double>(told) / static_cast<double>(4 * traces);
    if (traces > 12)
        std::printf("%zu traces: %.4f of %zu intervals hold the truth, %.4f of the laws told\n", 4 * traces, coverage,
                    intervals, share_told);
    // 95 % within three standard deviations of so many traces, whose intervals count as one, and a hundredth
    EXPECT_NEAR(coverage, 0.95, 0.01 + 3.0 * std::sqrt(0.95 * 0.05 / (4.0 * static_cast<double>(traces))));
    EXPECT_GE(share_told, 0.9);
}

TEST(FrictionFit, OfAnExactCurveIsTheCurve) {
    for (const FrictionKind kind : {FrictionKind::stribeck, FrictionKind::stribeck_rational}) {
        parameters::Contact contact = true_contact(kind);
        contact.viscous_friction = 0.4;
        contact.stribeck_exponent = 2.0;
        const model::FrictionLaw law = model::friction_law(contact);
        FrictionPoints points;
        for (int k = 0; k < 40; ++k) {
            FrictionPoint point;
            point.speeds.fill(0.002 * (k + 1));
            point.friction = -slip_ratio(law, model::Slip::forward, point.speeds[0]);
            points.points.push_back(point);
        }
        const FrictionFit fit = friction_fit(points);
        const FittedLaw& best = fit.laws[fit.best];
        EXPECT_EQ(fitted_kinds[best.kind], kind);
        EXPECT_TRUE(fit.rivals.empty());
        // golden section finds the place of a minimum to the root of rounding
        EXPECT_NEAR(best.contact.static_friction, 0.5, 1e-6);
        EXPECT_NEAR(best.contact.kinetic_friction, 0.3, 1e-6);
        EXPECT_NEAR(best.contact.stribeck_velocity, 0.02, 1e-7);
        EXPECT_NEAR(best.contact.viscous_friction, 0.4, 1e-5);
        EXPECT_EQ(best.contact.stribeck_exponent, 2.0);
        EXPECT_NEAR(friction_at(best, points.points[7]), points.points[7].friction, 1e-6);
    }
}

// mean, and Student's t times deviation over the root of the number: 0.975 of 5 and 11 degrees of freedom
TEST(FrictionFit, OfCoulombsLawIsTheMeanWithStudentsInterval) {
    for (const auto& [count, t] : {std::pair(6, 2.570582), std::pair(12, 2.200985)}) {
        FrictionPoints points;
        double squares = 0.0;
        for (int k = 0; k < count; ++k) {
            const double off = k % 2 == 0 ? 0.01 : -0.01;
            FrictionPoint point;
            point.speeds.fill(0.01);
            point.friction = 0.4 + off;
            points.points.push_back(point);
            squares += off * off;
        }
        const FittedNumber& number = friction_fit(points).laws.at(0).numbers.at(0);
        const double half = t * std::sqrt(squares / (count - 1) / count);
        EXPECT_NEAR(number.value, 0.4, 1e-12);
        EXPECT_NEAR(number.to - number.value, half, 2e-4 * half) << count;
        EXPECT_NEAR(number.value - number.from, half, 2e-4 * half) << count;
    }
}

// friction that does not fall says nothing of the speed at which it falls
TEST(FrictionFit, HasNoBoundsOnAStribeckVelocityThatDoesNotShow) {
    FrictionPoints points;
    for (int k = 0; k < 40; ++k) {
        FrictionPoint point;
        point.speeds.fill(0.002 * (k + 1));
        point.friction = k % 2 == 0 ? 0.39 : 0.41;
        points.points.push_back(point);
    }
    const FrictionFit fit = friction_fit(points);
    const FittedNumber& velocity = fit.laws[law_called(fit, "stribeck")].numbers.at(2);
    ASSERT_EQ(velocity.field->symbol, "v_s");
    EXPECT_EQ(velocity.from, 0.0);
    EXPECT_EQ(velocity.to, std::numeric_limits<double>::infinity());
}

TEST(FrictionFit, SaysInASentenceWhatTheDataBear) {
    EXPECT_EQ(words_of(fit_of_law(FrictionKind::coulomb, 1)),
              "The data bear coulomb. linear, stribeck and stribeck-rational fit them no better with more numbers.");
    FrictionFit fit;
    fit.laws.resize(3);
    fit.laws[0].kind = 2;
    fit.laws[1].kind = 3;
    fit.laws[2].kind = 4;
    fit.rivals = {1};
    fit.richer = {2};
    EXPECT_EQ(words_of(fit),
              "The data do not tell stribeck from stribeck-rational. table fits them no better with more numbers.");
    fit.laws[1].criterion = 3.0;
    fit.richer = {};
    EXPECT_EQ(words_of(fit), "The data do not tell stribeck from stribeck-rational. They speak rather for stribeck.");
    fit.best = 2;
    fit.rivals = fit.richer = {};
    EXPECT_EQ(words_of(fit), "The data bear table. No formula describes them as well.");
}

TEST(FrictionFit, TakesATableWhereNoFormulaDescribesTheRuns) {
    // friction that rises and falls again
    FrictionPoints points;
    for (std::size_t k = 0; k < 60; ++k) {
        FrictionPoint point;
        const double speed = 0.01 * static_cast<double>(k % 6 + 1);
        point.speeds.fill(speed);
        point.friction = 0.3 + 0.1 * std::sin(120.0 * speed) + (k / 6 % 2 == 0 ? 1e-3 : -1e-3);
        points.points.push_back(point);
    }
    const FrictionFit fit = friction_fit(points);
    const parameters::Contact& contact = fit.laws[fit.best].contact;
    ASSERT_EQ(contact.friction, FrictionKind::table);
    ASSERT_EQ(contact.friction_table.speeds.size(), 7U) << "from rest on";
    EXPECT_EQ(contact.friction_table.speeds.front(), 0.0);
    EXPECT_NEAR(contact.friction_table.coefficients[1], 0.3 + 0.1 * std::sin(1.2), 1e-3);
    // no row may lie above mu_s
    EXPECT_EQ(contact.static_friction, *std::max_element(contact.friction_table.coefficients.begin(),
                                                         contact.friction_table.coefficients.end()));
}

TEST(FrictionFit, OfOneSpeedIsCoulombs) {
    support::CounterRandom random(3);
    const std::vector<RigTrace> traces{
        trace_of(model::friction_law(true_contact(FrictionKind::stribeck)), std::vector<double>(4000, 0.03), random)};
    const FrictionFit fit = friction_fit(friction_points(runs_of(traces)));
    ASSERT_EQ(fit.laws.size(), 1U);
    ASSERT_EQ(fit.unfitted.size(), 4U);
    EXPECT_EQ(fit.unfitted[1].why, "its 3 numbers need as many speeds of slip; the runs have 1");
    const auto thrown = support::thrown_by([&] { law_called(fit, "stribeck"); });
    EXPECT_TRUE(thrown.says("its 3 numbers need as many speeds"));
    EXPECT_TRUE(thrown.says("Add runs at other speeds"));
}

TEST(FrictionFit, OfASweepFindsTheCurveBetweenItsEnds) {
    support::CounterRandom random(4);
    std::vector<double> speed;
    for (int k = 0; k < 30000; ++k)
        speed.push_back(0.0005 + 0.06 * std::abs(std::fmod(k / 5000.0, 2.0) - 1.0));
    const RigTrace trace = trace_of(model::friction_law(true_contact(FrictionKind::stribeck)), speed, random);
    FrictionRun run;
    run.measurement = {trace_rate, trace.force, trace.speed, {}, trace_preload};
    const FrictionFit fit = friction_fit(friction_points({&run, 1}));
    const FittedLaw& law = fit.laws[law_called(fit, "stribeck")];
    for (const FittedNumber& number : law.numbers)
        if (number.field->symbol != "delta") {
            const double value = true_value(true_contact(FrictionKind::stribeck), number.field->symbol);
            EXPECT_NEAR(number.value, value, number.to - number.from) << number.field->symbol;
        }
    EXPECT_GT(fit.speeds, 20U);
}

// White noise hangs together for one sample. A law that falls over a sweep would hang together for all of it, were it
// not left out.
TEST(FrictionPoints, OfASweepAreMeansOfBlocksAsShortAsAtOneSpeed) {
    support::CounterRandom random(5);
    const model::FrictionLaw law = model::friction_law(true_contact(FrictionKind::linear));
    const auto block_of = [&](double change) {
        RigTrace trace;
        for (int k = 0; k < 4000; ++k) {
            trace.speed.push_back(0.06 - change * k / 4000.0);
            const double friction = -slip_ratio(law, model::Slip::forward, trace.speed.back());
            trace.force.push_back(trace_preload * friction + 0.02 * normal(random));
        }
        FrictionRun run;
        run.measurement = {trace_rate, trace.force, trace.speed, {}, trace_preload};
        return friction_points({&run, 1}).longest_block;
    };
    EXPECT_NEAR(block_of(0.0), 0.01, 0.01);
    EXPECT_NEAR(block_of(0.05), 0.01, 0.01);
}

// A sweep over three v_s tells the two Stribeck laws apart in about half of the traces. Then the sentence names one; it
// must not name the wrong one.
TEST(FrictionFit, OfASweepNamesTheRightLawWhereItIsSure) {
    const std::size_t traces = fitted_traces(10);
    std::size_t sure = 0, right = 0;
    for (const std::size_t kind : {std::size_t{2}, std::size_t{3}}) {
        const model::FrictionLaw law = model::friction_law(true_contact(fitted_kinds[kind]));
        for (std::size_t trace = 0; trace < traces; ++trace) {
            support::CounterRandom random(10 * trace + kind + 1);
            std::vector<double> speed;
            for (int k = 0; k < 20000; ++k)
                speed.push_back(0.0005 + 0.06 * std::abs(std::fmod(k / 5000.0, 2.0) - 1.0));
            const RigTrace measured = trace_of(law, speed, random);
            FrictionRun run;
            run.measurement = {trace_rate, measured.force, measured.speed, {}, trace_preload};
            const FrictionFit fit = friction_fit(friction_points({&run, 1}));
            const std::string words = words_of(fit);
            if (words.find("do not tell") != std::string::npos) continue;
            sure += 1;
            right += fit.laws[fit.best].kind == kind ? 1 : 0;
        }
    }
    if (traces > 10) std::printf("%zu sweeps: %zu named, %zu of them rightly\n", 2 * traces, sure, right);
    EXPECT_GE(static_cast<double>(right), 0.95 * static_cast<double>(sure) - 1.0);
}

TEST(FrictionFit, TakesCoulombsNumbersFromStickSlip) {
    // a saw tooth between 5 and 3 N: it climbs for 90 ms and falls within 10
    std::vector<double> force;
    for (int k = 0; k < 3000; ++k)
        force.push_back(k % 100 < 90 ? 3.0 + 2.0 * (k % 100) / 90.0 : 5.0 - 2.0 * (k % 100 - 90) / 10.0);
    FrictionRun run;
    run.name = "saw";
    run.measurement = {trace_rate, force, {}, {}, trace_preload};
    const FrictionPoints points = friction_points({&run, 1});
    EXPECT_TRUE(points.points.empty());
    ASSERT_EQ(points.notes.size(), 1U);
    EXPECT_EQ(points.notes.front(), "saw has stick-slip: the mean of its force is no friction at its speed");
    const FrictionFit fit = friction_fit(points);
    ASSERT_EQ(fit.laws.size(), 1U);
    EXPECT_NEAR(fit.laws[0].contact.static_friction, 0.5, 0.01);
    EXPECT_NEAR(fit.laws[0].contact.kinetic_friction, 0.4, 0.01);
}

TEST(FrictionFit, DoesNotTakeARigThatRingsForStickSlip) {
    support::CounterRandom random(5);
    const std::vector<RigTrace> traces = seven_runs(model::friction_law(true_contact(FrictionKind::linear)), random);
    EXPECT_GT(friction_trace(runs_of(traces).back().measurement).all.drops, 10) << "it falls by more than 5 %";
    EXPECT_TRUE(friction_points(runs_of(traces)).notes.empty());
}

TEST(FrictionFit, RefusesWhatHasNoAnswer) {
    support::CounterRandom random(6);
    std::vector<RigTrace> traces = seven_runs(model::friction_law(true_contact(FrictionKind::coulomb)), random);
    std::vector<FrictionRun> runs = runs_of(traces);
    runs[2].velocity = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(support::thrown_by([&] { friction_points(runs); }).says("the speed of run 3 is not known"));
    for (double& force : traces[1].force)
        force = -force;
    runs = runs_of(traces);
    runs[1].measurement.velocity = traces[1].speed;
    EXPECT_TRUE(support::thrown_by([&] { friction_points(runs); }).says("comes out negative"));
    const std::vector<double> still(4000, 0.0);
    runs[0].measurement.force = still;
    EXPECT_TRUE(support::thrown_by([&] { friction_points(runs); }).says("nothing slides in this trace"));
    runs[0].measurement.velocity = traces[0].speed;
    EXPECT_TRUE(support::thrown_by([&] { friction_points(runs); }).says("nothing rubs in run 1"));
    EXPECT_TRUE(support::thrown_by([] { friction_fit({}); }).says("a fit needs 4 at least"));
}

}  // namespace
}  // namespace stridor::analysis
