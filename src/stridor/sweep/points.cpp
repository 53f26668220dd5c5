#include "stridor/sweep/points.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/sha256.hpp"
#include "stridor/crew/compute.hpp"
#include "stridor/parameters/case_key.hpp"
#include "stridor/parameters/field.hpp"
#include "stridor/sweep/evaluate.hpp"
#include "stridor/sweep/store/store_layout.hpp"
#include "stridor/sweep/study_work.hpp"

#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace stridor::sweep {

namespace {

using parameters::Case;
using parameters::Direction;

bool is_steady_drive(const DesignPoints& points) {
    return parameters::has_one_phase(points.base.drive);
}

// the same points with full keys
DesignPoints resolved(const DesignPoints& points) {
    DesignPoints result = points;
    for (std::string& key : result.keys) {
        key = parameters::quantity_key_called(key);
        parameters::expect_joint_of(points.base, key);
        if (!parameters::belongs(points.base, key))
            base::refuse(key + " means nothing for this case", "", "Choose a quantity that the case has.");
    }
    return result;
}

void check_keys(const DesignPoints& points) {
    if (points.keys.empty()) base::refuse("there are no points", "no quantity changes", "Give one quantity at least.");
    for (std::size_t k = 0; k < points.keys.size(); ++k)
        for (std::size_t other = 0; other < k; ++other)
            if (parameters::overlap(points.base, points.keys[k], points.keys[other]))
                base::refuse(points.keys[other] + " and " + points.keys[k] + " set the same quantity", "",
                             "Leave one of them out.");
    if (points.values.size() % points.keys.size() != 0)
        base::refuse("the points are not complete", "each has a value of every quantity", "");
}

void check_point_directions(const DesignPoints& points) {
    const auto& directions = points.directions;
    const bool is_twice = directions.size() == 2 && directions.front() == directions.back();
    if (directions.empty() || directions.size() > 2 || is_twice)
        base::refuse("the directions are none, or the same twice", "", "Choose going, coming or both.");
}

// the number of the point that is wrong, in front of what is wrong
[[noreturn]] void refuse_point(std::size_t point, const Error& error) {
    base::Problem problem = error.problem();
    problem.what = "point " + std::to_string(point) + ": " + problem.what;
    throw Error(error.kind(), std::move(problem));
}

void put_values(const DesignPoints& points, std::size_t point, Case& c) {
    for (std::size_t k = 0; k < points.keys.size(); ++k)
        parameters::set_quantity(c, points.keys[k], points.values[point * points.keys.size() + k]);
}

void check_values(const DesignPoints& points) {
    Case c = points.base;
    for (std::size_t point = 0; point < point_count(points); ++point) {
        try {
            put_values(points, point, c);
        } catch (const Error& error) {
            refuse_point(point, error);
        }
    }
}

void check_resolved(const DesignPoints& points) {
    check_keys(points);
    check_point_directions(points);
    check_values(points);
}

// where the cells of a run stand, shape [direction][point]: one of a constant drive gives one direction, any other all
struct RunPlace {
    std::size_t point = 0;
    std::size_t first = 0;  // into the directions
    std::size_t last = 0;   // behind the last one
};

RunPlace place_of_run(const DesignPoints& points, std::size_t run) {
    const std::size_t count = point_count(points);
    if (!is_steady_drive(points)) return {run, 0, points.directions.size()};
    return {run % count, run / count, run / count + 1};
}

// nothing if it was stopped
std::optional<std::string> computed_run(const DesignPoints& points, std::size_t run, const std::stop_token& stop,
                                        integration::Workspace& workspace) {
    const RunPlace place = place_of_run(points, run);
    const Case c = case_at(points, place.point, points.directions[place.first]);
    const std::optional<Attempt> attempted = attempt(c, {}, stop, workspace);
    if (!attempted) return std::nullopt;
    std::vector<Cell> cells;
    for (std::size_t k = place.first; k < place.last; ++k)
        cells.push_back(cell_of(c, points.directions[k], *attempted));
    return packed(cells);
}

// a task is the number of a run
crew::Work work_of(const DesignPoints& points) {
    crew::Work work;
    work.text = "points\n" + parameters::canonical_text(points.base);
    for (const std::string& key : points.keys)
        work.text += "key = " + key + "\n";
    const std::span values = std::as_bytes(std::span(points.values));
    work.text +=
        "values = " + base::sha256_text(std::string(reinterpret_cast<const char*>(values.data()), values.size())) +
        "\nresults = " + std::to_string(results_version) + "\n";
    work.worker = [&points] {
        return [&points, workspace = std::make_shared<integration::Workspace>()](const crew::Task& task,
                                                                                 const std::stop_token& stop) {
            return computed_run(points, task.number, stop, *workspace);
        };
    };
    return work;
}

}  // namespace

std::size_t point_count(const DesignPoints& points) {
    return points.keys.empty() ? 0 : points.values.size() / points.keys.size();
}

std::size_t run_count(const DesignPoints& points) {
    return point_count(points) * (is_steady_drive(points) ? points.directions.size() : 1);
}

Case case_at(const DesignPoints& points, std::size_t point, Direction direction) {
    Case c = points.base;
    put_values(points, point, c);
    const double sign = direction == Direction::going ? 1.0 : -1.0;
    if (is_steady_drive(points)) c.drive.velocity = std::copysign(c.drive.velocity, sign);
    return c;
}

void check(const DesignPoints& points) {
    check_resolved(resolved(points));
}

std::vector<Cell> evaluate(const DesignPoints& asked, const PointOptions& options) {
    const DesignPoints points = resolved(asked);
    check_resolved(points);
    const std::size_t count = point_count(points);
    std::vector<Cell> cells(count * points.directions.size());
    std::size_t done = 0;
    const auto take = [&](const crew::Result& result) {
        std::size_t direction = place_of_run(points, result.number).first;
        for (Cell& cell : unpacked_cells(result.bytes))
            cells[direction++ * count + place_of_run(points, result.number).point] = std::move(cell);
        ++done;
    };
    const auto tick = [&] {
        if (options.progress) options.progress(done);
    };
    const std::unique_ptr<crew::Crew> crew = options.crew(work_of(points), options.stop);
    crew::compute(*crew, crew::numbered_tasks(run_count(points)), take, tick);
    if (done < run_count(points))
        throw Error(ErrorKind::interrupted,
                    {"stopped after " + std::to_string(done) + " of " + std::to_string(run_count(points)) + " runs",
                     "an evaluation that is stopped keeps nothing", "Run it again."});
    return cells;
}

}  // namespace stridor::sweep
