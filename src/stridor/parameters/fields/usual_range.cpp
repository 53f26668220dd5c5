#include "stridor/parameters/fields/usual_range.hpp"

#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/fields/field_ranges.hpp"
#include "stridor/parameters/tables/material_pair.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace stridor::parameters {

namespace {

// a tenth to ten times
UsualRange around(double value) {
    const double near = value / usual_reach;
    const double far = value * usual_reach;
    return {std::min(near, far), std::max(near, far), Scale::logarithmic};
}

// the range of a field, wide enough for the value; zero is on no logarithmic scale
UsualRange widened(const UsualRange& range, double value) {
    const double from = range.scale == Scale::logarithmic ? 0.0 : range.from;
    return {std::min(from, value), std::max(range.to, value), Scale::linear};
}

// of a number of a builder the field says nothing
std::optional<UsualRange> unlimited_range(const Field& field, const Quantity& quantity, double value) {
    if (is_of_builder(field) && quantity.unit == "deg") return widened(usual_angle, value);
    if (is_of_builder(field) && value != 0.0) return around(value);
    if (!quantity.usual) return std::nullopt;
    return quantity.usual->scale == Scale::logarithmic && value != 0.0 ? around(value)
                                                                       : widened(*quantity.usual, value);
}

UsualRange within(UsualRange usual, const Range& allowed) {
    return {std::clamp(usual.from, allowed.low, allowed.high), std::clamp(usual.to, allowed.low, allowed.high),
            usual.scale};
}

}  // namespace

std::optional<UsualRange> usual_range(const Case& c, std::string_view key) {
    const Field* field = field_of(key);
    const auto* quantity = field == nullptr ? nullptr : std::get_if<Quantity>(&field->kind);
    if (quantity == nullptr || !belongs(c, key) || follows_table(c, key)) return std::nullopt;
    if (key == "temperature.value") {
        const Range range = range_of(c, *field);
        return between(range.low, range.high);
    }
    const std::optional<UsualRange> usual = unlimited_range(*field, *quantity, get_quantity(c, key));
    return usual ? std::optional(within(*usual, range_of(c, key))) : std::nullopt;
}

std::vector<std::string> design_keys(const Case& c) {
    std::vector<std::string> keys;
    for (const std::string& key : quantity_keys(c))
        if (std::get<Quantity>(field_of(key)->kind).usual && !follows_table(c, key)) keys.push_back(key);
    return keys;
}

}  // namespace stridor::parameters
