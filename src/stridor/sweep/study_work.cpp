#include "stridor/sweep/study_work.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/packed_bytes.hpp"
#include "stridor/crew/crew.hpp"
#include "stridor/sweep/evaluate.hpp"
#include "stridor/sweep/results_version.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>

namespace stridor::sweep {

namespace {

using base::Packing;
using base::Unpacking;
using classification::Category;

void add(Packing& packing, const Cell& cell) {
    packing.add(cell.status);
    packing.add(cell.category);
    packing.add(cell.quiet);
    packing.add(cell.agreement);
    packing.add(cell.message);
    packing.add(static_cast<std::uint64_t>(cell.starts.size()));
    for (const StartVerdict& start : cell.starts) {
        packing.add(start.status);
        packing.add(start.category);
        packing.add(start.quiet);
    }
    packing.add(static_cast<std::uint64_t>(cell.figures.size()));
    for (const double figure : cell.figures)
        packing.add(figure);
}

Cell unpacked_cell(Unpacking& unpacking) {
    constexpr std::size_t categories = classification::category_names.size();
    constexpr std::size_t silences = classification::quiet_names.size();
    Cell cell;
    cell.status = unpacking.kind<Status>(status_names.size());
    cell.category = unpacking.kind<Category>(categories);
    cell.quiet = unpacking.kind<classification::Quiet>(silences);
    cell.agreement = unpacking.kind<Agreement>(agreement_names.size());
    cell.message = unpacking.words();
    for (std::uint64_t left = unpacking.count(); left > 0 && unpacking.is_good(); --left) {
        StartVerdict& start = cell.starts.emplace_back();
        start.status = unpacking.kind<Status>(status_names.size());
        start.category = unpacking.kind<Category>(categories);
        start.quiet = unpacking.kind<classification::Quiet>(silences);
    }
    const std::uint64_t figures = unpacking.count();
    if (figures == cell_figures().size()) cell.figures.reserve(figures);
    for (std::uint64_t left = figures; left > 0 && unpacking.is_good(); --left)
        cell.figures.push_back(unpacking.number());
    return cell;
}

}  // namespace

crew::Work simulating_work(std::string text, Simulating compute) {
    return {std::move(text), [compute = std::move(compute)] {
                return [compute, workspace = std::make_shared<integration::Workspace>()](const crew::Task& task,
                                                                                         const std::stop_token& stop) {
                    return compute(task, stop, *workspace);
                };
            }};
}

void Agenda::add(std::size_t run) {
    STRIDOR_EXPECT(run < waiting_.size());
    if (was_added_[run]) return;
    was_added_[run] = true;
    waiting_[run] = true;
    ++left_;
    cursor_ = std::min(cursor_, run);
}

std::vector<std::size_t> Agenda::next(std::size_t most) {
    std::vector<std::size_t> runs;
    runs.reserve(std::min(most, left_));
    while (runs.size() < most && left_ > 0) {
        if (waiting_[cursor_]) {
            waiting_[cursor_] = false;
            --left_;
            runs.push_back(cursor_);
        }
        ++cursor_;
    }
    return runs;
}

crew::Work work_of(const Study& study) {
    std::string text = "chart\n" + canonical_text(study) + "results = " + std::to_string(results_version) + "\n";
    const auto compute = [&study](const crew::Task& task, const std::stop_token& stop,
                                  integration::Workspace& workspace) -> std::optional<std::string> {
        const std::vector<Cell> cells = evaluate_run(study, task.number, stop, workspace);
        return cells.empty() ? std::nullopt : std::optional(packed(cells));
    };
    return simulating_work(std::move(text), compute);
}

std::string packed(std::span<const Cell> cells) {
    Packing packing;
    packing.add(static_cast<std::uint64_t>(cells.size()));
    for (const Cell& cell : cells)
        add(packing, cell);
    return packing.take();
}

std::vector<Cell> unpacked_cells(std::string_view bytes) {
    Unpacking unpacking(bytes);
    std::vector<Cell> cells;
    for (std::uint64_t left = unpacking.count(); left > 0 && unpacking.is_good(); --left)
        cells.push_back(unpacked_cell(unpacking));
    const bool has_all_figures = std::all_of(cells.begin(), cells.end(), [](const Cell& cell) {
        return cell.figures.empty() || cell.figures.size() == cell_figures().size();
    });
    if (!unpacking.is_complete() || !has_all_figures) throw crew::damaged_result();
    return cells;
}

}  // namespace stridor::sweep
