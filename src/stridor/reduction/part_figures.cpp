#include "stridor/reduction/part_figures.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/reduction/lowest_modes.hpp"
#include "stridor/reduction/sparse_factor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <span>
#include <vector>

namespace stridor::reduction {

namespace {

constexpr Eigen::Index most_rigid = 6;
constexpr double share_of_highest = 1e-6;  // [1] of frequency
constexpr double share_of_next = 1e-3;     // [1] of frequency

// a material in a box that it fills by a hundredth or more: from foam at 1 % to steel and lead
constexpr double lightest = 1.0;    // [kg/m^3]
constexpr double heaviest = 2.5e4;  // [kg/m^3]

// a wave in a material: from gels to diamond; what weighs more than rubber is a metal, a glass or a ceramic
constexpr double slowest = 8.0;          // [m/s]
constexpr double slowest_heavy = 100.0;  // [m/s]
constexpr double heavy = 2000.0;         // [kg/m^3]
constexpr double fastest = 2e4;          // [m/s]

constexpr double shortest_part = 1e-4;  // [m]
constexpr double longest_part = 100.0;  // [m]

Eigen::VectorXd translation(const ElasticPart& part, int component) {
    Eigen::VectorXd motion = Eigen::VectorXd::Zero(rows_of(part));
    for (Eigen::Index row = 0; row < motion.size(); ++row)
        if (part.labels[static_cast<std::size_t>(row)].component == component) motion[row] = 1.0;
    return motion;
}

std::optional<Eigen::Vector3d> extent_of(const ElasticPart& part) {
    constexpr double far = std::numeric_limits<double>::infinity();
    Eigen::Vector3d low = Eigen::Vector3d::Constant(far);
    Eigen::Vector3d high = Eigen::Vector3d::Constant(-far);
    for (const RowLabel& label : part.labels) {
        const auto found = part.positions.find(label.node);
        if (found == part.positions.end()) continue;
        low = low.cwiseMin(found->second);
        high = high.cwiseMax(found->second);
    }
    if (!(low.array() <= high.array()).all()) return std::nullopt;
    return high - low;
}

// a sheet or a wire fills a box as thick as a hundredth of its length
double volume_of(const Eigen::Vector3d& extent) {
    return extent.cwiseMax(0.01 * extent.maxCoeff()).prod();
}

// Along a bar of elements h long a node has 2EA/h and rho A h, in a solid somewhat more of the one and less of the
// other: h sqrt(K_ii / M_ii) is 1.4 to 2.5 sqrt(E / rho). Bending is softer, so the upper quartile counts.
std::optional<double> wave_speed_of(const ElasticPart& part) {
    constexpr double of_mesh = 2.0;  // [1]
    std::vector<double> speeds;
    for (Eigen::Index row = 0; row < rows_of(part); ++row) {
        const RowLabel& label = part.labels[static_cast<std::size_t>(row)];
        const auto here = part.positions.find(label.node);
        const double stiffness = part.stiffness.coeff(row, row);
        const double mass = part.mass.coeff(row, row);
        if (label.component < 1 || label.component > 3 || here == part.positions.end()) continue;
        if (!(stiffness > 0.0 && mass > 0.0)) continue;
        double nearest = std::numeric_limits<double>::infinity();
        for (SparseMatrix::InnerIterator entry(part.stiffness, row); entry; ++entry) {
            const RowLabel& other = part.labels[static_cast<std::size_t>(entry.row())];
            const auto there = part.positions.find(other.node);
            if (entry.value() == 0.0 || other.node == label.node || there == part.positions.end()) continue;
            const double distance = (there->second - here->second).norm();
            if (distance > 0.0) nearest = std::min(nearest, distance);
        }
        const double speed = nearest * std::sqrt(stiffness / mass) / of_mesh;
        if (std::isfinite(speed)) speeds.push_back(speed);
    }
    if (speeds.empty()) return std::nullopt;
    const auto quartile = speeds.begin() + static_cast<std::ptrdiff_t>(3 * speeds.size() / 4);
    std::nth_element(speeds.begin(), quartile, speeds.end());
    return *quartile;
}

// what was written in SI into a model of other units
struct UnitSlip {
    bool density = false;
    bool modulus = false;
};
constexpr std::array slips{UnitSlip{}, UnitSlip{true, false}, UnitSlip{false, true}, UnitSlip{true, true}};

struct MaterialFigures {
    double density = 0.0;                // [kg/m^3]
    std::optional<double> wave_speed{};  // [m/s]
};

double unit_of_density(const UnitSystem& units) {
    return units.mass / std::pow(units.length, 3);
}

double unit_of_modulus(const UnitSystem& units) {
    return units.mass / (units.length * units.time * units.time);
}

// were its numbers of these units but for a slip; nothing where places are not known
std::optional<MaterialFigures> figures_in(const PartSize& size, const UnitSystem& units, UnitSlip slip) {
    const double mass = *std::max_element(size.mass.begin(), size.mass.end());
    if (!size.extent || !(mass > 0.0) || !(size.extent->maxCoeff() > 0.0)) return std::nullopt;
    const double too_dense = slip.density ? unit_of_density(units) : 1.0;
    const double too_stiff = slip.modulus ? unit_of_modulus(units) : 1.0;
    MaterialFigures figures{mass / volume_of(*size.extent) * unit_of_density(units) / too_dense, {}};
    if (size.wave_speed)
        figures.wave_speed = *size.wave_speed * units.length / units.time * std::sqrt(too_dense / too_stiff);
    return figures;
}

bool has_dense_material(const PartSize& size, const MaterialFigures& figures, const UnitSystem& units) {
    const double longest = size.extent->maxCoeff() * units.length;
    return figures.density >= lightest && figures.density <= heaviest && longest >= shortest_part &&
           longest <= longest_part;
}

bool is_material(const PartSize& size, const UnitSystem& units, UnitSlip slip = {}) {
    const std::optional<MaterialFigures> figures = figures_in(size, units, slip);
    if (!figures || !has_dense_material(size, *figures, units)) return false;
    const double least = figures->density > heavy ? slowest_heavy : slowest;
    return !figures->wave_speed || (*figures->wave_speed >= least && *figures->wave_speed <= fastest);
}

std::string slip_text(const UnitSystem& units, UnitSlip slip) {
    std::string text = fmt::format("in {} its numbers would be a material's, were ", units.name);
    if (slip.density) text += fmt::format("its mass {:.3g} of what it is", 1.0 / unit_of_density(units));
    if (slip.density && slip.modulus) text += " and ";
    if (slip.modulus) text += fmt::format("its stiffness {:.3g} of what it is", 1.0 / unit_of_modulus(units));
    text += ". Is ";
    if (slip.density) text += "the density in kg/m^3";
    if (slip.density && slip.modulus) text += ", and ";
    if (slip.modulus) text += "the modulus of elasticity in Pa";
    return text + "?";
}

}  // namespace

PartSize part_size(const ElasticPart& part) {
    PartSize size;
    size.rows = rows_of(part);
    size.entries = part.stiffness.nonZeros();
    for (int direction = 0; direction < 3; ++direction) {
        const Eigen::VectorXd motion = translation(part, direction + 1);
        size.mass.at(static_cast<std::size_t>(direction)) = motion.dot(part.mass * motion);
    }
    size.extent = extent_of(part);
    size.wave_speed = wave_speed_of(part);
    return size;
}

std::optional<double> density_in(const PartSize& size, const UnitSystem& units) {
    const std::optional<MaterialFigures> figures = figures_in(size, units, {});
    return figures && has_dense_material(size, *figures, units) ? std::optional(figures->density) : std::nullopt;
}

const UnitSystem* guessed_units(const PartSize& size) {
    for (const UnitSystem& units : unit_systems())
        if (is_material(size, units)) return &units;
    return nullptr;
}

std::string units_doubt(const PartSize& size, const UnitSystem& units) {
    const std::optional<MaterialFigures> figures = figures_in(size, units, {});
    if (!figures || is_material(size, units)) return "";
    const bool is_dense = has_dense_material(size, *figures, units);
    std::string doubt = is_dense
                            ? fmt::format("in {} a wave would run through it at {:.2g} m/s, as through no material",
                                          units.name, figures->wave_speed.value_or(0.0))
                            : fmt::format("in {} its mass per volume is no material's", units.name);
    if (const UnitSystem* guess = guessed_units(size))
        return doubt +
               (is_dense
                    ? fmt::format("; in {} as through one", guess->name)
                    : fmt::format("; in {} it is {:.3g} kg/m^3", guess->name, density_in(size, *guess).value_or(0.0))) +
               fmt::format(". Say --units {}?", guess->name);
    for (const UnitSlip slip : slips) {
        if (is_material(size, units, slip)) return doubt + "; " + slip_text(units, slip);
        for (const UnitSystem& other : unit_systems())
            if (is_material(size, other, slip)) return doubt + "; " + slip_text(other, slip);
    }
    return is_dense ? doubt : "in no system of units is its mass per volume a material's";
}

PartVibration part_vibration(const ElasticPart& part, Eigen::Index count, LinearSolver by) {
    PartVibration vibration;
    expect_stiff(part);
    const double highest = highest_squared(part.stiffness, part.mass, by);
    vibration.highest_frequency = std::isfinite(highest) ? frequency_of(highest) : highest;
    const Modes modes = lowest_modes(part.stiffness, part.mass, count + most_rigid, by);
    const auto found = modes.squared.size();
    const double small = std::isfinite(highest) ? highest * share_of_highest * share_of_highest : 0.0;
    Eigen::Index rigid = (modes.squared.array() <= small).count();
    for (Eigen::Index k = std::min(most_rigid, found - 1); k > rigid; --k)
        if (std::abs(modes.squared[k - 1]) < share_of_next * share_of_next * modes.squared[k]) rigid = k;
    if (rigid > 0 && rigid < found) {
        // between the last rigid-body mode and the first other one
        const double between =
            std::sqrt(std::max(std::abs(modes.squared[rigid - 1]), 1e-6 * modes.squared[rigid]) * modes.squared[rigid]);
        const SparseFactor factor(part.stiffness, part.mass, between, by, FactorUse::counting);
        if (factor.is_whole()) rigid = factor.negative_pivots();
    }
    vibration.rigid_body_modes = rigid;
    for (Eigen::Index k = rigid; k < found && k < rigid + count; ++k)
        vibration.frequencies.push_back(frequency_of(modes.squared[k]));
    return vibration;
}

}  // namespace stridor::reduction
