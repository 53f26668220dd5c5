#include "stridor/record/recorder.hpp"

#include "support/property.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace stridor::record {
namespace {

using model::ContactState;
using enum model::ContactState;

// going 0..4 (judged 1..3), coming 4..8 (judged 5..7), going 8..12 (judged 9..11)
Schedule two_phases() {
    Schedule plan;
    for (int k = 0; k < 3; ++k) {
        const double from = 4.0 * k;
        const Phase phase = k % 2 == 0 ? Phase::going : Phase::coming;
        plan.spans.push_back({from, from + 1.0, phase, Use::counted});
        plan.spans.push_back({from + 1.0, from + 3.0, phase, Use::judged});
        plan.spans.push_back({from + 3.0, from + 4.0, phase, Use::counted});
    }
    plan.phases = {Phase::going, Phase::coming};
    return plan;
}

Schedule one_phase(double from, double to) {
    return {{{0.0, from, Phase::all, Use::unused}, {from, to, Phase::all, Use::judged}}, {Phase::all}};
}

ContactInterval entry(ContactState state, double time) {
    return {state, time, 0.0, 0.0, 0.0};
}

double total(const std::array<double, model::contact_states>& times) {
    return std::accumulate(times.begin(), times.end(), 0.0);
}

TEST(Recorder, KeepsTheLargestForceOfTheJudgedTime) {
    Recorder recorder(two_phases(), {}, 3);
    recorder.enter(0, entry(slip, 0.0));
    const auto carries = [&](std::size_t span, double force) {
        const Load load{0.0, 0.0, force};
        recorder.load(span, {&load, 1});
    };
    carries(0, 90.0);  // not judged
    carries(1, 20.0);
    carries(4, 70.0);  // coming
    carries(7, 10.0);
    EXPECT_EQ(recorder.since(0), 0.0);
    recorder.enter(0, entry(stick, 9.5));
    EXPECT_EQ(recorder.since(0), 9.5);
    const Record record = recorder.finish(12.0);
    EXPECT_EQ(record.phases[0].contacts.front().load.largest_force, 20.0);
    EXPECT_EQ(record.phases[1].contacts.front().load.largest_force, 70.0);
}

// the judged time of each stretch by its parts of 1/4 s
TEST(Recorder, SharesOutJudgedTimeAmongThePartsOfItsStretch) {
    Recorder recorder(two_phases(), {}, 3);
    recorder.enter(0, entry(slip, 0.0));
    recorder.enter(0, entry(stick, 2.125));
    recorder.enter(0, entry(slip, 5.5));
    const Record record = recorder.finish(12.0);
    const ContactTally& going = record.phases[0].contacts.front();
    const ContactTally& coming = record.phases[1].contacts.front();
    ASSERT_EQ(going.judged_stretches, 2);
    ASSERT_EQ(going.stretches.size(), 2U);
    for (std::size_t part = 0; part < stretch_parts; ++part) {
        const double sticks = part < 4 ? 0.0 : part == 4 ? 0.125 : 0.25;
        EXPECT_EQ(going.stretches[0].at(part), (std::array{0.25 - sticks, sticks, 0.0})) << part;
        EXPECT_EQ(going.stretches[1].at(part), (std::array{0.25, 0.0, 0.0})) << part;
        EXPECT_EQ(coming.stretches[0].at(part), (part < 2 ? std::array{0.0, 0.25, 0.0} : std::array{0.25, 0.0, 0.0}));
    }
}

// a closing part belongs to the stretch that it closes; a stretch that the run's end cuts short is none
TEST(Recorder, TakesTheClosingPartIntoItsStretch) {
    const Schedule plan{{{0.0, 1.0, Phase::all, Use::unused},
                         {1.0, 7.0, Phase::all, Use::judged},
                         {7.0, 9.0, Phase::all, Use::closing}},
                        {Phase::all}};
    for (const double end : {9.0, 9.0 - 1e-13, 8.0}) {
        Recorder recorder(plan, {}, 3);
        recorder.enter(0, entry(slip, 0.0));
        recorder.enter(0, entry(stick, 6.5));
        const ContactTally contact = recorder.finish(end).phases.front().contacts.front();
        ASSERT_EQ(contact.judged_stretches, end > 8.5 ? 1 : 0);
        if (end < 8.5) continue;
        for (std::size_t part = 0; part < stretch_parts; ++part)
            EXPECT_EQ(contact.stretches.front().at(part)[1], part < 5 ? 0.0 : part == 5 ? 0.5 : 1.0) << part;
    }
}

// a tally stays as small as it is, however many stretches there are
TEST(Recorder, KeepsTheLatestStretches) {
    Schedule plan;
    for (int k = 0; k < 20; ++k) {
        plan.spans.push_back({1.0 * k, k + 0.5, Phase::going, Use::counted});
        plan.spans.push_back({k + 0.5, k + 1.0, Phase::going, Use::judged});
    }
    plan.phases = {Phase::going};
    Recorder recorder(plan, {}, 3);
    recorder.enter(0, entry(slip, 0.0));
    recorder.enter(0, entry(stick, 18.0));
    const ContactTally contact = recorder.finish(20.0).phases.front().contacts.front();
    EXPECT_EQ(contact.judged_stretches, 20);
    ASSERT_EQ(contact.stretches.size(), kept_stretches);
    EXPECT_EQ(contact.stretches.front().front()[0], 0.0625);
    EXPECT_EQ(contact.stretches.back().front()[1], 0.0625);
}

TEST(Recorder, SharesOutTimeAmongStatesAndPhases) {
    Recorder recorder(two_phases(), {}, 3);
    recorder.enter(0, entry(slip, 0.0));
    recorder.enter(0, entry(stick, 2.0));
    recorder.enter(0, entry(separation, 4.5));
    recorder.enter(0, entry(slip, 6.0));
    const Record record = recorder.finish(12.0);
    ASSERT_EQ(record.phases.size(), 2U);
    const ContactTally& going = record.phases[0].contacts.front();
    const ContactTally& coming = record.phases[1].contacts.front();
    EXPECT_EQ(record.phases[0].phase, Phase::going);
    EXPECT_EQ(going.time, (std::array{2.0 + 4.0, 2.0, 0.0}));  // slip, stick, separation
    EXPECT_EQ(going.judged_time, (std::array{1.0 + 2.0, 1.0, 0.0}));
    EXPECT_EQ(coming.time, (std::array{2.0, 0.5, 1.5}));
    EXPECT_EQ(coming.judged_time, (std::array{1.0, 0.0, 1.0}));
}

RC_GTEST_PROP(Recorder, TimesAddUpToTheWindow, ()) {
    Recorder recorder(two_phases(), {}, 3);
    double time = 0.0;
    int state = 0;
    while (time < 12.0) {
        recorder.enter(0, entry(static_cast<ContactState>(state), time));
        state = (state + *support::whole_between(1, 2)) % 3;
        time += *support::number_between(0.001, 2.0);
    }
    const Record record = recorder.finish(12.0);
    // some fifty additions of numbers up to 12
    RC_ASSERT(std::abs(total(record.phases[0].contacts.front().time) - 8.0) < 1e-13);
    RC_ASSERT(std::abs(total(record.phases[1].contacts.front().time) - 4.0) < 1e-13);
    RC_ASSERT(std::abs(total(record.phases[0].contacts.front().judged_time) - 4.0) < 1e-13);
    RC_ASSERT(std::abs(total(record.phases[1].contacts.front().judged_time) - 2.0) < 1e-13);
}

TEST(Recorder, LeavesOutTheTransient) {
    Recorder recorder(one_phase(1.0, 3.0), {}, 3);
    recorder.enter(0, entry(slip, 0.0));
    recorder.enter(0, entry(stick, 0.5));
    recorder.enter(0, entry(slip, 2.0));
    const Record record = recorder.finish(3.0);
    EXPECT_EQ(record.phases[0].contacts.front().time, (std::array{1.0, 1.0, 0.0}));
    EXPECT_EQ(record.phases[0].contacts.front().changes[change_kind(slip, stick)].count, 0);
    EXPECT_EQ(record.phases[0].contacts.front().changes[change_kind(stick, slip)].count, 1);
}

TEST(Recorder, StopsAtTheTimeItIsFinished) {
    Recorder recorder(one_phase(1.0, 3.0), {}, 3);
    recorder.enter(0, entry(slip, 0.0));
    EXPECT_EQ(total(recorder.finish(1.5).phases[0].contacts.front().time), 0.5);
}

TEST(Recorder, WithoutAnyStateIsEmpty) {
    Recorder recorder(one_phase(1.0, 3.0), {}, 3);
    EXPECT_EQ(total(recorder.finish(0.0).phases[0].contacts.front().time), 0.0);
}

TEST(Changes, AreKeptByKindWithinTheJudgedTime) {
    Recorder recorder(two_phases(), {}, 3);
    recorder.enter(0, entry(slip, 0.0));
    recorder.enter(0, entry(stick, 0.5));  // before the judged part
    recorder.enter(0, entry(slip, 1.0));   // its first instant belongs to it
    recorder.enter(0, entry(stick, 1.5));
    recorder.enter(0, entry(slip, 2.0));
    recorder.enter(0, entry(stick, 3.5));  // after it
    const Record record = recorder.finish(4.0);
    const ContactTally& going = record.phases[0].contacts.front();
    EXPECT_EQ(going.changes[change_kind(slip, stick)].count, 1);
    EXPECT_EQ(going.changes[change_kind(stick, slip)].count, 2);
    EXPECT_EQ(going.changes[change_kind(slip, separation)].count, 0);
}

// instants of two judged stretches of one phase are parted, so that no interval reaches across
TEST(Changes, OfDifferentStretchesAreParted) {
    Recorder recorder(two_phases(), {}, 3);
    recorder.enter(0, entry(stick, 0.0));
    recorder.enter(0, entry(slip, 1.5));
    recorder.enter(0, entry(stick, 6.0));  // another phase
    recorder.enter(0, entry(slip, 9.5));
    const Record record = recorder.finish(12.0);
    const std::vector<double>& times = record.phases[0].contacts.front().changes[change_kind(stick, slip)].times;
    ASSERT_GE(times.size(), 3U);
    EXPECT_EQ(times[0], 1.5);
    EXPECT_TRUE(std::isnan(times[1]));
    EXPECT_EQ(times[2], 9.5);
    EXPECT_EQ(record.phases[0].contacts.front().changes[change_kind(stick, slip)].count, 2);
    EXPECT_EQ(record.phases[1].contacts.front().changes[change_kind(slip, stick)].count, 1);
}

// the closing span goes on where the judged one ends: an interval may reach across
TEST(Changes, OfTheClosingPartFollowThoseBefore) {
    const Schedule plan{{{0.0, 2.0, Phase::all, Use::judged}, {2.0, 4.0, Phase::all, Use::closing}}, {Phase::all}};
    Recorder recorder(plan, {}, 3);
    for (int k = 0; k < 4; ++k) {
        recorder.enter(0, entry(slip, k));
        recorder.enter(0, entry(stick, k + 0.5));
    }
    const Tally tally = recorder.finish(3.75).phases[0];
    EXPECT_EQ(tally.contacts.front().changes[change_kind(slip, stick)].times, (std::vector{0.5, 1.5, 2.5, 3.5}));
    EXPECT_EQ(tally.contacts.front().releases, 3);
}

TEST(Recorder, CountsReleasesInAllOfTheWindow) {
    Recorder recorder(two_phases(), {}, 3);
    recorder.enter(0, entry(stick, 0.0));
    recorder.enter(0, entry(slip, 0.5));  // before the judged part
    recorder.enter(0, entry(stick, 0.75));
    recorder.enter(0, entry(separation, 2.0));
    recorder.enter(0, entry(slip, 2.5));  // ends no stick
    const Record record = recorder.finish(12.0);
    EXPECT_EQ(record.phases[0].contacts.front().releases, 2);
    EXPECT_EQ(record.phases[1].contacts.front().releases, 0);
}

TEST(Recorder, TellsHowTheRunEnded) {
    Recorder recorder(two_phases(), {}, 3);
    recorder.enter(0, entry(slip, 0.0));
    recorder.enter(0, entry(stick, 7.0));
    for (const Tally& tally : recorder.finish(12.0, {{Future::releases, 0.0, 20.0}}).phases) {
        EXPECT_EQ(tally.contacts.front().ending.state, stick);
        EXPECT_EQ(tally.contacts.front().ending.since, 7.0);
        EXPECT_EQ(tally.contacts.front().ending.outlook.future, Future::releases);
        EXPECT_EQ(tally.contacts.front().ending.outlook.release, 20.0);
    }
}

TEST(VibrationTally, KeepsTheClosingPartApart) {
    const Schedule plan{{{0.0, 2.0, Phase::all, Use::judged}, {2.0, 3.0, Phase::all, Use::closing}}, {Phase::all}};
    Recorder recorder(plan, {}, 1);
    recorder.vibrate(0, 2.0, std::vector<Vibration>{{4.0, 9.0}});
    recorder.vibrate(1, 1.0, std::vector<Vibration>{{1.0, 2.0}});
    const Tally tally = recorder.finish(3.0).phases[0];
    EXPECT_EQ(tally.vibration_time, 3.0);
    EXPECT_EQ(tally.vibration[0].square_time, 5.0);
    EXPECT_EQ(tally.closing_time, 1.0);
    EXPECT_EQ(tally.closing_vibration[0].square_time, 1.0);
    EXPECT_EQ(tally.closing_vibration[0].peak_square, 2.0);
}

TEST(Changes, TakeBoundedMemoryAndKeepTheLatest) {
    constexpr int beats = 100000;
    Recorder recorder(one_phase(0.0, 2.0 * beats + 1.0), {}, 3);  // longer than the run: no parting at its end
    for (int k = 0; k < beats; ++k) {
        recorder.enter(0, entry(slip, 2.0 * k));
        recorder.enter(0, entry(stick, 2.0 * k + 1.0));
    }
    const Record record = recorder.finish(2.0 * beats);
    const Instants& instants = record.phases[0].contacts.front().changes[change_kind(slip, stick)];
    EXPECT_EQ(instants.count, beats);
    EXPECT_GE(instants.times.size(), Instants::kept);
    EXPECT_LE(instants.times.size(), 2 * Instants::kept);
    EXPECT_LE(instants.times.capacity(), 4 * Instants::kept);
    EXPECT_EQ(instants.times.back(), 2.0 * beats - 1.0);
    for (std::size_t k = 1; k < instants.times.size(); ++k)
        ASSERT_EQ(instants.times[k] - instants.times[k - 1], 2.0);
}

TEST(History, IsKeptOnlyWhenAskedFor) {
    for (const KeepHistory keep : {KeepHistory::no, KeepHistory::yes}) {
        Recorder recorder(two_phases(), {keep, {}}, 3);
        recorder.enter(0, entry(slip, 0.0));
        recorder.enter(0, {stick, 2.0, 0.0, 0.25, -0.5});
        recorder.enter(0, entry(separation, 4.5));
        const Record record = recorder.finish(12.0);
        if (keep == KeepHistory::no) {
            EXPECT_TRUE(record.histories.front().empty());
            continue;
        }
        ASSERT_EQ(record.histories.front().size(), 3U);
        EXPECT_EQ(record.histories.front()[1].state, stick);
        EXPECT_EQ(record.histories.front()[1].from, 2.0);
        EXPECT_EQ(record.histories.front()[1].to, 4.5);
        EXPECT_EQ(record.histories.front()[1].slip_velocity, 0.25);
        EXPECT_EQ(record.histories.front()[1].gap_velocity, -0.5);
        EXPECT_EQ(record.histories.front()[2].to, 12.0);
    }
}

TEST(VibrationTally, SumsOverJudgedSpansAndKeepsThePeak) {
    Recorder recorder(two_phases(), {}, 2);
    const std::vector<Vibration> first{{1.0, 9.0}, {2.0, 1.0}};
    const std::vector<Vibration> second{{0.5, 4.0}, {1.0, 16.0}};
    recorder.vibrate(0, 1.0, first);   // counted, not judged
    recorder.vibrate(1, 2.0, first);   // going
    recorder.vibrate(4, 2.0, second);  // coming
    recorder.vibrate(7, 2.0, second);  // going
    const Record record = recorder.finish(12.0);
    EXPECT_EQ(record.phases[0].vibration_time, 4.0);
    EXPECT_EQ(record.phases[0].vibration[0].square_time, 1.5);
    EXPECT_EQ(record.phases[0].vibration[0].peak_square, 9.0);
    EXPECT_EQ(record.phases[0].vibration[1].square_time, 3.0);
    EXPECT_EQ(record.phases[0].vibration[1].peak_square, 16.0);
    EXPECT_EQ(record.phases[1].vibration_time, 2.0);
    EXPECT_EQ(record.phases[1].vibration[0].square_time, 0.5);
}

TEST(Recorder, HandsATraceOverInBlocksAndKeepsNone) {
    std::vector<double> taken;
    std::size_t largest = 0;
    Request request;
    request.trace.interval = 1.0;
    request.trace.taker = [&](const Trace& block) {
        largest = std::max(largest, block.time.size());
        taken.insert(taken.end(), block.time.begin(), block.time.end());
    };
    Recorder recorder({}, request, 1);
    const std::size_t count = 2 * trace_block + 5;
    const std::array nothing{0.0};
    const ContactSample contact;
    for (std::size_t k = 0; k < count; ++k)
        recorder.sample({static_cast<double>(k), nothing, nothing, nothing, 0.0, {&contact, 1}});
    EXPECT_TRUE(recorder.finish(1.0).trace.time.empty());
    EXPECT_EQ(largest, trace_block);
    ASSERT_EQ(taken.size(), count);
    for (std::size_t k = 0; k < count; ++k)
        EXPECT_EQ(taken[k], static_cast<double>(k));
}

TEST(Recorder, KeepsEachContactByItself) {
    Recorder recorder(two_phases(), {KeepHistory::yes, {}}, 3, 2);
    recorder.enter(0, entry(slip, 0.0));
    recorder.enter(1, entry(separation, 0.0));
    recorder.enter(1, entry(stick, 3.0));
    recorder.enter(0, entry(stick, 2.0));  // earlier than the last change of the other
    const Record record = recorder.finish(12.0, {{Future::sticks}, {Future::releases, 0.0, 20.0}});
    for (const Tally& tally : record.phases) {
        ASSERT_EQ(tally.contacts.size(), 2U);
        EXPECT_EQ(tally.contacts[0].ending.since, 2.0);
        EXPECT_EQ(tally.contacts[0].ending.outlook.future, Future::sticks);
        EXPECT_EQ(tally.contacts[1].ending.since, 3.0);
        EXPECT_EQ(tally.contacts[1].ending.outlook.release, 20.0);
    }
    const auto total = [](const ContactTally& tally) { return tally.time[0] + tally.time[1] + tally.time[2]; };
    EXPECT_EQ(total(record.phases[0].contacts[0]), total(record.phases[0].contacts[1]));
    EXPECT_EQ(record.phases[0].contacts[0].time[model::index_of(separation)], 0.0);
    EXPECT_GT(record.phases[0].contacts[1].time[model::index_of(separation)], 0.0);
    ASSERT_EQ(record.histories.size(), 2U);
    EXPECT_EQ(record.histories[0].front().to, 2.0);
    EXPECT_EQ(record.histories[1].front().to, 3.0);
}

}  // namespace
}  // namespace stridor::record
