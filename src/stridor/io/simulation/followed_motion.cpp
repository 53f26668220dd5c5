#include "stridor/io/simulation/followed_motion.hpp"

#include "stridor/base/csv_text.hpp"
#include "stridor/io/csv_opening.hpp"
#include "stridor/io/json_parts.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/sweep/starts.hpp"

#include <string_view>
#include <utility>
#include <vector>

namespace stridor::io {

namespace {

using namespace json_parts;
using sweep::Cell;
using sweep::FollowedRun;

std::string_view word_of(const Cell& cell) {
    return sweep::word({cell.status, cell.category, cell.quiet});
}

std::string_view way_of_run(const FollowedRun& run) {
    return sweep::way_names[static_cast<std::size_t>(run.way)];
}

Json cell_object(const Cell& cell) {
    Json object{{"verdict", word_of(cell)}, {"quiet_because", quiet_word(cell.quiet)}};
    object["message"] = base::text_or_null(cell.message);
    Json figures = Json::object();
    for (const sweep::CellFigure& figure : sweep::cell_figures())
        figures[std::string(figure.name)] = sweep::figure_of(cell, figure);
    object["figures"] = std::move(figures);
    return object;
}

}  // namespace

std::string following_csv(const sweep::Following& following) {
    base::csv_text::Facts facts = csv_opening("following", following.base);
    add_lines(facts, parameters::canonical_text(following.base));
    std::vector<base::csv_text::TableColumn> columns{
        {"way"},
        {following.over.key, std::string(parameters::unit_of(following.over.key))},
        {"direction"},
        {"verdict"}};
    for (const sweep::CellFigure& figure : sweep::cell_figures())
        columns.push_back({std::string(figure.name), std::string(figure.unit)});
    base::csv_text::Table table(facts, columns);
    for (const FollowedRun& run : following.runs)
        for (std::size_t d = 0; d < run.cells.size(); ++d) {
            table.word(way_of_run(run));
            table.number(run.value);
            table.word(parameters::direction_names[static_cast<std::size_t>(following.directions[d])]);
            table.word(word_of(run.cells[d]));
            for (const sweep::CellFigure& figure : sweep::cell_figures())
                table.number(sweep::figure_of(run.cells[d], figure));
            table.end_row();
        }
    return table.take();
}

std::string following_json(const sweep::Following& following) {
    Json document = opening("following");
    document["title"] = base::text_or_null(following.base.title);
    document["over"] = {{"parameter", following.over.key},
                        {"unit", parameters::unit_of(following.over.key)},
                        {"from", following.over.from},
                        {"to", following.over.to},
                        {"points", following.over.points}};
    Json hysteresis = Json::object();
    for (std::size_t d = 0; d < following.directions.size(); ++d)
        hysteresis[std::string(parameters::direction_names[static_cast<std::size_t>(following.directions[d])])] =
            sweep::hysteresis(following, d);
    document["hysteresis"] = std::move(hysteresis);
    document["runs"] = array_of(following.runs, [&](const FollowedRun& run) {
        Json object{{"way", way_of_run(run)}, {"value", run.value}, {"continued", run.is_continued}};
        for (std::size_t d = 0; d < run.cells.size(); ++d)
            object[std::string(parameters::direction_names[static_cast<std::size_t>(following.directions[d])])] =
                cell_object(run.cells[d]);
        return object;
    });
    Json units = Json::object();
    for (const sweep::CellFigure& figure : sweep::cell_figures())
        units[std::string(figure.name)] = figure.unit;
    document["units"] = std::move(units);
    return base::text_of(document);
}

}  // namespace stridor::io
