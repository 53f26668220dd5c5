#include "stridor/advice/design_space.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/parameters/check.hpp"
#include "stridor/parameters/field_name.hpp"
#include "stridor/parameters/temperature_table.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stridor::advice {

namespace {

using base::shortest;
using parameters::Case;
using parameters::Field;
using parameters::Quantity;

double octaves(const DesignParameter& parameter) {
    return base::logarithm_2(parameter.to / parameter.from);
}

std::vector<const Field*> quantities_of(const Case& c) {
    std::vector<const Field*> found;
    for (const Field& field : parameters::fields())
        if (std::holds_alternative<Quantity>(field.kind) && field.belongs(c) &&
            parameters::temperature_column(c, parameters::key_of(field)) == nullptr)
            found.push_back(&field);
    return found;
}

// wide enough for the case's own value
DesignParameter widened(DesignParameter parameter, double value) {
    // of a velocity the usual range is that of its magnitude
    if (value < 0.0 && parameter.from > 0.0) {
        std::swap(parameter.from, parameter.to);
        parameter.from = -parameter.from;
        parameter.to = -parameter.to;
    }
    parameter.from = std::min(parameter.from, value);
    parameter.to = std::max(parameter.to, value);
    // a logarithmic scale ends before zero
    if (!(parameter.from > 0.0 || parameter.to < 0.0)) parameter.scale = sweep::Scale::linear;
    return parameter;
}

void check_end(const Case& c, const Field& field, double value) {
    Case probe = c;
    parameters::set_quantity(probe, field, value);
}

DesignParameter parameter_for(const Case& c, const AskedRange& asked) {
    const Field& field = quantity_named(c, asked.name);
    const auto& quantity = std::get<Quantity>(field.kind);
    const std::string key = parameters::key_of(field);
    const double value = parameters::get_quantity(c, field);
    DesignParameter parameter{key, 0.0, 0.0, quantity.usual ? quantity.usual->scale : sweep::Scale::linear};
    if (quantity.usual)
        parameter = widened({key, quantity.usual->from, quantity.usual->to, quantity.usual->scale}, value);
    else if (!asked.from || !asked.to)
        base::refuse(key + " has no usual range", "it is a setting, not a property of the design",
                     "Say from where to where: " + key + "=FROM:TO.");
    if (!asked.from && !asked.to) return parameter;
    parameter.from = asked.from.value_or(parameter.from);
    parameter.to = asked.to.value_or(parameter.to);
    check_end(c, field, parameter.from);
    check_end(c, field, parameter.to);
    if (!(parameter.from < parameter.to))
        base::refuse(key + " from " + shortest(parameter.from) + " to " + shortest(parameter.to) + " is no range",
                     "its first end has to be below its second", parameter.from > parameter.to ? "Swap them?" : "");
    return widened(parameter, value);
}

std::vector<AskedRange> usual_ranges(const Case& c) {
    std::vector<AskedRange> ranges;
    for (const Field* field : quantities_of(c))
        if (std::get<Quantity>(field->kind).usual) ranges.push_back({parameters::key_of(*field)});
    return ranges;
}

}  // namespace

double value_at(const DesignParameter& parameter, double share) {
    if (share <= 0.0) return parameter.from;
    if (share >= 1.0) return parameter.to;
    const double value = parameter.scale == sweep::Scale::logarithmic
                             ? parameter.from * base::power_of_2(share * octaves(parameter))
                             : parameter.from + share * (parameter.to - parameter.from);
    // rounding must not carry a value out of the range
    return std::clamp(value, parameter.from, parameter.to);
}

double share_of(const DesignParameter& parameter, double value) {
    if (value <= parameter.from) return 0.0;
    if (value >= parameter.to) return 1.0;
    const double share = parameter.scale == sweep::Scale::logarithmic
                             ? base::logarithm_2(value / parameter.from) / octaves(parameter)
                             : (value - parameter.from) / (parameter.to - parameter.from);
    return std::clamp(share, 0.0, 1.0);
}

const Field& quantity_named(const Case& c, std::string_view name) {
    const Field& field = parameters::quantity_named(name);
    if (!field.belongs(c))
        base::refuse("\"" + std::string(name) + "\" changes nothing",
                     "this case, with its kind of drive and start, does not use it",
                     "`stridor check FILE` lists what it uses.");
    if (parameters::temperature_column(c, parameters::key_of(field)) != nullptr)
        base::refuse(parameters::key_of(field) + " cannot be set", "it follows the temperature by a table",
                     "Vary temperature instead, or take it out of [temperature].");
    return field;
}

DesignSpace design_space(const Case& c, std::span<const AskedRange> asked) {
    if (const std::vector<parameters::Finding> found = parameters::findings(c); !found.empty())
        throw Error(ErrorKind::input, found.front().problem);
    DesignSpace space{c, {}, {}, {}, record::schedule(c).phases};
    const std::vector<AskedRange> usual = asked.empty() ? usual_ranges(c) : std::vector<AskedRange>{};
    for (const AskedRange& range : asked.empty() ? std::span<const AskedRange>(usual) : asked) {
        DesignParameter parameter = parameter_for(c, range);
        for (const DesignParameter& other : space.parameters)
            if (other.key == parameter.key)
                base::refuse(parameter.key + " is asked for twice", "each parameter has one range", "");
        const Field& field = *parameters::find_field(parameter.key);
        space.origin.push_back(share_of(parameter, parameters::get_quantity(c, field)));
        if (!asked.empty() || field.section != "drive") space.free.push_back(space.parameters.size());
        space.parameters.push_back(std::move(parameter));
    }
    return space;
}

Case design_at(const DesignSpace& space, const Shares& shares) {
    STRIDOR_EXPECT(shares.size() == space.parameters.size());
    Case c = space.base;
    for (std::size_t k = 0; k < shares.size(); ++k)
        if (shares[k] != space.origin[k])
            parameters::set_quantity(c, *parameters::find_field(space.parameters[k].key),
                                     value_at(space.parameters[k], shares[k]));
    return c;
}

}  // namespace stridor::advice
