#pragma once

#include "stridor/analysis/evidence.hpp"
#include "stridor/classification/verdict.hpp"
#include "stridor/sweep/study.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::analysis {
struct SlidingStability;
}
namespace stridor::integration {
struct Motion;
}

namespace stridor::sweep {

/// One number of a cell. The content of a cell, the store's columns, CSV, netCDF, JSON and the quantities that a chart
/// can draw all come from this table: the figures of the evidence (analysis/evidence), then those of the run.
struct CellFigure {
    std::string_view name;      // a word of lower-case letters, digits and underscores
    std::string_view unit;      // "1", "Hz", "dB re 1e-9 m/s"
    std::string_view sentence;  // for attributes and colour bars
    std::size_t place = 0;      // in `Cell::figures`
};

/// Returns all figures, in the order of files.
std::span<const CellFigure> cell_figures();

/// Returns the figure with this name, or null if there is none.
const CellFigure* find_cell_figure(std::string_view name);

/// Returns the figure with a name that must be one.
const CellFigure& cell_figure(std::string_view name);

/// The source of a cell's figures.
struct JudgedRun {
    const analysis::Evidence& evidence;           // of the cell's direction
    const analysis::SlidingStability& stability;  // of the cell's direction
    const integration::Motion& motion;
};

/// Returns the values of all figures, shape [figure].
std::vector<double> figures_of(const JudgedRun& run);

/// How a cell ended. Only a done cell has figures; the others are drawn hatched and never guessed.
enum class Status : std::uint8_t {
    done,
    invalid,     // the axes' values contradict each other there (mu_d > mu_s)
    step_limit,  // the time step is unstable there
    diverged,    // a number left double precision
    failed,      // no valid start or contact forces exist (sprag-slip, Painleve)
};

inline constexpr std::array<std::string_view, 5> status_names{"done", "invalid", "step_limit", "diverged", "failed"};

/// Whether the starts of a cell lead to the same verdict.
enum class Agreement : std::uint8_t {
    agree,                   // they do, or there is one start only
    differ,                  // to different ones, but not to quiet and noise
    quiet_unless_disturbed,  // one to none, another to a noise: what is heard depends on the start
};

inline constexpr std::array<std::string_view, 3> agreement_names{"agree", "differ", "quiet_unless_disturbed"};

/// The verdict that one start of a cell led to.
struct StartVerdict {
    Status status = Status::failed;
    classification::Category category = classification::Category::undecided;  // meaningless unless done
    classification::Quiet quiet = classification::Quiet::no;                  // why, if the category is none
    bool operator==(const StartVerdict&) const = default;
};

/// The kept result of one cell in one direction.
struct Cell {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    Status status = Status::failed;
    classification::Category category = classification::Category::undecided;  // meaningless unless done
    classification::Quiet quiet = classification::Quiet::no;                  // why, if the category is none
    std::string message;               // why it is not done, or done and undecided; empty otherwise
    std::vector<StartVerdict> starts;  // by study.starts; empty if it has none, or the cell was inferred
    Agreement agreement = Agreement::agree;
    std::vector<double> figures;  // by `cell_figures`; empty unless done
};

/// Returns a figure of a cell, in its unit; `Cell::unknown` if the cell has none.
double figure_of(const Cell& cell, const CellFigure& figure);

/// Returns the figure of a cell with this name, which must be that of a figure.
double figure_of(const Cell& cell, std::string_view name);

/// Puts a figure into a cell, in its unit.
void set_figure(Cell& cell, const CellFigure& figure, double value);

/// A computed cell with its index in the study.
struct IndexedCell {
    std::size_t index = 0;
    Cell cell;
};

/// The computed cells of a sweep, in memory or in a file: those of a large chart do not fit into memory.
class ComputedCells {
public:
    virtual ~ComputedCells() = default;

    /// Shows the cells with first <= index < last, in index order, one at a time.
    virtual void visit(std::size_t first, std::size_t last, const std::function<void(IndexedCell&)>& use) = 0;

    /// Shows these cells to a caller that reads only these figures: the others may be missing. Reading few of them from
    /// a file is several times as fast.
    virtual void visit_figures(std::size_t first, std::size_t last, std::span<const CellFigure> figures,
                               const std::function<void(IndexedCell&)>& use);
};

/// Returns cells kept in memory; they must be in index order.
std::shared_ptr<ComputedCells> in_memory(std::vector<IndexedCell> cells);

/// The verdict on a cell of a chart, computed or inferred.
struct CellVerdict {
    Status status = Status::failed;
    classification::Category category = classification::Category::undecided;  // meaningless unless done
    classification::Quiet quiet = classification::Quiet::no;                  // why, if the category is none
    Agreement agreement = Agreement::agree;
    std::uint8_t shown_start = 0;  // the start of this verdict, into study.starts; 0 if there are none
};

/// Returns the verdict that a chart shows of a cell.
CellVerdict verdict_of(const Cell& cell);

/// The index of a cell in lists with one entry for each cell (`most_cells`).
using CellIndex = std::uint32_t;

/// A finished sweep; cells in index order (see `place_of`).
struct SweepResult {
    Study study;
    std::vector<CellVerdict> cells;
    std::vector<CellIndex> sources{};           // the computed cell of each, itself unless inferred; empty: itself
    std::shared_ptr<ComputedCells> computed{};  // with their figures
};

/// Returns a sweep with every cell computed, kept in memory; shape [cell].
SweepResult complete(Study study, std::vector<Cell> cells);

/// Returns the computed cell from which a cell was inferred; the cell itself if it was computed.
std::size_t source_of(const SweepResult& result, std::size_t index);

/// The source of a cell's verdict: 0 computed, 1 inferred.
inline constexpr std::array<std::string_view, 2> source_names{"computed", "inferred"};

/// Says whether the cell was inferred from its neighbours (`refine`). It then has a status and a category, and no
/// figures.
bool is_inferred(const SweepResult& result, std::size_t index);

/// Returns the number of cells that were not inferred.
std::size_t computed_count(const SweepResult& result);

/// Returns the cell at an index, which must not be inferred.
Cell computed_cell(const SweepResult& result, std::size_t index);

/// Returns one figure of every cell; for an inferred cell, that of its computed cell; shape [cell].
std::vector<double> figure_values(const SweepResult& result, const CellFigure& figure);

/// Returns the place of a cell with the start that it shows.
CellPlace shown_place(const SweepResult& result, std::size_t index);

/// Throws `Error` (input, numerical) if no cell has a result, with the reason of the first.
void require_result(const SweepResult& result);

}  // namespace stridor::sweep
