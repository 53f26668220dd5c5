#include "stridor/chart/field_axis.hpp"

#include "stridor/base/check.hpp"
#include "stridor/parameters/field_name.hpp"
#include "stridor/parameters/temperature_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace stridor::chart {

namespace {

std::string spelled(std::string_view name) {
    std::string words(name);
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
}

Text value_of(const parameters::Case& c, const parameters::Field& field) {
    if (const auto* quantity = std::get_if<parameters::Quantity>(&field.kind)) {
        const Text unit = unit_text(quantity->unit);
        const Text value = number_text(quantity->get(c));
        if (is_empty(unit)) return value;
        return value + (quantity->unit == "deg" ? Text() : Text(" ")) + unit;
    }
    return Text(spelled(parameters::value_text(c, field)));
}

// "k1i, μd over θ by table"
Text followers(const parameters::Case& c) {
    Text names;
    for (const parameters::TemperatureColumn& column : c.temperature.columns)
        names = (is_empty(names) ? names : names + ", ") + symbol(parameters::find_field(column.key)->symbol);
    return names + " over " + symbol(parameters::find_field("temperature.value")->symbol) + " by table";
}

}  // namespace

std::vector<double> cell_edges(const sweep::Axis& axis) {
    STRIDOR_EXPECT(axis.points >= 2);
    const bool is_linear = axis.scale == sweep::Scale::linear;
    const auto between = [&](double a, double b) { return is_linear ? 0.5 * (a + b) : std::sqrt(a * b); };
    // the value as far beyond `end` as `next` lies before it
    const auto mirrored = [&](double end, double next) { return is_linear ? 2.0 * end - next : end * end / next; };
    const int last = axis.points - 1;
    std::vector<double> edges;
    double before = mirrored(sweep::value_at(axis, 0), sweep::value_at(axis, 1));
    for (int i = 0; i <= last; ++i) {
        const double value = sweep::value_at(axis, i);
        edges.push_back(between(before, value));
        before = value;
    }
    edges.push_back(between(before, mirrored(before, sweep::value_at(axis, last - 1))));
    if (edges.front() > edges.back()) std::reverse(edges.begin(), edges.end());
    return edges;
}

Axis field_axis(const sweep::Axis& axis) {
    Axis result;
    if (const parameters::Field* field = parameters::find_field(axis.parameter)) {
        result.label = field_label(*field);
        if (const auto* quantity = std::get_if<parameters::Quantity>(&field->kind)) result.unit = quantity->unit;
    }
    result.scale = axis.scale == sweep::Scale::linear ? AxisScale::linear : AxisScale::logarithmic;
    const std::vector<double> edges = cell_edges(axis);
    result.range = {edges.front(), edges.back()};
    return result;
}

Text field_label(const parameters::Field& field) {
    const Text name(spelled(parameters::short_name(field)));
    return field.symbol.empty() ? name : name + " " + symbol(field.symbol);
}

Text setting(const parameters::Case& c, std::string_view key) {
    const parameters::Field* field = parameters::find_field(key);
    STRIDOR_EXPECT(field != nullptr);
    const Text name = field->symbol.empty() ? Text(spelled(parameters::short_name(*field))) : symbol(field->symbol);
    return name + " = " + value_of(c, *field);
}

Text settings(const parameters::Case& c, std::span<const std::string_view> keys) {
    Text row;
    for (const std::string_view key : keys) {
        const parameters::Field* field = parameters::find_field(key);
        STRIDOR_EXPECT(field != nullptr);
        if (field->belongs(c)) row = is_empty(row) ? setting(c, key) : row + ", " + setting(c, key);
    }
    return row;
}

Text conditions(const parameters::Case& c, std::span<const std::string_view> varied) {
    constexpr std::array<std::string_view, 11> telling{"joint.incidence_angle",
                                                       "contact.preload",
                                                       "contact.static_friction",
                                                       "contact.kinetic_friction",
                                                       "temperature.value",
                                                       "drive.amplitude",
                                                       "drive.frequency",
                                                       "drive.velocity",
                                                       "run.duration",
                                                       "run.initial",
                                                       "run.step"};
    const auto varies = [&](std::string_view key) {
        return std::find(varied.begin(), varied.end(), key) != varied.end();
    };
    // what follows an axis has no one value
    const bool is_temperature_varied = varies("temperature.value");
    std::vector<std::string_view> kept;
    for (const std::string_view key : telling)
        if (!varies(key) && !(is_temperature_varied && parameters::temperature_column(c, key) != nullptr))
            kept.push_back(key);
    const Text row = settings(c, kept);
    if (!is_temperature_varied || !parameters::has_temperature_table(c)) return row;
    return (is_empty(row) ? row : row + "; ") + followers(c);
}

Text lettered(std::size_t panel, const Text& title) {
    const char letter = static_cast<char>('a' + panel % 26);
    return Text(std::string(1, letter) + ")", TextStyle::bold) + " " + title;
}

}  // namespace stridor::chart
