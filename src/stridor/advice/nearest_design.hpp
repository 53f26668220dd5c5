#pragma once

#include "stridor/advice/design_runner.hpp"
#include "stridor/advice/design_space.hpp"
#include "stridor/advice/margins.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

/// The nearest design that behaves in a certain way, several parameters changed at once.
///
/// A search without promise of the very nearest, but the same on every machine and for every number of threads:
///  1. rays from the present design, in directions that are asked for and towards points of a Sobol sequence around it
///     that behave so, are followed at `ray_points` equal steps, and the first place where it behaves so is bisected;
///  2. the nearest few are polished: of the directions that differ from its own in one parameter, those that behave so
///     at a radius smaller by 3 % are bisected, and the best is taken; where there is none,
///     smaller differences are tried.
/// Where the boundary is flat, of intercepts dᵢ with the axes, its nearest point lies in the direction 1/dᵢ.
namespace stridor::advice {

/// Steps of a ray up to the edge of the box.
inline constexpr int ray_points = 24;

/// Distance to which the nearest design is located [1].
inline constexpr double ray_resolution = 1e-3;

/// A direction in the space of shares; its length means nothing; shape [parameter].
using Heading = std::vector<double>;

/// A design found: where, how far and how it behaves there.
struct NearestDesign {
    Shares shares{};
    double distance = 0.0;  // [1]
    DesignVerdict verdict{};
};

/// The direction to the nearest point of a flat boundary with these signed distances along the axes, 0 for an axis it
/// does not meet, of the chosen parameters only; shape [parameter].
Heading flat_heading(const std::vector<double>& intercepts, std::span<const std::size_t> chosen);

/// Do single points count that behave so while their neighbours do not?
enum class Specks { ignored, counted };

/// What is looked for.
struct DesignTarget {
    DesignCondition condition{};
    Specks specks = Specks::ignored;
};

/// The nearest designs along rays, one per heading, shape [heading]; nothing where a ray meets none.
std::vector<std::optional<NearestDesign>> along_rays(const DesignSpace& space, std::span<const Heading> headings,
                                                     const DesignTarget& target, DesignRunner& runner);

/// Those of some designs that count: all, or, without specks, those that behave so a little further on as well.
std::vector<std::optional<NearestDesign>> counted(const DesignSpace& space, std::vector<NearestDesign> designs,
                                                  const DesignTarget& target, DesignRunner& runner);

/// Headings towards the nearest few of many designs around the present one that behave so.
std::vector<Heading> explored_headings(const DesignSpace& space, const DesignTarget& target, DesignRunner& runner);

/// A nearer design than the one given, changing the chosen parameters only; at worst that one.
NearestDesign polished(const DesignSpace& space, NearestDesign start, std::span<const std::size_t> chosen,
                       const DesignTarget& target, DesignRunner& runner);

/// The unit vector from the present design to another one.
Heading heading_to(const DesignSpace& space, const Shares& shares);

/// The point at a distance along a unit heading, held within the box.
Shares point_along(const DesignSpace& space, const Heading& heading, double distance);

}  // namespace stridor::advice
