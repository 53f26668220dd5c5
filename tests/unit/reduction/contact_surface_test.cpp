#include "stridor/reduction/contact_surface.hpp"

#include "support/structures/lattice_part.hpp"

#include <gtest/gtest.h>

namespace stridor::reduction {
namespace {

using support::chain_part;
using support::lattice_part;
using support::LatticeSupport;

std::vector<base::Problem> doubts_at(const std::string& rows, int normal) {
    const ElasticPart part = lattice_part({5, 4, 4}, LatticeSupport::free);
    return surface_doubts(part, named_rows(part, rows), normal);
}

TEST(ContactSurface, OfALowerFaceIsTakenAsItIs) {
    EXPECT_TRUE(doubts_at("FOOT", 3).empty());
    EXPECT_TRUE(doubts_at("FOOT", 0).empty());
}

TEST(ContactSurface, TellsAReversedNormal) {
    const std::vector<base::Problem> found = doubts_at("FOOT", -3);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].what, "the normal -z points out of the part at 20 of 20 nodes");
    EXPECT_EQ(found[0].suggestion, "Say --normal 3?");
}

TEST(ContactSurface, TellsANormalInTheSurface) {
    const std::vector<base::Problem> found = doubts_at("FOOT", 1);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].what, "the normal x lies in the surface at 12 of 20 nodes");
    EXPECT_EQ(found[0].suggestion, "Say --normal 3?");
}

// of the 5 by 4 nodes of the second layer 3 by 2 are surrounded
TEST(ContactSurface, TellsNodesInside) {
    const std::vector<base::Problem> found = doubts_at("126", 3);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].what, "node 126 lies inside the part");
    EXPECT_TRUE(doubts_at("120", 1).empty()) << "an edge of the block";
}

TEST(ContactSurface, SaysNothingWithoutPlacesAndOfLines) {
    const ElasticPart chain = chain_part(7, 1.0, 0.5);
    EXPECT_TRUE(surface_doubts(chain, {0, 3}, 1).empty());
    const ElasticPart line = lattice_part({5, 1, 1}, LatticeSupport::free);
    EXPECT_TRUE(surface_doubts(line, named_rows(line, "102"), 3).empty());
}

}  // namespace
}  // namespace stridor::reduction
