#pragma once

#include "stridor/io/case/toml_writer.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/sweep/cell.hpp"
#include "stridor/sweep/ready_charts.hpp"
#include "stridor/sweep/refinement.hpp"
#include "stridor/sweep/starts.hpp"
#include "support/expected_error.hpp"
#include "support/scratch_folder.hpp"

#include <string>

namespace stridor::io {

using support::ScratchFolder;

using support::error_of;
using support::expect_error;
using support::replaced;

/// The squeal case without comments: short, and its lines are easily counted.
inline std::string squeal_toml() {
    return case_toml(parameters::paper_case(parameters::PaperCase::squeal),
                     {.comments = Comments::none, .heading = ""});
}

/// 4 by 3 points in two directions.
inline sweep::Study small_study() {
    sweep::Study study = sweep::figure_8();
    study.x.points = 4;
    study.y.points = 3;
    return study;
}

/// A cell of every status for them; numbers tell the cell they belong to.
inline std::vector<sweep::Cell> small_cells() {
    std::vector<sweep::Cell> cells(sweep::cell_count(small_study()));
    for (std::size_t index = 0; index < cells.size(); ++index) {
        sweep::Cell& cell = cells[index];
        cell.status = static_cast<sweep::Status>(index % sweep::status_names.size());
        if (cell.status != sweep::Status::done) {
            cell.message = "cell \"" + std::to_string(index) + "\", not done";
            continue;
        }
        cell.category = static_cast<classification::Category>(index / 5 % classification::category_names.size());
        for (const sweep::CellFigure& figure : sweep::cell_figures())
            set_figure(cell, figure, 0.1 * static_cast<double>(index));
        set_figure(cell, sweep::cell_figure("frequency"), sweep::Cell::unknown);
    }
    return cells;
}

/// The chart of these cells.
inline sweep::SweepResult small_chart() {
    return sweep::complete(small_study(), small_cells());
}

/// A refined chart: two of its cells were inferred.
inline sweep::SweepResult refined_chart() {
    sweep::SweepResult result = small_chart();
    result.study.refine = 1;
    std::vector<sweep::IndexedCell> computed;
    for (std::size_t index = 0; index < result.cells.size(); ++index) {
        result.sources.push_back(static_cast<sweep::CellIndex>(index == 1 ? 0 : index == 13 ? 15 : index));
        if (!sweep::is_inferred(result, index)) computed.push_back({index, sweep::computed_cell(result, index)});
    }
    result.computed = sweep::in_memory(std::move(computed));
    result.cells = sweep::inferred(result.cells, result.sources);
    return result;
}

/// A chart from two starts: where the cell is done the first one is quiet.
inline sweep::SweepResult chart_of_starts() {
    sweep::Study study = small_study();
    study.starts = {parameters::Initial::rest, parameters::Initial::sliding};
    std::vector<sweep::Cell> cells = small_cells();
    for (sweep::Cell& cell : cells) {
        sweep::Cell quiet = cell;
        quiet.category = classification::Category::none;
        cell = sweep::joined({quiet, cell});
    }
    return sweep::complete(study, std::move(cells));
}

}  // namespace stridor::io
