#include "stridor/integration/series/taylor_block.hpp"

#include "stridor/integration/modal/modal_structure.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace stridor::integration {
namespace {

// Two stuck contacts hold all four motions that there are: nothing accelerates, whatever load they carry. What rounding
// leaves of the load would move them the same way in each block.
TEST(TaylorBlock, LeavesNothingOfALoadThatStuckContactsCarry) {
    model::Structure structure = model::structure_of_size(4, 2);
    structure.mass.diagonal() << 1.0, 1.1, 0.9, 1.3;
    structure.mass(0, 2) = structure.mass(2, 0) = 0.3;
    structure.mass(1, 3) = structure.mass(3, 1) = -0.2;
    structure.stiffness.diagonal() << 2.0, 3.0, 5.0, 7.0;
    structure.stiffness(0, 1) = structure.stiffness(1, 0) = 1.0;
    structure.load = Eigen::Vector4d(0.7, -3e6, 0.1, -1e6);
    structure.contacts[0].normal = Eigen::Vector4d(0.1, 1.0, 0.0, 0.0);
    structure.contacts[0].tangent = Eigen::Vector4d(1.0, 0.2, 0.0, 0.0);
    structure.contacts[1].normal = Eigen::Vector4d(0.0, 0.3, 0.0, 1.0);
    structure.contacts[1].tangent = Eigen::Vector4d(0.0, 0.0, 1.0, -0.1);
    const ModalStructure modal = modal_structure(structure);
    TaylorBlock block(modal, 2.0 / modal.fastest);
    ASSERT_TRUE(block.choose({ContactMode::stick, ContactMode::stick}));
    const std::vector<double> rest(modal.modes(), 0.0);
    block.expand(rest, rest, {}, SurfaceSeries{});
    std::array<double, 4> acceleration{};
    block.acceleration_at(0.0, acceleration);
    // forces of one rounding leave 1e-16 of the load; of that the second pass leaves as small a share
    const double least = 1e-28 * structure.load.norm();
    for (const double each : acceleration)
        EXPECT_LT(std::abs(each), least);
}

}  // namespace
}  // namespace stridor::integration
