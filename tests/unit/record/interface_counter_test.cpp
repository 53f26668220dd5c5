#include "stridor/record/interface_counter.hpp"

#include "support/property.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace stridor::record {
namespace {

using model::ContactState;
using enum model::ContactState;

// judged from 1 to 3 and from 5 to 7
Schedule judged_twice() {
    return {{{0.0, 1.0, Phase::going, Use::counted},
             {1.0, 3.0, Phase::going, Use::judged},
             {3.0, 5.0, Phase::coming, Use::counted},
             {5.0, 7.0, Phase::coming, Use::judged},
             {7.0, 8.0, Phase::coming, Use::counted}},
            {Phase::going, Phase::coming}};
}

TEST(InterfaceCounter, CountsWhatTheContactsDoAtTheSameTime) {
    InterfaceCounter counter(judged_twice(), {2, 5});
    counter.enter(2, stick, 0.0);
    counter.enter(5, stick, 0.0);
    counter.enter(4, slip, 0.5);  // another interface's
    counter.enter(2, slip, 1.5);
    counter.enter(5, slip, 2.0);
    counter.enter(2, stick, 2.25);
    counter.enter(5, stick, 6.0);
    counter.enter(2, separation, 6.5);
    const std::vector<InterfaceTally> tallies = counter.finish(8.0);
    ASSERT_EQ(tallies.size(), 2U);
    const InterfaceTally& going = tallies[0];
    const InterfaceTally& coming = tallies[1];
    EXPECT_EQ(going.contacts, (std::vector<std::size_t>{2, 5}));
    EXPECT_EQ(going.state_time, (std::array{0.5, 1.25, 0.25, 0.0}));  // sticks, partly, slides, open
    EXPECT_EQ(going.free_together, (std::vector{0.75, 0.25, 0.25, 1.0}));
    EXPECT_EQ(coming.state_time, (std::array{1.0, 1.0, 0.0, 0.0}));  // an open contact does not count
    EXPECT_EQ(coming.free_together, (std::vector{0.5, 0.0, 0.0, 1.0}));
}

TEST(InterfaceCounter, IsThereForEachInterfaceOfSeveralContacts) {
    EXPECT_TRUE(interface_counters(judged_twice(), {}).empty());
    EXPECT_TRUE(interface_counters(judged_twice(), {-1, -1, 3}).empty());
    std::vector<InterfaceCounter> counters = interface_counters(judged_twice(), {7, -1, 3, 7, 3, 9});
    ASSERT_EQ(counters.size(), 2U);
    EXPECT_EQ(counters[0].finish(8.0).front().contacts, (std::vector<std::size_t>{2, 4}));
    EXPECT_EQ(counters[1].finish(8.0).front().contacts, (std::vector<std::size_t>{0, 3}));
}

// --- against samples of time: all changes lie on a grid of 1/8, so that they are exact

RC_GTEST_PROP(InterfaceCounter, AgreesWithSamplesOfTime, ()) {
    constexpr std::size_t contacts = 3;
    constexpr int ticks = 64;
    const auto states = *rc::gen::container<std::vector<int>>(contacts * ticks, support::whole_between(0, 2));
    InterfaceCounter counter(judged_twice(), {0, 1, 2});
    const auto state_at = [&](std::size_t contact, int tick) {
        return static_cast<ContactState>(states[contact * ticks + static_cast<std::size_t>(tick)]);
    };
    std::array<double, 4> time{};
    std::array<double, contacts * contacts> free{};
    for (int tick = 0; tick < ticks; ++tick) {
        for (std::size_t k = 0; k < contacts; ++k)
            if (tick == 0 || state_at(k, tick) != state_at(k, tick - 1))
                counter.enter(k, state_at(k, tick), tick / 8.0);
        if (tick < 8 || tick >= 24) continue;  // judged while going: from 1 to 3
        bool sticks = false, slides = false;
        for (std::size_t k = 0; k < contacts; ++k) {
            sticks |= state_at(k, tick) == stick;
            slides |= state_at(k, tick) == slip;
            for (std::size_t j = 0; j < contacts; ++j)
                if (state_at(k, tick) != stick && state_at(j, tick) != stick) free[k * contacts + j] += 0.125;
        }
        time[sticks ? (slides ? 1 : 0) : (slides ? 2 : 3)] += 0.125;
    }
    const InterfaceTally going = counter.finish(8.0).front();
    RC_ASSERT(going.state_time == time);
    RC_ASSERT(std::equal(free.begin(), free.end(), going.free_together.begin()));
}

}  // namespace
}  // namespace stridor::record
