#include "stridor/sweep/cell.hpp"

#include "stridor/analysis/evidence.hpp"
#include "stridor/analysis/sliding_stability.hpp"
#include "stridor/base/check.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/field_table.hpp"
#include "stridor/integration/run/motion.hpp"
#include "stridor/sweep/starts.hpp"

#include <algorithm>
#include <utility>

namespace stridor::sweep {

namespace {

using analysis::EvidenceFigure;

/// What a cell keeps beside the evidence.
struct RunFigure {
    std::string_view name;
    std::string_view unit;
    std::string_view sentence;
    double (*value)(const JudgedRun&);
};

constexpr std::array run_figures{
    RunFigure{"growth_rate", "1/s", "largest growth rate of steady sliding; unstable above zero",
              [](const JudgedRun& run) { return run.stability.growth; }},
    RunFigure{"mode_frequency", "Hz", "frequency of the mode with the largest growth rate",
              [](const JudgedRun& run) { return run.stability.frequency; }},
    RunFigure{"energy_residual", "1", "energy the computation created or lost, as a share of the turnover",
              [](const JudgedRun& run) { return run.motion.energy.relative_residual(); }},
    RunFigure{"proof_time", "s", "time from which the rest of the motion was proven; none if it was simulated",
              [](const JudgedRun& run) {
                  return run.motion.outcome.reason == integration::Reason::settled
                             ? run.motion.outcome.time
                             : std::numeric_limits<double>::quiet_NaN();
              }},
};

std::vector<CellFigure> all_figures() {
    std::vector<CellFigure> figures;
    for (const EvidenceFigure& figure : analysis::evidence_figures())
        if (figure.kept == EvidenceFigure::Kept::in_cells)
            figures.push_back({figure.name, figure.unit, figure.sentence, figures.size()});
    for (const RunFigure& figure : run_figures)
        figures.push_back({figure.name, figure.unit, figure.sentence, figures.size()});
    return figures;
}

class InMemory final : public ComputedCells {
public:
    explicit InMemory(std::vector<IndexedCell> cells) : cells_(std::move(cells)) {}

    void visit(std::size_t first, std::size_t last, const std::function<void(IndexedCell&)>& use) override {
        auto cell =
            std::lower_bound(cells_.begin(), cells_.end(), first,
                             [](const IndexedCell& indexed, std::size_t index) { return indexed.index < index; });
        for (; cell != cells_.end() && cell->index < last; ++cell) {
            IndexedCell copy = *cell;
            use(copy);
        }
    }

private:
    std::vector<IndexedCell> cells_;
};

}  // namespace

std::span<const CellFigure> cell_figures() {
    static const std::vector<CellFigure> figures = all_figures();
    return figures;
}

const CellFigure* find_cell_figure(std::string_view name) {
    return base::find_named(cell_figures(), name);
}

const CellFigure& cell_figure(std::string_view name) {
    const CellFigure* figure = find_cell_figure(name);
    STRIDOR_EXPECT(figure != nullptr);
    return *figure;
}

std::vector<double> figures_of(const JudgedRun& run) {
    std::vector<double> values;
    values.reserve(cell_figures().size());
    for (const EvidenceFigure& figure : analysis::evidence_figures())
        if (figure.kept == EvidenceFigure::Kept::in_cells) values.push_back(figure.value(run.evidence));
    for (const RunFigure& figure : run_figures)
        values.push_back(figure.value(run));
    return values;
}

double figure_of(const Cell& cell, const CellFigure& figure) {
    return cell.figures.empty() ? Cell::unknown : cell.figures[figure.place];
}

double figure_of(const Cell& cell, std::string_view name) {
    return figure_of(cell, cell_figure(name));
}

void set_figure(Cell& cell, const CellFigure& figure, double value) {
    cell.figures.resize(cell_figures().size(), Cell::unknown);
    cell.figures[figure.place] = value;
}

std::shared_ptr<ComputedCells> in_memory(std::vector<IndexedCell> cells) {
    STRIDOR_EXPECT(std::is_sorted(cells.begin(), cells.end(),
                                  [](const IndexedCell& a, const IndexedCell& b) { return a.index < b.index; }));
    return std::make_shared<InMemory>(std::move(cells));
}

CellVerdict verdict_of(const Cell& cell) {
    return {cell.status, cell.category, cell.quiet, cell.agreement, static_cast<std::uint8_t>(shown_start(cell))};
}

SweepResult complete(Study study, std::vector<Cell> cells) {
    STRIDOR_EXPECT(cells.size() == cell_count(study));
    SweepResult result{std::move(study), {}};
    std::vector<IndexedCell> indexed;
    for (std::size_t index = 0; index < cells.size(); ++index) {
        result.cells.push_back(verdict_of(cells[index]));
        indexed.push_back({index, std::move(cells[index])});
    }
    result.computed = in_memory(std::move(indexed));
    return result;
}

std::size_t source_of(const SweepResult& result, std::size_t index) {
    return result.sources.empty() ? index : result.sources[index];
}

bool is_inferred(const SweepResult& result, std::size_t index) {
    return source_of(result, index) != index;
}

std::size_t computed_count(const SweepResult& result) {
    std::size_t count = 0;
    for (std::size_t index = 0; index < result.cells.size(); ++index)
        count += is_inferred(result, index) ? 0 : 1;
    return count;
}

Cell computed_cell(const SweepResult& result, std::size_t index) {
    STRIDOR_EXPECT(!is_inferred(result, index));
    Cell cell;
    result.computed->visit(index, index + 1, [&](IndexedCell& indexed) { cell = std::move(indexed.cell); });
    return cell;
}

void ComputedCells::visit_figures(std::size_t first, std::size_t last, std::span<const CellFigure>,
                                  const std::function<void(IndexedCell&)>& use) {
    visit(first, last, use);
}

std::vector<double> figure_values(const SweepResult& result, const CellFigure& figure) {
    std::vector<double> values(result.cells.size(), Cell::unknown);
    result.computed->visit_figures(0, values.size(), std::span(&figure, 1), [&](const IndexedCell& indexed) {
        values[indexed.index] = figure_of(indexed.cell, figure);
    });
    for (std::size_t index = 0; index < values.size(); ++index)
        values[index] = values[source_of(result, index)];
    return values;
}

CellPlace shown_place(const SweepResult& result, std::size_t index) {
    CellPlace place = place_of(result.study, index);
    place.start = result.cells[index].shown_start;
    return place;
}

void require_result(const SweepResult& result) {
    for (const CellVerdict& cell : result.cells)
        if (cell.status == Status::done) return;
    const Cell first = computed_cell(result, 0);  // the corners of a chart are always computed
    const bool is_input = first.status == Status::invalid || first.status == Status::step_limit;
    throw Error(is_input ? ErrorKind::input : ErrorKind::numerical,
                {"no cell of the chart has a result", first.message, "Check the axes and run.step."});
}

}  // namespace stridor::sweep
