#pragma once

#include "stridor/reduction/part.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::reduction {

/// What a part says of itself before anything is solved. Its units are those of the part.
struct PartSize {
    Eigen::Index rows = 0;
    Eigen::Index entries = 0;                 // [1] of the stiffness, both triangles
    std::array<double, 3> mass{};             // [kg] r'Mr of a translation along x, y, z, over the rows that are there
    std::optional<Eigen::Vector3d> extent{};  // [m] of the box around its nodes, where positions are known
};

PartSize part_size(const ElasticPart& part);

/// Mass per volume of the box around a part [kg/m^3], were its numbers of these units; nothing where that is no
/// material's (1 to 25000, a box of 0.1 mm to 100 m), or where places are not known.
std::optional<double> density_in(const PartSize& size, const UnitSystem& units);

/// The first of the systems in which it is a material's; null: none.
const UnitSystem* guessed_units(const PartSize& size);

/// What makes it doubtful that the part's numbers are of these units, in words, with the units to try; empty: nothing.
std::string units_doubt(const PartSize& size, const UnitSystem& units);

/// How a part vibrates as it is held.
struct PartVibration {
    Eigen::Index rigid_body_modes = 0;  // [1] by the count of eigenvalues
    std::vector<double> frequencies{};  // [Hz] the lowest, rigid-body modes left out, rising
    double highest_frequency = 0.0;     // [Hz] infinite where a motion has no mass
};

/// The lowest frequencies, so many; rigid-body modes are those below a millionth of the highest frequency, or at most
/// six that lie a thousand times below the next one: files hold ten to sixteen digits, so that none is zero.
PartVibration part_vibration(const ElasticPart& part, Eigen::Index count, LinearSolver by = LinearSolver::eigen);

}  // namespace stridor::reduction
