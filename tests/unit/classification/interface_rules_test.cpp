#include "stridor/classification/interface_rules.hpp"

#include "stridor/classification/contact_rules.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace stridor::classification {
namespace {

using model::ContactState;

constexpr std::size_t releases = record::change_kind(ContactState::stick, ContactState::slip);

// a judged second, with so many releases at these intervals [s]
record::ContactTally node(double slip, double stick, int count = 0, double interval = 0.01, double unequal = 0.0) {
    record::ContactTally tally;
    tally.time = tally.judged_time = {slip, stick, 1.0 - slip - stick};
    for (int k = 0; k < count; ++k)
        tally.changes[releases].times.push_back(interval * (k + (k % 3 == 0 ? unequal : 0.0)));
    tally.changes[releases].count = count;
    tally.load = {1.0, slip};
    return tally;
}

// one interface of these contacts, of which those that are free are so at the same time or one by one
record::Tally nodes_phase(std::vector<record::ContactTally> contacts, bool is_together = true) {
    record::Tally tally;
    tally.contacts = std::move(contacts);
    const std::size_t n = tally.contacts.size();
    tally.vibration.resize(2 * n + 1);
    tally.closing_vibration.resize(2 * n + 1);
    record::InterfaceTally interface;
    interface.state_time = {1.0, 0.0, 0.0, 0.0};
    for (std::size_t i = 0; i < n; ++i) {
        interface.contacts.push_back(i);
        for (std::size_t j = 0; j < n; ++j) {
            const double free = 1.0 - std::max(tally.contacts[i].judged_time[1], tally.contacts[j].judged_time[1]);
            interface.free_together.push_back(i == j || is_together ? free : 0.0);
        }
    }
    tally.interfaces = {interface};
    return tally;
}

TEST(InterfaceRules, CallQuietOnlyWhatIsQuietInEachLoadedContact) {
    const InterfaceVerdict quiet = classify_interface(nodes_phase({node(1.0, 0.0), node(0.0, 1.0)}), 0, {});
    EXPECT_EQ(quiet.whole.category, Category::none);
    EXPECT_EQ(quiet.whole.quiet, Quiet::slides);
    EXPECT_EQ(quiet.whole.reasons.front(), "quiet because each of its 2 loaded contacts is: 1 slide, 1 stick");
    EXPECT_FALSE(quiet.differs);
    EXPECT_EQ(classify_interface(nodes_phase({node(0.0, 1.0), node(0.0, 1.0)}), 0, {}).whole.quiet, Quiet::sticks);

    // a small noisy contact beside a heavy quiet one: the mean slips 99 %
    record::ContactTally heavy = node(1.0, 0.0);
    heavy.load.normal_impulse = 15.0;
    const InterfaceVerdict noisy = classify_interface(nodes_phase({heavy, node(0.9, 0.1, 90)}), 0, {});
    EXPECT_EQ(noisy.whole.category, Category::squeal);
    EXPECT_EQ(noisy.whole.evidence.contact, 1U);
    EXPECT_DOUBLE_EQ(noisy.whole.evidence.judged_rates.slip, 0.9);
    EXPECT_TRUE(noisy.differs);
}

TEST(InterfaceRules, LockWhereOneLoadedContactDoes) {
    record::ContactTally locking = node(0.0, 1.0);
    locking.ending.outlook.future = record::Future::sticks;
    locking.ending.outlook.drag = {8.0, 58.0, 0.05, 1e3};
    const InterfaceVerdict verdict = classify_interface(nodes_phase({node(1.0, 0.0), locking}), 0, {});
    EXPECT_EQ(verdict.whole.category, Category::none);
    EXPECT_EQ(verdict.whole.quiet, Quiet::locks);
    const InterfaceVerdict named =
        classify_interface(nodes_phase({node(1.0, 0.0), locking}), 0, {}, {"node 7", "node 8"});
    EXPECT_TRUE(named.whole.reasons.front().starts_with("node 8 locks: ")) << named.whole.reasons.front();
    EXPECT_EQ(verdict.whole.reasons.front(),
              "contact 2 locks: N rises from 8 N to 58 N over 50 mm and goes on by 1 N/mm (proven)");
}

TEST(InterfaceRules, GiveUnloadedContactsNoVerdict) {
    record::ContactTally touching = node(0.5, 0.2, 40, 0.01, 0.5);
    touching.load.normal_impulse = 0.01;
    const InterfaceVerdict verdict = classify_interface(nodes_phase({node(1.0, 0.0), touching}), 0, {});
    EXPECT_FALSE(verdict.contacts[1].has_value());
    EXPECT_EQ(verdict.whole.category, Category::none);
}

TEST(InterfaceRules, WeighRatesByLoadAndTakeTheSequenceOfTheLeader) {
    record::ContactTally regular = node(0.4, 0.6, 90);
    record::ContactTally irregular = node(0.8, 0.2, 90, 0.01, 0.7);
    regular.load = {3.0, 5.0};
    irregular.load = {1.0, 1.0};
    const InterfaceVerdict verdict = classify_interface(nodes_phase({irregular, regular}), 0, {});
    EXPECT_EQ(verdict.whole.evidence.contact, 1U);
    EXPECT_EQ(verdict.whole.category, Category::squeal);
    EXPECT_DOUBLE_EQ(verdict.whole.evidence.judged_rates.slip, 0.25 * 0.8 + 0.75 * 0.4);
}

TEST(InterfaceRules, TakeNoThinEvidenceWhereThereIsEnough) {
    record::ContactTally thin = node(0.5, 0.2, 2);
    thin.load.friction_loss = 100.0;
    const InterfaceVerdict verdict = classify_interface(nodes_phase({thin, node(0.5, 0.2, 60)}), 0, {});
    EXPECT_EQ(verdict.whole.category, Category::squeal);
    EXPECT_EQ(classify_interface(nodes_phase({thin, thin}), 0, {}).whole.category, Category::undecided);
}

TEST(InterfaceRules, CallSlipOfSingleNodesNoCreak) {
    const std::vector<record::ContactTally> contacts(5, node(0.1, 0.9, 50));
    const InterfaceVerdict creak = classify_interface(nodes_phase(contacts, true), 0, {});
    EXPECT_EQ(creak.whole.category, Category::creak);
    EXPECT_DOUBLE_EQ(creak.free_together, 1.0);
    const InterfaceVerdict micro = classify_interface(nodes_phase(contacts, false), 0, {});
    EXPECT_EQ(micro.whole.category, Category::squeal);
    EXPECT_NEAR(micro.free_together, 0.2, 1e-15);
    EXPECT_EQ(micro.whole.reasons.front(), "contacts slip one by one, 20 % of their load at once: no creak");
    EXPECT_EQ(micro.contacts.front()->category, Category::creak);  // by itself
}

TEST(InterfaceRules, LeaveOpenWhatFewReleasesTellOfTheLoadFreeAtOnce) {
    const auto whole_of = [](int count, double together, const parameters::Thresholds& thresholds) {
        record::Tally phase = nodes_phase(std::vector<record::ContactTally>(5, node(0.1, 0.9, count)));
        for (std::size_t i = 0; i < 5; ++i)
            for (std::size_t j = 0; j < 5; ++j)  // itself is a fifth of the load
                phase.interfaces[0].free_together[5 * i + j] = 0.1 * (i == j ? 1.0 : (together - 0.2) / 0.8);
        return classify_interface(phase, 0, thresholds).whole;
    };
    // the largest standard error of 25 releases is 0.098
    const Verdict open = whole_of(25, 0.4, {});
    EXPECT_EQ(open.category, Category::undecided);
    EXPECT_EQ(open.reasons.back(),
              "40 % of the load of its contacts is free at once, give or take 10 %: too near to "
              "50 % to tell a release from slip one by one; use a longer run.window");
    EXPECT_EQ(whole_of(25, 0.6, {}).category, Category::undecided);
    EXPECT_EQ(whole_of(25, 0.8, {}).category, Category::creak);
    EXPECT_EQ(whole_of(25, 0.25, {}).category, Category::squeal);
    EXPECT_EQ(whole_of(400, 0.4, {}).category, Category::squeal);
    EXPECT_EQ(whole_of(400, 0.6, {}).category, Category::creak);
    parameters::Thresholds bold;
    bold.least_distance = 0.0;
    EXPECT_EQ(whole_of(25, 0.4, bold).category, Category::squeal);
}

TEST(InterfaceRules, SpeakForThePhase) {
    const record::Tally tally = nodes_phase(std::vector<record::ContactTally>(5, node(0.1, 0.9, 50)), false);
    EXPECT_EQ(classify_phase(tally, {}).category, Category::squeal);
    record::Tally with_another = tally;  // a contact apart from the interface
    with_another.contacts.push_back(node(1.0, 0.0));
    with_another.vibration.resize(13);
    with_another.closing_vibration.resize(13);
    EXPECT_EQ(classify_phase(with_another, {}).category, Category::squeal);
    for (record::ContactTally& one : with_another.contacts)
        one = node(1.0, 0.0);
    with_another.contacts.back() = node(0.1, 0.9, 50);
    EXPECT_EQ(classify_phase(with_another, {}).category, Category::creak);
}

}  // namespace
}  // namespace stridor::classification
