#pragma once

#include "stridor/crew/crew.hpp"
#include "stridor/sweep/refinement.hpp"
#include "stridor/sweep/study_work.hpp"
#include "support/small_study.hpp"

#include <cmath>
#include <deque>
#include <functional>
#include <random>
#include <utility>

/// Cells that cost nothing, for tests of how they travel.
namespace stridor::cluster {

using sweep::Cell;
using sweep::IndexedCell;
using sweep::Study;

/// A refined study of invented cells: areas with curved boundaries.
inline Study invented_study(int points, int refine) {
    Study study = sweep::small_study();
    study.base.drive.kind = parameters::DriveKind::sinusoidal;  // both directions in one run
    study.x.points = points;
    study.y.points = points - 2;
    study.refine = refine;
    return study;
}

/// A cell that depends on its place alone.
inline Cell invented_cell(const Study& study, std::size_t index) {
    const sweep::CellPlace place = sweep::place_of(study, index);
    const double x = place.ix / (study.x.points - 1.0);
    const double y = place.iy / (study.y.points - 1.0);
    Cell cell;
    if (x + y > 1.9) {
        cell.status = sweep::Status::failed;
        cell.message = "no cell in the corner";
        return cell;
    }
    cell.status = sweep::Status::done;
    const bool is_loud = std::hypot(x - 0.4, y - 0.6) < 0.25 + 0.1 * static_cast<double>(place.direction);
    cell.category = is_loud ? classification::Category::squeal : classification::Category::none;
    if (!is_loud) cell.quiet = x > 0.7 ? classification::Quiet::sticks : classification::Quiet::slides;
    for (const sweep::CellFigure& figure : sweep::cell_figures())
        sweep::set_figure(cell, figure, std::sin(static_cast<double>(index + figure.place)));
    return cell;
}

/// Invented cells as a work.
inline crew::Work invented_work(const Study& study) {
    crew::Work work = sweep::work_of(study);
    work.worker = [&study] {
        return [&study](const crew::Task& task, const std::stop_token&) -> std::optional<std::string> {
            const std::size_t stride = sweep::cell_count(study) / study.directions.size();
            std::vector<Cell> cells;
            for (std::size_t k = 0; k < sweep::directions_per_run(study); ++k)
                cells.push_back(invented_cell(study, task.number + k * stride));
            return sweep::packed(cells);
        };
    };
    return work;
}

/// Computes in its owner's thread: a few tasks at each look, in any order.
class OwnersCrew final : public crew::Crew {
public:
    /// `turn` is called at each look: what else happens meanwhile.
    OwnersCrew(const crew::Work& work, std::stop_token stop, std::mt19937_64& random, std::function<void()> turn)
        : worker_(work.worker()),
          stop_(std::move(stop)),
          random_(random),
          turn_(std::move(turn)) {}

    std::size_t appetite(std::size_t left) override {
        return stop_.stop_requested() || queue_.size() > 4 ? 0 : std::min<std::size_t>(left, 8);
    }

    void give(std::vector<crew::Task> tasks) override { queue_.insert(queue_.end(), tasks.begin(), tasks.end()); }

    std::vector<crew::Result> take(std::size_t, Clock::time_point) override {
        if (turn_) turn_();
        std::vector<crew::Result> results;
        for (std::size_t left = random_() % 4; left > 0 && !queue_.empty() && !stop_.stop_requested(); --left) {
            std::swap(queue_.front(), queue_[random_() % queue_.size()]);
            results.push_back({queue_.front().number, worker_(queue_.front(), stop_).value()});
            queue_.pop_front();
        }
        return results;
    }

    bool is_idle() override { return queue_.empty() || stop_.stop_requested(); }
    bool has_stopped() override { return stop_.stop_requested(); }
    void rethrow() override {}
    double seconds_per_task() override { return 0.01; }

private:
    crew::Worker worker_;
    std::stop_token stop_;
    std::mt19937_64& random_;
    std::function<void()> turn_;
    std::deque<crew::Task> queue_;
};

}  // namespace stridor::cluster
