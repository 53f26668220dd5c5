#include "stridor/io/simulation/followed_motion.hpp"

#include "stridor/base/csv_text.hpp"
#include "stridor/io/csv_opening.hpp"
#include "stridor/io/json_parts.hpp"
#include "stridor/io/simulation/cell_parts.hpp"
#include "stridor/parameters/fields/case_key.hpp"

#include <string_view>
#include <utility>
#include <vector>

namespace stridor::io {

namespace {

using namespace json_parts;
using sweep::FollowedRun;

std::string_view way_of_run(const FollowedRun& run) {
    return sweep::way_names[static_cast<std::size_t>(run.way)];
}

}  // namespace

std::string following_csv(const sweep::Following& following) {
    base::csv_text::Facts facts = csv_opening("following", following.base);
    add_lines(facts, parameters::canonical_text(following.base));
    std::vector<base::csv_text::TableColumn> columns{
        {"way"}, {following.over.key, std::string(parameters::unit_of(following.over.key))}};
    cell_parts::add_columns(columns);
    base::csv_text::Table table(facts, columns);
    for (const FollowedRun& run : following.runs)
        for (std::size_t d = 0; d < run.cells.size(); ++d) {
            table.word(way_of_run(run));
            table.number(run.value);
            cell_parts::add_fields(table, following.directions[d], run.cells[d]);
            table.end_row();
        }
    return table.take();
}

std::string following_json(const sweep::Following& following) {
    Json document = opening("following", following.base);
    document["title"] = base::text_or_null(following.base.title);
    document["over"] = {{"parameter", following.over.key},
                        {"unit", parameters::unit_of(following.over.key)},
                        {"from", following.over.from},
                        {"to", following.over.to},
                        {"points", following.over.points}};
    Json hysteresis = Json::object();
    for (std::size_t d = 0; d < following.directions.size(); ++d)
        hysteresis[cell_parts::name_of(following.directions[d])] = sweep::hysteresis(following, d);
    document["hysteresis"] = std::move(hysteresis);
    document["runs"] = array_of(following.runs, [&](const FollowedRun& run) {
        Json object{{"way", way_of_run(run)}, {"value", run.value}, {"continued", run.is_continued}};
        cell_parts::add_cells(object, following.directions, run.cells);
        return object;
    });
    document["units"] = cell_parts::figure_units();
    return base::text_of(document);
}

}  // namespace stridor::io
