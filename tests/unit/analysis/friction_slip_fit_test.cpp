// Traces of stick-slip: a slider of 127 g on a spring of 2 N/mm, dragged at 4 mm/s and sampled at 1 kHz. Friction is a
// share of its own (0.3 %) higher or lower in each slip; the sensor has noise of 5 mN. STRIDOR_FIT_TRACES in the
// environment says how many of each law.

#include "friction_fit_support.hpp"
#include "stridor/analysis/friction/slip_fit.hpp"
#include "stridor/model/laws/friction.hpp"
#include "support/counter_random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stridor::analysis {
namespace {

using parameters::FrictionKind;

constexpr MeasuringRig slip_rig{0.127, 2000.0, 0.4};
constexpr double slip_velocity = 4e-3, slip_rate = 1000.0, slip_load = 10.0;  // [m/s], [Hz], [N]
constexpr double to_fit = std::numeric_limits<double>::quiet_NaN();

struct SlipNoise {
    double sensor = 0.005;   // [N] standard deviation
    double between = 0.003;  // [1] of the share
};

parameters::Contact slipping_contact(FrictionKind kind) {
    parameters::Contact contact;
    contact.friction = kind;
    contact.static_friction = 0.5;
    contact.kinetic_friction = kind == FrictionKind::linear ? 0.4 : 0.3;
    contact.friction_slope = 1.0;
    contact.stribeck_velocity = 0.02;
    return contact;
}

// Explicit midpoint steps of 10 us, other than those of the fit; a release is where the force of the stick crosses the
// limit, and a stick begins where the velocities cross, both on a straight line within the step.
std::vector<double> stick_slip(const model::FrictionLaw& law, const SlipNoise& noise, double duration,
                               support::CounterRandom& random) {
    constexpr std::size_t substeps = 100;
    constexpr double h = 1.0 / slip_rate / static_cast<double>(substeps);
    const auto& [mass, stiffness, damping] = slip_rig;
    const double limit = stick_limit(law, model::Slip::forward);
    double x = 0.0, v = slip_velocity, share = 1.0;
    bool sticks = true;
    const auto acceleration = [&](double place, double velocity) {
        const double w = std::max(0.0, slip_velocity - velocity);
        const double friction = -slip_ratio(law, model::Slip::forward, w) * share * slip_load;
        return (friction - stiffness * place - damping * velocity) / mass;
    };
    const auto slide = [&](double time) {
        const double half_v = v + 0.5 * time * acceleration(x, v), half_x = x + 0.5 * time * v;
        x += time * half_v;
        v += time * acceleration(half_x, half_v);
    };
    std::vector<double> force;
    for (long sample = 0; sample < static_cast<long>(duration * slip_rate); ++sample) {
        for (std::size_t k = 0; k < substeps; ++k) {
            if (sticks) {
                const double released = (limit * share * slip_load - damping * slip_velocity) / stiffness;
                const double time = (released - x) / slip_velocity;
                x += slip_velocity * std::min(h, time);
                if (time >= h) continue;
                sticks = false;
                slide(h - time);
                continue;
            }
            const double before_x = x, before_v = v;
            slide(h);
            if (v < slip_velocity || before_v == slip_velocity) continue;
            const double part = (slip_velocity - before_v) / (v - before_v);
            x = before_x + part * (x - before_x) + (1.0 - part) * h * slip_velocity;
            v = slip_velocity;
            sticks = true;
            share = 1.0 + noise.between * normal(random);
        }
        force.push_back(stiffness * x + noise.sensor * normal(random));
    }
    return force;
}

FrictionFit fit_of_stick_slip(FrictionKind kind, const MeasuringRig& rig, std::uint64_t seed,
                              const SlipNoise& noise = {}) {
    support::CounterRandom random(seed);
    const std::vector<double> force = stick_slip(model::friction_law(slipping_contact(kind)), noise, 20.0, random);
    FrictionRun run;
    run.name = "slips";
    run.measurement = {slip_rate, force, {}, {}, slip_load};
    run.velocity = slip_velocity;
    return friction_fit(friction_points({&run, 1}), rig);
}

TEST(SlipTrack, IsASwingAboutKineticFrictionWithCoulombsLaw) {
    parameters::Contact contact;
    contact.static_friction = 1.0;
    contact.kinetic_friction = 0.6;
    constexpr MeasuringRig rig{0.127, 2000.0, 0.0};
    const double w0 = std::sqrt(rig.stiffness / rig.mass), V = slip_velocity;
    std::vector<double> times;
    for (int k = -5; k < 25; ++k)
        times.push_back((k + 0.3) / slip_rate);
    const SlipTrack track = slip_track(model::friction_law(contact), rig, {V, 5.0, 2.5e-4}, times);
    for (std::size_t k = 0; k < times.size(); ++k) {
        // m x'' + k x = 3 N from x = 5 N/k and x' = V on; before, the spring is wound up
        const double t = times[k];
        const double force = t <= 0.0 ? 5.0 + rig.stiffness * V * t
                                      : 3.0 + 2.0 * std::cos(w0 * t) + rig.stiffness * V / w0 * std::sin(w0 * t);
        EXPECT_NEAR(track.force[k], force, 1e-5) << t;  // O(h^4): (w0 h)^4/120 per step of 2 N, 100 steps
    }
}

TEST(SlipTrack, SticksAgainOnceTheSliderIsAsFastAsTheDrive) {
    parameters::Contact contact;
    contact.static_friction = 1.0;
    contact.kinetic_friction = 0.6;
    const std::vector<double> times{0.06, 0.061, 0.08};
    const SlipTrack track = slip_track(model::friction_law(contact), slip_rig, {slip_velocity, 5.0, 2.5e-4}, times);
    const double climb = slip_rig.stiffness * slip_velocity;
    EXPECT_NEAR(track.force[1] - track.force[0], climb * 0.001, 1e-12);
    EXPECT_NEAR(track.force[2] - track.force[0], climb * 0.020, 1e-12);
    EXPECT_EQ(track.rate[2], climb);
}

TEST(FrictionFitOfSlips, FindsTheLawOfAnExactTrace) {
    for (std::size_t kind = 0; kind < 4; ++kind) {
        const parameters::Contact truth = slipping_contact(fitted_kinds[kind]);
        const FrictionFit fit = fit_of_stick_slip(fitted_kinds[kind], slip_rig, 1, {0.0, 0.0});
        ASSERT_GE(fit.slips, 30U);
        EXPECT_EQ(fit.laws[fit.best].kind, kind);
        for (const FittedNumber& number : fit.laws[law_called(fit, fitted_names[kind])].numbers) {
            if (number.field->symbol == "delta") continue;
            const double value = true_value(truth, number.field->symbol);
            EXPECT_NEAR(number.value, value, 1e-4 * value) << fitted_names[kind] << " " << number.field->symbol;
        }
    }
}

// share of intervals that hold the truth, by number
struct Coverage {
    std::map<std::string, std::pair<std::size_t, std::size_t>> numbers;  // covering, all
    std::size_t told = 0;

    void add(const std::string& name, double from, double to, double truth) {
        auto& [covering, all] = numbers[name];
        covering += from <= truth && truth <= to ? 1 : 0;
        all += 1;
    }
    double share() const {
        double covering = 0.0, all = 0.0;
        for (const auto& [name, counts] : numbers) {
            covering += static_cast<double>(counts.first);
            all += static_cast<double>(counts.second);
        }
        return covering / all;
    }
};

Coverage coverage_of(const MeasuringRig& rig, std::size_t traces) {
    Coverage coverage;
    for (std::size_t kind = 0; kind < 4; ++kind) {
        const parameters::Contact truth = slipping_contact(fitted_kinds[kind]);
        const std::string name(fitted_names[kind]);
        for (std::size_t trace = 0; trace < traces; ++trace) {
            const FrictionFit fit = fit_of_stick_slip(fitted_kinds[kind], rig, 10 * trace + kind + 1);
            coverage.told += fit.laws[fit.best].kind == kind && fit.rivals.empty() ? 1 : 0;
            const FittedLaw& law = fit.laws[law_called(fit, fitted_names[kind])];
            for (const FittedNumber& number : law.numbers)
                if (number.field->symbol != "delta")
                    coverage.add(name + " " + std::string(number.field->symbol), number.from, number.to,
                                 true_value(truth, number.field->symbol));
            for (const RigNumber& number : law.rig)
                coverage.add(name + " " + std::string(number.name), number.from, number.to,
                             number.name == "mass" ? slip_rig.mass : slip_rig.stiffness);
        }
    }
    return coverage;
}

void expect_coverage(const Coverage& coverage, std::size_t traces, std::size_t usual) {
    if (traces > usual) {
        for (const auto& [name, counts] : coverage.numbers)
            std::printf("%-26s %.3f of %zu\n", name.c_str(),
                        static_cast<double>(counts.first) / static_cast<double>(counts.second), counts.second);
        std::printf("%.4f of all intervals hold the truth; %zu of %zu laws told\n", coverage.share(), coverage.told,
                    4 * traces);
    }
    // 95 % within three standard deviations of so many traces, whose intervals count as one, and two hundredths
    EXPECT_NEAR(coverage.share(), 0.95, 0.02 + 3.0 * std::sqrt(0.95 * 0.05 / (4.0 * static_cast<double>(traces))));
    EXPECT_GE(static_cast<double>(coverage.told), 0.9 * 4.0 * static_cast<double>(traces));
}

TEST(FrictionFitOfSlips, CoversTheTruthWithAKnownRig) {
    const std::size_t traces = fitted_traces(1);
    expect_coverage(coverage_of(slip_rig, traces), traces, 1);
}

TEST(FrictionFitOfSlips, CoversTheTruthAndTheRigWhereItIsFitted) {
    const std::size_t traces = fitted_traces(1);
    expect_coverage(coverage_of({to_fit, to_fit, slip_rig.damping}, traces), traces, 1);
}

// steady means at 30 to 120 mm/s, where slips seldom go, with noise of 0.2 % of the preload
FrictionPoints steady_points(const parameters::Contact& contact, support::CounterRandom& random) {
    FrictionPoints points;
    const model::FrictionLaw law = model::friction_law(contact);
    for (std::size_t run = 0; run < 4; ++run)
        for (std::size_t k = 0; k < 40; ++k) {
            FrictionPoint point;
            const double speed = 0.03 * static_cast<double>(run + 1);
            point.speeds.fill(speed);
            point.friction = slip_ratio(law, model::Slip::backward, -speed) + 0.002 * normal(random);
            point.run = run + 1;
            points.points.push_back(point);
        }
    return points;
}

double width_of(const FrictionFit& fit, std::string_view law, std::string_view symbol) {
    for (const FittedNumber& number : fit.laws[law_called(fit, law)].numbers)
        if (number.field->symbol == symbol) return number.to - number.from;
    return 0.0;
}

// what both say is told better than what either says, and lies where the truth is
TEST(FrictionFitOfBoth, JoinsSteadyRunsAndSlips) {
    for (std::size_t kind = 0; kind < 4; ++kind) {
        const std::string name(fitted_names[kind]);
        const parameters::Contact truth = slipping_contact(fitted_kinds[kind]);
        support::CounterRandom random(1000 + kind);  // other numbers than those of the slips
        FrictionPoints both = steady_points(truth, random);
        const FrictionFit slips = fit_of_stick_slip(fitted_kinds[kind], slip_rig, kind + 1);
        both.slips = slips.data.slips;
        const FrictionFit steady = friction_fit(both);
        const FrictionFit fit = friction_fit(both, slip_rig);
        EXPECT_EQ(fit.laws[fit.best].kind, kind) << words_of(fit);
        EXPECT_EQ(fit.slips, slips.slips);
        EXPECT_EQ(fit.laws[fit.best].residuals.size(), both.points.size());
        for (const FittedNumber& number : fit.laws[law_called(fit, name)].numbers) {
            const std::string symbol(number.field->symbol);
            if (symbol == "delta") continue;
            const double value = true_value(truth, symbol), half = 0.5 * (number.to - number.from);
            EXPECT_NEAR(number.value, value, 1.7 * half) << name << " " << symbol;
            EXPECT_LT(2.0 * half, 1.02 * width_of(slips, name, symbol)) << name << " " << symbol;
        }
        if (kind == 0) continue;
        EXPECT_LT(width_of(fit, name, "mu_d"), 0.8 * width_of(steady, name, "mu_d")) << name;
    }
}

TEST(FrictionFitOfSlips, NeedsTheRig) {
    support::CounterRandom random(1);
    const std::vector<double> force =
        stick_slip(model::friction_law(slipping_contact(FrictionKind::coulomb)), {}, 5.0, random);
    FrictionRun run;
    run.measurement = {slip_rate, force, {}, {}, slip_load};
    run.velocity = slip_velocity;
    const FrictionFit fit = friction_fit(friction_points({&run, 1}));
    ASSERT_EQ(fit.laws.size(), 1U);
    EXPECT_EQ(fit.slips, 0U);
    EXPECT_EQ(fit.unfitted[0].why, "the runs have stick-slip, and the rig is not known (--mass, --stiffness)");
}

}  // namespace
}  // namespace stridor::analysis
