#include "stridor/advice/design_space.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/fields/usual_range.hpp"
#include "stridor/parameters/rules/check.hpp"
#include "stridor/parameters/tables/material_pair.hpp"
#include "stridor/parameters/tables/temperature_table.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stridor::advice {

namespace {

using base::shortest;
using parameters::Case;
using parameters::Direction;
using parameters::Initial;

double octaves(const DesignParameter& parameter) {
    return base::logarithm_2(parameter.to / parameter.from);
}

// wide enough for the case's own value
DesignParameter widened(DesignParameter parameter, double value) {
    parameter.from = std::min(parameter.from, value);
    parameter.to = std::max(parameter.to, value);
    // a logarithmic scale ends before zero
    if (!(parameter.from > 0.0 || parameter.to < 0.0)) parameter.scale = sweep::Scale::linear;
    return parameter;
}

void check_end(const Case& c, const std::string& key, double value) {
    Case probe = c;
    parameters::set_quantity(probe, key, value);
}

DesignParameter parameter_for(const Case& c, const AskedRange& asked) {
    const std::string key = quantity_key_called(c, asked.name);
    expect_one_value(c, key);
    const double value = parameters::get_quantity(c, key);
    const std::optional<parameters::UsualRange> usual = parameters::usual_range(c, key);
    if (!usual && (!asked.from || !asked.to))
        base::refuse(key + " has no usual range", "it is a setting, not a property of the design",
                     "Say from where to where: " + key + "=FROM:TO.");
    DesignParameter parameter{key, 0.0, 0.0, sweep::Scale::linear};
    if (usual) parameter = {key, usual->from, usual->to, usual->scale};
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
    for (const std::string& key : parameters::design_keys(c))
        ranges.push_back({key});
    return ranges;
}

// those with which the case can begin, its own first: what slides needs a surface that moves
std::vector<Initial> possible_starts(const Case& c) {
    std::vector<Initial> starts{c.run.initial};
    for (const Initial start : {Initial::rest, Initial::sliding, Initial::stuck})
        if (start != c.run.initial && parameters::findings(case_of(c, {{}, start})).empty()) starts.push_back(start);
    return starts;
}

std::vector<record::Phase> phases_of(const Case& c, const std::vector<Direction>& directions) {
    std::vector<record::Phase> phases;
    if (c.drive.kind == parameters::DriveKind::constant)
        phases = {record::Phase::going, record::Phase::coming};
    else
        phases = record::schedule(c).phases;
    const auto is_unasked = [&](record::Phase phase) {
        const Direction direction = phase == record::Phase::going ? Direction::going : Direction::coming;
        return !directions.empty() && std::find(directions.begin(), directions.end(), direction) == directions.end();
    };
    std::erase_if(phases, is_unasked);
    if (phases.empty())
        base::refuse("the motion has none of the directions asked for", "the surface stands still or never moves so",
                     "Leave the direction out.");
    return phases;
}

std::vector<DesignRun> runs_of(const Case& c, const std::vector<record::Phase>& phases, const AskedRuns& asked) {
    std::vector<DesignRun> runs;
    for (const Initial start : asked.starts.empty() ? possible_starts(c) : asked.starts) {
        const std::vector<parameters::Finding> found = parameters::findings(case_of(c, {{}, start}));
        if (!found.empty()) throw Error(ErrorKind::input, found.front().problem);
        if (c.drive.kind != parameters::DriveKind::constant) {
            runs.push_back({{}, start});
            continue;
        }
        for (const record::Phase phase : phases)
            runs.push_back({phase == record::Phase::going ? Direction::going : Direction::coming, start});
    }
    return runs;
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
    if (parameters::temperature_column(c, key) == nullptr && parameters::follows_table(c, key))
        base::refuse(key + " cannot be set", "it follows from contact.pair",
                     "Vary what the pair depends on instead, or remove contact.pair.");
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

DesignSpace design_space(const Case& c, std::span<const AskedRange> asked, const AskedRuns& runs) {
    if (const std::vector<parameters::Finding> found = parameters::findings(c); !found.empty())
        throw Error(ErrorKind::input, found.front().problem);
    DesignSpace space{c, {}, {}, {}, phases_of(c, runs.directions), {}};
    space.runs = runs_of(c, space.phases, runs);
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
    return c;
}

Case case_of(const Case& design, const DesignRun& run) {
    Case c = design;
    c.run.initial = run.start;
    if (run.direction)
        c.drive.velocity =
            *run.direction == Direction::going ? std::abs(c.drive.velocity) : -std::abs(c.drive.velocity);
    return c;
}

std::vector<Initial> starts_of(const DesignSpace& space) {
    std::vector<Initial> starts;
    for (const DesignRun& run : space.runs)
        if (std::find(starts.begin(), starts.end(), run.start) == starts.end()) starts.push_back(run.start);
    return starts;
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
