#include "stridor/pictures/sensitivity.hpp"

#include "stridor/drawing/palette.hpp"
#include "stridor/pictures/parts/category_colours.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stridor::pictures {

namespace {

using noise_library::CategoryRange;
using noise_library::Observation;
using noise_library::RankCorrelation;
using noise_library::Sensitivity;

constexpr double diameter = 4.4;    // [pt] of a record
constexpr double row_share = 0.16;  // height of a row of categories over that of another panel
constexpr double log_from = 20.0;   // ratio of the ends from which an axis is logarithmic

std::string name_of(const CategoryRange& category) {
    return category.category.empty() ? "unknown" : category.category;
}

// of the five categories their own colours, of an engineer's words others
drawing::Points points_of(const CategoryRange& category, std::size_t number) {
    constexpr drawing::Mark marks[] = {drawing::Mark::disc, drawing::Mark::square, drawing::Mark::triangle,
                                       drawing::Mark::diamond, drawing::Mark::nabla};
    constexpr drawing::Colour others[] = {drawing::accent, {0xC4, 0x6A, 0x00}, {0x7B, 0x3F, 0x8C}, {0x5A, 0x5A, 0x5A}};
    drawing::Points points{{},          {},           others[number % std::size(others)],
                           diameter,    std::nullopt, marks[number % std::size(marks)],
                           drawing::ink};
    const auto& names = classification::category_names;
    const auto found = std::find(names.begin(), names.end(), category.category);
    if (found == names.end()) return points;
    const auto index = static_cast<std::size_t>(found - names.begin());
    points.colour = category_fill(static_cast<classification::Category>(index)).colour;
    points.mark = marks[index];
    return points;
}

// the values a panel shows, with some air around them
drawing::PanelAxis axis_over(const std::vector<double>& values) {
    drawing::PanelAxis axis;
    double low = 0.0;
    double high = 0.0;
    bool is_first = true;
    for (const double value : values) {
        if (std::isnan(value)) continue;
        low = is_first ? value : std::min(low, value);
        high = is_first ? value : std::max(high, value);
        is_first = false;
    }
    if (low > 0.0 && high / low >= log_from) {
        axis.scale = drawing::AxisScale::logarithmic;
        axis.range = {low / 1.15, high * 1.15};
        return axis;
    }
    const double air = high > low ? 0.06 * (high - low) : std::max(1.0, 0.1 * std::abs(high));
    axis.range = {low - air, high + air};
    return axis;
}

std::vector<double> values_of(const std::vector<Observation>& records, double Observation::*member) {
    std::vector<double> values;
    for (const Observation& record : records)
        values.push_back(record.*member);
    return values;
}

// records of one value beside each other rather than one on top of the other: shares of a row from -0.5 to 0.5
std::vector<double> spread(const std::vector<double>& values) {
    std::vector<double> shares;
    for (std::size_t from = 0; from < values.size();) {
        std::size_t to = from + 1;
        while (to < values.size() && values[to] == values[from])
            ++to;
        const auto count = static_cast<double>(to - from);
        for (std::size_t k = from; k < to; ++k)
            shares.push_back((static_cast<double>(k - from) + 0.5) / count - 0.5);
        from = to;
    }
    return shares;
}

drawing::Panel category_panel(const Sensitivity& sensitivity) {
    drawing::Panel panel;
    panel.grid = drawing::Grid::both;
    panel.y.label = "category";
    const auto rows = static_cast<double>(sensitivity.categories.size());
    panel.y.range = {0.0, std::max(1.0, rows)};
    for (std::size_t k = 0; k < sensitivity.categories.size(); ++k) {
        const double row = static_cast<double>(k) + 0.5;
        drawing::Points points = points_of(sensitivity.categories[k], k);
        for (const Observation& record : sensitivity.records)
            if (record.category == sensitivity.categories[k].category) points.x.push_back(record.quantity);
        for (const double share : spread(points.x))
            points.y.push_back(row + 0.6 * share);
        panel.layers.emplace_back(std::move(points));
        panel.y.ticks.push_back({row, name_of(sensitivity.categories[k]), drawing::TickSize::major});
    }
    return panel;
}

drawing::Panel figure_panel(const Sensitivity& sensitivity, double Observation::*member) {
    drawing::Panel panel;
    panel.grid = drawing::Grid::both;
    panel.y = axis_over(values_of(sensitivity.records, member));
    for (std::size_t k = 0; k < sensitivity.categories.size(); ++k) {
        drawing::Points points = points_of(sensitivity.categories[k], k);
        for (const Observation& record : sensitivity.records)
            if (record.category == sensitivity.categories[k].category) {
                points.x.push_back(record.quantity);
                points.y.push_back(record.*member);
            }
        panel.layers.emplace_back(std::move(points));
    }
    return panel;
}

// "Spearman's rank correlation 0.83 (12 records, p = 0.0008)."
std::string words_on(const char* what, const RankCorrelation& correlation) {
    if (std::isnan(correlation.coefficient)) return "";
    return fmt::format(" {}: Spearman's rank correlation {:.2f} ({} records, p = {:.2g}).", what,
                       correlation.coefficient, correlation.records, correlation.p_value);
}

bool has_any(const std::vector<Observation>& records, double Observation::*member) {
    return std::any_of(records.begin(), records.end(),
                       [&](const Observation& record) { return !std::isnan(record.*member); });
}

}  // namespace

drawing::Scene sensitivity(const Sensitivity& sensitivity) {
    drawing::Scene scene;
    std::string quantity = sensitivity.quantity;
    std::replace(quantity.begin(), quantity.end(), '_', ' ');
    scene.title = "Sensitivity to " + quantity;
    scene.caption = {drawing::StyledText(fmt::format("Each mark is a record; {} in all.{}{}",
                                                     sensitivity.records.size(), words_on("Level", sensitivity.level),
                                                     words_on("Dominant frequency", sensitivity.frequency)))};
    scene.panels.push_back(category_panel(sensitivity));
    scene.row_heights = {row_share * static_cast<double>(std::max<std::size_t>(2, sensitivity.categories.size()))};
    if (has_any(sensitivity.records, &Observation::level)) {
        scene.panels.push_back(figure_panel(sensitivity, &Observation::level));
        scene.panels.back().y.label = "level";
        scene.panels.back().y.unit = sensitivity.level_unit;
        scene.row_heights.push_back(1.0);
    }
    if (has_any(sensitivity.records, &Observation::frequency)) {
        scene.panels.push_back(figure_panel(sensitivity, &Observation::frequency));
        scene.panels.back().y.label = "dominant frequency";
        scene.panels.back().y.unit = "Hz";
        scene.row_heights.push_back(1.0);
    }
    const drawing::PanelAxis x = axis_over(values_of(sensitivity.records, &Observation::quantity));
    for (std::size_t row = 0; row < scene.panels.size(); ++row) {
        drawing::Panel& panel = scene.panels[row];
        panel.row = row;
        panel.x = x;
        panel.x.label = quantity;
        panel.x.unit = sensitivity.unit;
        if (row + 1 < scene.panels.size()) panel.x.text = drawing::AxisText::hidden;
    }
    for (std::size_t k = 0; k < sensitivity.categories.size(); ++k)
        scene.legend.push_back({name_of(sensitivity.categories[k]), points_of(sensitivity.categories[k], k)});
    scene.width = 120.0;
    scene.height = 45.0 + 45.0 * static_cast<double>(scene.panels.size() - 1);
    return scene;
}

}  // namespace stridor::pictures
