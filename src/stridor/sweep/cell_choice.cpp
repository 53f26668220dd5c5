#include "stridor/sweep/cell_choice.hpp"

#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/parameters/fields/case_key.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stridor::sweep {

namespace {

using parameters::Direction;

double distance(const Axis& axis, int index, double value) {
    const double point = value_at(axis, index);
    if (axis.scale == Scale::linear) return std::abs(point - value);
    return std::abs(base::logarithm_2(point / value));
}

int nearest_index(const Axis& axis, const std::string& text, char name) {
    const std::string_view unit = parameters::unit_of(axis.parameter);
    const double value = base::parse_quantity(text, unit);
    // so much beyond an end is still meant to be the end
    const double slack = 1e-9 * (std::abs(axis.from) + std::abs(axis.to));
    if (!(value >= axis.from - slack && value <= axis.to + slack))
        base::refuse(
            fmt::format("cell {}={} lies outside the chart", name, text),
            fmt::format("its {} axis, {}, goes from {:g} to {:g} {}", name, axis.parameter, axis.from, axis.to, unit),
            "");
    int nearest = 0;
    for (int index = 1; index < axis.points; ++index)
        if (distance(axis, index, value) < distance(axis, nearest, value)) nearest = index;
    return nearest;
}

Direction direction_named(const std::string& name) {
    for (const Direction direction : {Direction::going, Direction::coming})
        if (name == parameters::direction_names[static_cast<std::size_t>(direction)]) return direction;
    base::refuse("direction=" + name + " is no direction", "it is going or coming", "");
}

}  // namespace

CellChoice parse_cell(const std::string& text) {
    CellChoice choice;
    choice.text = text;
    std::size_t begin = 0;
    while (begin <= text.size()) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string part(base::trimmed(text.substr(begin, end - begin)));
        const std::size_t sign = std::min(part.find('='), part.size());
        const std::string key(base::trimmed(part.substr(0, sign)));
        const std::string value(base::trimmed(part.substr(std::min(sign + 1, part.size()))));
        begin = end + 1;
        if (key == "direction" && !choice.direction) {
            choice.direction = direction_named(value);
            continue;
        }
        const bool is_known = (key == "x" || key == "y") && !value.empty();
        if (!is_known || !(key == "x" ? choice.x : choice.y).empty())
            base::refuse("cell \"" + text + "\" cannot be read", "it names both of the chart's axes once",
                         "For example \"x=20 N,y=0.6\".");
        (key == "x" ? choice.x : choice.y) = value;
    }
    if (choice.x.empty() || choice.y.empty())
        base::refuse("cell \"" + text + "\" names one axis only", "a cell is a place on both",
                     "For example \"x=20 N,y=0.6\".");
    return choice;
}

CellPlace nearest_cell(const Study& study, const CellChoice& choice) {
    const Direction direction = choice.direction.value_or(study.directions.front());
    const auto found = std::find(study.directions.begin(), study.directions.end(), direction);
    if (found == study.directions.end())
        base::refuse("the chart has no direction " +
                         std::string(parameters::direction_names[static_cast<std::size_t>(direction)]),
                     "chart.directions leaves it out", "");
    return {static_cast<std::size_t>(found - study.directions.begin()), nearest_index(study.y, choice.y, 'y'),
            nearest_index(study.x, choice.x, 'x'), 0};
}

std::string cell_words(const Study& study, const CellPlace& place) {
    const parameters::Case c = case_at(study, place);
    const auto words = [&](const Axis& axis) {
        return axis.parameter + " = " + parameters::value_text(c, axis.parameter);
    };
    return words(study.x) + ", " + words(study.y);
}

std::string cell_name(const Study& study, const CellPlace& place) {
    const auto value = [](const Axis& axis, int index) {
        const std::string_view unit = parameters::unit_of(axis.parameter);
        return fmt::format("{:.4g}{}{}", value_at(axis, index), unit == "1" ? "" : " ", unit == "1" ? "" : unit);
    };
    return "x=" + value(study.x, place.ix) + ",y=" + value(study.y, place.iy);
}

}  // namespace stridor::sweep
