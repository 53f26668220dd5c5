#include "stridor/sweep/cell.hpp"

#include "stridor/base/check.hpp"
#include "stridor/sweep/starts.hpp"

#include <algorithm>
#include <utility>

namespace stridor::sweep {

namespace {

constexpr std::array figures{
    CellFigure{"slip", "1", "share of the window in slip", &Cell::slip},
    CellFigure{"stick", "1", "share of the window in stick", &Cell::stick},
    CellFigure{"separation", "1", "share of the window in separation", &Cell::separation},
    CellFigure{"judged_slip", "1", "share of the judged time in slip", &Cell::judged_slip},
    CellFigure{"judged_stick", "1", "share of the judged time in stick", &Cell::judged_stick},
    CellFigure{"judged_separation", "1", "share of the judged time in separation", &Cell::judged_separation},
    CellFigure{"regularity", "1", "regularity of the beats: 1 when all intervals are equal", &Cell::regularity},
    CellFigure{"repetition", "1", "repetition of the pattern, perhaps after several unequal beats", &Cell::repetition},
    CellFigure{"variation", "1", "coefficient of variation of the intervals between beats", &Cell::variation},
    CellFigure{"intervals", "1", "number of intervals between beats", &Cell::intervals},
    CellFigure{"releases", "1", "number of sticks that ended in the judged time", &Cell::releases},
    CellFigure{"lag", "1", "beats per period of the pattern", &Cell::lag},
    CellFigure{"period", "s", "period of the pattern", &Cell::period},
    CellFigure{"frequency", "Hz", "dominant frequency of the alternation", &Cell::frequency},
    CellFigure{"joint_rms", "m/s", "root mean square velocity of the joint", &Cell::joint_rms},
    CellFigure{"joint_peak", "m/s", "peak velocity of the joint", &Cell::joint_peak},
    CellFigure{"joint_level", "dB re 1e-9 m/s", "velocity level of the joint", &Cell::joint_level},
    CellFigure{"plate_rms", "m/s", "root mean square velocity of the plate", &Cell::plate_rms},
    CellFigure{"plate_peak", "m/s", "peak velocity of the plate", &Cell::plate_peak},
    CellFigure{"plate_level", "dB re 1e-9 m/s", "velocity level of the plate", &Cell::plate_level},
    CellFigure{"growth_rate", "1/s", "largest growth rate of steady sliding; unstable above zero", &Cell::growth_rate},
    CellFigure{"mode_frequency", "Hz", "frequency of the mode with the largest growth rate", &Cell::mode_frequency},
    CellFigure{"energy_residual", "1", "energy the computation created or lost, as a share of the turnover",
               &Cell::energy_residual},
    CellFigure{"proof_time", "s", "time from which the rest of the motion was proven; none if it was simulated",
               &Cell::proof_time},
};

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

std::span<const CellFigure> cell_figures() {
    return figures;
}

const CellFigure* find_cell_figure(std::string_view name) {
    const auto found =
        std::find_if(figures.begin(), figures.end(), [&](const CellFigure& figure) { return figure.name == name; });
    return found == figures.end() ? nullptr : &*found;
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

std::vector<double> figure_values(const SweepResult& result, double Cell::*figure) {
    std::vector<double> values(result.cells.size(), Cell::unknown);
    result.computed->visit(0, values.size(),
                           [&](const IndexedCell& indexed) { values[indexed.index] = indexed.cell.*figure; });
    for (std::size_t index = 0; index < values.size(); ++index)
        values[index] = values[source_of(result, index)];
    return values;
}

CellPlace shown_place(const SweepResult& result, std::size_t index) {
    CellPlace place = place_of(result.study, index);
    place.start = result.cells[index].shown_start;
    return place;
}

}  // namespace stridor::sweep
