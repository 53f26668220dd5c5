#include "stridor/sweep/agenda.hpp"

#include <gtest/gtest.h>

namespace stridor::sweep {
namespace {

using Runs = std::vector<std::size_t>;

TEST(Agenda, GivesTheLowestFirstWhateverTheOrderTheyCameIn) {
    Agenda agenda(100);
    for (const std::size_t run : {7U, 3U, 99U, 0U})
        agenda.add(run);
    EXPECT_EQ(agenda.next(2), (Runs{0, 3}));
    agenda.add(1);
    EXPECT_EQ(agenda.left(), 3U);
    EXPECT_EQ(agenda.next(10), (Runs{1, 7, 99}));
    EXPECT_EQ(agenda.left(), 0U);
    EXPECT_TRUE(agenda.next(10).empty());
}

TEST(Agenda, TakesARunOnce) {
    Agenda agenda(10);
    agenda.add(4);
    agenda.add(4);
    EXPECT_EQ(agenda.next(10), Runs{4});
    agenda.add(4);
    EXPECT_EQ(agenda.left(), 0U) << "it is out, or done";
}

}  // namespace
}  // namespace stridor::sweep
