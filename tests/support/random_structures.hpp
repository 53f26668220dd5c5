#pragma once

#include "stridor/parameters/case.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "support/counter_random.hpp"

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace stridor::support {

inline std::vector<double> numbers_of(const Eigen::MatrixXd& matrix) {
    return {matrix.data(), matrix.data() + matrix.size()};
}

/// A contact whose normal and tangent are one row each, of so many.
inline parameters::OwnContact contact_at(const std::string& name, std::size_t rows, std::size_t normal,
                                         std::size_t tangent, double preload_share) {
    parameters::OwnContact contact;
    contact.name = name;
    contact.normal.assign(rows, 0.0);
    contact.tangent = contact.normal;
    contact.normal[normal] = 1.0;
    contact.tangent[tangent] = 1.0;
    contact.preload_share = preload_share;
    return contact;
}

/// A structure of random masses and springs with one to four contacts, dragged at a constant velocity. Each contact has
/// a row along and a row across, every fourth one rubs between two rows; some rows touch nothing. Springs couple any
/// rows, so that normals and tangents answer each other: most of them lift off. Structure k is the same in every run.
inline parameters::Case random_structure(std::uint64_t number) {
    using Eigen::Index;
    CounterRandom random(number);
    const auto contacts = static_cast<Index>(1 + random.below(4));
    const Index rows = 2 * contacts + static_cast<Index>(random.below(4));
    Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(rows, rows), stiffness = Eigen::MatrixXd::Zero(rows, rows);
    for (Index row = 0; row < rows; ++row) {
        mass(row, row) = random.between(0.04, 0.2);
        stiffness(row, row) = random.between(5e5, 3e6);
    }
    for (Index a = 0; a < rows; ++a)
        for (Index b = 0; b < a; ++b) {
            const double coupling = random.one_in(2) ? random.between(-1.5e6, 1.5e6) : 0.0;
            stiffness(a, b) += coupling;
            stiffness(b, a) += coupling;
            // each row keeps more than it hands on: no motion has a negative stiffness
            stiffness(a, a) += 1.05 * std::abs(coupling);
            stiffness(b, b) += 1.05 * std::abs(coupling);
        }
    parameters::OwnStructure own;
    own.mass = numbers_of(mass);
    own.stiffness = numbers_of(stiffness);
    own.following.ratio = random.decades(3e-4, 0.02);
    for (Index row = 0; row < rows; ++row)
        own.row.push_back("u" + std::to_string(row + 1));
    for (Index k = 0; k < contacts; ++k) {
        const auto at = static_cast<std::size_t>(2 * k);
        parameters::OwnContact contact =
            contact_at("c" + std::to_string(k + 1), static_cast<std::size_t>(rows), at, at + 1, 1.0);
        if (2 * contacts < rows && random.one_in(4)) contact.normal[static_cast<std::size_t>(rows - 1)] = -1.0;
        own.contacts.push_back(std::move(contact));
    }
    parameters::Case c;
    c.own_structure = std::make_shared<const parameters::OwnStructure>(std::move(own));
    c.contact().preload = random.decades(1.0, 30.0);
    c.contact().static_friction = random.between(0.4, 1.2);
    c.contact().kinetic_friction = c.contact().static_friction * random.between(0.3, 1.0);
    c.drive.kind = parameters::DriveKind::constant;
    const double way = random.one_in(2) ? 1.0 : -1.0;
    c.drive.velocity = way * random.decades(0.03, 0.3);
    c.run.initial = random.one_in(2) ? parameters::Initial::rest : parameters::Initial::stuck;
    return c;
}

}  // namespace stridor::support
