#pragma once

#include "stridor/integration/initial_state.hpp"
#include "stridor/model/structure.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <utility>

namespace stridor::support {

/// A strip of rubber that is pressed on a moving surface, from a file of a prototype: lumped mass, Q4 elements.
struct Strip {
    model::Structure structure;
    integration::InitialState start;
    double velocity = 0.0;  // [m/s] of the surface
};

inline Strip read_strip(const std::string& path) {
    std::ifstream file(path);
    std::string name;
    int n = 0, p = 0;
    file >> name >> n >> p;
    model::Structure structure = model::structure_of_size(n, p);
    const auto read = [&](auto&& matrix) {
        for (Eigen::Index i = 0; i < matrix.rows(); ++i)
            for (Eigen::Index j = 0; j < matrix.cols(); ++j)
                file >> matrix(i, j);
    };
    Eigen::MatrixXd normals(n, p), tangents(n, p), laws(5, p);
    double omega = 0.0;
    read(structure.mass);
    read(structure.damping);
    read(structure.stiffness);
    read(structure.load);
    read(normals);
    read(tangents);
    read(laws);
    file >> omega;
    integration::InitialState start{Eigen::VectorXd(n), Eigen::VectorXd(n)};
    read(start.displacement);
    read(start.velocity);
    EXPECT_TRUE(static_cast<bool>(file)) << path;
    for (int k = 0; k < p; ++k) {
        model::ContactPoint& contact = structure.contacts[static_cast<std::size_t>(k)];
        contact.normal = normals.col(k);
        contact.tangent = tangents.col(k);
        contact.initial_gap = laws(0, k);
        contact.friction = model::Coulomb{laws(1, k), laws(2, k)};
    }
    return {std::move(structure), std::move(start), laws(3, 0)};
}

}  // namespace stridor::support
