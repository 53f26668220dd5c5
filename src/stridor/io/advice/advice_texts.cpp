#include "stridor/io/advice/advice_texts.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/field_table.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/io/chart/range_text.hpp"
#include "stridor/io/json_parts.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/sweep/starts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>

namespace stridor::io {

namespace {

Error unreadable_text(const std::string& option, const std::string& text, const std::string& expected,
                      const std::string& example) {
    return {ErrorKind::input, {option + " \"" + text + "\" cannot be read", "expected " + expected, example}};
}

std::string_view unit_named(const parameters::Case& c, const std::string& name) {
    return parameters::unit_of(advice::quantity_key_called(c, name));
}

advice::AskedRange range_from(const parameters::Case& c, const std::string& text) {
    const std::optional<RangeText> said = split_range(text);
    if (!said) return {std::string(base::trimmed(text))};
    if (said->parts.size() != 2)
        throw unreadable_text("--over", text, "KEY or KEY=FROM:TO", "For example contact.kinetic_friction=0:0.8.");
    advice::AskedRange range{std::string(said->key)};
    const RangeEnds ends = read_range_ends(said->parts[0], said->parts[1], unit_named(c, range.name));
    range.from = ends.from;
    range.to = ends.to;
    return range;
}

// "10%", "10 % normal", "2 N"
advice::AskedTolerance tolerance_from(const parameters::Case& c, const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos)
        throw unreadable_text("--tolerance", text, "KEY=AMOUNT, in percent or with a unit", "For example preload=10%.");
    advice::AskedTolerance tolerance{std::string(base::trimmed(text.substr(0, equals)))};
    std::string amount(base::trimmed(text.substr(equals + 1)));
    for (std::size_t k = 0; k < advice::spread_names.size(); ++k) {
        const std::string_view name = advice::spread_names[k];
        if (!amount.ends_with(name)) continue;
        tolerance.spread = static_cast<advice::Spread>(k);
        amount = std::string(base::trimmed(amount.substr(0, amount.size() - name.size())));
    }
    if (amount.empty())
        throw unreadable_text("--tolerance", text, "KEY=AMOUNT, in percent or with a unit", "For example preload=10%.");
    if (amount.ends_with('%'))
        tolerance.relative = base::parse_quantity(amount, "1");
    else
        tolerance.absolute = base::parse_quantity(amount, unit_named(c, tolerance.name));
    return tolerance;
}

// the choices of a list, each once
template <typename Choice>
std::vector<Choice> choices_of(const std::string& option, const std::vector<std::string>& texts,
                               std::span<const std::string_view> names) {
    std::vector<Choice> all;
    for (const std::string& text : texts) {
        const auto each = static_cast<Choice>(
            base::place_of_choice(option, std::string(base::trimmed(text)), names, base::Place{option, 0, 0, text}));
        if (std::find(all.begin(), all.end(), each) == all.end()) all.push_back(each);
    }
    return all;
}

// what is wrong with an option is told with the option's name
template <typename Read>
auto placed(const char* option, const std::string& text, Read read) {
    try {
        return read();
    } catch (const Error& error) {
        throw Error(error.kind(), error.problem(), base::Place{option, 0, 0, text});
    }
}

using advice::Advice;
using advice::DesignChange;
using advice::DesignSpace;
using advice::DesignVerdict;
using advice::ParameterMargin;
using base::Json;
using json_parts::array_of;
using json_parts::name_of;

std::string_view unit_of(const DesignSpace& space, std::size_t parameter) {
    return parameters::unit_of(space.parameters[parameter].key);
}

// "category": of the loudest phase, and each phase's own
Json verdict_object(const DesignSpace& space, const DesignVerdict& verdict) {
    Json phases = Json::object();
    for (std::size_t k = 0; k < space.phases.size(); ++k)
        phases[std::string(name_of<record::Phase>(record::phase_names, space.phases[k]))] =
            sweep::word(verdict.phases[k]);
    return {{"category", sweep::word(advice::overall(verdict))},
            {"phases", std::move(phases)},
            {"sticks", advice::is_quiet(verdict) && !advice::slips_quietly(verdict)}};
}

Json change_object(const DesignSpace& space, const ParameterMargin& margin,
                   const std::optional<advice::VerdictChange>& change) {
    if (!change) return nullptr;
    Json object = {{"value", change->value},
                   {"before", change->before},
                   {"distance", std::abs(change->value - margin.value)},
                   {"relative", std::abs(change->value - margin.value) / std::abs(margin.value)},
                   {"share", std::abs(change->share - space.origin[margin.parameter])}};
    object.update(verdict_object(space, change->beyond));
    return object;
}

Json end_object(const advice::ScanSide& side) {
    Json object = {{"value", side.last}, {"why", name_of<advice::ScanEnd>(advice::scan_end_names, side.end)}};
    if (!side.reason.empty()) object["reason"] = side.reason;
    return object;
}

Json scan_array(const ParameterMargin& margin) {
    return array_of(margin.scan, [](const advice::ScanPoint& point) -> Json {
        return {{"value", point.value}, {"category", sweep::word(advice::overall(point.verdict))}};
    });
}

Json margin_object(const DesignSpace& space, const ParameterMargin& margin) {
    const advice::DesignParameter& parameter = space.parameters[margin.parameter];
    return {{"key", parameter.key},
            {"value", margin.value},
            {"unit", unit_of(space, margin.parameter)},
            {"from", parameter.from},
            {"to", parameter.to},
            {"scale", name_of<sweep::Scale>(sweep::scale_names, parameter.scale)},
            {"free", std::find(space.free.begin(), space.free.end(), margin.parameter) != space.free.end()},
            {"below", change_object(space, margin, margin.below.change)},
            {"above", change_object(space, margin, margin.above.change)},
            {"quiet_below", change_object(space, margin, margin.below.quiet)},
            {"quiet_above", change_object(space, margin, margin.above.quiet)},
            {"end_below", end_object(margin.below)},
            {"end_above", end_object(margin.above)},
            {"scan", scan_array(margin)}};
}

Json setting(const DesignSpace& space, std::size_t parameter, double from, double to) {
    return {{"key", space.parameters[parameter].key}, {"from", from}, {"to", to}, {"unit", unit_of(space, parameter)}};
}

Json starts_array(const DesignSpace& space) {
    return array_of(advice::starts_of(space),
                    [](parameters::Initial start) { return name_of(sweep::start_names(), start); });
}

Json quieting_object(const DesignSpace& space, const DesignChange& change) {
    Json set = array_of(change.set, [&](const advice::ParameterChange& each) {
        return setting(space, each.parameter, each.from, each.to);
    });
    Json verified = verdict_object(space, change.verdict);
    verified["runs"] = change.runs;
    verified["designs"] = change.designs;
    verified["neighbourhood"] = advice::verified_around;
    verified["starts"] = starts_array(space);
    return {{"set", std::move(set)},
            {"distance", change.distance},
            {"options", advice::settings_of(space, change)},
            {"verified", std::move(verified)}};
}

// what lies close to a quiet design
Json near_object(const DesignSpace& space, const std::optional<advice::Neighbourhood>& near) {
    if (!near) return nullptr;
    const std::vector<std::string> words = advice::turn_words(space, *near);
    Json turns = Json::array();
    for (std::size_t k = 0; k < near->turns.size(); ++k) {
        const advice::NearChange& turn = near->turns[k];
        Json object = {{"key", turn.key},
                       {"relative", turn.relative},
                       {"value", turn.value},
                       {"unit", parameters::unit_of(turn.key)},
                       {"words", words[k]}};
        object.update(verdict_object(space, turn.verdict));
        turns.push_back(std::move(object));
    }
    return {{"within", advice::looked_within}, {"turns", std::move(turns)}};
}

Json nearest_object(const DesignSpace& space, const std::optional<advice::NearestDesign>& nearest) {
    if (!nearest) return nullptr;
    Json set = Json::array();
    for (std::size_t k = 0; k < space.parameters.size(); ++k)
        if (nearest->shares[k] != space.origin[k]) {
            set.push_back(setting(space, k, parameters::get_quantity(space.base, space.parameters[k].key),
                                  advice::value_at(space.parameters[k], nearest->shares[k])));
        }
    Json object = {
        {"set", std::move(set)}, {"distance", nearest->distance}, {"words", advice::nearest_words(space, *nearest)}};
    object.update(verdict_object(space, nearest->verdict));
    return object;
}

Json changes_array(const Advice& advice) {
    return array_of(advice.changes, [&](const DesignChange& change) { return quieting_object(advice.space, change); });
}

Json estimate_object(const advice::Estimate& estimate) {
    return {{"share", estimate.share}, {"low", estimate.low}, {"high", estimate.high}};
}

Json chance_object(const std::optional<advice::Chance>& chance) {
    if (!chance) return nullptr;
    Json tolerances = array_of(chance->tolerances, [](const advice::Tolerance& each) -> Json {
        return {{"key", each.key},
                {"value", each.value},
                {"tolerance", each.tolerance},
                {"unit", parameters::unit_of(each.key)},
                {"spread", name_of<advice::Spread>(advice::spread_names, each.spread)}};
    });
    Json by_category = Json::object();
    for (std::size_t k = 0; k < sweep::verdict_words.size(); ++k)
        if (chance->by_verdict[k].share > 0.0)
            by_category[std::string(sweep::verdict_words[k])] = estimate_object(chance->by_verdict[k]);
    return {{"noise", chance->noise.share},
            {"low", chance->noise.low},
            {"high", chance->noise.high},
            {"confidence", advice::confidence},
            {"samples", chance->samples},
            {"usual", chance->is_default},
            {"seed", chance->options.seed},
            {"not_quiet", estimate_object(chance->not_quiet)},
            {"by_category", std::move(by_category)},
            {"tolerances", std::move(tolerances)}};
}

}  // namespace

advice::AskedRange read_asked_range(const parameters::Case& c, const std::string& text) {
    return placed("--over", text, [&] { return range_from(c, text); });
}

advice::AskedTolerance read_asked_tolerance(const parameters::Case& c, const std::string& text) {
    return placed("--tolerance", text, [&] { return tolerance_from(c, text); });
}

advice::AskedRuns read_asked_runs(const std::vector<std::string>& directions, const std::vector<std::string>& starts) {
    return {choices_of<parameters::Direction>("--direction", directions, parameters::direction_names),
            choices_of<parameters::Initial>("--start", starts, sweep::start_names())};
}

namespace {

// what a design does, as its headline says it
void add_standing(Json& document, const DesignSpace& space, const DesignVerdict& present,
                  const std::optional<advice::Neighbourhood>& near) {
    document["headline"] = advice::headline(space, present, near);
    document["standing"] = name_of<advice::Standing>(advice::standing_names, advice::standing(present, near));
    document["phases"] =
        array_of(space.phases, [](record::Phase phase) { return name_of(record::phase_names, phase); });
    document["starts"] = starts_array(space);
    document["present"] = verdict_object(space, present);
    document["present"]["quiet"] = advice::is_quiet(present);
    document["present"]["message"] = present.message;
    document["near"] = near_object(space, near);
}

// the design that the recommended change leads to
Json changed_object(const advice::ChangedDesign& changed) {
    Json object = {{"words", advice::changed_words(changed)}};
    add_standing(object, changed.standing.space, changed.standing.present, changed.standing.near);
    object["chance"] = chance_object(changed.chance);
    return object;
}

}  // namespace

std::string standing_json(const advice::DesignStanding& design) {
    Json document = json_parts::opening("design", design.space.base);
    add_standing(document, design.space, design.present, design.near);
    return base::text_of(document);
}

std::string advice_json(const Advice& advice) {
    const DesignSpace& space = advice.space;
    Json document = json_parts::opening("advice", space.base);
    document["units"] = json_parts::case_units(space.base);
    add_standing(document, space, advice.present, advice.near);
    document["margins"] =
        array_of(advice.margins, [&](const ParameterMargin& margin) { return margin_object(space, margin); });
    document["ranking"] =
        array_of(advice.ranking, [&](std::size_t parameter) { return space.parameters[parameter].key; });
    document["nearest"] = nearest_object(space, advice.nearest);
    document["change"] =
        advice.recommended ? quieting_object(space, advice.changes[*advice.recommended]) : Json(nullptr);
    document["changed"] = advice.changed ? changed_object(*advice.changed) : Json(nullptr);
    document["changes"] = changes_array(advice);
    document["chance"] = chance_object(advice.chance);
    document["runs"] = advice.runs;
    return base::text_of(document);
}

}  // namespace stridor::io
