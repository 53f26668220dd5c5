#include "stridor/hearing/run_sound.hpp"

#include "stridor/parameters/paper_cases.hpp"
#include "stridor/sweep/ready_charts.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace stridor::hearing {
namespace {

using parameters::Case;
using parameters::Direction;
using signal::Signal;
using sound::AuralisationSettings;
using support::thrown_by;

// 0.3 s of the squeal of Table 1: going from 0, coming from about 0.05 s on, and so on
Case squeal() {
    Case c = parameters::paper_case(parameters::PaperCase::squeal);
    c.run.duration = 0.3;
    c.run.window = 0.3;
    return c;
}

// as `stridor simulate --trace` and `sound::auralise` have it
Signal from_trace(const Case& c, const AuralisationSettings& settings) {
    record::Request request;
    request.trace = {0.0, c.run.duration, 1.0 / (settings.rate * settings.density), {}};
    return sound::auralise(integration::simulate(c, request).record.trace, settings);
}

TEST(SoundOfCase, OfTheWholeRunIsThatOfItsTrace) {
    AuralisationSettings settings;
    settings.rate = 16000.0;
    const Signal sound = sound_of_case(squeal(), settings);
    const Signal expected = from_trace(squeal(), settings);
    EXPECT_EQ(sound.rate, 16000.0);
    EXPECT_EQ(sound.unit, "m/s");
    EXPECT_EQ(sound.samples.size(), 4801U);
    EXPECT_EQ(sound.samples, expected.samples);
}

TEST(SoundOfCase, IsItsPhasesOneAfterTheOther) {
    const Case c = squeal();
    AuralisationSettings settings;
    settings.rate = 16000.0;
    settings.stretches = heard_stretches(c, Direction::going);
    ASSERT_GE(settings.stretches.size(), 2U);
    const Signal sound = sound_of_case(c, settings);
    const Signal expected = from_trace(c, settings);
    double seconds = 0.0;
    for (const sound::Stretch& stretch : settings.stretches)
        seconds += stretch.to - stretch.from;
    // a sample more or less where a stretch begins and ends
    EXPECT_NEAR(signal::duration(sound), seconds, 2.0 * static_cast<double>(settings.stretches.size()) / sound.rate);
    ASSERT_EQ(sound.samples.size(), expected.samples.size());
    const double peak = sound::peak(expected.samples);
    for (std::size_t n = 0; n < sound.samples.size(); ++n)
        ASSERT_NEAR(sound.samples[n], expected.samples[n], 1e-12 * peak) << n;
    EXPECT_EQ(sound.samples.front(), 0.0) << "faded in";
}

TEST(SoundOfRun, CutsStretchesThatOverlapEachByItself) {
    const Case c = squeal();
    AuralisationSettings settings{.rate = 16000.0, .fade = 0.0};
    settings.stretches = {{0.1, 0.2}, {0.15, 0.25}};
    integration::Workspace workspace;
    const std::optional<RunSound> run = sound_of_run(c, settings, {}, workspace);
    ASSERT_TRUE(run);
    ASSERT_EQ(run->parts.size(), 2U);
    ASSERT_EQ(run->parts[0].samples.size(), 1600U);
    ASSERT_EQ(run->parts[1].samples.size(), 1600U);
    EXPECT_TRUE(
        std::equal(run->parts[0].samples.begin() + 800, run->parts[0].samples.end(), run->parts[1].samples.begin()));
    EXPECT_EQ(joined(run->parts).samples.size(), 3200U);
}

TEST(SoundOfRun, SamplesNoMoreThanFiltersLookAhead) {
    const Case c = squeal();
    AuralisationSettings settings{.rate = 8000.0, .stretches = {{0.05, 0.1}}};
    EXPECT_EQ(sound::heard_until(settings, c.run.duration), 0.2);
    integration::Workspace workspace;
    const std::optional<RunSound> early = sound_of_run(c, settings, {}, workspace);
    settings.stretches.push_back({0.2, 0.3});
    EXPECT_EQ(sound::heard_until(settings, c.run.duration), 0.3);
    const std::optional<RunSound> whole = sound_of_run(c, settings, {}, workspace);
    ASSERT_TRUE(early && whole);
    EXPECT_EQ(early->parts[0].samples, whole->parts[0].samples) << "what was not sampled changes no bit";
}

TEST(SoundOfRun, WhatHardlyMovesIsSilent) {
    Case c = sweep::figure_8().base;
    c.contact().kinetic_friction = 0.0;
    c.contact().preload = 20.0;
    AuralisationSettings settings;
    settings.stretches = heard_stretches(c, Direction::going);
    const Signal sound = sound_of_case(c, settings);
    EXPECT_FALSE(sound.samples.empty());
    EXPECT_EQ(sound::peak(sound.samples), 0.0);
}

TEST(SoundOfCase, RefusesWhatCannotBeHeard) {
    Case c = squeal();
    c.contact().kinetic_friction = 0.9;
    EXPECT_EQ(thrown_by([&] { sound_of_case(c, {}); }).kind, ErrorKind::input);
    EXPECT_TRUE(heard_stretches(c, Direction::going).empty());
    c = squeal();
    c.run.engine = parameters::Engine::beta_2;
    c.run.step = 1e-5;
    const support::Thrown thrown = thrown_by([&] { sound_of_case(c, {}); });
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_TRUE(thrown.says("Use at most 5.208e-06 s")) << thrown.message;
    c.run.step = 5.208e-6;
    EXPECT_NO_THROW(check_audible(c, {}));
    std::stop_source stop;
    stop.request_stop();
    EXPECT_EQ(thrown_by([&] { sound_of_case(squeal(), {}, stop.get_token()); }).kind, ErrorKind::interrupted);
}

}  // namespace
}  // namespace stridor::hearing
