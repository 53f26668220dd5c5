// From the engine to the sound: against closed forms of the mass on a belt, and against denser traces.

#include "stridor/sound/auralisation.hpp"

#include "stridor/base/elementary.hpp"
#include "stridor/integration/exact/exact.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/model/built/mass_on_belt.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/parameters/system.hpp"
#include "support/belt_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace stridor::sound {
namespace {

using parameters::PaperCase;

constexpr double rate = 48000.0;

record::Record run_belt(const support::BeltRun& run) {
    parameters::Case c;
    c.drive = support::constant_drive(1.0);
    c.run.duration = c.run.window = run.duration;
    return integration::integrate_exact(model::mass_on_belt(run.belt), run.drive, run.start, {},
                                        record::Recorder(record::schedule(c), run.request, 2))
        .record;
}

// The undamped stick-slip cycle: v = V while sticking for 2 lambda / w0, then V cos - V lambda sin for 2
// (pi - atan lambda) / w0
struct BeltCycle {
    double w0, lambda, velocity;

    double stick() const { return 2.0 * lambda / w0; }
    double slip() const { return 2.0 * (std::numbers::pi - std::atan(lambda)) / w0; }
    double period() const { return stick() + slip(); }

    // coefficient of exp(i 2 pi n t / period), time counted from the beginning of a slip: sums of exponentials
    std::complex<double> harmonic(int n) const {
        using Complex = std::complex<double>;
        const Complex i(0.0, 1.0);
        const double w = 2.0 * std::numbers::pi * n / period();
        const auto integral = [&](Complex exponent, double from, double to) {
            return (std::exp(exponent * to) - std::exp(exponent * from)) / exponent;
        };
        const Complex up = 0.5 * (velocity - lambda * velocity / i), down = 0.5 * (velocity + lambda * velocity / i);
        return (up * integral(i * (w0 - w), 0.0, slip()) + down * integral(i * (-w0 - w), 0.0, slip()) +
                velocity * integral(-i * w, slip(), period())) /
               period();
    }
};

TEST(Auralisation, GivesTheHarmonicsOfTheClosedBeltCycle) {
    // 2.69 kHz: no harmonic lies where the low pass falls
    const double lambda = 1.0, distance = 1e-5;
    const double w0 =
        2.0 * std::numbers::pi * 2690.123 * (lambda + std::numbers::pi - std::atan(lambda)) / std::numbers::pi;
    const BeltCycle cycle{w0, lambda, w0 * distance / lambda};
    ASSERT_NEAR(1.0 / cycle.period(), 2690.123, 1e-6);

    support::BeltRun run;
    run.belt = {1.0, w0 * w0, 0.0, 2.0 * distance * w0 * w0, {0.8, 0.3}};
    run.drive = support::constant_drive(cycle.velocity);
    run.start = {parameters::Initial::stuck, 0.0};
    run.duration = 0.1;
    run.request = {record::KeepHistory::yes, {0.0, run.duration, 1.0 / (rate * trace_density)}};
    const record::Record record = run_belt(run);
    const auto first_slip = std::find_if(
        record.histories.front().begin(), record.histories.front().end(),
        [](const auto& interval) { return interval.state == model::ContactState::slip && interval.from > 0.0; });
    ASSERT_NE(first_slip, record.histories.front().end());

    for (const signal::MotionQuantity quantity :
         {signal::MotionQuantity::velocity, signal::MotionQuantity::acceleration}) {
        const signal::Signal sound = auralise(record.trace, {{quantity}, rate, 0.0, 0.0, {}});
        EXPECT_EQ(sound.unit, unit_of(quantity));
        ASSERT_EQ(sound.samples.size(), 4801U);
        const int highest = static_cast<int>(0.45 * rate * cycle.period());
        double most = 0.0, fundamental = 0.0;
        for (std::size_t k = 1000; k < 3800; ++k) {
            double wanted = 0.0;
            for (int n = 1; n <= highest; ++n) {
                const double turns = n * (static_cast<double>(k) / rate - first_slip->from) / cycle.period();
                const base::SineCosine at = base::sine_cosine_of_turns(turns);
                std::complex<double> c = cycle.harmonic(n);
                if (quantity == signal::MotionQuantity::acceleration)
                    c *= std::complex<double>(0.0, 2.0 * std::numbers::pi * n / cycle.period());
                if (n == 1) fundamental = 2.0 * std::abs(c);
                wanted += 2.0 * (c.real() * at.cosine - c.imag() * at.sine);
            }
            most = std::max(most, std::abs(sound.samples[k] - wanted));
        }
        EXPECT_LT(20.0 * std::log10(most / fundamental), -90.0);
    }
}

record::Trace trace_of(const parameters::Case& c, double interval) {
    return integration::simulate(c, {record::KeepHistory::no, {0.0, c.run.duration, interval}}).record.trace;
}

TEST(Auralisation, OfImpactsIsThatOfADenserTrace) {
    parameters::Case c = parameters::paper_case(PaperCase::squeal);
    c.run.duration = c.run.window = 0.05;
    const record::Trace usual = trace_of(c, 1.0 / (rate * trace_density));
    const record::Trace dense = trace_of(c, 1.0 / (rate * 8 * trace_density));
    for (const std::size_t dof : {0U, 1U, 2U})
        for (const signal::MotionQuantity quantity :
             {signal::MotionQuantity::velocity, signal::MotionQuantity::acceleration}) {
            const AuralisationSettings settings{{quantity, parameters::weight_of_one(c, dof)}, rate, 0.0, 0.0, {}};
            const std::vector<double> a = auralise(usual, settings).samples, b = auralise(dense, settings).samples;
            ASSERT_EQ(a.size(), b.size());
            double most = 0.0;
            for (std::size_t k = 0; k < a.size(); ++k)
                most = std::max(most, std::abs(a[k] - b[k]));
            EXPECT_LT(20.0 * std::log10(most / peak(b)), quantity == signal::MotionQuantity::velocity ? -90.0 : -75.0)
                << dof;
        }
}

TEST(Auralisation, InBlocksIsThatOfTheWhole) {
    parameters::Case c = parameters::paper_case(PaperCase::squeak);
    c.run.duration = c.run.window = 0.2;
    const AuralisationSettings settings{
        {signal::MotionQuantity::velocity}, rate, 20.0, 5e-3, {{0.01, 0.06}, {0.1, 0.1505}}};
    Auralisation auralisation(settings);
    std::vector<double> sound;
    std::size_t largest = 0;
    record::Request request;
    request.trace = auralisation.request(c.run.duration, [&](std::span<const double> block) {
        largest = std::max(largest, block.size());
        sound.insert(sound.end(), block.begin(), block.end());
    });
    EXPECT_TRUE(integration::simulate(c, request).record.trace.time.empty());
    const std::vector<double> rest = auralisation.finish();
    sound.insert(sound.end(), rest.begin(), rest.end());
    EXPECT_LE(largest, record::trace_block);
    EXPECT_EQ(sound, auralise(trace_of(c, 1.0 / (rate * trace_density)), settings).samples);
    EXPECT_EQ(sound.size(), 2400U + 2424U);
    EXPECT_EQ(sound.front(), 0.0);
    EXPECT_EQ(sound[2400], 0.0);
    EXPECT_LT(std::abs(sound.back()), 1e-3 * peak(sound));
}

TEST(Auralisation, LeavesOutTheDrivesOwnMotion) {
    // a joint that sticks moves as the plate does: nothing to hear
    record::Trace trace;
    trace.displacement.resize(1);
    trace.velocity.resize(1);
    trace.acceleration.resize(1);
    const double frequency = 5.0, omega = 2.0 * std::numbers::pi * frequency, h = 1.0 / (rate * trace_density);
    for (int k = 0; k <= 48000 * trace_density / 2; ++k) {
        const base::SineCosine at = base::sine_cosine_of_turns(frequency * h * k);
        trace.time.push_back(h * k);
        trace.displacement[0].push_back(4e-3 * at.sine);
        trace.velocity[0].push_back(4e-3 * omega * at.cosine);
        trace.acceleration[0].push_back(-4e-3 * omega * omega * at.sine);
    }
    const auto loudness = [&](double high_pass) {
        return peak(auralise(trace, {{signal::MotionQuantity::velocity}, rate, high_pass, 5e-3, {{0.1, 0.5}}}).samples);
    };
    EXPECT_NEAR(loudness(0.0), 4e-3 * omega, 1e-6);
    EXPECT_LT(loudness(20.0), 0.07 * 4e-3 * omega);  // (5/20)^2 = 1/16
}

TEST(Auralisation, CutsTheStretchesOfADirection) {
    parameters::Case c = parameters::paper_case(PaperCase::squeal);
    const record::Schedule schedule = record::schedule(c);
    const std::vector<Stretch> going = stretches_of(schedule, record::Phase::going, record::Use::counted);
    const std::vector<Stretch> judged = stretches_of(schedule, record::Phase::going, record::Use::judged);
    ASSERT_EQ(going.size(), 6U);  // four whole ones, two cut by the ends of the run
    ASSERT_EQ(judged.size(), 4U);
    double whole = 0.0;
    for (const Stretch& stretch : going)
        whole += stretch.to - stretch.from;
    EXPECT_NEAR(whole, 0.5, 1e-12);
    for (const Stretch& stretch : judged)
        EXPECT_NEAR(stretch.to - stretch.from, 0.1 * (1.0 - c.verdict.settling - c.verdict.reversal), 1e-12);
}

TEST(Auralisation, IsOfTheFirstDegreeOfFreedomWhereNothingElseIsSaid) {
    parameters::Case c = parameters::two_lips();
    c.run.duration = c.run.window = 0.01;
    const record::Trace trace = trace_of(c, 1.0 / (rate * trace_density));
    ASSERT_EQ(trace.displacement.size(), 5U);
    const auto heard = [&](std::vector<double> weights) {
        return auralise(trace, {{signal::MotionQuantity::velocity, std::move(weights)}, rate, 0.0, 0.0, {}}).samples;
    };
    EXPECT_EQ(heard({}), heard(parameters::weight_of_one(c, 0)));
    EXPECT_NE(heard({}), heard(parameters::weight_of_one(c, 4)));
    EXPECT_GT(peak(heard(parameters::weight_of_one(c, 4))), 0.0);
}

TEST(Auralisation, OfAPointIsTheSumOfWhatMovesIt) {
    parameters::Case c = parameters::two_lips();
    c.run.duration = c.run.window = 0.01;
    const record::Trace trace = trace_of(c, 1.0 / (rate * trace_density));
    const auto heard = [&](const Pickup& pickup) { return auralise(trace, {pickup, rate, 0.0, 0.0, {}}).samples; };
    const signal::MotionQuantity velocity = signal::MotionQuantity::velocity;
    const std::vector<double> sum = heard({velocity, {2.0, 0.0, 0.0, 0.0, -1.0}});
    const std::vector<double> joint = heard({velocity}), plate = heard({velocity, parameters::weight_of_one(c, 4)});
    ASSERT_EQ(sum.size(), joint.size());
    // each jump is placed by its own moments: what the band limit of one of them may miss, -110 dB
    for (std::size_t i = 0; i < sum.size(); ++i)
        EXPECT_NEAR(sum[i], 2.0 * joint[i] - plate[i], 1e-5 * peak(sum)) << i;
}

}  // namespace
}  // namespace stridor::sound
