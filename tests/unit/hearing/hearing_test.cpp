#include "stridor/hearing/hearing.hpp"

#include "stridor/base/error.hpp"
#include "stridor/hearing/hearing_run.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/sweep/evaluate.hpp"
#include "stridor/sweep/ready_charts.hpp"
#include "support/scratch_folder.hpp"
#include "support/small_study.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <set>

namespace stridor::hearing {
namespace {

using classification::Category;
using parameters::Direction;

constexpr std::array both_directions{Direction::going, Direction::coming};

// 0.2 s of a plane that holds every category: half of it is heard
sweep::Study audible_study() {
    sweep::Study study = sweep::figure_8();
    study.base.run.duration = 0.3;
    study.base.run.window = 0.15;
    study.x.points = 4;
    study.y.points = 3;
    return study;
}

std::vector<HeardSound> heard(parameters::PaperCase which) {
    integration::Workspace workspace;
    return hear(parameters::paper_case(which), both_directions, {}, {}, workspace);
}

bool same_sound(const HeardSound& a, const HeardSound& b) {
    const auto& f = a.features;
    const auto& g = b.features;
    return a.index == b.index && same_cell(a.cell, b.cell) && a.heard == b.heard && a.perturbed == b.perturbed &&
           a.reason == b.reason && sweep::same_bits(f.mean_square, g.mean_square) &&
           sweep::same_bits(f.frequency, g.frequency) && sweep::same_bits(f.regularity, g.regularity) &&
           sweep::same_bits(f.rest, g.rest);
}

TEST(Hearing, TheFourCasesOfTable1SoundAsTheirContactStatesSay) {
    constexpr std::array expected{Category::squeal, Category::squeak, Category::creak, Category::none};
    for (std::size_t k = 0; k < expected.size(); ++k) {
        const std::vector<HeardSound> sounds = heard(static_cast<parameters::PaperCase>(k));
        ASSERT_EQ(sounds.size(), 2u);
        EXPECT_EQ(sounds[0].cell.category, expected[k]) << parameters::paper_case_names[k];
        EXPECT_EQ(sounds[0].heard, expected[k]) << parameters::paper_case_names[k] << ": " << sounds[0].reason;
        EXPECT_EQ(sounds[1].heard, sounds[1].cell.category) << sounds[1].reason;
    }
}

TEST(Hearing, TheVerdictByContactStatesIsThatOfTheSameRun) {
    parameters::Case c = sweep::case_at(audible_study(), {0, 1, 2});
    c.run.early_ending = parameters::EarlyEnding::never;
    integration::Workspace workspace;
    const std::array going{Direction::going};
    const std::vector<HeardSound> sounds = hear(c, going, {}, {}, workspace);
    ASSERT_EQ(sounds.size(), 1u);
    const std::optional<sweep::Attempt> plain = sweep::attempt(c, {}, {}, workspace);
    ASSERT_TRUE(plain);
    EXPECT_EQ(sounds[0].cell.category, sweep::cell_of(c, Direction::going, *plain).category);
    EXPECT_NEAR(sounds[0].features.duration, c.run.window, 1e-3);
}

// creep in the place of a stick makes a sound, too: it bears no verdict, by states or by ear, but where one is asked
// for
TEST(Hearing, HoldsBackTheVerdictOnRegularisedFriction) {
    integration::Workspace workspace;
    const std::array going{Direction::going};
    for (const auto friction : {parameters::FrictionKind::tanh, parameters::FrictionKind::arctan}) {
        parameters::Case c = parameters::paper_case(parameters::PaperCase::squeal);
        c.drive.kind = parameters::DriveKind::constant;
        c.drive.velocity = 0.1;
        c.contact().friction = friction;
        c.run.engine = parameters::Engine::moreau;
        c.run.step = 2e-6;
        c.run.duration = c.run.window = 0.12;
        HearingSettings settings;
        settings.seed = 1;
        const HeardSound held = hear(c, going, settings, {}, workspace).front();
        ASSERT_EQ(held.cell.status, sweep::Status::done) << held.cell.message;
        EXPECT_EQ(held.cell.category, Category::undecided);
        EXPECT_EQ(held.heard, Category::undecided);
        EXPECT_NE(held.reason.find("friction is regularised"), std::string::npos) << held.reason;
        for (const Category perturbed : held.perturbed)
            EXPECT_EQ(perturbed, Category::undecided);
        if (friction == parameters::FrictionKind::arctan) continue;
        c.verdict.creeping = parameters::Creeping::judged;
        const HeardSound asked = hear(c, going, {}, {}, workspace).front();
        EXPECT_EQ(asked.heard, Category::squeal) << asked.reason;
    }
}

TEST(Hearing, IsTheSameForEveryNumberOfThreads) {
    const sweep::Study study = audible_study();
    HearingOptions options;
    options.perturb_every = 11;
    options.crew = crew::thread_crews(1);
    const std::vector<HeardSound> one = hear(study, options);
    ASSERT_EQ(one.size(), sweep::cell_count(study));
    options.crew = crew::thread_crews(3);
    const std::vector<HeardSound> three = hear(study, options);
    ASSERT_EQ(three.size(), one.size());
    std::size_t perturbed_sounds = 0;
    for (std::size_t k = 0; k < one.size(); ++k) {
        EXPECT_EQ(one[k].index, k);
        EXPECT_TRUE(same_sound(one[k], three[k])) << k;
        perturbed_sounds += one[k].perturbed.empty() ? 0 : 1;
    }
    EXPECT_EQ(perturbed_sounds, 3u);  // 0, 11 and 22
}

TEST(Hearing, CountsEverySoundOnceAndInItsHalf) {
    const sweep::Study study = audible_study();
    HearingOptions options;
    options.perturb_every = 0;
    std::size_t reports = 0;
    std::size_t done = 0;
    options.progress = [&](const sweep::Progress& progress) {
        ++reports;
        EXPECT_LE(done, progress.done);
        done = progress.done;
        EXPECT_EQ(progress.total, sweep::cell_count(study));
    };
    const std::vector<HeardSound> sounds = hear(study, options);
    EXPECT_GT(reports, 0u);
    EXPECT_EQ(done, sounds.size());
    const std::size_t even = total(confusion(sounds, Half::even));
    const std::size_t odd = total(confusion(sounds, Half::odd));
    EXPECT_EQ(even, odd);
    EXPECT_EQ(total(confusion(sounds)), even + odd);
    EXPECT_EQ(total(perturbed_confusion(sounds, std::nullopt)), 0u);
    // a plane of this kind holds noise and silence, and ear and contact states mostly agree on it
    EXPECT_GT(classification::agreement(confusion(sounds)), 0.8);
}

TEST(Hearing, ASinusoidalDriveGivesBothDirectionsInOneRun) {
    sweep::Study study;
    study.base = parameters::paper_case(parameters::PaperCase::squeal);
    study.x = {"contact.preload", 10.0, 30.0, 2, sweep::Scale::linear};
    study.y = {"contact.kinetic_friction", 0.1, 0.6, 2, sweep::Scale::linear};
    HearingOptions options;
    options.perturb_every = 0;
    const std::vector<HeardSound> sounds = hear(study, options);
    ASSERT_EQ(sounds.size(), 8u);
    for (std::size_t k = 0; k < sounds.size(); ++k) {
        EXPECT_EQ(sounds[k].index, k);
        EXPECT_EQ(sounds[k].cell.status, sweep::Status::done);
    }
}

TEST(Hearing, WhatCannotMoveIsNotHeard) {
    sweep::Study study = audible_study();
    study.y = {"contact.kinetic_friction", 0.7, 0.9, 3, sweep::Scale::linear};  // above static friction at the end
    HearingOptions options;
    options.perturb_every = 1;
    const std::vector<HeardSound> sounds = hear(study, options);
    const HeardSound& last = sounds.back();
    EXPECT_EQ(last.cell.status, sweep::Status::invalid);
    EXPECT_TRUE(last.perturbed.empty());
    EXPECT_EQ(total(confusion(sounds)), 16u);
}

TEST(Hearing, AMotionWithoutVibrationIsSilenceWhateverTheNoise) {
    parameters::Case c = audible_study().base;
    c.contact().kinetic_friction = 0.0;
    c.contact().preload = 20.0;
    integration::Workspace workspace;
    HearingSettings settings;
    settings.seed = 1;
    const std::array going{Direction::going};
    const std::vector<HeardSound> sounds = hear(c, going, settings, {}, workspace);
    ASSERT_EQ(sounds.size(), 1u);
    EXPECT_EQ(sounds[0].heard, Category::none);
    for (const Category category : sounds[0].perturbed)
        EXPECT_EQ(category, Category::none);
}

TEST(Hearing, StopsOnRequestAndKeepsNothing) {
    std::stop_source stop;
    HearingOptions options;
    options.stop = stop.get_token();
    options.progress = [&](const sweep::Progress&) { stop.request_stop(); };
    EXPECT_TRUE(hear(sweep::figure_8(), options).empty());
}

// what an earlier run kept is taken as it is; what says nothing, or of too few directions, is heard anew
TEST(Hearing, GoesOnFromWhatIsKept) {
    sweep::Study study = audible_study();
    study.x.points = study.y.points = 2;
    HearingOptions options;
    options.perturb_every = 0;
    const std::vector<HeardSound> fresh = hear(study, options);
    ASSERT_EQ(fresh.size(), 8U);
    const support::ScratchFolder folder;
    const std::filesystem::path file = folder / "heard.sqlite";
    const std::string what = heard_text(study, options);
    {
        storage::KeptResults earlier(file, what, "cache");
        std::array<HeardSound, 1> known{fresh[1]};
        known[0].reason = "heard earlier";
        earlier.keep(1, packed(known));
        earlier.keep(2, "no sound");
        earlier.keep(3, packed(std::span(fresh).first(2)));
    }
    {
        storage::KeptResults kept(file, what, "cache");
        ASSERT_EQ(kept.found(), 3U);
        options.kept = &kept;
        const std::vector<HeardSound> sounds = hear(study, options);
        ASSERT_EQ(sounds.size(), fresh.size());
        EXPECT_EQ(sounds[1].reason, "heard earlier");
        for (std::size_t k = 0; k < sounds.size(); ++k)
            EXPECT_TRUE(k == 1 || same_sound(sounds[k], fresh[k])) << k;
    }
    const storage::KeptResults all(file, what, "cache");
    for (std::size_t k = 0; k < fresh.size(); ++k) {
        const std::optional<std::vector<HeardSound>> kept = unpacked_heard_sounds(all.find(k).value_or(""));
        ASSERT_TRUE(kept && kept->size() == 1) << k;
        EXPECT_TRUE(k == 1 || same_sound(kept->front(), fresh[k])) << k;
    }
}

// one text for one result: what is kept is found again just if nothing that decides a sound has changed
TEST(Hearing, IsKeptUnderAllThatDecidesIt) {
    const sweep::Study study = audible_study();
    HearingOptions options;
    const std::string plain = heard_text(study, options);
    std::set<std::string> texts{plain};
    const auto is_another = [&](const HearingOptions& changed) {
        return texts.insert(heard_text(study, changed)).second;
    };
    sweep::Study other = study;
    other.base.contact().static_friction += 0.01;
    EXPECT_NE(heard_text(other, options), plain);
    HearingOptions changed = options;
    changed.settings.motion.of = "plate";
    EXPECT_TRUE(is_another(changed));
    changed = options;
    changed.settings.motion.quantity = signal::MotionQuantity::acceleration;
    EXPECT_TRUE(is_another(changed));
    changed = options;
    changed.settings.sound.rate = 16000.0;
    EXPECT_TRUE(is_another(changed));
    changed = options;
    changed.settings.sound.high_pass = 50.0;
    EXPECT_TRUE(is_another(changed));
    changed = options;
    changed.settings.sound.fade = 0.01;
    EXPECT_TRUE(is_another(changed));
    changed = options;
    changed.settings.sound.density = 16;
    EXPECT_TRUE(is_another(changed));
    changed = options;
    changed.perturb_every = 3;
    EXPECT_TRUE(is_another(changed));
    for (const parameters::SoundThreshold& threshold : parameters::sound_thresholds()) {
        changed = options;
        changed.settings.thresholds.*threshold.member *= 1.0 + 1e-15;
        EXPECT_TRUE(is_another(changed)) << threshold.name;
    }
    changed = options;
    changed.crew = crew::thread_crews(3);
    EXPECT_EQ(heard_text(study, changed), plain);
}

// the steps of beta_2 get too long for a sound along the axis: the error of that cell reaches who asked
TEST(Hearing, SaysOnWhichCellItFailed) {
    sweep::Study study = audible_study();
    study.base.run.engine = parameters::Engine::beta_2;
    study.base.run.step = 1e-6;
    study.base.run.duration = study.base.run.window = 0.01;
    study.x = {"run.step", 1e-6, 1e-5, 2, sweep::Scale::linear};
    study.y.points = 2;
    try {
        hear(study, {});
        ADD_FAILURE() << "all was heard";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::input);
        EXPECT_NE(std::string(error.what()).find("run.step = 1e-05 s is too long"), std::string::npos) << error.what();
    }
}

TEST(Hearing, RefusesWhatItCouldNotHear) {
    sweep::Study study = audible_study();
    study.starts = {parameters::Initial::rest, parameters::Initial::sliding};
    EXPECT_THROW(hear(study, {}), Error);
    study = audible_study();
    study.base.run.engine = parameters::Engine::beta_2;
    study.base.run.step = 1e-5;
    EXPECT_THROW(hear(study, {}), Error);
}

TEST(Hearing, PerturbationsChangeWhatTheySay) {
    signal::Signal tone{48000.0, "m/s", {}};
    for (int n = 0; n < 24000; ++n)
        tone.samples.push_back(std::sin(2.0 * 3.14159265358979 * 1000.0 * n / tone.rate));
    const auto power = [](const signal::Signal& sound) {
        return std::inner_product(sound.samples.begin(), sound.samples.end(), sound.samples.begin(), 0.0) /
               static_cast<double>(sound.samples.size());
    };
    for (const Perturbation& perturbation : perturbations()) {
        const signal::Signal changed = perturbed(tone, perturbation, 7);
        EXPECT_EQ(changed.samples.size(), tone.samples.size()) << perturbation.name;
        EXPECT_EQ(changed.rate, tone.rate);
        double decibels = perturbation.gain;
        if (perturbation.noise) decibels = 10.0 * std::log10(1.0 + std::pow(10.0, -*perturbation.noise / 10.0));
        // a tone of 1 kHz passes every band; 24000 samples of noise have their power to 1 % or 0.05 dB
        EXPECT_NEAR(10.0 * std::log10(power(changed) / power(tone)), decibels, 0.1) << perturbation.name;
        const signal::Signal again = perturbed(tone, perturbation, 7);
        EXPECT_EQ(changed.samples, again.samples);
    }
}

}  // namespace
}  // namespace stridor::hearing
