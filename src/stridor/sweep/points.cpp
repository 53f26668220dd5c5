#include "stridor/sweep/points.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/packed_bytes.hpp"
#include "stridor/crew/crew.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/sweep/evaluate.hpp"
#include "stridor/sweep/results_version.hpp"
#include "stridor/sweep/starts.hpp"
#include "stridor/sweep/study_work.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

namespace stridor::sweep {

namespace {

using parameters::Case;
using parameters::Direction;

/// Points with full keys, and which of them mean something for each base; shape [base].
struct ResolvedPoints {
    DesignPoints points;
    std::vector<std::vector<std::size_t>> keys_of;
};

/// What one run computes: a constant drive's one direction, of any other all of them.
struct PointRun {
    std::size_t point = 0;
    std::size_t direction = 0;   // the first
    std::size_t directions = 1;  // [1] number of them
};

std::size_t base_of(const DesignPoints& points, std::size_t point) {
    return points.base_of.empty() ? 0 : points.base_of[point];
}

std::vector<PointRun> runs_of(const DesignPoints& points) {
    std::vector<PointRun> runs;
    const std::size_t count = points.directions.size();
    for (std::size_t direction = 0; direction < count; ++direction)
        for (std::size_t point = 0; point < point_count(points); ++point) {
            const bool is_steady = parameters::has_one_phase(points.bases[base_of(points, point)].drive);
            if (is_steady || direction == 0) runs.push_back({point, direction, is_steady ? 1 : count});
        }
    return runs;
}

// does it mean something for a case from one of the starts?
bool belongs_from_a_start(Case c, const std::vector<parameters::Initial>& starts, const std::string& key) {
    if (starts.empty()) return parameters::belongs(c, key);
    return std::any_of(starts.begin(), starts.end(), [&](parameters::Initial start) {
        c.run.initial = start;
        return parameters::belongs(c, key);
    });
}

ResolvedPoints resolved(const DesignPoints& asked) {
    ResolvedPoints result{asked, std::vector<std::vector<std::size_t>>(asked.bases.size())};
    DesignPoints& points = result.points;
    for (std::size_t k = 0; k < points.keys.size(); ++k) {
        std::string& key = points.keys[k];
        key = parameters::quantity_key_called(key);
        bool belongs = false;
        for (std::size_t base = 0; base < points.bases.size(); ++base) {
            parameters::expect_joint_of(points.bases[base], key);
            if (!belongs_from_a_start(points.bases[base], points.starts, key)) continue;
            result.keys_of[base].push_back(k);
            belongs = true;
        }
        if (!belongs) base::refuse(key + " means nothing for this case", "", "Choose a quantity that the case has.");
    }
    return result;
}

void check_keys(const DesignPoints& points) {
    if (points.keys.empty() && points.base_of.empty())
        base::refuse("there are no points", "no quantity changes", "Give one quantity at least.");
    for (std::size_t k = 0; k < points.keys.size(); ++k)
        for (std::size_t other = 0; other < k; ++other)
            if (parameters::overlap(points.bases.front(), points.keys[k], points.keys[other]))
                base::refuse(points.keys[other] + " and " + points.keys[k] + " set the same quantity", "",
                             "Leave one of them out.");
}

void check_shape(const DesignPoints& points) {
    STRIDOR_EXPECT(!points.bases.empty());
    const std::size_t keys = points.keys.size();
    const bool has_bases = points.base_of.empty() || points.base_of.size() == point_count(points);
    if (!has_bases || (keys > 0 && points.values.size() % keys != 0))
        base::refuse("the points are not complete", "each has a value of every quantity", "");
    for (const std::size_t base : points.base_of)
        STRIDOR_EXPECT(base < points.bases.size());
}

void check_point_directions(const DesignPoints& points) {
    const auto& directions = points.directions;
    const bool is_twice = directions.size() == 2 && directions.front() == directions.back();
    if (directions.empty() || directions.size() > 2 || is_twice)
        base::refuse("the directions are none, or the same twice", "", "Choose going, coming or both.");
}

void check_point_starts(const DesignPoints& points) {
    for (auto it = points.starts.begin(); it != points.starts.end(); ++it)
        if (std::find(points.starts.begin(), it, *it) != it)
            base::refuse("the starts name \"" + std::string(start_names()[static_cast<std::size_t>(*it)]) + "\" twice",
                         "each is computed once", "");
}

// the number of the point that is wrong, in front of what is wrong
[[noreturn]] void refuse_point(std::size_t point, const Error& error) {
    base::Problem problem = error.problem();
    problem.what = "point " + std::to_string(point) + ": " + problem.what;
    throw Error(error.kind(), std::move(problem));
}

void put_values(const ResolvedPoints& resolved, std::size_t point, Case& c) {
    const DesignPoints& points = resolved.points;
    for (const std::size_t k : resolved.keys_of[base_of(points, point)])
        parameters::set_quantity(c, points.keys[k], points.values[point * points.keys.size() + k]);
}

void check_values(const ResolvedPoints& resolved) {
    std::vector<Case> cases = resolved.points.bases;
    for (std::size_t point = 0; point < point_count(resolved.points); ++point) {
        try {
            put_values(resolved, point, cases[base_of(resolved.points, point)]);
        } catch (const Error& error) {
            refuse_point(point, error);
        }
    }
}

// resolved, and nothing wrong with them
ResolvedPoints checked(const DesignPoints& asked) {
    check_shape(asked);
    check_point_directions(asked);
    check_point_starts(asked);
    ResolvedPoints result = resolved(asked);
    check_keys(result.points);
    check_values(result);
    return result;
}

// the case of one run from one start, by its number in the points' starts
Case case_at(const ResolvedPoints& resolved, const PointRun& run, std::size_t start) {
    const DesignPoints& points = resolved.points;
    Case c = points.bases[base_of(points, run.point)];
    put_values(resolved, run.point, c);
    const double sign = points.directions[run.direction] == Direction::going ? 1.0 : -1.0;
    if (parameters::has_one_phase(c.drive)) c.drive.velocity = std::copysign(c.drive.velocity, sign);
    if (!points.starts.empty()) c.run.initial = points.starts[start];
    return c;
}

// of each direction of a run, from all starts; none if it was stopped
std::vector<Cell> cells_of(const ResolvedPoints& resolved, const PointRun& run, const std::stop_token& stop,
                           integration::Workspace& workspace) {
    const std::span<const Direction> directions =
        std::span(resolved.points.directions).subspan(run.direction, run.directions);
    return evaluate_starts(
        resolved.points.starts.size(), directions, [&](std::size_t start) { return case_at(resolved, run, start); },
        stop, workspace);
}

// all that decides the cells
std::string text_of(const DesignPoints& points) {
    base::Packing packing;
    packing.add("points");
    packing.add(std::uint64_t{results_version});
    for (const Case& base : points.bases)
        packing.add(parameters::canonical_text(base));
    for (const std::string& key : points.keys)
        packing.add(key);
    for (const double value : points.values)
        packing.add(value);
    for (const std::size_t base : points.base_of)
        packing.add(std::uint64_t{base});
    for (const Direction direction : points.directions)
        packing.add(direction);
    for (const parameters::Initial start : points.starts)
        packing.add(start);
    return packing.take();
}

// a task is the number of a run
crew::Work work_of(const ResolvedPoints& resolved, const std::vector<PointRun>& runs) {
    const auto compute = [&resolved, &runs](const crew::Task& task, const std::stop_token& stop,
                                            integration::Workspace& workspace) -> std::optional<std::string> {
        const std::vector<Cell> cells = cells_of(resolved, runs[task.number], stop, workspace);
        return cells.empty() ? std::nullopt : std::optional(packed(cells));
    };
    return simulating_work(text_of(resolved.points), compute);
}

}  // namespace

std::size_t point_count(const DesignPoints& points) {
    return points.keys.empty() ? points.base_of.size() : points.values.size() / points.keys.size();
}

std::size_t run_count(const DesignPoints& points) {
    return runs_of(points).size();
}

void check(const DesignPoints& points) {
    checked(points);
}

std::vector<Cell> evaluate(const DesignPoints& asked, const PointOptions& options) {
    const ResolvedPoints points = checked(asked);
    const std::vector<PointRun> runs = runs_of(points.points);
    const std::size_t count = point_count(points.points);
    std::vector<Cell> cells(count * points.points.directions.size());
    std::size_t done = 0;
    const auto take = [&](const crew::Result& result) {
        const PointRun& run = runs[result.number];
        std::size_t direction = run.direction;
        for (Cell& cell : unpacked_cells(result.bytes))
            cells[direction++ * count + run.point] = std::move(cell);
        ++done;
    };
    const auto tick = [&] {
        if (options.progress) options.progress(done);
    };
    const std::unique_ptr<crew::Crew> crew = options.crew(work_of(points, runs), options.stop);
    crew::compute(*crew, crew::numbered_tasks(runs.size()), take, tick);
    if (done < runs.size())
        throw Error(ErrorKind::interrupted,
                    {"stopped after " + std::to_string(done) + " of " + std::to_string(runs.size()) + " runs",
                     "an evaluation that is stopped keeps nothing", "Run it again."});
    return cells;
}

}  // namespace stridor::sweep
