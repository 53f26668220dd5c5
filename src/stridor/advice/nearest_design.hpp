#pragma once

#include "stridor/advice/design_runner.hpp"
#include "stridor/advice/design_space.hpp"
#include "stridor/advice/margins.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

/// The nearest design with a certain verdict, several parameters changed at once.
///
/// The search does not promise the very nearest design, but finds the same one on every machine and with every number
/// of threads:
///  1. rays from the present design go in given directions, and towards those points of a Sobol sequence around it that
///     have the verdict; they are followed at `ray_points` equal steps, and the first place with the verdict is
///     bisected;
///  2. the nearest few are polished: directions that differ in one parameter are tried at a radius smaller by 3 %,
///     those with the verdict there are bisected, and the best is taken; if there is none, smaller differences are
///     tried.
/// If the boundary is flat, with intercepts dᵢ on the axes, its nearest point lies in the direction 1/dᵢ.
namespace stridor::advice {

/// Steps of a ray up to the edge of the box.
inline constexpr int ray_points = 24;

/// Distance to which the nearest design is located [1].
inline constexpr double ray_resolution = 1e-3;

/// A direction in the space of shares; its length means nothing; shape [parameter].
using Heading = std::vector<double>;

/// A design that was found: its place, its distance and its verdict.
struct NearestDesign {
    Shares shares{};
    double distance = 0.0;  // [1]
    DesignVerdict verdict{};
};

/// Returns the direction to the nearest point of a flat boundary with these signed distances along the axes, 0 for an
/// axis that it does not meet, of the chosen parameters only; shape [parameter].
Heading flat_heading(const std::vector<double>& intercepts, std::span<const std::size_t> chosen);

/// Whether single points count whose neighbours do not have the verdict.
enum class Specks { ignored, counted };

/// The verdict that is searched.
struct DesignTarget {
    DesignCondition condition{};
    Specks specks = Specks::ignored;
};

/// Returns the nearest designs along rays, one per heading, shape [heading]; `std::nullopt` if a ray meets none.
std::vector<std::optional<NearestDesign>> along_rays(const DesignSpace& space, std::span<const Heading> headings,
                                                     const DesignTarget& target, DesignRunner& runner);

/// Returns the designs that count: all, or, without specks, those that still have the verdict a little further on.
std::vector<std::optional<NearestDesign>> counted(const DesignSpace& space, std::vector<NearestDesign> designs,
                                                  const DesignTarget& target, DesignRunner& runner);

/// Returns headings towards the nearest few designs with the verdict, among many around the present one.
std::vector<Heading> explored_headings(const DesignSpace& space, const DesignTarget& target, DesignRunner& runner);

/// Returns a nearer design than the given one, with only the chosen parameters changed; at worst that one.
NearestDesign polished(const DesignSpace& space, NearestDesign start, std::span<const std::size_t> chosen,
                       const DesignTarget& target, DesignRunner& runner);

/// Returns the unit vector from the present design to another one.
Heading heading_to(const DesignSpace& space, const Shares& shares);

/// Returns the point at a distance along a unit heading, held within the box.
Shares point_along(const DesignSpace& space, const Heading& heading, double distance);

}  // namespace stridor::advice
