#include "stridor/analysis/stability_scan.hpp"

#include "stridor/analysis/critical_velocity.hpp"
#include "stridor/base/check.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/model/built/case_structure.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/fields/field.hpp"

#include <utility>

namespace stridor::analysis {

namespace {

// 40 halvings: 1e-12 of the distance between two points
constexpr int halvings = 40;

// [1] rows of a structure whose critical velocity is followed along a parameter: it costs some 80 eigenvalue problems
constexpr int most_followed_rows = 12;

StabilityBoundary bisected(const std::function<SlidingStability(double)>& at, StabilityPoint below,
                           StabilityPoint above) {
    for (int k = 0; k < halvings; ++k) {
        const double middle = 0.5 * (below.value + above.value);
        const SlidingStability stability = at(middle);
        // a third kind in between is found as well: the boundary next to the lower point is the one that is kept
        (stability.kind == below.stability.kind ? below : above) = {middle, stability};
    }
    const SlidingStability& unstable =
        above.stability.kind == StabilityKind::stable ? below.stability : above.stability;
    return {0.5 * (below.value + above.value), below.stability.kind, above.stability.kind, unstable.frequency};
}

void check(const parameters::Case& c, const std::string& key, const ScanRange& range) {
    if (!(range.from < range.to) || range.points < 2 || range.points > most_scan_points)
        throw Error(ErrorKind::input,
                    {range.key + " cannot be followed from " + base::shortest(range.from) + " to " +
                         base::shortest(range.to) + " at " + std::to_string(range.points) + " points",
                     "the ends must rise, and 2 to " + std::to_string(most_scan_points) + " points do",
                     range.from > range.to ? "Swap the ends?" : ""});
    parameters::expect_joint_of(c, key);
    if (!parameters::belongs(c, key))
        throw Error(ErrorKind::input,
                    {range.key + " changes nothing", "this case, with its kind of drive and start, does not use it",
                     "`stridor check FILE` lists what it uses."});
    // both ends must be values the parameter can take
    parameters::Case copy = c;
    parameters::set_quantity(copy, key, range.from);
    parameters::set_quantity(copy, key, range.to);
}

}  // namespace

StabilityPath stability_path(const std::function<SlidingStability(double)>& at, double from, double to, int points) {
    STRIDOR_EXPECT(points >= 2);
    StabilityPath path;
    for (int k = 0; k < points; ++k) {
        const double share = static_cast<double>(k) / (points - 1);
        const double value = k == points - 1 ? to : from + share * (to - from);
        path.points.push_back({value, at(value)});
    }
    for (std::size_t k = 1; k < path.points.size(); ++k)
        if (path.points[k].stability.kind != path.points[k - 1].stability.kind)
            path.boundaries.push_back(bisected(at, path.points[k - 1], path.points[k]));
    return path;
}

StabilityScan scan_stability(const parameters::Case& c, const std::optional<ScanRange>& range) {
    StabilityScan scan;
    scan.base = c;
    if (range) {
        scan.key = parameters::quantity_key_called(range->key);
        check(c, scan.key, *range);
        scan.unit = parameters::unit_of(scan.key);
    }
    for (const parameters::Direction direction : {parameters::Direction::going, parameters::Direction::coming}) {
        const model::Structure structure = model::structure_of(c);
        DirectionScan along{direction, sliding_stability(structure, direction, sliding_speed(c.drive)), {}};
        along.critical_velocity = critical_velocity(structure, direction);
        const auto at = [&](double value) {
            parameters::Case changed = c;
            parameters::set_quantity(changed, scan.key, value);
            return sliding_stability(model::structure_of(changed), direction, sliding_speed(changed.drive));
        };
        if (range) along.path = stability_path(at, range->from, range->to, range->points);
        if (along.critical_velocity && model::dofs_of(structure) <= most_followed_rows)
            for (StabilityPoint& point : along.path.points) {
                parameters::Case changed = c;
                parameters::set_quantity(changed, scan.key, point.value);
                point.critical_velocity = critical_velocity(model::structure_of(changed), direction);
            }
        scan.directions.push_back(std::move(along));
    }
    return scan;
}

StabilityScan with_modes(StabilityScan scan) {
    for (DirectionScan& direction : scan.directions) {
        direction.modes = SlidingModes{};
        // without steady sliding there is nothing to disturb
        if (direction.here.kind == StabilityKind::locked) continue;
        direction.modes = sliding_modes(model::structure_of(scan.base), direction.direction, most_sliding_modes,
                                        sliding_speed(scan.base.drive));
    }
    return scan;
}

}  // namespace stridor::analysis
