#include "stridor/console/results/chart_text.hpp"

#include "stridor/console/progress.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/parameters/case_key.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace stridor::console {

std::string starts_text(const sweep::SweepResult& result) {
    if (result.study.starts.empty()) return {};
    std::string text = fmt::format("from {} starts:", result.study.starts.size());
    for (std::size_t k = 0; k < sweep::agreement_names.size(); ++k) {
        const auto number = std::count_if(
            result.cells.begin(), result.cells.end(),
            [k](const sweep::CellVerdict& cell) { return static_cast<std::size_t>(cell.agreement) == k; });
        std::string name(sweep::agreement_names[k]);
        std::replace(name.begin(), name.end(), '_', ' ');
        if (number > 0) text += fmt::format(" {} {} ", name, number);
    }
    return text.substr(0, text.find_last_not_of(' ') + 1) + "\n";
}

std::string outside_text(const sweep::Study& study) {
    std::string values;
    for (const sweep::Axis* axis : {&study.x, &study.y}) {
        if (axis == &study.y && sweep::has_one_axis(study)) continue;
        values += (values.empty() ? "" : ", ") + axis->parameter + " = " +
                  parameters::value_text(study.base, axis->parameter);
    }
    return "the design lies outside of the chart: " + values;
}

std::string cells_text(const sweep::SweepResult& result) {
    sweep::Counts counts;
    for (const sweep::CellVerdict& cell : result.cells)
        sweep::count(counts, cell);
    const std::string share =
        result.study.refine == 0 ? "" : fmt::format(", {} of them computed", sweep::computed_count(result));
    return fmt::format("{} cells{}: {}\n", result.cells.size(), share, counts_text(counts));
}

std::string failures_text(const sweep::SweepResult& result, const std::string& chart_file) {
    std::size_t failures = 0;
    std::size_t first = result.cells.size();
    for (std::size_t k = 0; k < result.cells.size(); ++k) {
        if (result.cells[k].status == sweep::Status::done) continue;
        // an inferred cell has no message of its own
        if (first == result.cells.size() && !sweep::is_inferred(result, k)) first = k;
        ++failures;
    }
    if (failures == 0) return {};
    return fmt::format("{} of {} cells have no result and are drawn hatched; the first: {} ({})\n  reproduce: {}",
                       failures, result.cells.size(),
                       sweep::status_names[static_cast<std::size_t>(result.cells[first].status)],
                       sweep::computed_cell(result, first).message,
                       sweep::reproduce_command(result.study, sweep::shown_place(result, first), chart_file));
}

}  // namespace stridor::console
