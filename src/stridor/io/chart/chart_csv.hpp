#pragma once

#include "stridor/sweep/boundaries.hpp"
#include "stridor/sweep/cell.hpp"
#include "stridor/sweep/diagram.hpp"

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Tables as CSV text: a first line `# key: value | key: value ...` (schema, version, commit, title, the canonical text
/// of the case), a row of names with units ("gap [m]"; none for words and numbers without dimension), then numbers in
/// their shortest form that reads back as the same double. NaN is an empty field. Fields are quoted as RFC 4180 has it.
/// Nothing in it changes between two runs of the same case.
namespace stridor::io {

/// Takes the next piece of a text.
using Sink = std::function<void(std::string_view piece)>;

/// What stands in a chart's table.
struct ChartTableOptions {
    std::string file;  // the chart file's name in commands
    std::span<const sweep::CellFigure> figures = sweep::cell_figures();
};

/// "stridor.chart/1": a row per cell in index order (direction slowest, x fastest).
///
/// Columns: x, y, direction, status, category, slip, stick, separation, the other figures, source, of a chart with
/// starts agreement and one column per start, message, reproduce. Only done cells have a category, only those of them
/// that were computed figures; cells that are not done have in `reproduce` the command that runs them alone. The text
/// goes to the sink row by row: that of a large chart is too long to be held.
void chart_csv(const sweep::SweepResult& result, const ChartTableOptions& options, const Sink& sink);

/// "stridor.boundaries/1": a row per vertex of each line, in order.
std::string boundaries_csv(const sweep::Study& study, const std::vector<sweep::Boundary>& boundaries);

/// "stridor.diagram/1": a row per value of a diagram over one axis: x, direction, and either a local extreme of the
/// joint's displacement along the plate or an interval between beats, the other of the two being empty.
std::string diagram_csv(const sweep::Study& study, const std::vector<sweep::DiagramCell>& cells);

}  // namespace stridor::io
