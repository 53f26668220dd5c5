#include "stridor/integration/rules/set_search.hpp"

#include <gtest/gtest.h>

namespace stridor::integration {
namespace {

using Set = std::vector<ContactMode>;
using enum ContactMode;

TEST(ContactSets, ComeWithTheFewestChangesFirst) {
    const std::vector<Set> sets = contact_sets({{stick, slip_forward, open}, {slip_backward, open}}, {open, open});
    EXPECT_EQ(sets, (std::vector<Set>{{open, open},
                                      {stick, open},
                                      {slip_forward, open},
                                      {open, slip_backward},
                                      {stick, slip_backward},
                                      {slip_forward, slip_backward}}));
}

TEST(ContactSets, AreNoneWhereTheyAreTooMany) {
    EXPECT_EQ(contact_sets({{stick, open}, {stick, open}}, {open, open}, 4).size(), 4U);
    EXPECT_TRUE(contact_sets({{stick, open}, {stick, open}}, {open, open}, 3).empty());
}

}  // namespace
}  // namespace stridor::integration
