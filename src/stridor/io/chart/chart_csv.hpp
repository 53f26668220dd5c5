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
/// of the case), a row of names with units ("gap [m]"; no unit for words and numbers without dimension), then numbers
/// in the shortest form that reads back as the same double. NaN is an empty field. Fields are quoted after RFC 4180.
/// Two runs of the same case give the same text.
namespace stridor::io {

/// Takes the next piece of a text.
using Sink = std::function<void(std::string_view piece)>;

/// The content of a chart's table.
struct ChartTableOptions {
    std::string file;  // the chart file's name in commands
    std::span<const sweep::CellFigure> figures = sweep::cell_figures();
};

/// Writes "stridor.chart/1": a row per cell in index order (direction slowest, x fastest).
///
/// Columns: x, y, direction, status, category, slip, stick, separation, the other figures, source; for a chart with
/// starts agreement and one column per start; message, reproduce. Only done cells have a category, and only computed
/// ones among them have figures. A cell that is not done has in `reproduce` the command that runs it alone. The text
/// goes to the sink row by row: that of a large chart is too long for memory.
void chart_csv(const sweep::SweepResult& result, const ChartTableOptions& options, const Sink& sink);

/// Returns "stridor.boundaries/1": a row per vertex of each line, in order.
std::string boundaries_csv(const sweep::Study& study, const std::vector<sweep::Boundary>& boundaries);

/// Returns "stridor.diagram/1": a row per value of a diagram over one axis: x, direction, and either a local extreme of
/// the joint's displacement along the plate or an interval between beats; the other one is empty.
std::string diagram_csv(const sweep::Study& study, const std::vector<sweep::DiagramCell>& cells);

}  // namespace stridor::io
