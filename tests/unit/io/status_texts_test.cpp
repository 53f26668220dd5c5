#include "stridor/io/chart/status_texts.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace stridor::io {
namespace {

// the chart in so many shares, those of these numbers lacking cells
sweep::ChartState state_of(std::size_t count, const std::vector<std::size_t>& lacking) {
    sweep::ChartState state;
    for (std::size_t index = 0; index < count; ++index) {
        sweep::StoreState share;
        share.share = sweep::Share{index, count};
        share.standing = sweep::StoreStanding::complete;
        state.shares.push_back(share);
    }
    for (const std::size_t index : lacking)
        state.shares[index].missing = 7;
    return state;
}

TEST(LackingText, NamesTheSharesAsAnArray) {
    EXPECT_EQ(lacking_text(state_of(16, {0, 3, 7, 8, 9}), 16), "0,3,7-9");
    EXPECT_EQ(lacking_text(state_of(3, {2}), 3), "2");
    EXPECT_EQ(lacking_text(state_of(3, {}), 3), "");
}

TEST(LackingText, NamesAllWhereNoneOfThatNumberWasBegun) {
    EXPECT_EQ(lacking_text({}, 16), "0-15");
    EXPECT_EQ(lacking_text(state_of(3, {2}), 16), "0-15");
    sweep::ChartState merged;
    merged.is_merged = true;
    EXPECT_EQ(lacking_text(merged, 16), "");
}

TEST(LackingText, NamesAShareThatCannotBeRead) {
    sweep::ChartState state = state_of(3, {});
    state.shares[1].standing = sweep::StoreStanding::unreadable;
    EXPECT_EQ(lacking_text(state, 3), "1");
}

}  // namespace
}  // namespace stridor::io
