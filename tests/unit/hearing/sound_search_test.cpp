#include "stridor/hearing/sound_search.hpp"

#include "stridor/classification/sound_rules.hpp"
#include "stridor/hearing/hearing_run.hpp"
#include "stridor/signal/perturb.hpp"
#include "stridor/signal/resample.hpp"
#include "stridor/sound/analysis.hpp"
#include "support/effort.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

namespace stridor::hearing {
namespace {

using classification::likeness;
using classification::SoundProfile;
using signal::Signal;

// 5 by 4 cells of 0.25 s, with squeals, squeaks, creaks and quiet cells among them
sweep::Study chart() {
    sweep::Study study;
    study.base.drive.kind = parameters::DriveKind::constant;
    study.base.drive.velocity = 0.1;
    study.base.run.duration = 0.25;
    study.base.run.window = 0.15;
    study.directions = {parameters::Direction::going};
    study.x = {"contact.preload", 5.0, 3000.0, 5, sweep::Scale::logarithmic};
    study.y = {"contact.kinetic_friction", 0.35, 0.75, 4, sweep::Scale::linear};
    return study;
}

CellListening listening() {
    CellListening result;
    result.sound.rate = 16000.0;
    return result;
}

// what `stridor listen` would write of a cell: the whole run
Signal recording_of(std::size_t index) {
    const sweep::Study study = chart();
    const parameters::Case c = sweep::case_at(study, sweep::place_of(study, index));
    Signal sound{16000.0, "m/s", {}};
    sound::AuralisationSettings settings = listening().sound;
    settings.stretches = {{0.0, c.run.duration}};
    sound::Auralisation auralisation(settings);
    const auto keep = [&](std::span<const double> block) {
        sound.samples.insert(sound.samples.end(), block.begin(), block.end());
    };
    integration::simulate(c, {record::KeepHistory::no, auralisation.request(c.run.duration, keep)});
    keep(auralisation.finish());
    return sound;
}

SoundProfile profile(const Signal& sound) {
    const auto source = signal::source_of({sound});
    const sound::SoundAnalysis analysis = sound::analyse(*source).front();
    const parameters::SoundThresholds thresholds;
    return classification::profile_of(analysis.stretches,
                                      classification::classify_recording(analysis.stretches, thresholds), thresholds);
}

SoundSearchResult found(const Signal& sound, SoundSearch options = {}) {
    return search(chart(), profile(sound), listening(), options);
}

// all cells, listened to once
const std::vector<CellSound>& cells() {
    static const auto all = [] {
        std::vector<CellSound> result;
        integration::Workspace workspace;
        for (std::size_t index = 0; index < sweep::cell_count(chart()); ++index)
            result.push_back(*sound_of_cell(chart(), index, listening(), {}, workspace));
        return result;
    }();
    return all;
}

std::size_t nearest(const Signal& sound) {
    const SoundProfile wanted = profile(sound);
    const auto distance = [&](const CellSound& cell) { return likeness(wanted, cell.profile).distance; };
    return std::min_element(cells().begin(), cells().end(),
                            [&](const CellSound& a, const CellSound& b) { return distance(a) < distance(b); })
        ->index;
}

// cells that are a noise, the first of each category
std::map<classification::Category, std::size_t> noises() {
    std::map<classification::Category, std::size_t> result;
    for (const CellSound& cell : cells())
        if (cell.contact != classification::Category::none && cell.contact != classification::Category::undecided)
            result.emplace(cell.contact, cell.index);
    return result;
}

}  // namespace

TEST(SoundSearch, FindsTheCellThatWasRecorded) {
    ASSERT_GE(noises().size(), 2U);
    for (const auto& [category, index] : noises()) {
        const Signal sound = recording_of(index);
        EXPECT_EQ(found(sound).best.front().cell.index, index) << name(category);
        EXPECT_EQ(nearest(signal::amplified(sound, -30.0)), index) << name(category) << ", gain";
        EXPECT_EQ(nearest(signal::with_noise(sound, 20.0, 3)), index) << name(category) << ", noise";
        EXPECT_EQ(nearest(signal::resampled(sound, 12000.0)), index) << name(category) << ", resampled";
    }
}

TEST(SoundSearch, GivesTheSameForAnyNumberOfThreads) {
    const Signal sound = recording_of(noises().begin()->second);
    SoundSearch options;
    options.first_grid = 4;
    options.crew = crew::thread_crews(1);
    const SoundSearchResult one = found(sound, options);
    options.crew = crew::thread_crews(3);
    const SoundSearchResult three = found(sound, options);
    EXPECT_EQ(one.heard, three.heard);
    ASSERT_EQ(one.best.size(), three.best.size());
    for (std::size_t k = 0; k < one.best.size(); ++k) {
        EXPECT_EQ(one.best[k].cell.index, three.best[k].cell.index);
        EXPECT_EQ(one.best[k].likeness.distance, three.best[k].likeness.distance);
    }
}

TEST(SoundSearch, ListensToFewerCellsOfALargeChart) {
    sweep::Study study = chart();
    study.x.points = support::effort(41, 31);
    study.y.points = support::effort(25, 19);
    study.base.run.duration = 0.05;
    study.base.run.window = 0.03;
    SoundSearch options;
    options.first_grid = 20;
    options.keep = 1;
    const SoundSearchResult result =
        search(study, profile(recording_of(noises().begin()->second)), listening(), options);
    EXPECT_LT(result.heard, sweep::cell_count(study) / 3);
    EXPECT_EQ(result.best.size(), 1U);
}

TEST(SoundSearch, LeavesOutWhatIsRuledOut) {
    SoundSearch options;
    options.ruled_out.assign(sweep::cell_count(chart()), true);
    const std::size_t index = noises().begin()->second;
    options.ruled_out[index == 0 ? 1 : 0] = false;
    const SoundSearchResult result = found(recording_of(index), options);
    EXPECT_EQ(result.heard, 1U);
    EXPECT_EQ(result.ruled_out, sweep::cell_count(chart()) - 1);
    for (const SoundMatch& match : result.best)
        EXPECT_NE(match.cell.index, index);
}

// a cell that was kept is taken as it is; what is another's or nothing is listened to again
TEST(SoundSearch, GoesOnFromWhatIsKept) {
    const Signal sound = recording_of(noises().begin()->second);
    const support::ScratchFolder folder;
    const std::filesystem::path file = folder / "cells.sqlite";
    const std::string what = listening_text(chart(), listening());
    {
        storage::KeptResults earlier(file, what, "cache");
        CellSound known = cells()[1];
        known.status = sweep::Status::failed;
        earlier.keep(1, packed(known));
        earlier.keep(2, packed(known));
        earlier.keep(3, "no sound");
    }
    SoundSearch options;
    options.extent = SearchExtent::every;
    options.keep = sweep::cell_count(chart());
    SearchProgress last;
    options.progress = [&](const SearchProgress& progress) { last = progress; };
    const SoundSearchResult fresh = found(sound, options);
    EXPECT_EQ(last.before, 0U);
    EXPECT_EQ(fresh.best.size(), sweep::cell_count(chart()));
    {
        storage::KeptResults kept(file, what, "cache");
        options.kept = &kept;
        const SoundSearchResult result = found(sound, options);
        EXPECT_EQ(last.before, 1U);
        EXPECT_EQ(last.done, sweep::cell_count(chart()));
        EXPECT_EQ(result.without_result, 1U);
        EXPECT_EQ(result.best.size() + 1, fresh.best.size());
    }
    storage::KeptResults all(file, what, "cache");
    options.kept = &all;
    const SoundSearchResult again = found(sound, options);
    EXPECT_EQ(last.before, sweep::cell_count(chart()));
    ASSERT_EQ(again.best.size() + 1, fresh.best.size());
    EXPECT_EQ(again.best.front().cell.index, fresh.best.front().cell.index);
    EXPECT_EQ(again.best.front().likeness.distance, fresh.best.front().likeness.distance);
}

// cells are kept under what decides them, and never taken for runs that `hear` kept
TEST(SoundSearch, IsKeptUnderAllThatDecidesIt) {
    const std::string plain = listening_text(chart(), listening());
    sweep::Study other = chart();
    other.base.contact().static_friction += 0.01;
    EXPECT_NE(listening_text(other, listening()), plain);
    CellListening changed = listening();
    changed.sound.rate = 48000.0;
    EXPECT_NE(listening_text(chart(), changed), plain);
    changed = listening();
    changed.thresholds.squeal_regularity *= 1.0 + 1e-15;
    EXPECT_NE(listening_text(chart(), changed), plain);
    HearingOptions heard;
    heard.settings.sound = listening().sound;
    heard.perturb_every = 0;
    EXPECT_NE(heard_text(chart(), heard), plain);
}

TEST(SoundSearch, StopsWhenAsked) {
    std::stop_source stop;
    SoundSearch options;
    options.stop = stop.get_token();
    options.progress = [&](const SearchProgress&) { stop.request_stop(); };
    const SoundSearchResult result = found(recording_of(0), options);
    EXPECT_TRUE(result.is_stopped);
    EXPECT_LT(result.heard, sweep::cell_count(chart()));
}

TEST(CellSound, ThatCannotBeComputedHasAStatus) {
    sweep::Study study = chart();
    study.y.to = 0.95;  // above the static coefficient
    integration::Workspace workspace;
    const auto cell = sound_of_cell(study, sweep::cell_count(study) - 1, listening(), {}, workspace);
    ASSERT_TRUE(cell);
    EXPECT_EQ(cell->status, sweep::Status::invalid);
    EXPECT_FALSE(cell->message.empty());
}

}  // namespace stridor::hearing
