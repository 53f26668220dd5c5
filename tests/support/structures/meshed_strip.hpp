#pragma once

#include "stridor/integration/run/initial_state.hpp"
#include "stridor/model/linear/modal_damping.hpp"
#include "stridor/model/structure.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <cmath>
#include <vector>

namespace stridor::support {

/// A strip of rubber on a moving surface, and how its motion begins.
struct RubberStrip {
    model::Structure structure;
    integration::InitialState start;
    double velocity = 0.0;  // [m/s] of the surface
};

/// How the mass of an element is shared by its corners.
enum class MeshMass { lumped, consistent };

namespace strip_mesh {

constexpr int layers = 4;
constexpr double length = 0.04, height = 0.01;  // [m], 1 m deep
constexpr double young = 5e6, poisson = 0.4;    // [Pa], [1]
constexpr double density = 1100.0;              // [kg/m^3]
constexpr double pressed = 1e-4;                // [m] the clamped top, downwards

/// Stiffness and mass of a rectangle with four corners, two by two points, plane strain; corners counter-clockwise.
struct Element {
    Eigen::Matrix<double, 8, 8> stiffness = Eigen::Matrix<double, 8, 8>::Zero();
    Eigen::Matrix<double, 8, 8> mass = Eigen::Matrix<double, 8, 8>::Zero();
};

inline Element element(double width, double depth, MeshMass kind) {
    const double scale = young / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
    Eigen::Matrix3d law;
    law << 1.0 - poisson, poisson, 0.0, poisson, 1.0 - poisson, 0.0, 0.0, 0.0, 0.5 - poisson;
    constexpr double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const double point = 1.0 / std::sqrt(3.0);
    const double area = width * depth / 4.0;  // of one point
    Element result;
    for (const double x : {-point, point})
        for (const double y : {-point, point}) {
            Eigen::Matrix<double, 3, 8> strain = Eigen::Matrix<double, 3, 8>::Zero();
            Eigen::Matrix<double, 2, 8> shape = Eigen::Matrix<double, 2, 8>::Zero();
            for (int k = 0; k < 4; ++k) {
                const double along = 1.0 + corner[k][0] * x, across = 1.0 + corner[k][1] * y;
                const double dx = 0.5 * corner[k][0] * across / width, dy = 0.5 * corner[k][1] * along / depth;
                strain(0, 2 * k) = strain(2, 2 * k + 1) = dx;
                strain(1, 2 * k + 1) = strain(2, 2 * k) = dy;
                shape(0, 2 * k) = shape(1, 2 * k + 1) = 0.25 * along * across;
            }
            result.stiffness += scale * area * strain.transpose() * law * strain;
            result.mass += density * area * shape.transpose() * shape;
        }
    if (kind == MeshMass::lumped)
        result.mass = Eigen::Matrix<double, 8, 8>::Identity() * (density * width * depth / 4.0);
    return result;
}

}  // namespace strip_mesh

/// A strip of 40 by 10 mm in `columns` by 4 elements, its top clamped and pressed down by 0.1 mm, its bottom on a
/// surface that moves: mu_s = 0.8, mu_d = 0.5, V = 0.1 m/s, 1 % of critical damping in each mode. It starts at the rest
/// without friction, pushed a little along.
inline RubberStrip meshed_strip(int columns, MeshMass kind) {
    using namespace strip_mesh;
    const int across = columns + 1;
    const int all = 2 * across * (layers + 1);
    const int rows = 2 * across * layers;  // the top is held
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(all, all), mass = stiffness;
    const Element each = element(length / columns, height / layers, kind);
    for (int j = 0; j < layers; ++j)
        for (int i = 0; i < columns; ++i) {
            const int node[4] = {i + j * across, i + 1 + j * across, i + 1 + (j + 1) * across, i + (j + 1) * across};
            for (int a = 0; a < 8; ++a)
                for (int b = 0; b < 8; ++b) {
                    const int row = 2 * node[a / 2] + a % 2, column = 2 * node[b / 2] + b % 2;
                    stiffness(row, column) += each.stiffness(a, b);
                    mass(row, column) += each.mass(a, b);
                }
        }
    RubberStrip strip{
        model::structure_of_size(rows, across), {Eigen::VectorXd::Zero(rows), Eigen::VectorXd::Zero(rows)}, 0.1};
    strip.structure.stiffness = stiffness.topLeftCorner(rows, rows);
    strip.structure.mass = mass.topLeftCorner(rows, rows);
    strip.structure.damping = model::modal_damping(strip.structure.mass, strip.structure.stiffness, 0.01);
    // the forces of the bottom at rest, without friction: it may move along and not across
    Eigen::VectorXd top = Eigen::VectorXd::Zero(all - rows);
    for (int i = 0; i < across; ++i)
        top(2 * i + 1) = -pressed;
    const Eigen::VectorXd push = -stiffness.topRightCorner(rows, all - rows) * top;
    std::vector<int> moves;
    for (int row = 0; row < rows; ++row)
        if (row >= 2 * across || row % 2 == 0) moves.push_back(row);
    const Eigen::MatrixXd free = strip.structure.stiffness(moves, moves);
    Eigen::VectorXd rest = Eigen::VectorXd::Zero(rows);
    const Eigen::VectorXd moved = free.ldlt().solve(Eigen::VectorXd(push(moves)));
    rest(moves) = moved;
    const Eigen::VectorXd force = strip.structure.stiffness * rest - push;
    for (int i = 0; i < across; ++i) {
        model::ContactPoint& contact = strip.structure.contacts[static_cast<std::size_t>(i)];
        contact.tangent(2 * i) = contact.normal(2 * i + 1) = 1.0;
        contact.friction = model::Coulomb{0.8, 0.5};
        strip.structure.load(2 * i + 1) = -force(2 * i + 1);
        strip.start.velocity(2 * i) = i % 2 == 0 ? 4e-4 : -3e-4;
    }
    return strip;
}

/// Craig and Bampton's coordinates: the rows of the contacts, which come first, and so many modes with these held.
inline model::Structure craig_bampton_of(const model::Structure& structure, int modes) {
    const auto held = static_cast<Eigen::Index>(2 * structure.contacts.size());
    const Eigen::Index inner = structure.mass.rows() - held;
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
        structure.stiffness.bottomRightCorner(inner, inner), structure.mass.bottomRightCorner(inner, inner));
    Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(held + inner, held + modes);
    basis.topLeftCorner(held, held).setIdentity();
    basis.bottomLeftCorner(inner, held) = -structure.stiffness.bottomRightCorner(inner, inner)
                                               .ldlt()
                                               .solve(structure.stiffness.bottomLeftCorner(inner, held));
    basis.bottomRightCorner(inner, modes) = solver.eigenvectors().leftCols(modes);
    model::Structure reduced = structure;
    for (Eigen::MatrixXd* matrix : {&reduced.mass, &reduced.damping, &reduced.stiffness})
        *matrix = (basis.transpose() * *matrix * basis).eval();
    reduced.load = basis.transpose() * structure.load;
    for (model::ContactPoint& contact : reduced.contacts) {
        contact.normal = (basis.transpose() * contact.normal).eval();
        contact.tangent = (basis.transpose() * contact.tangent).eval();
    }
    return reduced;
}

}  // namespace stridor::support
