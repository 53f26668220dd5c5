#pragma once

#include "support/structures/meshed_strip.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace stridor::support {

/// From tests/fixtures/structures, whose README.md says what stands in the file.
inline RubberStrip read_strip(const std::string& path) {
    std::ifstream file(path);
    std::string name;
    int n = 0, p = 0;
    file >> name >> n >> p;
    RubberStrip strip{model::structure_of_size(n, p), {Eigen::VectorXd(n), Eigen::VectorXd(n)}};
    const auto read = [&](auto&& matrix) {
        for (Eigen::Index i = 0; i < matrix.rows(); ++i)
            for (Eigen::Index j = 0; j < matrix.cols(); ++j)
                file >> matrix(i, j);
    };
    Eigen::MatrixXd normals(n, p), tangents(n, p), laws(5, p);
    double omega = 0.0;
    read(strip.structure.mass);
    read(strip.structure.damping);
    read(strip.structure.stiffness);
    read(strip.structure.load);
    read(normals);
    read(tangents);
    read(laws);
    file >> omega;
    read(strip.start.displacement);
    read(strip.start.velocity);
    EXPECT_TRUE(static_cast<bool>(file)) << path;
    for (int k = 0; k < p; ++k) {
        model::ContactPoint& contact = strip.structure.contacts[static_cast<std::size_t>(k)];
        contact.normal = normals.col(k);
        contact.tangent = tangents.col(k);
        contact.initial_gap = laws(0, k);
        contact.friction = model::Coulomb{laws(1, k), laws(2, k)};
    }
    strip.velocity = laws(3, 0);
    return strip;
}

}  // namespace stridor::support
