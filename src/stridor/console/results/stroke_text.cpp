#include "stridor/console/results/stroke_text.hpp"

#include "stridor/console/results/text_table.hpp"
#include "stridor/sweep/starts.hpp"

#include <fmt/format.h>

#include <vector>

namespace stridor::console {

namespace {

using sweep::ComputedStroke;
using sweep::StrokeHistory;

// "10", "10-30"
std::string from_to(double from, double to, double scale) {
    const std::string first = fmt::format("{:.4g}", scale * from), last = fmt::format("{:.4g}", scale * to);
    return first == last ? first : first + " to " + last;
}

std::string plan_text(const sweep::StrokePlan& plan) {
    std::string text = fmt::format("{} strokes of {:g} s", plan.strokes, plan.duration);
    if (plan.pause > 0.0) text += fmt::format(", {:g} s apart", plan.pause);
    text += "\n";
    if (plan.heating)
        text += fmt::format("heat: {:g} degC for each watt that lasts, with a time constant of {:g} s\n",
                            plan.heating->resistance, plan.heating->time);
    if (plan.wear)
        text += fmt::format("wear: {:g} mm^3 for each joule from {:g} mm^2; nothing presses after {:g} mm\n",
                            1e9 * plan.wear->rate, 1e6 * plan.wear->area, 1e3 * plan.wear->interference);
    return text;
}

TextTable empty_table(const sweep::StrokePlan& plan) {
    TextTable table{{left("direction"), right("from stroke"), right("to"), left("verdict"), left("friction [W]")}};
    if (plan.heating) table.columns.push_back(left("temperature [degC]"));
    if (plan.wear) {
        table.columns.push_back(left("preload [%]"));
        table.columns.push_back(left("worn [um]"));
    }
    return table;
}

void add_stretches(TextTable& table, const StrokeHistory& history, std::size_t direction) {
    for (const sweep::StrokeStretch& stretch : sweep::stretches_of(history, direction)) {
        const ComputedStroke &first = history.strokes[stretch.first], &last = history.strokes[stretch.last];
        const sweep::Cell& cell = first.cells[direction];
        std::vector<std::string> row{
            std::string(parameters::direction_names[static_cast<std::size_t>(history.directions[direction])]),
            std::to_string(first.number), std::to_string(last.number), std::string(sweep::word(cell)),
            from_to(first.friction_power, last.friction_power, 1.0)};
        if (history.plan.heating) row.push_back(from_to(first.temperature, last.temperature, 1.0));
        if (history.plan.wear) {
            row.push_back(from_to(first.preload_share, last.preload_share, 100.0));
            row.push_back(from_to(first.worn_depth, last.worn_depth, 1e6));
        }
        table.rows.push_back(std::move(row));
    }
}

}  // namespace

std::string stroke_text(const StrokeHistory& history) {
    TextTable table = empty_table(history.plan);
    for (std::size_t d = 0; d < history.directions.size(); ++d)
        add_stretches(table, history, d);
    std::string text = plan_text(history.plan) + "\n" + text_of(table) + "\n";
    text += counted(history.strokes.size(), "stroke was run", "strokes were run") +
            "; each of the others lies between two with the same verdict\n";
    if (!history.ended.empty()) text += "ended before its last stroke: " + history.ended + "\n";
    return text;
}

}  // namespace stridor::console
