#include "stridor/advice/margins.hpp"

#include "stridor/advice/headline.hpp"
#include "stridor/base/check.hpp"
#include "stridor/base/error.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/rules/check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace stridor::advice {

namespace {

// around the present value a parameter is looked at more closely [1, share of the range]
constexpr std::array close_steps{0.002, 0.005, 0.01};

// the end of what is valid is located so well: no run is needed for it [1]
constexpr double validity_resolution = 1e-9;

// points nearer to each other than this are one [1]
constexpr double least_step = 1e-6;

enum class Side { below, above };

Shares moved(const DesignSpace& space, std::size_t parameter, double share) {
    Shares shares = space.origin;
    shares[parameter] = share;
    return shares;
}

bool is_valid(const DesignSpace& space, std::size_t parameter, double share) {
    return parameters::findings(case_of(space, design_at(space, moved(space, parameter, share)))).empty();
}

// how far a parameter can go to one side without a contradiction
struct Reach {
    double share = 0.0;
    ScanEnd end = ScanEnd::range;
    std::string reason{};
};

Reach reach(const DesignSpace& space, std::size_t parameter, Side side) {
    const double step = (side == Side::above ? 1.0 : -1.0) / scan_intervals;
    const double end = side == Side::above ? 1.0 : 0.0;
    double valid = space.origin[parameter];
    while (valid != end) {
        double next = std::clamp(valid + step, 0.0, 1.0);
        if (is_valid(space, parameter, next)) {
            valid = next;
            continue;
        }
        while (std::abs(next - valid) > validity_resolution) {
            const double middle = 0.5 * (valid + next);
            (is_valid(space, parameter, middle) ? valid : next) = middle;
        }
        const parameters::Case beyond = case_of(space, design_at(space, moved(space, parameter, next)));
        return {valid, ScanEnd::invalid, parameters::findings(beyond).front().problem.why};
    }
    return {end, ScanEnd::range, ""};
}

// what is followed of one parameter
struct Track {
    Reach below;
    Reach above;
    std::vector<double> shares{};  // rising, without the present one
};

Track track(const DesignSpace& space, std::size_t parameter) {
    Track track{reach(space, parameter, Side::below), reach(space, parameter, Side::above)};
    const double origin = space.origin[parameter];
    std::vector<double> shares{track.below.share, track.above.share};
    for (const double step : close_steps) {
        shares.push_back(origin - step);
        shares.push_back(origin + step);
    }
    // a few per cent of a value may be less than any of these, or more
    const DesignParameter& range = space.parameters[parameter];
    const double value = parameters::get_quantity(space.base, range.key);
    for (const double step : near_steps) {
        shares.push_back(share_of(range, value - step * std::abs(value)));
        shares.push_back(share_of(range, value + step * std::abs(value)));
    }
    for (int k = 0; k <= scan_intervals; ++k)
        shares.push_back(static_cast<double>(k) / scan_intervals);
    std::sort(shares.begin(), shares.end());
    for (const double share : shares) {
        const bool is_reached = share >= track.below.share && share <= track.above.share;
        const bool is_new =
            std::abs(share - origin) > least_step && (track.shares.empty() || share - track.shares.back() > least_step);
        if (is_reached && is_new) track.shares.push_back(share);
    }
    return track;
}

// the scan outwards from the present value: its points on one side, nearest first, after the present one
std::vector<const ScanPoint*> outwards(const ParameterMargin& margin, double origin, Side side) {
    std::vector<const ScanPoint*> points;
    for (const ScanPoint& point : margin.scan)
        if (side == Side::above ? point.share >= origin : point.share <= origin) points.push_back(&point);
    if (side == Side::below) std::reverse(points.begin(), points.end());
    return points;
}

// a bracket, and where its result belongs
struct Search {
    Bracket bracket;
    DesignCondition condition;
    std::optional<VerdictChange>* result;
    std::size_t parameter;
};

void look(const DesignSpace& space, std::vector<Search>& searches, const std::vector<const ScanPoint*>& points,
          DesignCondition condition, std::pair<std::size_t, std::optional<VerdictChange>*> result) {
    for (std::size_t k = 1; k < points.size(); ++k) {
        if (!condition(points[k]->verdict)) continue;
        const auto [parameter, place] = result;
        searches.push_back({{moved(space, parameter, points[k - 1]->share), moved(space, parameter, points[k]->share),
                             points[k]->verdict},
                            std::move(condition),
                            place,
                            parameter});
        return;
    }
}

void locate(const DesignSpace& space, const std::vector<Search>& searches, DesignRunner& runner) {
    std::vector<Bracket> brackets;
    std::vector<DesignCondition> conditions;
    const auto keep = [&] {
        for (std::size_t k = 0; k < searches.size(); ++k) {
            const std::size_t parameter = searches[k].parameter;
            const DesignParameter& range = space.parameters[parameter];
            const double share = brackets[k].beyond[parameter];
            *searches[k].result = VerdictChange{share, value_at(range, share),
                                                value_at(range, brackets[k].before[parameter]), brackets[k].verdict};
        }
    };
    for (const Search& search : searches) {
        brackets.push_back(search.bracket);
        conditions.push_back(search.condition);
    }
    // as the scan has them, in case that the search is stopped
    keep();
    brackets = bisect(std::move(brackets), conditions, scan_resolution, runner);
    keep();
}

// a design of a scan that is to be judged
struct ToJudge {
    double far = 0.0;  // [1] from the present share
    std::size_t parameter = 0;
    double share = 0.0;
};

// of all tracks, the nearest first
std::vector<ToJudge> nearest_first(const DesignSpace& space, const std::vector<Track>& tracks) {
    std::vector<ToJudge> order;
    for (std::size_t k = 0; k < tracks.size(); ++k)
        for (const double share : tracks[k].shares)
            order.push_back({std::abs(share - space.origin[k]), k, share});
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.far < b.far; });
    return order;
}

// what is known before any design is judged
std::vector<ParameterMargin> empty_margins(const DesignSpace& space, const DesignVerdict& present,
                                           const std::vector<Track>& tracks) {
    std::vector<ParameterMargin> margins(tracks.size());
    for (std::size_t k = 0; k < margins.size(); ++k) {
        const DesignParameter& parameter = space.parameters[k];
        ParameterMargin& margin = margins[k];
        margin.parameter = k;
        margin.value = parameters::get_quantity(space.base, parameter.key);
        margin.below = {
            {}, {}, value_at(parameter, tracks[k].below.share), tracks[k].below.end, tracks[k].below.reason};
        margin.above = {
            {}, {}, value_at(parameter, tracks[k].above.share), tracks[k].above.end, tracks[k].above.reason};
        margin.scan = {{space.origin[k], margin.value, present}};
    }
    return margins;
}

// where nobody looked any further
void end_at_last(MarginSearch& search) {
    for (ParameterMargin& margin : search.margins) {
        margin.below.last = margin.scan.front().value;
        margin.above.last = margin.scan.back().value;
    }
}

// in growing parts, so that a search that is stopped early has something, and a long one keeps its crew busy
void scan(const DesignSpace& space, const std::vector<ToJudge>& order, MarginSearch& search, DesignRunner& runner) {
    constexpr std::size_t first_part = 16;  // [1] designs
    for (std::size_t begin = 0, size = first_part; begin < order.size(); begin += size, size *= 2) {
        const std::size_t end = std::min(order.size(), begin + size);
        std::vector<Shares> designs;
        for (std::size_t k = begin; k < end; ++k)
            designs.push_back(moved(space, order[k].parameter, order[k].share));
        std::vector<DesignVerdict> verdicts = runner.judge(designs);
        for (std::size_t k = begin; k < end; ++k) {
            const auto& [far, parameter, share] = order[k];
            std::vector<ScanPoint>& points = search.margins[parameter].scan;
            const auto place = std::find_if(points.begin(), points.end(),
                                            [at = share](const ScanPoint& point) { return point.share > at; });
            points.insert(place, {share, value_at(space.parameters[parameter], share), std::move(verdicts[k - begin])});
        }
    }
}

const VerdictChange* nearer(double origin, const std::optional<VerdictChange>& below,
                            const std::optional<VerdictChange>& above) {
    if (!below) return above ? &*above : nullptr;
    if (!above) return &*below;
    return origin - below->share <= above->share - origin ? &*below : &*above;
}

}  // namespace

double distance(const Shares& a, const Shares& b) {
    double square = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k)
        square += (a[k] - b[k]) * (a[k] - b[k]);
    return std::sqrt(square);
}

std::vector<Bracket> bisect(std::vector<Bracket> brackets, const std::vector<DesignCondition>& conditions,
                            double resolution, DesignRunner& runner) {
    STRIDOR_EXPECT(brackets.size() == conditions.size());
    while (true) {
        // all brackets at once: each round is as many runs as there are wide ones
        std::vector<std::size_t> wide;
        std::vector<Shares> middles;
        for (std::size_t k = 0; k < brackets.size(); ++k) {
            const Bracket& bracket = brackets[k];
            if (distance(bracket.before, bracket.beyond) <= resolution) continue;
            Shares middle = bracket.before;
            for (std::size_t i = 0; i < middle.size(); ++i)
                middle[i] = 0.5 * (bracket.before[i] + bracket.beyond[i]);
            wide.push_back(k);
            middles.push_back(std::move(middle));
        }
        if (wide.empty()) return brackets;
        std::vector<DesignVerdict> verdicts = runner.judge(middles);
        for (std::size_t k = 0; k < wide.size(); ++k) {
            Bracket& bracket = brackets[wide[k]];
            if (conditions[wide[k]](verdicts[k])) {
                bracket.beyond = std::move(middles[k]);
                bracket.verdict = std::move(verdicts[k]);
            } else {
                bracket.before = std::move(middles[k]);
            }
        }
    }
}

MarginSearch find_margins(const DesignSpace& space, const DesignVerdict& present, DesignRunner& runner) {
    std::vector<Track> tracks;
    for (std::size_t k = 0; k < space.parameters.size(); ++k)
        tracks.push_back(track(space, k));
    MarginSearch search{empty_margins(space, present, tracks), {}};
    const auto until_stopped = [&](const std::function<void()>& part) {
        try {
            part();
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::interrupted) throw;
            search.stopped = error;
        }
    };
    until_stopped([&] { scan(space, nearest_first(space, tracks), search, runner); });
    if (search.stopped) end_at_last(search);
    const DesignCondition is_other = [&](const DesignVerdict& verdict) { return !are_alike(verdict, present); };
    std::vector<Search> searches;
    for (ParameterMargin& margin : search.margins)
        for (const Side side : {Side::below, Side::above}) {
            const auto points = outwards(margin, space.origin[margin.parameter], side);
            ScanSide& found = side == Side::below ? margin.below : margin.above;
            look(space, searches, points, is_other, {margin.parameter, &found.change});
            if (!is_quiet(present)) look(space, searches, points, slips_quietly, {margin.parameter, &found.quiet});
        }
    until_stopped([&] { locate(space, searches, runner); });
    return search;
}

const VerdictChange* nearest_change(const DesignSpace& space, const ParameterMargin& margin) {
    return nearer(space.origin[margin.parameter], margin.below.change, margin.above.change);
}

const VerdictChange* nearest_quiet(const DesignSpace& space, const ParameterMargin& margin) {
    return nearer(space.origin[margin.parameter], margin.below.quiet, margin.above.quiet);
}

}  // namespace stridor::advice
