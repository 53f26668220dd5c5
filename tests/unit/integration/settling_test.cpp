#include "stridor/integration/series/settling.hpp"

#include "stridor/integration/modal/modal_structure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace stridor::integration {
namespace {

// A mass slips fast and nearly along the surface. Stuck it would be pulled, for its inertia couples both ways. Open it
// falls by less than the impact tells beside its slip, but the search for forces tells it. So it slips on.
TEST(Settling, ClosesAGapThatFallsByLessThanAnImpactTells) {
    model::Structure structure = model::structure_of_size(2, 1);
    structure.mass << 1.0, 2.0, 2.0, 8.0;
    structure.stiffness = 100.0 * Eigen::Matrix2d::Identity();
    structure.load = Eigen::Vector2d(0.0, -1.0);
    structure.contacts[0].normal = Eigen::Vector2d(0.0, 1.0);
    structure.contacts[0].tangent = Eigen::Vector2d(1.0, 0.0);
    structure.contacts[0].friction = model::Coulomb{0.3, 0.3};
    const ModalStructure modes = modal_structure(structure);
    Settling settling(modes, 2.0 / modes.fastest);
    const Eigen::VectorXd v = modal(modes, structure, Eigen::Vector2d(1.0, -1e-13));
    TaylorState state;
    state.q = {0.0, 0.0};
    state.v = {v(0), v(1)};
    state.set = {ContactMode::open};
    state.dropped.resize(1);
    ASSERT_EQ(settling.fire(state, SurfaceSeries{}, 0, 0), Settled::done);
    EXPECT_EQ(state.set[0], ContactMode::slip_forward);
    EXPECT_LT(std::abs(gap_velocity(modes.contacts[0], state.v)), 1e-15);
    EXPECT_NEAR(slip_velocity(modes.contacts[0], state.v, 0.0), 1.0, 1e-12);
}

}  // namespace
}  // namespace stridor::integration
