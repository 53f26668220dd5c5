#include "stridor/advice/nearest_design.hpp"

#include "stridor/advice/sobol.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace stridor::advice {

namespace {

// --- exploring: so many designs in a box of so many shares around the present one, and so many of those found are used
constexpr std::size_t explored_designs = 256;
constexpr std::array explored_boxes{0.15, 0.4};
constexpr std::size_t kept_headings = 4;

// --- polishing
constexpr double shrinking = 0.97;        // [1] of the distance that a better heading has to keep
constexpr double beyond_margin = 0.02;    // [1] it behaves so that much further on, too: no speck
constexpr double first_difference = 0.5;  // [1] in one parameter, of the distance
constexpr double last_difference = 0.06;  // likewise
constexpr int most_rounds = 40;

double length(const Heading& heading) {
    double square = 0.0;
    for (const double each : heading)
        square += each * each;
    return std::sqrt(square);
}

std::optional<Heading> unit(Heading heading) {
    const double size = length(heading);
    if (!(size > 0.0) || !std::isfinite(size)) return std::nullopt;
    for (double& each : heading)
        each /= size;
    return heading;
}

// how far a ray goes before it leaves the box
double exit_distance(const DesignSpace& space, const Heading& heading) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < heading.size(); ++k) {
        if (heading[k] > 0.0) nearest = std::min(nearest, (1.0 - space.origin[k]) / heading[k]);
        if (heading[k] < 0.0) nearest = std::min(nearest, -space.origin[k] / heading[k]);
    }
    return nearest;
}

std::optional<Bracket> first_meeting(const DesignSpace& space, std::span<const Shares> points,
                                     std::span<const DesignVerdict> verdicts, const DesignTarget& target) {
    for (std::size_t k = 0; k < points.size(); ++k) {
        // once alone is a speck, unless the ray ends there
        const bool goes_on =
            target.specks == Specks::counted || k + 1 == points.size() || target.condition(verdicts[k + 1]);
        if (target.condition(verdicts[k]) && goes_on)
            return Bracket{k > 0 ? points[k - 1] : space.origin, points[k], verdicts[k]};
    }
    return std::nullopt;
}

std::vector<NearestDesign> located(const DesignSpace& space, std::vector<Bracket> brackets, const DesignTarget& target,
                                   DesignRunner& runner) {
    const std::vector<DesignCondition> conditions(brackets.size(), target.condition);
    std::vector<NearestDesign> designs;
    for (Bracket& bracket : bisect(std::move(brackets), conditions, ray_resolution, runner)) {
        const double far = distance(space.origin, bracket.beyond);
        designs.push_back({std::move(bracket.beyond), far, std::move(bracket.verdict)});
    }
    return designs;
}

// headings that differ from one in a single parameter, each way and without it
std::vector<Heading> variations(const Heading& heading, std::span<const std::size_t> chosen, double difference) {
    std::vector<Heading> all;
    const auto add = [&](std::size_t parameter, double value) {
        Heading other = heading;
        other[parameter] = value;
        if (std::optional<Heading> normal = unit(std::move(other))) all.push_back(std::move(*normal));
    };
    for (const std::size_t k : chosen) {
        if (heading[k] != 0.0) add(k, 0.0);
        add(k, heading[k] + difference);
        add(k, heading[k] - difference);
    }
    return all;
}

// those of the headings that behave so somewhat nearer than `far`
std::vector<NearestDesign> nearer(const DesignSpace& space, std::vector<Heading> headings, double far,
                                  const DesignTarget& target, DesignRunner& runner) {
    std::erase_if(headings, [&](const Heading& heading) { return exit_distance(space, heading) < shrinking * far; });
    std::vector<Shares> points;
    for (const Heading& heading : headings)
        points.push_back(point_along(space, heading, shrinking * far));
    const std::vector<DesignVerdict> verdicts = runner.judge(points);
    std::vector<NearestDesign> found;
    for (std::size_t k = 0; k < points.size(); ++k)
        if (target.condition(verdicts[k])) found.push_back({points[k], shrinking * far, verdicts[k]});
    std::vector<Bracket> brackets;
    for (std::optional<NearestDesign>& design : counted(space, std::move(found), target, runner))
        if (design) brackets.push_back({space.origin, std::move(design->shares), std::move(design->verdict)});
    return located(space, std::move(brackets), target, runner);
}

}  // namespace

Heading flat_heading(const std::vector<double>& intercepts, std::span<const std::size_t> chosen) {
    Heading heading(intercepts.size(), 0.0);
    for (const std::size_t k : chosen)
        if (intercepts[k] != 0.0) heading[k] = 1.0 / intercepts[k];
    return heading;
}

Heading heading_to(const DesignSpace& space, const Shares& shares) {
    Heading heading(shares.size());
    for (std::size_t k = 0; k < shares.size(); ++k)
        heading[k] = shares[k] - space.origin[k];
    return unit(heading).value_or(Heading(shares.size(), 0.0));
}

Shares point_along(const DesignSpace& space, const Heading& heading, double distance) {
    Shares point = space.origin;
    for (std::size_t k = 0; k < point.size(); ++k)
        if (heading[k] != 0.0) point[k] = std::clamp(space.origin[k] + distance * heading[k], 0.0, 1.0);
    return point;
}

std::vector<std::optional<NearestDesign>> along_rays(const DesignSpace& space, std::span<const Heading> headings,
                                                     const DesignTarget& target, DesignRunner& runner) {
    std::vector<Shares> points;
    std::vector<std::size_t> followed;
    for (std::size_t k = 0; k < headings.size(); ++k) {
        const std::optional<Heading> heading = unit(headings[k]);
        if (!heading) continue;
        followed.push_back(k);
        const double exit = exit_distance(space, *heading);
        for (int step = 1; step <= ray_points; ++step)
            points.push_back(point_along(space, *heading, exit * step / ray_points));
    }
    const std::vector<DesignVerdict> verdicts = runner.judge(points);
    std::vector<Bracket> brackets;
    std::vector<std::size_t> met;
    for (std::size_t k = 0; k < followed.size(); ++k) {
        const auto of_ray = [&](const auto& all) { return std::span(all).subspan(k * ray_points, ray_points); };
        if (auto bracket = first_meeting(space, of_ray(points), of_ray(verdicts), target)) {
            brackets.push_back(std::move(*bracket));
            met.push_back(followed[k]);
        }
    }
    std::vector<std::optional<NearestDesign>> designs(headings.size());
    std::vector<NearestDesign> found = located(space, std::move(brackets), target, runner);
    for (std::size_t k = 0; k < met.size(); ++k)
        designs[met[k]] = std::move(found[k]);
    return designs;
}

std::vector<std::optional<NearestDesign>> counted(const DesignSpace& space, std::vector<NearestDesign> designs,
                                                  const DesignTarget& target, DesignRunner& runner) {
    std::vector<std::optional<NearestDesign>> kept(designs.size());
    std::vector<Shares> farther;
    if (target.specks == Specks::ignored)
        for (const NearestDesign& design : designs)
            farther.push_back(point_along(space, heading_to(space, design.shares), design.distance + beyond_margin));
    const std::vector<DesignVerdict> verdicts = runner.judge(farther);
    for (std::size_t k = 0; k < designs.size(); ++k)
        if (farther.empty() || target.condition(verdicts[k])) kept[k] = std::move(designs[k]);
    return kept;
}

std::vector<Heading> explored_headings(const DesignSpace& space, const DesignTarget& target, DesignRunner& runner) {
    const std::size_t dimensions = space.free.size();
    if (dimensions > most_sobol_dimensions) return {};
    std::vector<Shares> points;
    for (std::size_t box = 0; box < explored_boxes.size(); ++box)
        for (const std::vector<double>& share : sobol_points(dimensions, explored_designs, {0, box})) {
            Shares point = space.origin;
            for (std::size_t k = 0; k < dimensions; ++k) {
                double& moved = point[space.free[k]];
                moved = std::clamp(moved + explored_boxes[box] * (2.0 * share[k] - 1.0), 0.0, 1.0);
            }
            points.push_back(std::move(point));
        }
    const std::vector<DesignVerdict> verdicts = runner.judge(points);
    std::vector<std::pair<double, std::size_t>> found;
    for (std::size_t k = 0; k < points.size(); ++k)
        if (target.condition(verdicts[k])) found.emplace_back(distance(space.origin, points[k]), k);
    std::sort(found.begin(), found.end());
    std::vector<Heading> headings;
    for (std::size_t k = 0; k < std::min(kept_headings, found.size()); ++k)
        headings.push_back(heading_to(space, points[found[k].second]));
    return headings;
}

NearestDesign polished(const DesignSpace& space, NearestDesign best, std::span<const std::size_t> chosen,
                       const DesignTarget& target, DesignRunner& runner) {
    double difference = first_difference;
    for (int round = 0; round < most_rounds && difference > last_difference; ++round) {
        const Heading heading = heading_to(space, best.shares);
        const std::vector<NearestDesign> found =
            nearer(space, variations(heading, chosen, difference), best.distance, target, runner);
        const auto least = std::min_element(found.begin(), found.end(),
                                            [](const auto& a, const auto& b) { return a.distance < b.distance; });
        if (least == found.end() || least->distance >= best.distance)
            difference *= 0.5;
        else
            best = *least;
    }
    return best;
}

}  // namespace stridor::advice
