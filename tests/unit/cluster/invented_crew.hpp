#pragma once

#include "stridor/sweep/crew.hpp"
#include "stridor/sweep/refinement.hpp"
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

/// Computes invented cells in its owner's thread: a few at each look, in any order.
class InventedCrew final : public sweep::Crew {
public:
    /// `turn` is called at each look: what else happens meanwhile.
    InventedCrew(const Study& study, std::stop_token stop, std::mt19937_64& random, std::function<void()> turn)
        : study_(study),
          stop_(std::move(stop)),
          random_(random),
          turn_(std::move(turn)) {}

    std::size_t appetite(std::size_t left) override {
        return stop_.stop_requested() || queue_.size() > 4 ? 0 : std::min<std::size_t>(left, 8);
    }

    void give(std::vector<std::size_t> runs) override { queue_.insert(queue_.end(), runs.begin(), runs.end()); }

    std::vector<IndexedCell> take(std::size_t, Clock::time_point) override {
        if (turn_) turn_();
        std::vector<IndexedCell> cells;
        const std::size_t stride = sweep::cell_count(study_) / study_.directions.size();
        for (std::size_t left = random_() % 4; left > 0 && !queue_.empty() && !stop_.stop_requested(); --left) {
            std::swap(queue_.front(), queue_[random_() % queue_.size()]);
            for (std::size_t k = 0; k < sweep::directions_per_run(study_); ++k) {
                const std::size_t index = queue_.front() + k * stride;
                cells.push_back({index, invented_cell(study_, index)});
            }
            queue_.pop_front();
        }
        return cells;
    }

    bool is_idle() override { return queue_.empty() || stop_.stop_requested(); }
    bool has_stopped() override { return stop_.stop_requested(); }
    void rethrow() override {}
    double seconds_per_run() override { return 0.01; }

private:
    const Study& study_;
    std::stop_token stop_;
    std::mt19937_64& random_;
    std::function<void()> turn_;
    std::deque<std::size_t> queue_;
};

}  // namespace stridor::cluster
