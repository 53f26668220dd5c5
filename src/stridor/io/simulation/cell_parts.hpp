#pragma once

// What documents and tables of several runs share. Private to this folder, as json_parts.hpp is.

#include "stridor/base/csv_text.hpp"
#include "stridor/io/json_parts.hpp"
#include "stridor/parameters/drive.hpp"
#include "stridor/sweep/cell.hpp"
#include "stridor/sweep/starts.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stridor::io::cell_parts {

/// Returns the word of a cell's verdict.
inline std::string_view word_of(const sweep::Cell& cell) {
    return sweep::word(cell);
}

/// Returns the name of a direction.
inline std::string name_of(parameters::Direction direction) {
    return std::string(parameters::direction_names[static_cast<std::size_t>(direction)]);
}

/// Returns a cell with its verdict and its figures.
inline base::Json cell_object(const sweep::Cell& cell) {
    base::Json object{{"verdict", word_of(cell)}, {"quiet_because", json_parts::quiet_word(cell.quiet)}};
    object["message"] = base::text_or_null(cell.message);
    base::Json figures = base::Json::object();
    for (const sweep::CellFigure& figure : sweep::cell_figures())
        figures[std::string(figure.name)] = sweep::figure_of(cell, figure);
    object["figures"] = std::move(figures);
    return object;
}

/// Adds a run's cells under the names of their directions.
inline void add_cells(base::Json& object, std::span<const parameters::Direction> directions,
                      std::span<const sweep::Cell> cells) {
    for (std::size_t d = 0; d < cells.size(); ++d)
        object[name_of(directions[d])] = cell_object(cells[d]);
}

/// Returns the units of all figures.
inline base::Json figure_units() {
    base::Json units = base::Json::object();
    for (const sweep::CellFigure& figure : sweep::cell_figures())
        units[std::string(figure.name)] = figure.unit;
    return units;
}

/// Adds the columns of a cell: direction, verdict, all figures.
inline void add_columns(std::vector<base::csv_text::TableColumn>& columns) {
    columns.push_back({"direction"});
    columns.push_back({"verdict"});
    for (const sweep::CellFigure& figure : sweep::cell_figures())
        columns.push_back({std::string(figure.name), std::string(figure.unit)});
}

/// Adds what stands in these columns.
inline void add_fields(base::csv_text::Table& table, parameters::Direction direction, const sweep::Cell& cell) {
    table.word(name_of(direction));
    table.word(word_of(cell));
    for (const sweep::CellFigure& figure : sweep::cell_figures())
        table.number(sweep::figure_of(cell, figure));
}

}  // namespace stridor::io::cell_parts
