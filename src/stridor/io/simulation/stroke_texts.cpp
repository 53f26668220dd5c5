#include "stridor/io/simulation/stroke_texts.hpp"

#include "stridor/base/csv_text.hpp"
#include "stridor/io/csv_opening.hpp"
#include "stridor/io/json_parts.hpp"
#include "stridor/io/simulation/cell_parts.hpp"
#include "stridor/parameters/fields/case_key.hpp"

#include <array>
#include <string_view>
#include <utility>
#include <vector>

namespace stridor::io {

namespace {

using namespace json_parts;
using sweep::ComputedStroke;
using sweep::StrokeHistory;

// a number of a stroke, as it stands in both
struct StrokeFigure {
    std::string_view name;
    std::string_view unit;
    double ComputedStroke::*value;
};

constexpr std::array stroke_figures{StrokeFigure{"temperature", "degC", &ComputedStroke::temperature},
                                    StrokeFigure{"worn_depth", "m", &ComputedStroke::worn_depth},
                                    StrokeFigure{"preload_share", "1", &ComputedStroke::preload_share},
                                    StrokeFigure{"friction_power", "W", &ComputedStroke::friction_power}};

Json stroke_object(const StrokeHistory& history, const ComputedStroke& stroke) {
    Json object{{"number", stroke.number}};
    for (const StrokeFigure& figure : stroke_figures)
        object[std::string(figure.name)] = stroke.*figure.value;
    cell_parts::add_cells(object, history.directions, stroke.cells);
    return object;
}

Json plan_object(const sweep::StrokePlan& plan) {
    Json object{{"strokes", plan.strokes}, {"duration", plan.duration}, {"pause", plan.pause}};
    object["heating"] = nullptr;
    if (plan.heating) object["heating"] = {{"resistance", plan.heating->resistance}, {"time", plan.heating->time}};
    object["wear"] = nullptr;
    if (plan.wear)
        object["wear"] = {
            {"rate", plan.wear->rate}, {"area", plan.wear->area}, {"interference", plan.wear->interference}};
    return object;
}

Json stretches_object(const StrokeHistory& history) {
    Json object = Json::object();
    for (std::size_t d = 0; d < history.directions.size(); ++d)
        object[cell_parts::name_of(history.directions[d])] =
            array_of(sweep::stretches_of(history, d), [&](const sweep::StrokeStretch& stretch) {
                const ComputedStroke& first = history.strokes[stretch.first];
                return Json{{"from", first.number},
                            {"to", history.strokes[stretch.last].number},
                            {"verdict", cell_parts::word_of(first.cells[d])}};
            });
    return object;
}

}  // namespace

std::string strokes_csv(const StrokeHistory& history) {
    base::csv_text::Facts facts = csv_opening("strokes", history.base);
    add_lines(facts, parameters::canonical_text(history.base));
    std::vector<base::csv_text::TableColumn> columns{{"stroke", "1"}};
    for (const StrokeFigure& figure : stroke_figures)
        columns.push_back({std::string(figure.name), std::string(figure.unit)});
    cell_parts::add_columns(columns);
    base::csv_text::Table table(facts, columns);
    for (const ComputedStroke& stroke : history.strokes)
        for (std::size_t d = 0; d < stroke.cells.size(); ++d) {
            table.number(static_cast<double>(stroke.number));
            for (const StrokeFigure& figure : stroke_figures)
                table.number(stroke.*figure.value);
            cell_parts::add_fields(table, history.directions[d], stroke.cells[d]);
            table.end_row();
        }
    return table.take();
}

std::string strokes_json(const StrokeHistory& history) {
    Json document = opening("strokes", history.base);
    document["title"] = base::text_or_null(history.base.title);
    document["plan"] = plan_object(history.plan);
    document["stretches"] = stretches_object(history);
    document["ended"] = base::text_or_null(history.ended);
    document["strokes"] =
        array_of(history.strokes, [&](const ComputedStroke& stroke) { return stroke_object(history, stroke); });
    Json units = cell_parts::figure_units();
    for (const StrokeFigure& figure : stroke_figures)
        units[std::string(figure.name)] = figure.unit;
    document["units"] = std::move(units);
    return base::text_of(document);
}

}  // namespace stridor::io
