#include "stridor/analysis/stability_path.hpp"

#include "stridor/base/check.hpp"

namespace stridor::analysis {

namespace {

// 40 halvings: 1e-12 of the distance between two points
constexpr int halvings = 40;

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

}  // namespace stridor::analysis
