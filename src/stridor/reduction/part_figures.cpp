#include "stridor/reduction/part_figures.hpp"

#include "stridor/reduction/lowest_modes.hpp"
#include "stridor/reduction/sparse_factor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace stridor::reduction {

namespace {

constexpr Eigen::Index most_rigid = 6;
constexpr double share_of_highest = 1e-6;  // [1] of frequency
constexpr double share_of_next = 1e-3;     // [1] of frequency

// a material in a box that it fills by a hundredth or more: from foam at 1 % to steel and lead
constexpr double lightest = 1.0;    // [kg/m^3]
constexpr double heaviest = 2.5e4;  // [kg/m^3]

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
    return size;
}

std::optional<double> density_in(const PartSize& size, const UnitSystem& units) {
    const double mass = *std::max_element(size.mass.begin(), size.mass.end());
    if (!size.extent || !(mass > 0.0) || !(size.extent->maxCoeff() > 0.0)) return std::nullopt;
    const double density = mass * units.mass / (volume_of(*size.extent) * std::pow(units.length, 3));
    const double longest = size.extent->maxCoeff() * units.length;
    if (density < lightest || density > heaviest || longest < shortest_part || longest > longest_part)
        return std::nullopt;
    return density;
}

const UnitSystem* guessed_units(const PartSize& size) {
    for (const UnitSystem& units : unit_systems())
        if (density_in(size, units)) return &units;
    return nullptr;
}

std::string units_doubt(const PartSize& size, const UnitSystem& units) {
    if (!size.extent || density_in(size, units)) return "";
    const UnitSystem* guess = guessed_units(size);
    if (guess == nullptr) return "in no system of units is its mass per volume a material's";
    return fmt::format("in {} its mass per volume is no material's; in {} it is {:.3g} kg/m^3. Say --units {}?",
                       units.name, guess->name, density_in(size, *guess).value_or(0.0), guess->name);
}

PartVibration part_vibration(const ElasticPart& part, Eigen::Index count, LinearSolver by) {
    PartVibration vibration;
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
