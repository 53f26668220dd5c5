#include "stridor/pictures/parts/field_axis.hpp"

#include "stridor/base/check.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/fields/field_name.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/tables/material_pair.hpp"
#include "stridor/parameters/tables/temperature_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace stridor::pictures {

namespace {

drawing::StyledText value_of(const parameters::Case& c, std::string_view key) {
    const parameters::Field& field = *parameters::field_of(key);
    if (!parameters::has_one_value(c, key)) return drawing::StyledText(parameters::value_text(c, key));
    if (const auto* quantity = std::get_if<parameters::Quantity>(&field.kind))
        return with_unit(drawing::number_text(parameters::get_quantity(c, key)), quantity->unit);
    return drawing::StyledText(spelled(parameters::value_text(c, key)));
}

// "lip2: " of one of several joints
drawing::StyledText whose(std::string_view key) {
    const std::optional<parameters::JointKey> of_joint = parameters::joint_key(key);
    return of_joint ? drawing::StyledText(of_joint->joint + ": ") : drawing::StyledText();
}

// "k1i, μd over θ by table"
drawing::StyledText followers(const parameters::Case& c) {
    drawing::StyledText names;
    std::vector<const parameters::Field*> said;  // of several joints once
    for (const parameters::TemperatureColumn& column : c.temperature.columns) {
        const parameters::Field* field = parameters::field_of(column.key);
        if (std::find(said.begin(), said.end(), field) != said.end()) continue;
        said.push_back(field);
        names = (drawing::is_empty(names) ? names : names + ", ") + drawing::symbol(field->symbol);
    }
    return names + " over " + drawing::symbol(parameters::find_field("temperature.value")->symbol) + " by table";
}

}  // namespace

std::string spelled(std::string_view name) {
    std::string words(name);
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
}

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

drawing::StyledText with_unit(const drawing::StyledText& value, std::string_view unit) {
    const drawing::StyledText text = drawing::unit_text(unit);
    if (drawing::is_empty(text)) return value;
    return value + (unit == "deg" ? drawing::StyledText() : drawing::StyledText(" ")) + text;
}

drawing::PanelAxis field_axis(const sweep::Axis& axis) {
    drawing::PanelAxis result;
    if (const parameters::Field* field = parameters::field_of(axis.parameter)) {
        result.label = whose(axis.parameter) + field_label(*field);
        if (const auto* quantity = std::get_if<parameters::Quantity>(&field->kind)) result.unit = quantity->unit;
    }
    result.scale = axis.scale == sweep::Scale::linear ? drawing::AxisScale::linear : drawing::AxisScale::logarithmic;
    const std::vector<double> edges = cell_edges(axis);
    result.range = {edges.front(), edges.back()};
    return result;
}

drawing::StyledText field_label(const parameters::Field& field) {
    const drawing::StyledText name(spelled(parameters::short_name(field)));
    return field.symbol.empty() ? name : name + " " + drawing::symbol(field.symbol);
}

drawing::StyledText setting(const parameters::Case& c, std::string_view key) {
    const parameters::Field* field = parameters::field_of(key);
    STRIDOR_EXPECT(field != nullptr);
    const drawing::StyledText name = field->symbol.empty()
                                         ? drawing::StyledText(spelled(parameters::short_name(*field)))
                                         : drawing::symbol(field->symbol);
    return whose(key) + name + " = " + value_of(c, key);
}

drawing::StyledText settings(const parameters::Case& c, std::span<const std::string_view> keys) {
    drawing::StyledText row;
    for (const std::string_view key : keys) {
        if (parameters::belongs(c, key)) row = drawing::is_empty(row) ? setting(c, key) : row + ", " + setting(c, key);
    }
    return row;
}

drawing::StyledText conditions(const parameters::Case& c, std::span<const std::string_view> varied) {
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
    // what several joints have in common is said; what each has of its own has no place here
    const auto is_of_one = [&](std::string_view key) {
        const bool is_varied = std::any_of(varied.begin(), varied.end(), [&](std::string_view each) {
            return parameters::field_of(each) == parameters::find_field(key);
        });
        return parameters::has_key_of_joint(c, *parameters::find_field(key)) &&
               (is_varied || !parameters::has_one_value(c, key));
    };
    // what follows an axis has no one value
    const bool is_temperature_varied = varies("temperature.value");
    const auto follows_by_pair = [&](std::string_view key) {
        return parameters::follows_pair(c, *parameters::find_field(key)) &&
               std::any_of(varied.begin(), varied.end(), [&](std::string_view each) {
                   return !parameters::pair_nodes(c.contact().pair, *parameters::field_of(each)).empty();
               });
    };
    std::vector<std::string_view> kept;
    for (const std::string_view key : telling)
        if (!is_of_one(key) && !varies(key) && !follows_by_pair(key) &&
            !(is_temperature_varied && parameters::temperature_column(c, key) != nullptr))
            kept.push_back(key);
    const drawing::StyledText row = settings(c, kept);
    if (!is_temperature_varied || !parameters::has_temperature_table(c)) return row;
    return (drawing::is_empty(row) ? row : row + "; ") + followers(c);
}

drawing::StyledText lettered(std::size_t panel, const drawing::StyledText& title) {
    const char letter = static_cast<char>('a' + panel % 26);
    return drawing::StyledText(std::string(1, letter) + ")", drawing::TextStyle::bold) + " " + title;
}

}  // namespace stridor::pictures
