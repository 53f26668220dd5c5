#include "stridor/io/chart/chart_csv.hpp"

#include "stridor/base/csv_text.hpp"
#include "stridor/io/csv_opening.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/sweep/starts.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace stridor::io {

using base::csv_text::Facts;
using base::csv_text::Table;
using base::csv_text::TableColumn;

namespace {

// slip, stick and separation stand first, whatever the order of the table
std::vector<sweep::CellFigure> figures_in_order(std::span<const sweep::CellFigure> wanted) {
    constexpr std::array<std::string_view, 3> first{"slip", "stick", "separation"};
    std::vector<sweep::CellFigure> figures(wanted.begin(), wanted.end());
    const auto rank = [&](const sweep::CellFigure& figure) {
        return std::find(first.begin(), first.end(), figure.name) - first.begin();
    };
    std::stable_sort(figures.begin(), figures.end(), [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
    return figures;
}

std::vector<TableColumn> chart_columns(const sweep::Study& study, const std::vector<sweep::CellFigure>& figures) {
    std::vector<TableColumn> columns{{"x", std::string(parameters::unit_of(study.x.parameter))},
                                     {"y", std::string(parameters::unit_of(study.y.parameter))},
                                     {"direction"},
                                     {"status"},
                                     {"category"}};
    for (const sweep::CellFigure& figure : figures)
        columns.push_back({std::string(figure.name), std::string(figure.unit)});
    columns.push_back({"quiet_because"});
    columns.push_back({"source"});
    if (!study.starts.empty()) columns.push_back({"agreement"});
    for (const parameters::Initial start : study.starts)
        columns.push_back({"start_" + std::string(sweep::start_names()[static_cast<std::size_t>(start)])});
    columns.push_back({"message"});
    columns.push_back({"reproduce"});
    return columns;
}

Facts chart_opening(std::string_view what, const sweep::Study& study) {
    Facts facts = csv_opening(what, study.base);
    facts.emplace_back("x", study.x.parameter);
    facts.emplace_back("y", study.y.parameter);
    add_lines(facts, sweep::canonical_text(study));
    return facts;
}

/// The rows of a chart.
class ChartTable {
public:
    ChartTable(const sweep::SweepResult& result, const ChartTableOptions& options, const Sink& sink)
        : result_(result),
          file_(options.file),
          sink_(sink),
          figures_(figures_in_order(options.figures)) {
        sink_(table_.take());
    }

    // `cell` is what was computed there; of an inferred cell only the verdict is known
    void row(std::size_t index, const sweep::Cell& cell) {
        const sweep::Study& study = result_.study;
        const sweep::CellVerdict& verdict = result_.cells[index];
        const sweep::CellPlace place = sweep::place_of(study, index);
        const bool is_done = verdict.status == sweep::Status::done;
        table_.number(sweep::value_at(study.x, place.ix));
        table_.number(sweep::value_at(study.y, place.iy));
        table_.word(parameters::direction_names[static_cast<std::size_t>(study.directions[place.direction])]);
        table_.word(sweep::status_names[static_cast<std::size_t>(verdict.status)]);
        table_.word(is_done ? classification::name(verdict.category) : std::string_view());
        for (const sweep::CellFigure& figure : figures_)
            table_.number(figure_of(cell, figure));
        const bool is_quiet = verdict.quiet != classification::Quiet::no;
        table_.word(is_quiet ? classification::name(verdict.quiet) : std::string_view());
        table_.word(sweep::source_names[sweep::is_inferred(result_, index) ? 1 : 0]);
        if (!study.starts.empty()) table_.word(sweep::agreement_names[static_cast<std::size_t>(verdict.agreement)]);
        for (std::size_t start = 0; start < study.starts.size(); ++start)
            table_.word(start < cell.starts.size() ? sweep::word(cell.starts[start]) : std::string_view());
        table_.word(cell.message);
        table_.word(is_done ? std::string()
                            : sweep::reproduce_command(study, sweep::shown_place(result_, index), file_));
        table_.end_row();
        sink_(table_.take());
    }

private:
    const sweep::SweepResult& result_;
    const std::string& file_;
    const Sink& sink_;
    std::vector<sweep::CellFigure> figures_;
    Table table_{chart_opening("chart", result_.study), chart_columns(result_.study, figures_)};
};

}  // namespace

void chart_csv(const sweep::SweepResult& result, const ChartTableOptions& options, const Sink& sink) {
    ChartTable table(result, options, sink);
    std::size_t next = 0;
    const auto put_inferred_until = [&](std::size_t end) {
        for (; next < end; ++next)
            table.row(next, sweep::Cell{});
    };
    result.computed->visit_figures(0, result.cells.size(), options.figures, [&](const sweep::IndexedCell& computed) {
        put_inferred_until(computed.index);
        table.row(next++, computed.cell);
    });
    put_inferred_until(result.cells.size());
}

std::string boundaries_csv(const sweep::Study& study, const std::vector<sweep::Boundary>& boundaries) {
    const std::string x_unit(parameters::unit_of(study.x.parameter));
    const std::string y_unit(parameters::unit_of(study.y.parameter));
    Table table(chart_opening("boundaries", study), {{"line"},
                                                     {"direction"},
                                                     {"first"},
                                                     {"second"},
                                                     {"form"},
                                                     {"x", x_unit},
                                                     {"y", y_unit},
                                                     {"x_resolution", x_unit},
                                                     {"y_resolution", y_unit}});
    for (std::size_t line = 0; line < boundaries.size(); ++line) {
        const sweep::Boundary& boundary = boundaries[line];
        for (const sweep::BoundaryVertex& vertex : boundary.vertices) {
            table.number(static_cast<double>(line));
            table.word(parameters::direction_names[static_cast<std::size_t>(study.directions[boundary.direction])]);
            table.word(boundary.first);
            table.word(boundary.second);
            table.word(sweep::line_form_names[static_cast<std::size_t>(boundary.form)]);
            for (const double value : {vertex.x, vertex.y, vertex.x_resolution, vertex.y_resolution})
                table.number(value);
            table.end_row();
        }
    }
    return table.take();
}

std::string diagram_csv(const sweep::Study& study, const std::vector<sweep::DiagramCell>& cells) {
    Table table(chart_opening("diagram", study), {{"x", std::string(parameters::unit_of(study.x.parameter))},
                                                  {"direction"},
                                                  {"extreme", "m"},
                                                  {"interval", "s"}});
    for (std::size_t index = 0; index < cells.size(); ++index) {
        const sweep::CellPlace place = sweep::place_of(study, index);
        const auto row = [&](double extreme, double interval) {
            table.number(sweep::value_at(study.x, place.ix));
            table.word(parameters::direction_names[static_cast<std::size_t>(study.directions[place.direction])]);
            table.number(extreme);
            table.number(interval);
            table.end_row();
        };
        for (const double value : cells[index].extremes)
            row(value, sweep::Cell::unknown);
        for (const double value : cells[index].intervals)
            row(sweep::Cell::unknown, value);
    }
    return table.take();
}

}  // namespace stridor::io
