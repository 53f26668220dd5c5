#include "stridor/advice/quieting.hpp"

#include "stridor/base/check.hpp"
#include "stridor/parameters/fields/case_key.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace stridor::advice {

namespace {

using parameters::Case;

// how far beyond the boundary it is tried, one after the other [1, share of the range]
constexpr std::array tried_safeties{safety, 0.03, 0.04, 0.06, 0.08, 0.1, 0.12};

// a rounded value may lie so much farther than asked for [1, share of the range]
constexpr double rounding_room = 0.01;

DesignTarget target_for(Wanted wanted) {
    if (wanted == Wanted::quiet) return {slips_quietly, Specks::ignored};
    // no noise is too small to count
    return {[](const DesignVerdict& verdict) { return !is_quiet(verdict) && !is_invalid(verdict); }, Specks::counted};
}

// of how many parameters pairs and triples are made, and how many of each are searched closely
constexpr std::size_t combined_parameters = 6;
constexpr std::size_t polished_combinations = 3;

// so many of the designs found first are polished: the nearest one need not lead to the nearest one
constexpr std::size_t polished_starts = 5;

// a new value for one parameter, `share` or a little further away from the present one
ParameterChange rounded(const DesignSpace& space, std::size_t parameter, double share, double room) {
    const DesignParameter& range = space.parameters[parameter];
    const double outwards = share > space.origin[parameter] ? 1.0 : -1.0;
    const double near = value_at(range, share);
    const double far = value_at(range, std::clamp(share + outwards * room, 0.0, 1.0));
    return {parameter, parameters::get_quantity(space.base, range.key), roundest(near, far)};
}

DesignChange change_of(const DesignSpace& space, std::vector<ParameterChange> set) {
    Shares shares = space.origin;
    for (const ParameterChange& each : set)
        shares[each.parameter] = share_of(space.parameters[each.parameter], each.to);
    DesignChange change{std::move(set)};
    change.distance = distance(space.origin, shares);
    return change;
}

// a value somewhat more or less (`steps` -1, 0, 1), within what the field allows
double neighbour(const DesignSpace& space, const ParameterChange& change, int steps) {
    const DesignParameter& range = space.parameters[change.parameter];
    const double size = change.to != 0.0 ? std::abs(change.to) : range.to - range.from;
    const parameters::Range allowed = parameters::range_of(space.base, range.key);
    return std::clamp(change.to + steps * verified_around * size, allowed.low, allowed.high);
}

// the changed design and those around it
std::vector<Design> around(const DesignSpace& space, const DesignChange& change) {
    std::vector<Design> designs{{}};
    for (const ParameterChange& each : change.set) {
        std::vector<Design> more;
        for (const int steps : {0, -1, 1})
            for (Design design : designs) {
                design.settings.push_back({space.parameters[each.parameter].key, neighbour(space, each, steps)});
                more.push_back(std::move(design));
            }
        designs = std::move(more);
    }
    return designs;
}

// the changes with what their runs say; nothing for those that do not meet the condition all around. Neighbours whose
// values contradict each other are no designs, and asked for nothing.
std::vector<std::optional<DesignChange>> verified(const DesignSpace& space, std::vector<DesignChange> changes,
                                                  const DesignCondition& condition, DesignRunner& runner) {
    std::vector<Design> designs;
    std::vector<std::size_t> counts;
    for (const DesignChange& change : changes) {
        const std::vector<Design> near = around(space, change);
        counts.push_back(near.size());
        designs.insert(designs.end(), near.begin(), near.end());
    }
    const std::vector<DesignVerdict> verdicts = runner.judge(designs);
    std::vector<std::optional<DesignChange>> results(changes.size());
    auto first = verdicts.begin();
    for (std::size_t k = 0; k < changes.size(); ++k) {
        const auto last = first + static_cast<std::ptrdiff_t>(counts[k]);
        const auto quiet = std::count_if(first, last, condition);
        const auto invalid = std::count_if(first, last, is_invalid);
        changes[k].verdict = *first;
        changes[k].designs = static_cast<std::size_t>(quiet);
        for (auto each = first; each != last; ++each)
            changes[k].runs += each->runs;
        if (condition(*first) && quiet + invalid == last - first) results[k] = std::move(changes[k]);
        first = last;
    }
    return results;
}

enum class Way { below, above };

// the quiet stretches of a scan to one side, each as shares from its near to its far end
struct QuietStretch {
    double near = 0.0;
    double far = 0.0;
};

std::vector<QuietStretch> quiet_stretches(const DesignSpace& space, const ParameterMargin& margin, Way side,
                                          const DesignCondition& condition) {
    const bool is_above = side == Way::above;
    const double origin = space.origin[margin.parameter];
    std::vector<const ScanPoint*> points;
    for (const ScanPoint& point : margin.scan)
        if (is_above ? point.share > origin : point.share < origin) points.push_back(&point);
    if (!is_above) std::reverse(points.begin(), points.end());
    std::vector<QuietStretch> stretches;
    bool is_within = false;
    for (const ScanPoint* point : points) {
        const bool quiet = condition(point->verdict);
        if (quiet && !is_within) stretches.push_back({point->share, point->share});
        if (quiet) stretches.back().far = point->share;
        is_within = quiet;
    }
    const std::optional<VerdictChange>& located = is_above ? margin.above.quiet : margin.below.quiet;
    const bool is_its_start =
        located && !stretches.empty() && std::abs(located->share - stretches.front().near) <= 1.0 / scan_intervals;
    if (is_its_start) stretches.front().near = located->share;
    return stretches;
}

// what to try for one parameter, smallest change first
std::vector<DesignChange> candidates(const DesignSpace& space, const ParameterMargin& margin,
                                     const DesignCondition& condition) {
    std::vector<DesignChange> changes;
    for (const Way side : {Way::below, Way::above})
        for (const QuietStretch& stretch : quiet_stretches(space, margin, side, condition)) {
            const double outwards = side == Way::above ? 1.0 : -1.0;
            const double width = std::abs(stretch.far - stretch.near);
            for (const double beyond : tried_safeties) {
                if (beyond > width) break;
                const double room = std::min(rounding_room, width - beyond);
                changes.push_back(
                    change_of(space, {rounded(space, margin.parameter, stretch.near + outwards * beyond, room)}));
            }
        }
    std::stable_sort(changes.begin(), changes.end(),
                     [](const auto& a, const auto& b) { return a.distance < b.distance; });
    return changes;
}

// the first candidate of each list that can be verified
std::vector<DesignChange> first_verified(const DesignSpace& space,
                                         const std::vector<std::vector<DesignChange>>& candidates,
                                         const DesignCondition& condition, DesignRunner& runner) {
    std::vector<DesignChange> found;
    std::vector<std::size_t> open(candidates.size());
    std::iota(open.begin(), open.end(), 0U);
    for (std::size_t turn = 0; !open.empty(); ++turn) {
        std::erase_if(open, [&](std::size_t k) { return turn >= candidates[k].size(); });
        std::vector<DesignChange> asked;
        for (const std::size_t k : open)
            asked.push_back(candidates[k][turn]);
        const std::vector<std::optional<DesignChange>> results = verified(space, std::move(asked), condition, runner);
        std::vector<std::size_t> still_open;
        for (std::size_t k = 0; k < results.size(); ++k) {
            if (results[k])
                found.push_back(*results[k]);
            else
                still_open.push_back(open[k]);
        }
        open = std::move(still_open);
    }
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.distance < b.distance; });
    return found;
}

// signed distances along the axes to the nearest design of that kind, 0 where there is none, or a parameter is not free
std::vector<double> intercepts(const DesignSpace& space, std::span<const ParameterMargin> margins, Wanted wanted) {
    std::vector<double> all(margins.size(), 0.0);
    for (const std::size_t k : space.free) {
        const VerdictChange* found =
            wanted == Wanted::quiet ? nearest_quiet(space, margins[k]) : nearest_change(space, margins[k]);
        if (found != nullptr) all[k] = found->share - space.origin[k];
    }
    return all;
}

// the nearest designs of that kind along single parameters
std::vector<NearestDesign> single_designs(const DesignSpace& space, std::span<const ParameterMargin> margins,
                                          Wanted wanted) {
    std::vector<NearestDesign> designs;
    for (const std::size_t k : space.free) {
        const VerdictChange* found =
            wanted == Wanted::quiet ? nearest_quiet(space, margins[k]) : nearest_change(space, margins[k]);
        if (found == nullptr) continue;
        Shares shares = space.origin;
        shares[k] = found->share;
        designs.push_back({std::move(shares), std::abs(found->share - space.origin[k]), found->beyond});
    }
    return designs;
}

// the parameters that help most: by their part in the nearest design, then by their own nearness
std::vector<std::size_t> most_helpful(const DesignSpace& space, const std::vector<double>& intercepts,
                                      const std::optional<NearestDesign>& nearest) {
    std::vector<std::pair<double, std::size_t>> help;
    const Heading heading = nearest ? heading_to(space, nearest->shares) : Heading(intercepts.size(), 0.0);
    for (std::size_t k = 0; k < intercepts.size(); ++k) {
        const double alone = intercepts[k] != 0.0 ? 0.1 / std::abs(intercepts[k]) : 0.0;
        help.emplace_back(-(std::abs(heading[k]) + alone), k);
    }
    std::sort(help.begin(), help.end());
    std::vector<std::size_t> chosen;
    for (std::size_t k = 0; k < std::min(combined_parameters, help.size()); ++k)
        if (help[k].first < 0.0) chosen.push_back(help[k].second);
    std::sort(chosen.begin(), chosen.end());
    return chosen;
}

// all combinations of `size` of the parameters, rising
std::vector<std::vector<std::size_t>> combinations(const std::vector<std::size_t>& parameters, std::size_t size) {
    std::vector<std::vector<std::size_t>> all{{}};
    std::vector<std::vector<std::size_t>> result;
    for (std::size_t next = 0; next < all.size(); ++next) {
        const std::vector<std::size_t> start = all[next];
        if (start.size() == size) {
            result.push_back(start);
            continue;
        }
        for (const std::size_t parameter : parameters)
            if (start.empty() || parameter > start.back()) {
                all.push_back(start);
                all.back().push_back(parameter);
            }
    }
    return result;
}

// of all combinations of so many parameters the few that get quiet nearest, polished
std::vector<NearestDesign> nearest_combinations(const DesignSpace& space, const std::vector<double>& intercepts,
                                                const std::optional<NearestDesign>& nearest,
                                                const std::vector<std::vector<std::size_t>>& combinations,
                                                DesignRunner& runner) {
    std::vector<Heading> headings;  // two per combination
    for (const std::vector<std::size_t>& chosen : combinations) {
        headings.push_back(flat_heading(intercepts, chosen));
        Heading part(space.parameters.size(), 0.0);
        if (nearest)
            for (const std::size_t k : chosen)
                part[k] = nearest->shares[k] - space.origin[k];
        headings.push_back(std::move(part));
    }
    const std::vector<std::optional<NearestDesign>> met =
        along_rays(space, headings, target_for(Wanted::quiet), runner);
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t k = 0; k < met.size(); ++k)
        if (met[k]) order.emplace_back(met[k]->distance, k);
    std::sort(order.begin(), order.end());
    std::vector<NearestDesign> designs;
    for (std::size_t k = 0; k < std::min(polished_combinations, order.size()); ++k)
        designs.push_back(polished(space, *met[order[k].second], combinations[order[k].second / 2],
                                   target_for(Wanted::quiet), runner));
    std::stable_sort(designs.begin(), designs.end(),
                     [](const auto& a, const auto& b) { return a.distance < b.distance; });
    return designs;
}

// what to try beyond a quiet design, smallest change first
std::vector<DesignChange> candidates(const DesignSpace& space, const NearestDesign& design) {
    const Heading heading = heading_to(space, design.shares);
    std::vector<DesignChange> changes;
    for (const double beyond : tried_safeties) {
        const Shares shares = point_along(space, heading, design.distance + beyond);
        std::vector<ParameterChange> set;
        for (std::size_t k = 0; k < shares.size(); ++k)
            if (shares[k] != space.origin[k]) set.push_back(rounded(space, k, shares[k], rounding_room));
        changes.push_back(change_of(space, std::move(set)));
    }
    return changes;
}

}  // namespace

double roundest(double near, double far) {
    if (near == far) return near;
    const double low = std::min(near, far);
    const double high = std::max(near, far);
    if (low <= 0.0 && high >= 0.0) return 0.0;
    // powers of ten are exact up to 10^22, so each candidate is rounded once
    double power = 1.0;
    int exponent = 0;
    while (power <= std::max(std::abs(low), std::abs(high)) && exponent < 22) {
        power *= 10.0;
        ++exponent;
    }
    for (; exponent >= -22; --exponent) {
        double scale = 1.0;
        for (int k = 0; k < std::abs(exponent); ++k)
            scale *= 10.0;
        const auto rounded = [&](double count) { return exponent >= 0 ? count * scale : count / scale; };
        const double count = exponent >= 0 ? near / scale : near * scale;
        const double inwards = near < far ? std::ceil(count) : std::floor(count);
        const double candidate = rounded(inwards);
        if (candidate >= low && candidate <= high) return candidate;
    }
    return near;
}

std::vector<DesignChange> single_changes(const DesignSpace& space, std::span<const ParameterMargin> margins,
                                         Sticking sticking, DesignRunner& runner) {
    const DesignCondition condition = sticking == Sticking::refused ? slips_quietly : is_quiet;
    std::vector<std::vector<DesignChange>> tried;
    for (const std::size_t k : space.free)
        tried.push_back(candidates(space, margins[k], condition));
    return first_verified(space, tried, condition, runner);
}

std::vector<DesignChange> joint_changes(const DesignSpace& space, std::span<const ParameterMargin> margins,
                                        const std::optional<NearestDesign>& nearest, DesignRunner& runner) {
    const std::vector<double> axes = intercepts(space, margins, Wanted::quiet);
    const std::vector<std::size_t> helpful = most_helpful(space, axes, nearest);
    std::vector<DesignChange> changes;
    for (std::size_t size = 2; size <= most_changed; ++size) {
        std::vector<std::vector<DesignChange>> tried;
        for (const NearestDesign& design :
             nearest_combinations(space, axes, nearest, combinations(helpful, size), runner))
            tried.push_back(candidates(space, design));
        const std::vector<DesignChange> found = first_verified(space, tried, slips_quietly, runner);
        if (!found.empty()) changes.push_back(found.front());
    }
    return changes;
}

const DesignChange* recommended(std::span<const DesignChange> changes) {
    const auto cost = [](const DesignChange& change) {
        double dearness = change.distance;
        for (std::size_t k = 1; k < change.set.size(); ++k)
            dearness /= worth_another;
        return dearness;
    };
    const auto best = std::min_element(changes.begin(), changes.end(),
                                       [&](const auto& a, const auto& b) { return cost(a) < cost(b); });
    return best == changes.end() ? nullptr : &*best;
}

std::optional<NearestDesign> nearest_design(const DesignSpace& space, std::span<const ParameterMargin> margins,
                                            Wanted wanted, DesignRunner& runner) {
    const DesignTarget target = target_for(wanted);
    const std::vector<double> axes = intercepts(space, margins, wanted);
    std::vector<Heading> headings{flat_heading(axes, space.free)};
    for (const Heading& heading : explored_headings(space, target, runner))
        headings.push_back(heading);
    std::vector<NearestDesign> starts;
    for (std::optional<NearestDesign>& design : along_rays(space, headings, target, runner))
        if (design) starts.push_back(std::move(*design));
    for (std::optional<NearestDesign>& design : counted(space, single_designs(space, margins, wanted), target, runner))
        if (design) starts.push_back(std::move(*design));
    const auto is_nearer = [](const auto& a, const auto& b) { return a.distance < b.distance; };
    std::stable_sort(starts.begin(), starts.end(), is_nearer);
    if (starts.size() > polished_starts) starts.resize(polished_starts);
    for (NearestDesign& start : starts)
        start = polished(space, start, space.free, target, runner);
    const auto nearest = std::min_element(starts.begin(), starts.end(), is_nearer);
    return nearest == starts.end() ? std::nullopt : std::optional(*nearest);
}

}  // namespace stridor::advice
