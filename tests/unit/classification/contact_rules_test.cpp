#include "stridor/classification/contact_rules.hpp"

#include "stridor/classification/interface_rules.hpp"
#include "support/property.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace stridor::classification {
namespace {

using analysis::Evidence;
using parameters::Thresholds;

// shares of the judged time, with twenty intervals of this regularity
Evidence evidence(double slip, double stick, double regularity, long intervals = 20) {
    Evidence figures;
    figures.window_time = 1.0;
    figures.judged_time = 0.4;
    figures.judged_rates = {slip, stick, 1.0 - slip - stick};
    figures.alternation.intervals = intervals;
    figures.releases = figures.all_releases = intervals + 1;
    figures.alternation.regularity = regularity;
    figures.alternation.repetition = regularity;
    figures.alternation.mismatch[0] = {1.0 - regularity};
    return figures;
}

// a pattern of so many unequal beats that comes again after a time, with an error of its repetition
Evidence pattern(int beats, double period, double repetition, double error = 0.0) {
    Evidence figures = evidence(0.4, 0.2, 0.3);
    figures.alternation.mismatch.at(static_cast<std::size_t>(beats) - 1) = {1.0 - repetition, error};
    figures.alternation.repetition = repetition;
    figures.alternation.lag = beats;
    figures.alternation.period = period;
    return figures;
}

bool tells(const Verdict& verdict, std::string_view words) {
    return std::any_of(verdict.reasons.begin(), verdict.reasons.end(),
                       [&](const std::string& reason) { return reason.find(words) != std::string::npos; });
}

Category category(const Evidence& figures, const Thresholds& thresholds = {}) {
    return classify(figures, thresholds).category;
}

const Margin& margin(const Verdict& verdict, std::string_view name) {
    const auto found = std::find_if(verdict.margins.begin(), verdict.margins.end(),
                                    [&](const Margin& entry) { return entry.threshold_name == name; });
    EXPECT_NE(found, verdict.margins.end()) << name;
    return *found;
}

// regularised friction has no stick: nothing that it does is a rubbing contact's, unless a user asks
TEST(ContactRules, JudgeNoContactThatCreepsUnlessAsked) {
    Thresholds thresholds;
    for (Evidence figures : {evidence(1.0, 0.0, 0.0, 0), evidence(0.4, 0.2, 0.99), evidence(0.1, 0.9, 0.5)}) {
        const Category judged = category(figures);
        figures.creeps = true;
        thresholds.creeping = parameters::Creeping::undecided;
        const Verdict verdict = classify(figures, thresholds);
        EXPECT_EQ(verdict.category, Category::undecided);
        EXPECT_EQ(verdict.reasons.size(), 1U);
        EXPECT_TRUE(tells(verdict, "it creeps where it should stick"));
        thresholds.creeping = parameters::Creeping::judged;
        EXPECT_EQ(category(figures, thresholds), judged);
    }
}

// a contact that nearly always slips and yet ends that 249 times a second is heard; one event that rings out is not
TEST(ContactRules, SlipThatEndsAgainAndAgainIsNotQuiet) {
    Evidence figures = evidence(0.982, 0.018, 0.86, 100);
    figures.alternation.frequency = 249.0;
    figures.alternation.period = 1.0 / 249.0;
    const Verdict verdict = classify(figures, {});
    EXPECT_EQ(verdict.category, Category::squeal);
    EXPECT_TRUE(tells(verdict, "but ends that again and again"));
    figures.alternation.intervals = 40;
    EXPECT_EQ(category(figures), Category::none);
}

// six patterns of 50 ms that are alike to 0.96: 20.1 of them a second are known to 0.3
TEST(ContactRules, APatternNearItsLeastRepetitionIsUndecided) {
    const Verdict near = classify(pattern(3, 1.0 / 20.1, 0.96), {});
    EXPECT_EQ(near.category, Category::undecided);
    EXPECT_TRUE(tells(near, "number of patterns per second"));
    EXPECT_NEAR(margin(near, "squeal_frequency").error.value(), 20.1 * 0.04 / std::sqrt(20.0 / 3.0), 1e-9);
    EXPECT_EQ(category(pattern(3, 1.0 / 22.0, 0.96)), Category::squeal);
    EXPECT_EQ(category(pattern(3, 1.0 / 18.0, 0.96)), Category::squeak);
    Evidence steps = pattern(3, 1.0 / 21.0, 0.999);
    EXPECT_EQ(category(steps), Category::squeal);
    steps.coarser = steps.alternation;
    steps.coarser->period = 1.0 / 20.0;  // at twice the step
    EXPECT_EQ(category(steps), Category::undecided);
}

TEST(ContactRules, SlipOnlyIsNone) {
    EXPECT_EQ(category(evidence(1.0, 0.0, 0.0, 0)), Category::none);
    EXPECT_EQ(category(evidence(0.98, 0.01, 1.0)), Category::none);
    EXPECT_NE(category(evidence(0.979, 0.01, 1.0)), Category::none);
}

// stuck in all of the judged time, without a release anywhere
Evidence stuck() {
    Evidence figures = evidence(0.0, 1.0, 0.0, 0);
    figures.rates = figures.judged_rates;
    figures.releases = figures.all_releases = 0;
    return figures;
}

TEST(ContactRules, StuckThroughoutIsNone) {
    EXPECT_EQ(category(stuck()), Category::none);
    EXPECT_EQ(category(evidence(0.0, 0.999, 0.0)), Category::creak);
}

TEST(ContactRules, TellWhyItIsQuiet) {
    EXPECT_EQ(classify(evidence(1.0, 0.0, 0.0, 0), {}).quiet, Quiet::slides);
    EXPECT_EQ(classify(stuck(), {}).quiet, Quiet::sticks);
    EXPECT_EQ(classify(evidence(0.1, 0.9, 1.0), {}).quiet, Quiet::no);
    EXPECT_EQ(classify(evidence(0.5, 0.2, 1.0, 1), {}).quiet, Quiet::no);
}

// a contact that is known to slip after the run is never called quiet, however long the run
TEST(ContactRules, StuckButNotForEverIsUndecided) {
    Evidence figures = stuck();
    figures.ending.outlook = {record::Future::releases, 0.0, 12.5};
    const Verdict verdict = classify(figures, {});
    EXPECT_EQ(verdict.category, Category::undecided);
    EXPECT_NE(verdict.reasons.back().find("slips at about 12.5 s"), std::string::npos) << verdict.reasons.back();
}

// sliding that does not last is on its way to something else, however long it was looked at
TEST(ContactRules, SlidingThatGrowsIsUndecided) {
    Evidence figures = evidence(1.0, 0.0, 0.0, 0);
    figures.ending.outlook.growth = 0.43;
    figures.ending.outlook.grown = 1.625;
    const Verdict verdict = classify(figures, {});
    EXPECT_EQ(verdict.category, Category::undecided);
    EXPECT_EQ(verdict.quiet, Quiet::no);
    EXPECT_NE(verdict.reasons.back().find("grows with 0.43 1/s, and ends that at about 1.625 s"), std::string::npos)
        << verdict.reasons.back();
    figures.ending.outlook.growth = 0.0;
    EXPECT_EQ(category(figures), Category::undecided);
}

// where it has become something else, that is what it is
TEST(ContactRules, SlidingThatHasGrownIsWhatItAlternatesBy) {
    Evidence figures = evidence(0.99, 0.005, 1.0);
    EXPECT_EQ(category(figures), Category::none);
    figures.ending.outlook.growth = 0.43;
    EXPECT_EQ(category(figures), Category::squeal);
    figures.alternation.intervals = 1;
    EXPECT_EQ(category(figures), Category::undecided);
}

// slips that come back in every stroke, but outside the judged part, are no silence
TEST(ContactRules, StuckThroughoutTheJudgedPartAloneIsCreak) {
    Evidence figures = stuck();
    figures.rates = {0.1, 0.9, 0.0};
    figures.all_releases = 3;
    EXPECT_EQ(category(figures), Category::creak);
    figures.all_releases = 2;
    EXPECT_EQ(category(figures), Category::none);
}

// the lip of a seal slips once for 28 us and then sticks for ever
TEST(ContactRules, OneSlipBeforeAnEternalStickIsNone) {
    Evidence figures = evidence(0.001, 0.999, std::numeric_limits<double>::quiet_NaN(), 0);
    figures.ending = {model::ContactState::stick, 28e-6, {record::Future::sticks}};
    const Verdict verdict = classify(figures, {});
    EXPECT_EQ(verdict.category, Category::none);
    EXPECT_EQ(verdict.quiet, Quiet::sticks);
}

// N rises with the way under a constant drive: 8 N to 494 N over 50 mm
Evidence locked() {
    Evidence figures = stuck();
    figures.preload = 8.0;
    figures.ending = {model::ContactState::stick, 28e-6, {record::Future::sticks}};
    figures.ending.outlook.drag = {8.0, 494.0, 0.05, 9.72e3};
    return figures;
}

TEST(ContactRules, WhatIsPressedHarderTheFartherItIsDraggedLocks) {
    const Verdict verdict = classify(locked(), {});
    EXPECT_EQ(verdict.category, Category::none);
    EXPECT_EQ(verdict.quiet, Quiet::locks);
    EXPECT_EQ(verdict.reasons.back(), "locks: N rises from 8 N to 494 N over 50 mm and goes on by 9.72 N/mm (proven)");
    EXPECT_TRUE(verdict.warnings.empty());

    Evidence not_proven = locked();
    not_proven.ending.outlook.future = record::Future::unknown;
    EXPECT_EQ(classify(not_proven, {}).quiet, Quiet::locks);
    EXPECT_EQ(classify(not_proven, {}).reasons.back().find("(proven)"), std::string::npos);
    // what will slip does not lock, and is no silence either
    not_proven.ending.outlook.future = record::Future::releases;
    EXPECT_EQ(classify(not_proven, {}).category, Category::undecided);

    Evidence steady = locked();
    steady.ending.outlook.drag = {8.0, 8.0, 0.05, 0.0};
    EXPECT_EQ(classify(steady, {}).quiet, Quiet::sticks);
}

TEST(ContactRules, WhatSticksAndLeavesItsPreloadLocks) {
    Evidence figures = locked();
    figures.ending.outlook.drag = {1.0, 80.0, 0.006, 0.0};  // a sinusoidal drive
    EXPECT_EQ(classify(figures, {}).quiet, Quiet::sticks);
    figures.ending.outlook.drag.to = 82.0;
    const Verdict verdict = classify(figures, {});
    EXPECT_EQ(verdict.quiet, Quiet::locks);
    EXPECT_EQ(verdict.reasons.back(),
              "locks: N goes from 1 N to 82 N over each stroke of 6 mm, 10.2 times the preload of 8 N (proven)");
    EXPECT_EQ(classify(figures, {.lock_force = 11.0}).quiet, Quiet::sticks);

    Evidence unforetold = stuck();
    unforetold.preload = 8.0;
    unforetold.largest_force = 1.6e3;
    EXPECT_EQ(classify(unforetold, {}).quiet, Quiet::locks);
    EXPECT_EQ(classify(unforetold, {}).reasons.back(), "locks: N reaches 1.6 kN, 200 times the preload of 8 N");
    unforetold.preload = 0.0;  // open at rest, or not known
    EXPECT_EQ(classify(unforetold, {}).quiet, Quiet::sticks);
}

TEST(ContactRules, WarnOfForcesThatLeaveThePreloadInWhatDoesNotLock) {
    Evidence creaking = evidence(0.1, 0.9, 1.0);
    creaking.preload = 0.67;
    creaking.largest_force = 55.0;
    const Verdict verdict = classify(creaking, {});
    EXPECT_EQ(verdict.category, Category::creak);
    ASSERT_EQ(verdict.warnings.size(), 1U);
    EXPECT_EQ(verdict.warnings.front(),
              "N reaches 55 N, 82.1 times the preload of 0.67 N: the contact digs in (sprag-slip)");
    // in a squeal N swings so far by vibration
    Evidence squealing = evidence(0.2, 0.1, 1.0);
    squealing.preload = 20.0;
    squealing.largest_force = 439.0;
    EXPECT_TRUE(classify(squealing, {}).warnings.empty());
    creaking.largest_force = 6.7;
    EXPECT_TRUE(classify(creaking, {}).warnings.empty());
}

TEST(ContactRules, SayOfWhatLiftsOffThatItDoes) {
    Evidence figures = evidence(0.0, 0.0, std::numeric_limits<double>::quiet_NaN(), 0);
    figures.ending.since = 0.0125;
    const Verdict verdict = classify(figures, {});
    EXPECT_EQ(verdict.category, Category::undecided);
    EXPECT_EQ(verdict.reasons.back(), "lifts off at 0.0125 s and stays off to the end of the run");
}

TEST(ContactRules, WhatSlidesForEverIsNoneWhateverCameBefore) {
    Evidence figures = evidence(0.4, 0.3, 1.0);
    figures.ending.outlook = {record::Future::slides, 0.75};
    EXPECT_EQ(category(figures), Category::none);
    EXPECT_EQ(classify(figures, {}).quiet, Quiet::slides);
}

TEST(ContactRules, CreakNeedsRepetition) {
    Evidence figures = evidence(0.1, 0.9, std::numeric_limits<double>::quiet_NaN(), 0);
    for (const long releases : {0L, 1L, 2L, 3L, 4L}) {
        figures.releases = releases;
        EXPECT_EQ(category(figures), releases < 3 ? Category::undecided : Category::creak) << releases;
    }
    figures.releases = 1;
    EXPECT_EQ(category(figures, {.least_releases = 1.0}), Category::creak);
    figures.ending.outlook.future = record::Future::repeats;  // a proven cycle is repetition enough
    EXPECT_EQ(category(figures), Category::creak);
}

TEST(ContactRules, StickPredominanceIsCreak) {
    EXPECT_EQ(category(evidence(0.3, 0.7, 0.0)), Category::creak);
    EXPECT_NE(category(evidence(0.31, 0.69, 0.0)), Category::creak);
}

TEST(ContactRules, RegularAlternationIsSqueal) {
    EXPECT_EQ(category(evidence(0.2, 0.1, 1.0)), Category::squeal);
    EXPECT_EQ(category(evidence(0.2, 0.1, 0.8)), Category::squeal);
}

TEST(ContactRules, IrregularAlternationIsSqueak) {
    EXPECT_EQ(category(evidence(0.2, 0.1, 0.79)), Category::squeak);
    EXPECT_EQ(category(evidence(0.2, 0.1, 0.0)), Category::squeak);
}

// a pattern that comes again exactly and often is a tone, however many beats it has
TEST(ContactRules, PatternThatRepeatsOftenIsSqueal) {
    EXPECT_EQ(category(pattern(9, 0.01, 0.999)), Category::squeal);
    EXPECT_TRUE(tells(classify(pattern(9, 0.01, 0.999), {}),
                      "in a pattern of 9 unequal beats that comes again 100 times a second (repetition 0.999)"));
    EXPECT_EQ(category(pattern(9, 0.04, 0.999)), Category::squeal);
    EXPECT_EQ(category(pattern(9, 0.06, 0.999)), Category::squeak);
    EXPECT_TRUE(tells(classify(pattern(9, 0.06, 0.999), {}), "the pattern repeats, but only 16.7 times a second"));
    EXPECT_EQ(category(pattern(9, 0.06, 0.999), {.squeal_frequency = 10.0}), Category::squeal);
}

// nearly the same again is what jerky motions do
TEST(ContactRules, PatternThatNearlyRepeatsIsSqueak) {
    const Verdict verdict = classify(pattern(7, 0.01, 0.9), {});
    EXPECT_EQ(verdict.category, Category::squeak);
    EXPECT_TRUE(tells(verdict, "the pattern repeats after 7 unequal beats, but only to 0.900"));
    EXPECT_FALSE(tells(classify(pattern(7, 0.01, 0.7), {}), "the pattern repeats"));
    EXPECT_EQ(category(pattern(7, 0.01, 0.9), {.squeal_repetition = 0.85}), Category::squeal);
}

// what is proven to repeat itself is regular, whatever its judged beats show of its beginning
TEST(ContactRules, ProvenCycleIsSquealIfItComesAgainOften) {
    Evidence figures = evidence(0.4, 0.2, 0.3);
    figures.ending.outlook = {.future = record::Future::repeats, .from = 0.5, .period = 0.02};
    EXPECT_EQ(category(figures), Category::squeal);
    EXPECT_TRUE(tells(classify(figures, {}), "a cycle that repeats itself 50 times a second (proven)"));
    figures.alternation.intervals = 2;
    EXPECT_EQ(category(figures), Category::squeal);
    figures.alternation.intervals = 20;
    figures.ending.outlook.period = 0.1;
    EXPECT_EQ(category(figures), Category::squeak);
}

// a creak may be perfectly regular
TEST(ContactRules, StickPredominanceComesBeforeRegularity) {
    EXPECT_EQ(category(evidence(0.1, 0.9, 1.0)), Category::creak);
    EXPECT_EQ(category(evidence(0.1, 0.9, std::numeric_limits<double>::quiet_NaN(), 2)), Category::creak);
}

TEST(ContactRules, ThinEvidenceIsUndecided) {
    EXPECT_EQ(category(evidence(0.5, 0.2, 1.0, 5)), Category::undecided);
    EXPECT_EQ(category(evidence(0.5, 0.2, 1.0, 6)), Category::squeal);
    EXPECT_EQ(category(evidence(0.5, 0.2, std::numeric_limits<double>::quiet_NaN())), Category::undecided);
}

TEST(ContactRules, NoJudgedTimeIsUndecidedNeverNone) {
    Evidence figures = evidence(1.0, 0.0, 1.0);
    figures.judged_time = 0.0;
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    figures.judged_rates = {unknown, unknown, unknown};
    EXPECT_EQ(category(figures), Category::undecided);
}

TEST(ContactRules, ObeyTheThresholdsTheyAreGiven) {
    EXPECT_EQ(category(evidence(0.9, 0.1, 0.5), {.quiet_slip = 0.9}), Category::none);
    EXPECT_EQ(category(evidence(0.5, 0.5, 0.5), {.creak_stick = 0.5}), Category::creak);
    EXPECT_EQ(category(evidence(0.5, 0.2, 0.5), {.squeal_regularity = 0.5}), Category::squeal);
    EXPECT_EQ(category(evidence(0.5, 0.2, 0.5), {.least_intervals = 30.0}), Category::undecided);
}

// as many unequal beats as are allowed count as one, though they repeat less well than a pattern must
TEST(ContactRules, UnequalBeatsAreSquealAsFarAsAllowed) {
    EXPECT_EQ(category(pattern(2, 0.01, 0.9)), Category::squeak);
    EXPECT_EQ(category(pattern(2, 0.01, 0.9), {.squeal_beats = 2.0}), Category::squeal);
    EXPECT_EQ(category(pattern(3, 0.01, 0.9), {.squeal_beats = 2.0}), Category::squeak);
}

// such a creak is told by its pitch
TEST(ContactRules, TellOfTheFrequencyOfARegularCreak) {
    Evidence figures = evidence(0.1, 0.9, 0.99);
    figures.alternation.frequency = 199.0;
    EXPECT_TRUE(tells(classify(figures, {}), "regularly, 199 times a second"));
    figures.alternation.frequency = 12.0;
    EXPECT_FALSE(tells(classify(figures, {}), "regularly"));
    figures = evidence(0.1, 0.9, 0.5);
    figures.alternation.frequency = 199.0;
    EXPECT_FALSE(tells(classify(figures, {}), "regularly"));
}

TEST(Margins, AreFigureLessThreshold) {
    const Verdict verdict = classify(evidence(0.4, 0.3, 0.9), {});
    ASSERT_EQ(verdict.margins.size(), 7U);
    EXPECT_DOUBLE_EQ(margin(verdict, "quiet_slip").distance, 0.4 - 0.98);
    EXPECT_DOUBLE_EQ(margin(verdict, "creak_stick").distance, 0.3 - 0.7);
    EXPECT_DOUBLE_EQ(margin(verdict, "least_intervals").distance, 20.0 - 6.0);
    EXPECT_NEAR(margin(verdict, "squeal_regularity").distance, 0.1, 1e-15);
    EXPECT_EQ(margin(verdict, "squeal_regularity").figure_name, "regularity");
}

// the category follows from the margins' signs alone
RC_GTEST_PROP(Margins, SignsGiveTheCategory, ()) {
    const double slip = *support::number_between(0.0, 1.0);
    const double stick = *support::number_between(0.0, 1.0) * (1.0 - slip);
    Evidence figures = evidence(slip, stick, *support::number_between(0.0, 1.0), *support::whole_between(0, 12));
    figures.alternation.mismatch[4] = {*support::number_between(0.0, 0.1)};
    figures.alternation.period = *support::number_between(0.01, 0.1);
    figures.alternation.lag = figures.alternation.mismatch[4].mean < figures.alternation.mismatch[0].mean ? 5 : 1;
    RC_PRE(stick < 1.0);
    const Verdict verdict = classify(figures, {});
    const auto is_above = [&](std::string_view threshold) { return margin(verdict, threshold).distance >= 0.0; };
    const Margin& often = margin(verdict, "squeal_frequency");
    const bool is_pattern = is_above("squeal_repetition") && often.distance >= 0.0;
    const bool is_open = is_above("squeal_repetition") && std::abs(often.distance) < 2.0 * often.error.value();
    const Category expected = is_above("quiet_slip") ? Category::none
                              : is_above("creak_stick")
                                  ? (is_above("least_releases") ? Category::creak : Category::undecided)
                              : !is_above("least_intervals")  ? Category::undecided
                              : is_above("squeal_regularity") ? Category::squeal
                              : is_open                       ? Category::undecided
                              : is_pattern                    ? Category::squeal
                                                              : Category::squeak;
    RC_ASSERT(verdict.category == expected);
    RC_ASSERT(!verdict.reasons.empty());
}

// whatever the figures are, an error that reaches from one to its threshold takes the verdict away, and no smaller one
TEST(Margins, SmallerThanTheErrorAreUndecided) {
    Evidence near_quiet = evidence(0.975, 0.01, 1.0);
    near_quiet.judged_errors.slip = 0.002;
    EXPECT_EQ(category(near_quiet), Category::squeal);
    near_quiet.judged_errors.slip = 0.003;
    const Verdict doubted = classify(near_quiet, {});
    EXPECT_EQ(doubted.category, Category::undecided);
    EXPECT_EQ(*margin(doubted, "quiet_slip").error, 0.003);
    EXPECT_TRUE(tells(doubted,
                      "its slip share of 0.975 scatters within the judged time by 0.003, and lies too near to "
                      "quiet_slip = 0.98 for that: use a longer run.window"));
    EXPECT_EQ(category(near_quiet, {.least_distance = 1.0}), Category::squeal);

    Evidence near_creak = evidence(0.3, 0.69, 1.0);
    near_creak.judged_errors.stick = 0.006;
    EXPECT_EQ(category(near_creak), Category::undecided);

    Evidence near_squeal = evidence(0.3, 0.2, 0.79);
    near_squeal.alternation.mismatch[0].error = 0.004;
    EXPECT_EQ(category(near_squeal), Category::squeak);
    near_squeal.alternation.mismatch[0].error = 0.006;
    EXPECT_EQ(category(near_squeal), Category::undecided);

    EXPECT_EQ(category(pattern(7, 0.01, 0.94, 0.01)), Category::undecided);
    EXPECT_EQ(category(pattern(7, 0.1, 0.94, 0.01)), Category::squeak);
}

// an engine that compared two steps knows how the beats change with the step, too
TEST(Margins, SmallerThanTheChangeWithTheStepAreUndecided) {
    Evidence figures = evidence(0.3, 0.2, 0.79);
    figures.judged_step_change = analysis::Rates{};
    figures.coarser = figures.alternation;
    EXPECT_EQ(category(figures), Category::squeak);
    figures.coarser->mismatch[0].mean = 0.23;
    const Verdict doubted = classify(figures, {});
    EXPECT_EQ(doubted.category, Category::undecided);
    EXPECT_TRUE(tells(doubted, "its regularity of 0.790 changes from twice the time step by 0.02"))
        << doubted.reasons.back();
    EXPECT_TRUE(tells(doubted, "use a smaller run.step"));
}

TEST(Category, HasAName) {
    EXPECT_EQ(name(Category::none), "none");
    EXPECT_EQ(name(Category::squeal), "squeal");
    EXPECT_EQ(name(Category::squeak), "squeak");
    EXPECT_EQ(name(Category::creak), "creak");
    EXPECT_EQ(name(Category::undecided), "undecided");
}

// of one contact: a judged second of slip and of stick
record::ContactTally contact(double slip, double stick) {
    record::ContactTally tally;
    tally.time = tally.judged_time = {slip, stick, 1.0 - slip - stick};
    return tally;
}

record::Tally phase(std::vector<record::ContactTally> contacts) {
    record::Tally tally;
    tally.contacts = std::move(contacts);
    tally.vibration.resize(2 * tally.contacts.size() + 1);
    tally.closing_vibration.resize(tally.vibration.size());
    return tally;
}

TEST(PhaseRules, AreThoseOfTheLoudestContact) {
    const Thresholds thresholds;
    record::ContactTally creaking = contact(0.1, 0.9);
    creaking.changes[record::change_kind(model::ContactState::stick, model::ContactState::slip)].count = 50;
    const record::Tally tally = phase({contact(1.0, 0.0), creaking, contact(0.0, 1.0)});
    const std::vector<std::optional<Verdict>> verdicts = classify_all(tally, thresholds).contacts;
    ASSERT_EQ(verdicts.size(), 3U);
    EXPECT_EQ(verdicts[0]->category, Category::none);
    EXPECT_EQ(verdicts[1]->category, Category::creak);
    EXPECT_EQ(verdicts[2]->category, Category::none);
    const Verdict verdict = classify_phase(tally, thresholds);
    EXPECT_EQ(verdict.category, Category::creak);
    EXPECT_EQ(verdict.evidence.contact, 1U);
}

// a contact whose verdict is in doubt may be the loudest: a quieter one does not speak for the phase
TEST(PhaseRules, AreUndecidedWhereADoubtedContactMayBeTheLoudest) {
    record::ContactTally creaking = contact(0.1, 0.9);
    creaking.changes[record::change_kind(model::ContactState::stick, model::ContactState::slip)].count = 50;
    record::ContactTally doubted = contact(0.97, 0.0);
    doubted.coarser = record::CoarserTally{doubted.time, {0.99, 0.0, 0.01}, {}};
    EXPECT_EQ(classify_phase(phase({creaking, doubted}), {}).category, Category::undecided);
    EXPECT_EQ(classify_phase(phase({creaking, doubted}), {.least_distance = 0.0}).category, Category::creak);
}

TEST(PhaseRules, CallQuietOnlyWhatIsQuietEverywhere) {
    const record::Tally tally = phase({contact(1.0, 0.0), contact(0.5, 0.2)});  // the second: too few intervals
    EXPECT_EQ(classify_phase(tally, {}).category, Category::undecided);
    EXPECT_EQ(classify_phase(phase({contact(1.0, 0.0), contact(1.0, 0.0)}), {}).category, Category::none);
}

// shares of an engine with steps are as good as they stay where the step is halved
TEST(ContactRules, ShareNearerToItsThresholdThanItChangesWithTheStepIsUndecided) {
    Evidence near_quiet = evidence(0.985, 0.01, 1.0);
    near_quiet.judged_step_change = analysis::Rates{0.002, 0.1, 0.0};
    EXPECT_EQ(category(near_quiet), Category::none);
    near_quiet.judged_step_change->slip = 0.003;
    const Verdict doubted = classify(near_quiet, {});
    EXPECT_EQ(doubted.category, Category::undecided);
    EXPECT_EQ(
        doubted.reasons.back(),
        "its slip share of 0.985 changes from twice the time step by 0.003, and lies too near to quiet_slip = 0.98 "
        "for that: use a smaller run.step");

    Evidence near_creak = evidence(0.32, 0.68, 1.0);
    near_creak.judged_step_change = analysis::Rates{0.03, 0.009, 0.0};
    EXPECT_EQ(category(near_creak), Category::squeal);
    near_creak.judged_step_change->stick = 0.011;
    EXPECT_EQ(category(near_creak), Category::undecided);
    EXPECT_NE(classify(near_creak, {}).reasons.back().find("stick share of 0.680"), std::string::npos);
}

// of three joints one locks and pushes the plate away from the others
TEST(PhaseRules, SayThatAJointLocksWhereTheOthersAreSilent) {
    record::ContactTally locking = contact(0.0, 1.0);
    locking.preload = 8.0;
    locking.ending = {model::ContactState::stick, 0.0, {record::Future::sticks}};
    locking.ending.outlook.drag = {8.0, 58.0, 0.05, 1e3};
    const record::ContactTally apart = contact(0.0, 0.0);
    const Verdict verdict = classify_phase(phase({apart, locking, apart}), {});
    EXPECT_EQ(verdict.category, Category::none);
    EXPECT_EQ(verdict.quiet, Quiet::locks);
    EXPECT_EQ(verdict.evidence.contact, 1U);
    ASSERT_EQ(verdict.reasons.size(), 2U);
    EXPECT_EQ(verdict.reasons[0],
              "contact 2 locks: N rises from 8 N to 58 N over 50 mm and goes on by 1 N/mm (proven)");
    EXPECT_EQ(verdict.reasons[1], "2 contacts have lifted off and stay off");
    EXPECT_EQ(classify_phase(phase({contact(1.0, 0.0), locking}), {}).quiet, Quiet::locks);
    const Verdict named = classify_phase(phase({apart, locking, apart}), {}, {"hinge side", "top", "latch side"});
    EXPECT_TRUE(named.reasons[0].starts_with("top locks: N rises")) << named.reasons[0];

    // beside a noise, or what may become one, it is a warning
    record::ContactTally creaking = contact(0.1, 0.9);
    creaking.changes[record::change_kind(model::ContactState::stick, model::ContactState::slip)].count = 50;
    const Verdict noisy = classify_phase(phase({creaking, locking}), {});
    EXPECT_EQ(noisy.category, Category::creak);
    ASSERT_EQ(noisy.warnings.size(), 1U);
    EXPECT_EQ(noisy.warnings.front(), verdict.reasons.front());
    record::ContactTally slipping = contact(0.5, 0.2);
    slipping.ending.state = model::ContactState::slip;
    const Verdict thin = classify_phase(phase({slipping, locking}), {});
    EXPECT_EQ(thin.category, Category::undecided);
    EXPECT_EQ(thin.warnings.size(), 1U);
}

TEST(PhaseRules, WarnOfTheContactThatIsPressedMost) {
    record::ContactTally light = contact(1.0, 0.0), heavy = contact(1.0, 0.0);
    light.preload = 0.67;
    light.load.largest_force = 55.0;
    heavy.preload = 10.0;
    heavy.load.largest_force = 200.0;
    const Verdict verdict = classify_phase(phase({heavy, light}), {});
    EXPECT_EQ(verdict.quiet, Quiet::slides);
    ASSERT_EQ(verdict.warnings.size(), 1U);
    EXPECT_TRUE(classify_phase(phase({heavy, light}), {}, {"left", "right"}).warnings.front().starts_with("right: N"));
    EXPECT_EQ(verdict.warnings.front(),
              "contact 2: N reaches 55 N, 82.1 times the preload of 0.67 N: the contact digs in (sprag-slip)");
}

}  // namespace
}  // namespace stridor::classification
