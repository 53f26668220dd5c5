#include "stridor/console/results/simulation_text.hpp"

#include "stridor/classification/contact_rules.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <string>

namespace stridor::console {
namespace {

using integration::Motion;
using integration::Reason;

using StateTimes = std::array<double, model::contact_states>;  // [s] slip, stick, separation

// two joints in one phase; the second has these shares, by time [s]
record::Tally tally(record::Phase phase, const StateTimes& second) {
    record::Tally tally;
    tally.phase = phase;
    tally.contacts.resize(2);
    tally.contacts[0].time = tally.contacts[0].judged_time = {1.0, 0.0, 0.0};
    tally.contacts[1].time = tally.contacts[1].judged_time = second;
    tally.vibration.resize(5);
    tally.closing_vibration.resize(5);
    return tally;
}

constexpr StateTimes slides{1.0, 0.0, 0.0}, changes{0.5, 0.375, 0.125};

std::string text_of(const Motion& motion) {
    parameters::Case c;
    c.joints.push_back({.name = "lower"});
    return simulation_text(c, motion, classification::classify_phases(motion.record.phases, c.verdict));
}

std::size_t count(const std::string& text, const std::string& words) {
    std::size_t found = 0;
    for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1))
        ++found;
    return found;
}

TEST(SimulationText, SaysNothingOfAFormulationThatWasNotAskedFor) {
    Motion motion;
    motion.record.phases = {tally(record::Phase::all, slides)};
    EXPECT_EQ(count(text_of(motion), "inertia"), 0U);
}

TEST(SimulationText, FlagsVerdictsThatDependOnInertiaAtTheContacts) {
    Motion motion;
    motion.record.phases = {tally(record::Phase::all, slides)};
    motion.massless = integration::MasslessTwin{{Reason::completed, 1.0}, {tally(record::Phase::all, changes)}};
    const std::string text = text_of(motion);
    EXPECT_EQ(count(text,
                    "\nwithout inertia at the contacts shares differ by at most: "
                    "slip 50.00 %, stick 37.50 %, separation 12.50 %\n"),
              1U);
    EXPECT_EQ(count(text, "\nall: the formulations disagree: none with inertia at the contacts, undecided without\n"),
              1U);
}

TEST(SimulationText, GivesTheDifferenceWhereVerdictsAgree) {
    Motion motion;
    motion.record.phases = {tally(record::Phase::all, slides)};
    motion.massless = integration::MasslessTwin{{Reason::completed, 1.0}, motion.record.phases};
    const std::string text = text_of(motion);
    EXPECT_EQ(count(text,
                    "\nwithout inertia at the contacts shares differ by at most: "
                    "slip 0.00 %, stick 0.00 %, separation 0.00 %\n"),
              1U);
    EXPECT_EQ(count(text, "disagree"), 0U);
}

TEST(SimulationText, NamesThePhaseOfEachDifference) {
    Motion motion;
    motion.record.phases = {tally(record::Phase::going, slides), tally(record::Phase::coming, slides)};
    motion.massless = integration::MasslessTwin{
        {Reason::completed, 1.0}, {tally(record::Phase::going, slides), tally(record::Phase::coming, changes)}};
    const std::string text = text_of(motion);
    EXPECT_EQ(count(text, "\ngoing: without inertia at the contacts shares differ by at most: slip 0.00 %"), 1U);
    EXPECT_EQ(count(text, "\ncoming: without inertia at the contacts shares differ by at most: slip 50.00 %"), 1U);
    EXPECT_EQ(count(text, "going: the formulations disagree"), 0U);
    EXPECT_EQ(count(text, "coming: the formulations disagree"), 1U);
}

TEST(SimulationText, SaysWhyTheOtherFormulationHasNoResult) {
    Motion motion;
    motion.record.phases = {tally(record::Phase::all, slides)};
    motion.massless = integration::MasslessTwin{{Reason::no_forces, 0.25}, {}};
    const std::string text = text_of(motion);
    EXPECT_EQ(count(text, "\nwithout inertia at the contacts it has no result: no_forces\n"), 1U);
    EXPECT_EQ(count(text, "disagree"), 0U);
}

}  // namespace
}  // namespace stridor::console
