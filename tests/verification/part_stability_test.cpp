// Steady sliding of a finite-element part on many nodes, against the numbers of an implementation written apart.

#include "stridor/analysis/sliding_stability.hpp"
#include "stridor/io/structure/part_files.hpp"
#include "stridor/reduction/part.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace stridor {
namespace {

using analysis::SlidingStability;
using analysis::StabilityKind;

// a block of rubber that slides along x on the twelve nodes of its foot, each pressed with 1 N, without damping
model::Structure block_on_its_foot(double kinetic_friction) {
    const reduction::ElasticPart part =
        io::read_part({.files = {STRIDOR_SOURCE_DIR "/tests/fixtures/structures/calculix/block.sti"}});
    const auto& nodes = reduction::find_set(part, "foot")->nodes;
    const int dofs = static_cast<int>(reduction::rows_of(part));
    model::Structure structure = model::structure_of_size(dofs, static_cast<int>(nodes.size()));
    structure.mass = part.mass;
    structure.stiffness = part.stiffness;
    const auto row = [&](const std::string& node, int component) {
        const auto found = std::find(part.labels.begin(), part.labels.end(), reduction::RowLabel{node, component});
        return static_cast<Eigen::Index>(found - part.labels.begin());
    };
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        model::ContactPoint& contact = structure.contacts[k];
        contact.normal(row(nodes[k], 3)) = 1.0;
        contact.tangent(row(nodes[k], 1)) = 1.0;
        contact.friction = model::Coulomb{kinetic_friction, kinetic_friction};
        structure.load -= contact.normal;
    }
    return structure;
}

SlidingStability block_at(double mu, parameters::Direction direction = parameters::Direction::going) {
    return analysis::sliding_stability(block_on_its_foot(mu), direction);
}

TEST(BlockOnItsFoot, HasTheFrequenciesOfAFootThatIsHeldAcross) {
    const SlidingStability still = block_at(0.0);
    EXPECT_EQ(still.kind, StabilityKind::stable);
    EXPECT_NEAR(still.normal_force, 1.0, 1e-9);
    const double hertz[]{757.1408, 802.5101, 835.8893, 1752.2227, 2131.7996};
    for (std::size_t k = 0; k < std::size(hertz); ++k)
        EXPECT_NEAR(still.modes[k].frequency, hertz[k], 1e-4);
}

TEST(BlockOnItsFoot, BeginsToFlutterWhereTheOtherImplementationSays) {
    constexpr double onset = 0.03900902;
    EXPECT_EQ(block_at(onset * (1.0 - 1e-6)).kind, StabilityKind::stable);
    const SlidingStability beyond = block_at(onset * (1.0 + 1e-6));
    EXPECT_EQ(beyond.kind, StabilityKind::flutter);
    EXPECT_NEAR(beyond.frequency, 3683.5068, 1e-3);
}

TEST(BlockOnItsFoot, GrowsAsTheOtherImplementationSaysBothWays) {
    EXPECT_NEAR(block_at(0.4).growth, 908.5, 0.1);
    EXPECT_NEAR(block_at(0.4, parameters::Direction::coming).growth, 908.5, 0.1);
}

}  // namespace
}  // namespace stridor
