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
    figures.alternation.mismatch.fill(std::numeric_limits<double>::infinity());
    figures.alternation.mismatch[0] = 1.0 - regularity;
    return figures;
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

// said of a squeak whose pattern comes back after more beats than a squeal may have, and of nothing else
TEST(ContactRules, TellOfALateRepetitionWhereThereIsOne) {
    const auto tells = [](const Evidence& figures, Category expected) {
        const Verdict verdict = classify(figures, {});
        EXPECT_EQ(verdict.category, expected);
        return std::any_of(verdict.reasons.begin(), verdict.reasons.end(), [](const std::string& reason) {
            return reason == "the pattern repeats, but only after 7 unequal beats";
        });
    };
    Evidence figures = evidence(0.2, 0.1, 0.3);
    figures.alternation.lag = 7;
    EXPECT_FALSE(tells(figures, Category::squeak));
    figures.alternation.repetition = 0.9;
    EXPECT_TRUE(tells(figures, Category::squeak));
    Evidence regular = evidence(0.2, 0.1, 0.9);
    regular.alternation.lag = 7;
    EXPECT_FALSE(tells(regular, Category::squeal));
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

// a pattern of two unequal beats is squeak by default, squeal where two beats are allowed
TEST(ContactRules, UnequalBeatsAreSquealOnlyAsFarAsAllowed) {
    Evidence figures = evidence(0.4, 0.2, 0.3);
    figures.alternation.mismatch[1] = 0.0;
    figures.alternation.repetition = 1.0;
    figures.alternation.lag = 2;
    EXPECT_EQ(category(figures), Category::squeak);
    EXPECT_EQ(category(figures, {.squeal_beats = 2.0}), Category::squeal);
    const Verdict verdict = classify(figures, {});
    EXPECT_TRUE(std::any_of(verdict.reasons.begin(), verdict.reasons.end(), [](const std::string& reason) {
        return reason.find("after 2 unequal beats") != std::string::npos;
    }));
}

TEST(Margins, AreFigureLessThreshold) {
    const Verdict verdict = classify(evidence(0.4, 0.3, 0.9), {});
    ASSERT_EQ(verdict.margins.size(), 5U);
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
    const Evidence figures = evidence(slip, stick, *support::number_between(0.0, 1.0), *support::whole_between(0, 12));
    RC_PRE(stick < 1.0);
    const Verdict verdict = classify(figures, {});
    const Category expected =
        margin(verdict, "quiet_slip").distance >= 0.0 ? Category::none
        : margin(verdict, "creak_stick").distance >= 0.0
            ? (margin(verdict, "least_releases").distance >= 0.0 ? Category::creak : Category::undecided)
        : margin(verdict, "least_intervals").distance < 0.0    ? Category::undecided
        : margin(verdict, "squeal_regularity").distance >= 0.0 ? Category::squeal
                                                               : Category::squeak;
    RC_ASSERT(verdict.category == expected);
    RC_ASSERT(!verdict.reasons.empty());
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

TEST(PhaseRules, CallQuietOnlyWhatIsQuietEverywhere) {
    const record::Tally tally = phase({contact(1.0, 0.0), contact(0.5, 0.2)});  // the second: too few intervals
    EXPECT_EQ(classify_phase(tally, {}).category, Category::undecided);
    EXPECT_EQ(classify_phase(phase({contact(1.0, 0.0), contact(1.0, 0.0)}), {}).category, Category::none);
}

// shares of an engine with steps are as good as they stay where the step is halved
TEST(ContactRules, ShareNearerToItsThresholdThanItChangesWithTheStepIsUndecided) {
    Evidence near_quiet = evidence(0.985, 0.01, 1.0);
    near_quiet.judged_step_change = analysis::Rates{0.004, 0.1, 0.0};
    EXPECT_EQ(category(near_quiet), Category::none);
    near_quiet.judged_step_change->slip = 0.006;
    const Verdict doubted = classify(near_quiet, {});
    EXPECT_EQ(doubted.category, Category::undecided);
    EXPECT_EQ(doubted.reasons.back(),
              "its slip share of 98.5 % changes by 0.6 % from twice the time step, and lies nearer than that to "
              "quiet_slip = 98.0 %: use a smaller run.step");

    Evidence near_creak = evidence(0.32, 0.68, 1.0);
    near_creak.judged_step_change = analysis::Rates{0.03, 0.019, 0.0};
    EXPECT_EQ(category(near_creak), Category::squeal);
    near_creak.judged_step_change->stick = 0.021;
    EXPECT_EQ(category(near_creak), Category::undecided);
    EXPECT_NE(classify(near_creak, {}).reasons.back().find("stick share of 68.0 %"), std::string::npos);
}

}  // namespace
}  // namespace stridor::classification
