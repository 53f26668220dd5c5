#pragma once

#include "stridor/model/structure.hpp"

#include <cmath>
#include <vector>

/// Blocks that slip in a plane, in two directions, for tests of the circular cone of friction.
namespace stridor::support {

/// A block on a plane: x, y along it, z across. Its mass [kg], the springs that hold it along x and y [N/m], the force
/// that presses it [N] and those that pull it along x and y [N].
struct BlockOnPlane {
    double mass = 2.0;
    double along_x = 0.0;
    double along_y = 0.0;
    double preload = 10.0;
    double pull_x = 0.0;
    double pull_y = 0.0;
};

/// One contact of directions x, y that are turned about z by an angle [rad]; the surface moves along x.
inline model::Structure block_on_plane(const BlockOnPlane& block, const model::Coulomb& friction, double turn = 0.0) {
    model::Structure structure = model::structure_of_size(3);
    structure.mass.diagonal().setConstant(block.mass);
    structure.stiffness.diagonal() << block.along_x, block.along_y, 0.0;
    structure.load << block.pull_x, block.pull_y, -block.preload;
    model::ContactPoint& contact = structure.contacts.front();
    const double c = std::cos(turn), s = std::sin(turn);
    contact.normal << 0.0, 0.0, 1.0;
    contact.tangent << c, s, 0.0;
    contact.second_tangent = Eigen::Vector3d(-s, c, 0.0);
    contact.drive_share = c;
    contact.second_drive_share = -s;
    contact.friction = friction;
    return structure;
}

/// Three blocks whose inertia and springs are coupled in all directions, each with a contact whose tangents are turned
/// by its own angle [rad].
inline model::Structure coupled_blocks(const std::vector<double>& turns) {
    constexpr Eigen::Index size = 9;
    model::Structure structure = model::structure_of_size(size, 3);
    for (Eigen::Index i = 0; i < size; ++i)
        for (Eigen::Index j = 0; j < size; ++j) {
            const double both = std::sin(1.0 + 0.7 * static_cast<double>((i + 1) * (j + 1)));
            structure.mass(i, j) = i == j ? 1.0 : 0.05 * both;
            structure.stiffness(i, j) = i == j ? 2e4 + 900.0 * static_cast<double>(i) : 1.5e3 * both;
        }
    structure.mass = (0.5 * (structure.mass + structure.mass.transpose())).eval();
    structure.stiffness = (0.5 * (structure.stiffness + structure.stiffness.transpose())).eval();
    structure.damping = 1e-4 * structure.stiffness;
    for (Eigen::Index k = 0; k < 3; ++k) {
        model::ContactPoint& contact = structure.contacts[static_cast<std::size_t>(k)];
        const double turn = turns[static_cast<std::size_t>(k)];
        const double c = std::cos(turn), s = std::sin(turn);
        contact.normal(3 * k + 2) = 1.0;
        contact.tangent(3 * k) = c;
        contact.tangent(3 * k + 1) = s;
        contact.second_tangent = Eigen::VectorXd::Zero(size);
        contact.second_tangent(3 * k) = -s;
        contact.second_tangent(3 * k + 1) = c;
        contact.drive_share = c;
        contact.second_drive_share = -s;
        contact.friction = model::Coulomb{0.5, 0.3};
        structure.load(3 * k + 2) = -20.0 - 5.0 * static_cast<double>(k);
    }
    return structure;
}

}  // namespace stridor::support
