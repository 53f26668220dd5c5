#pragma once

#include "stridor/reduction/part.hpp"

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace stridor::support {

/// How a lattice is held.
enum class LatticeSupport { free, top_held };

/// A block of nx by ny by nz nodes, 10 mm apart, each linked to its neighbours, those across faces and corners too, by
/// bars of one stiffness per length with consistent mass: a solid in all but name, with six rigid-body modes where it
/// is free. Nodes are numbered from 100, x first; those of the lowest layer are the set FOOT.
inline reduction::ElasticPart lattice_part(std::array<int, 3> size, LatticeSupport support) {
    constexpr double pitch = 0.01;     // [m]
    constexpr double stiffness = 2e4;  // [N] of a bar times its length
    constexpr double mass = 0.04;      // [kg/m] of a bar
    const auto [nx, ny, nz] = size;
    const int layers = support == LatticeSupport::free ? nz : nz - 1;
    const auto node = [nx = nx, ny = ny](int x, int y, int z) { return x + nx * (y + ny * z); };
    const int nodes = nx * ny * layers;
    std::vector<Eigen::Triplet<double>> k;
    std::vector<Eigen::Triplet<double>> m;
    const auto link = [&](const Eigen::Vector3i& from, const Eigen::Vector3i& to) {
        const Eigen::Vector3d along = pitch * (to - from).cast<double>();
        const double length = along.norm();
        const Eigen::Matrix3d axial = stiffness / length * along * along.transpose() / (length * length);
        const std::array<int, 2> ends{node(from[0], from[1], from[2]), node(to[0], to[1], to[2])};
        for (int a = 0; a < 2; ++a)
            for (int b = 0; b < 2; ++b) {
                const int row = ends.at(static_cast<std::size_t>(a));
                const int column = ends.at(static_cast<std::size_t>(b));
                if (row >= nodes || column >= nodes) continue;  // in the layer that is held
                for (int i = 0; i < 3; ++i) {
                    m.emplace_back(3 * row + i, 3 * column + i, mass * length * (a == b ? 2.0 : 1.0) / 6.0);
                    for (int j = 0; j < 3; ++j)
                        k.emplace_back(3 * row + i, 3 * column + j, (a == b ? 1.0 : -1.0) * axial(i, j));
                }
            }
    };
    for (int z = 0; z < nz; ++z)
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x)
                for (int step = 14; step < 27; ++step) {  // half of the 26 neighbours: each link once
                    const Eigen::Vector3i to(x + step % 3 - 1, y + step / 3 % 3 - 1, z + step / 9 - 1);
                    if (to[0] < 0 || to[0] >= nx || to[1] < 0 || to[1] >= ny || to[2] >= nz) continue;
                    link({x, y, z}, to);
                }
    reduction::ElasticPart part;
    part.stiffness.resize(3 * nodes, 3 * nodes);
    part.stiffness.setFromTriplets(k.begin(), k.end());
    part.mass.resize(3 * nodes, 3 * nodes);
    part.mass.setFromTriplets(m.begin(), m.end());
    reduction::NodeSet foot{"FOOT", {}};
    for (int z = 0; z < layers; ++z)
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) {
                const std::string name = std::to_string(100 + node(x, y, z));
                part.positions[name] = pitch * Eigen::Vector3d(x, y, z);
                for (int component = 1; component <= 3; ++component)
                    part.labels.push_back({name, component});
                if (z == 0) foot.nodes.push_back(name);
            }
    part.sets.push_back(foot);
    return part;
}

/// n equal masses in a row with springs between, the first held by a wall; rows "1.1" to "n.1".
/// Its frequencies are 2 sqrt(k/m) sin((2 j - 1) pi / (2 (2 n + 1))).
inline reduction::ElasticPart chain_part(int masses, double spring, double mass) {
    std::vector<Eigen::Triplet<double>> k;
    std::vector<Eigen::Triplet<double>> m;
    reduction::ElasticPart part;
    for (int row = 0; row < masses; ++row) {
        k.emplace_back(row, row, row + 1 < masses ? 2.0 * spring : spring);
        if (row > 0) k.emplace_back(row, row - 1, -spring);
        if (row > 0) k.emplace_back(row - 1, row, -spring);
        m.emplace_back(row, row, mass);
        part.labels.push_back({std::to_string(row + 1), 1});
    }
    part.stiffness.resize(masses, masses);
    part.stiffness.setFromTriplets(k.begin(), k.end());
    part.mass.resize(masses, masses);
    part.mass.setFromTriplets(m.begin(), m.end());
    return part;
}

}  // namespace stridor::support
