#include "stridor/base/decompositions.hpp"

#include <gtest/gtest.h>

// Eigen adds the products of large matrices in blocks as large as the caches. Were they asked of the processor, the
// inverse of 300 numbers by 300 would end in other bits on a machine with 48 KiB than on one with 32 KiB.
TEST(Decompositions, AddInTheSameBlocksOnEveryMachine) {
    EXPECT_EQ(Eigen::l1CacheSize(), 32 * 1024);
    EXPECT_EQ(Eigen::l2CacheSize(), 256 * 1024);
    EXPECT_EQ(Eigen::l3CacheSize(), 2 * 1024 * 1024);
}
