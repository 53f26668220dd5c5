#pragma once

#include "stridor/reduction/part.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::reduction {

/// Figures of a part that need no solution. Its units are those of the part.
struct PartSize {
    Eigen::Index rows = 0;
    Eigen::Index entries = 0;                 // [1] of the stiffness, both triangles
    std::array<double, 3> mass{};             // [kg] r'Mr of a translation along x, y, z, over the existing rows
    std::optional<Eigen::Vector3d> extent{};  // [m] of the box around its nodes, if positions are known
    // [m/s] of a wave in its material, within a factor of three: nodes' stiffness over their mass, and the mesh's size
    std::optional<double> wave_speed{};
};

PartSize part_size(const ElasticPart& part);

/// Returns the mass per volume of the box around a part [kg/m^3] if its numbers have these units. Returns
/// `std::nullopt` if no material has that density (1 to 25000, in a box of 0.1 mm to 100 m), or if places are not
/// known.
std::optional<double> density_in(const PartSize& size, const UnitSystem& units);

/// Returns the first of the systems in which the density and the speed of a wave are those of a material (8 m/s in
/// gels, 100 in heavy parts, to 20 km/s in diamond), or null if there is none.
const UnitSystem* guessed_units(const PartSize& size);

/// Returns the reason to doubt that the part's numbers have these units, in words: the units to try, or that its
/// modulus of elasticity is in Pa or its density in kg/m^3 in a model of other units. Empty if there is none.
std::string units_doubt(const PartSize& size, const UnitSystem& units);

/// The free vibration of a part with its supports.
struct PartVibration {
    Eigen::Index rigid_body_modes = 0;  // [1] by the count of eigenvalues
    std::vector<double> frequencies{};  // [Hz] the lowest, rigid-body modes left out, rising
    double highest_frequency = 0.0;     // [Hz] infinite if a motion has no mass
};

/// Returns the lowest `count` frequencies. Rigid-body modes are those below a millionth of the highest frequency, or at
/// most six that lie a thousand times below the next one: files hold ten to sixteen digits, so that none is zero.
PartVibration part_vibration(const ElasticPart& part, Eigen::Index count, LinearSolver by = LinearSolver::eigen);

}  // namespace stridor::reduction
