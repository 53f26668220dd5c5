#include "stridor/advice/design_space.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/parameters/case_key.hpp"
#include "stridor/parameters/check.hpp"
#include "stridor/parameters/temperature_table.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stridor::advice {

namespace {

using base::shortest;
using parameters::Case;
using parameters::Quantity;

double octaves(const DesignParameter& parameter) {
    return base::logarithm_2(parameter.to / parameter.from);
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

const Quantity& quantity_of(std::string_view key) {
    return std::get<Quantity>(parameters::field_of(key)->kind);
}

void check_end(const Case& c, const std::string& key, double value) {
    Case probe = c;
    parameters::set_quantity(probe, key, value);
}

DesignParameter parameter_for(const Case& c, const AskedRange& asked) {
    const std::string key = quantity_key_called(c, asked.name);
    expect_one_value(c, key);
    const Quantity& quantity = quantity_of(key);
    const double value = parameters::get_quantity(c, key);
    DesignParameter parameter{key, 0.0, 0.0, quantity.usual ? quantity.usual->scale : sweep::Scale::linear};
    if (quantity.usual)
        parameter = widened({key, quantity.usual->from, quantity.usual->to, quantity.usual->scale}, value);
    else if (!asked.from || !asked.to)
        base::refuse(key + " has no usual range", "it is a setting, not a property of the design",
                     "Say from where to where: " + key + "=FROM:TO.");
    if (!asked.from && !asked.to) return parameter;
    parameter.from = asked.from.value_or(parameter.from);
    parameter.to = asked.to.value_or(parameter.to);
    check_end(c, key, parameter.from);
    check_end(c, key, parameter.to);
    if (!(parameter.from < parameter.to))
        base::refuse(key + " from " + shortest(parameter.from) + " to " + shortest(parameter.to) + " is no range",
                     "its first end has to be below its second", parameter.from > parameter.to ? "Swap them?" : "");
    return widened(parameter, value);
}

std::vector<AskedRange> usual_ranges(const Case& c) {
    std::vector<AskedRange> ranges;
    for (const std::string& key : parameters::quantity_keys(c)) {
        const bool follows = parameters::temperature_column(c, key) != nullptr;
        if (quantity_of(key).usual && !follows) ranges.push_back({key});
    }
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

std::string quantity_key_called(const Case& c, std::string_view name) {
    std::string key = parameters::quantity_key_called(name);
    parameters::expect_joint_of(c, key);
    if (!parameters::belongs(c, key))
        base::refuse("\"" + std::string(name) + "\" changes nothing",
                     "this case, with its kind of drive and start, does not use it",
                     "`stridor check FILE` lists what it uses.");
    if (parameters::temperature_column(c, key) != nullptr)
        base::refuse(key + " cannot be set", "it follows the temperature by a table",
                     "Vary temperature instead, or take it out of [temperature].");
    return key;
}

void expect_one_value(const Case& c, std::string_view key) {
    if (parameters::has_one_value(c, key)) return;
    const std::vector<std::string> keys = parameters::single_keys(c, key);
    base::refuse(std::string(key) + " is not the same for all joints: " + parameters::value_text(c, key),
                 "a design has one value of it, from which it is changed", "Name a joint: " + base::listed(keys) + ".");
}

DesignSpace design_space(const Case& c, std::span<const AskedRange> asked) {
    if (const std::vector<parameters::Finding> found = parameters::findings(c); !found.empty())
        throw Error(ErrorKind::input, found.front().problem);
    DesignSpace space{c, {}, {}, {}, record::schedule(c).phases};
    const std::vector<AskedRange> usual = asked.empty() ? usual_ranges(c) : std::vector<AskedRange>{};
    for (const AskedRange& range : asked.empty() ? std::span<const AskedRange>(usual) : asked) {
        DesignParameter parameter = parameter_for(c, range);
        for (const DesignParameter& other : space.parameters)
            if (parameters::overlap(c, other.key, parameter.key))
                base::refuse(parameter.key + " is asked for twice", "each parameter has one range", "");
        space.origin.push_back(share_of(parameter, parameters::get_quantity(c, parameter.key)));
        if (!asked.empty() || parameters::field_of(parameter.key)->section != "drive")
            space.free.push_back(space.parameters.size());
        space.parameters.push_back(std::move(parameter));
    }
    return space;
}

Case case_of(const DesignSpace& space, const Design& design) {
    Case c = space.base;
    for (const Design::Setting& setting : design.settings)
        parameters::set_quantity(c, setting.key, setting.value);
    if (design.start) c.run.initial = *design.start;
    return c;
}

Design design_at(const DesignSpace& space, const Shares& shares) {
    STRIDOR_EXPECT(shares.size() == space.parameters.size());
    Design design;
    for (std::size_t k = 0; k < shares.size(); ++k)
        if (shares[k] != space.origin[k])
            design.settings.push_back({space.parameters[k].key, value_at(space.parameters[k], shares[k])});
    return design;
}

}  // namespace stridor::advice
