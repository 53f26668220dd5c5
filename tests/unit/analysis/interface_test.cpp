#include "stridor/analysis/interface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace stridor::analysis {
namespace {

// a judged time of 2 s; three contacts
record::Tally phase(const std::vector<record::Load>& loads, std::vector<double> free_together) {
    record::Tally tally;
    tally.contacts.resize(loads.size());
    record::InterfaceTally interface;
    for (std::size_t k = 0; k < loads.size(); ++k) {
        tally.contacts[k].load = loads[k];
        interface.contacts.push_back(k);
    }
    interface.state_time = {1.0, 0.5, 0.5, 0.0};
    interface.free_together = std::move(free_together);
    tally.interfaces = {interface};
    return tally;
}

TEST(Interface, WeighsItsContactsByWhatTheyCarry) {
    const Interface whole = interface_of(phase({{60.0, 4.0}, {39.4, 2.0}, {0.6, 0.0}}, {}), 0);
    EXPECT_EQ(whole.rates, (std::array{0.5, 0.25, 0.25, 0.0}));
    EXPECT_DOUBLE_EQ(whole.loads[0].normal_force, 30.0);
    EXPECT_DOUBLE_EQ(whole.loads[0].share, 0.6);
    EXPECT_DOUBLE_EQ(whole.loads[0].friction_power, 2.0);
    EXPECT_TRUE(whole.loads[1].is_loaded);
    EXPECT_FALSE(whole.loads[2].is_loaded);
}

TEST(Interface, OfManyEqualContactsHasNoUnloadedOnes) {
    const Interface whole = interface_of(phase(std::vector<record::Load>(300, {2.0, 1.0}), {}), 0);
    for (const CarriedLoad& load : whole.loads)
        EXPECT_TRUE(load.is_loaded);
}

TEST(Interface, OfWhichNoLoadIsKnownHasEqualShares) {
    const Interface whole = interface_of(phase(std::vector<record::Load>(4), {}), 0);
    EXPECT_DOUBLE_EQ(whole.loads[3].share, 0.25);
    EXPECT_TRUE(whole.loads[3].is_loaded);
}

TEST(Interface, SaysHowMuchOfTheLoadIsFreeAtOnce) {
    const std::vector<record::Load> loads{{50.0, 0.0}, {30.0, 0.0}, {20.0, 0.0}};
    const std::vector<std::size_t> all{0, 1, 2};
    const auto free = [&](std::vector<double> together) {
        const record::Tally tally = phase(loads, std::move(together));
        return free_together(tally.interfaces.front(), interface_of(tally, 0), all);
    };
    EXPECT_DOUBLE_EQ(free({1, 1, 1, 1, 1, 1, 1, 1, 1}), 1.0);
    EXPECT_NEAR(free({1, 0, 0, 0, 1, 0, 0, 0, 1}), 0.25 + 0.09 + 0.04, 1e-15);  // one by one
    EXPECT_TRUE(std::isnan(free(std::vector<double>(9, 0.0))));
    const record::Tally tally = phase(loads, {1, 0, 0, 0, 1, 1, 0, 1, 1});
    EXPECT_DOUBLE_EQ(free_together(tally.interfaces.front(), interface_of(tally, 0), std::vector<std::size_t>{1, 2}),
                     1.0);
}

}  // namespace
}  // namespace stridor::analysis
