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
    // [m/s] of a wave in its material, within a factor of three: nodes' stiffness over their mass, and the mesh's size
    std::optional<double> wave_speed{};
};

PartSize part_size(const ElasticPart& part);

/// Mass per volume of the box around a part [kg/m^3], were its numbers of these units; nothing where that is no
/// material's (1 to 25000, a box of 0.1 mm to 100 m), or where places are not known.
std::optional<double> density_in(const PartSize& size, const UnitSystem& units);

/// The first of the systems in which it is a material's, and a wave runs through it as through one (8 m/s in gels, 100
/// in what is heavy, to 20 km/s in diamond); null: none.
const UnitSystem* guessed_units(const PartSize& size);

/// What makes it doubtful that the part's numbers are of these units, in words: the units to try, or that its modulus
/// of elasticity is in Pa or its density in kg/m^3 in a model of other units. Empty: nothing.
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
