#include "stridor/io/simulation/fitted_friction.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/json_members.hpp"
#include "stridor/io/json_parts.hpp"
#include "stridor/io/simulation/friction_test_json.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/parameters/tables/material_pair.hpp"
#include "stridor/parameters/tables/temperature_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

namespace stridor::io {

namespace {

using analysis::FittedLaw;
using analysis::FittedNumber;
using base::Json;

constexpr std::string_view to_be_fitted = "fit";  // in the place of a number of the rig

constexpr auto number_members = std::to_array<Member<FittedNumber>>({
    {{"key"}, [](const FittedNumber& number) -> Json { return parameters::key_of(*number.field); }},
    {{"symbol"}, [](const FittedNumber& number) -> Json { return number.field->symbol; }},
    {{"unit"}, [](const FittedNumber& number) -> Json { return parameters::unit_of(*number.field); }},
    {{"value"}, &FittedNumber::value},
    {{"from"}, &FittedNumber::from},
    {{"to"}, &FittedNumber::to},
});

constexpr auto rig_members = std::to_array<Member<analysis::RigNumber>>({
    {{"name"}, [](const analysis::RigNumber& number) -> Json { return number.name; }},
    {{"symbol"}, [](const analysis::RigNumber& number) -> Json { return number.symbol; }},
    {{"unit"}, [](const analysis::RigNumber& number) -> Json { return number.unit; }},
    {{"value"}, &analysis::RigNumber::value},
    {{"from"}, &analysis::RigNumber::from},
    {{"to"}, &analysis::RigNumber::to},
});

constexpr auto law_members = std::to_array<Member<FittedLaw>>({
    {{"law"}, [](const FittedLaw& law) -> Json { return analysis::fitted_names[law.kind]; }},
    {{"numbers"}, [](const FittedLaw& law) { return objects_of(number_members, law.numbers); }},
    {{"rig"}, [](const FittedLaw& law) { return objects_of(rig_members, law.rig); }},
    {{"free_numbers"}, [](const FittedLaw& law) -> Json { return law.free_numbers; }},
    {{"deviation", "1"}, &FittedLaw::deviation},
    {{"criterion", "1"}, &FittedLaw::criterion},
    {{"difference", "1"}, &FittedLaw::difference},
    {{"table_speeds", "m/s"}, [](const FittedLaw& law) -> Json { return law.contact.friction_table.speeds; }},
    {{"table_friction", "1"}, [](const FittedLaw& law) -> Json { return law.contact.friction_table.coefficients; }},
});

// four digits say more than any rig measures
double to_four_figures(double value) {
    if (value == 0.0) return 0.0;
    const double scale = std::pow(10.0, 3.0 - std::floor(std::log10(std::abs(value))));
    return std::round(value * scale) / scale;
}

std::vector<std::string> listed_texts(const std::string& text, std::size_t files, const char* option) {
    std::vector<std::string> parts;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t comma = std::min(text.find(',', from), text.size());
        parts.emplace_back(base::trimmed(std::string_view(text).substr(from, comma - from)));
        from = comma + 1;
    }
    if (parts.size() == 1) return std::vector<std::string>(files, parts.front());
    if (parts.size() != files)
        base::refuse(fmt::format("{} has {} values for {} file{}", option, parts.size(), files, files == 1 ? "" : "s"),
                     "it takes one for all, or one each", "");
    return parts;
}

// each file's temperature [degC]; none where none is said
std::vector<double> temperatures_of(const FrictionFitTexts& texts) {
    std::vector<double> temperatures;
    if (texts.temperature.empty()) return temperatures;
    for (const std::string& text : listed_texts(texts.temperature, texts.files.size(), "--temperature"))
        temperatures.push_back(base::parse_quantity(text, "degC"));
    return temperatures;
}

// the runs of each temperature
analysis::FrictionPoints& points_at(std::vector<analysis::FrictionAtTemperature>& groups, double temperature) {
    for (analysis::FrictionAtTemperature& group : groups)
        if (group.temperature == temperature) return group.data;
    return groups.emplace_back(analysis::FrictionAtTemperature{temperature, {}}).data;
}

// an error about a file names it
template <typename Function>
auto at_file(const std::string& file, Function function) {
    try {
        return function();
    } catch (const Error& error) {
        if (error.place() || error.complaints().size() > 1) throw;
        throw Error(error.kind(), error.problem(), base::Place{file, 0, 0, {}});
    }
}

// adds what a recording shows, and returns what it was measured with
FrictionTest add_recording(analysis::FrictionPoints& points, const FrictionTexts& texts, std::size_t number,
                           const analysis::FrictionTraceOptions& options,
                           const std::function<void(const std::string&)>& note) {
    return at_file(texts.file, [&] {
        const RecordedFriction recorded = recorded_friction(texts, note);
        const analysis::FrictionRun run{texts.file, recorded.measurement, recorded.test.velocity};
        analysis::add_run(points, run, number, options);
        return recorded.test;
    });
}

// two quantities as they are written; nothing is known of both or of none
bool is_same(const std::string& a, const std::string& b, std::string_view unit) {
    if (a.empty() || b.empty()) return a == b;
    return a == b || base::parse_quantity(a, unit) == base::parse_quantity(b, unit);
}

// what one run shows, or Coulomb's numbers of several at one condition
MeasuredFriction friction_of_group(const FrictionFitTexts& texts, const std::vector<FrictionTexts>& each,
                                   const std::vector<std::size_t>& group,
                                   const std::function<void(const std::string&)>& note) {
    if (group.size() == 1)
        return at_file(each[group.front()].file, [&] { return measured_friction(each[group.front()], note); });
    FrictionFitTexts some = texts;
    some.files.clear();
    some.shared.preload = some.shared.velocity = "";
    for (const std::size_t k : group) {
        some.files.push_back(each[k].file);
        some.shared.preload += (some.shared.preload.empty() ? "" : ", ") + each[k].preload;
        some.shared.velocity += (k == group.front() ? "" : ", ") + each[k].velocity;
    }
    const FittedFriction fitted = fitted_friction(some, note);
    const parameters::Contact& contact = fitted.fit.laws[analysis::law_called(fitted.fit, "coulomb")].contact;
    MeasuredFriction measured;
    measured.test = fitted.tests.front();
    for (std::size_t k = 1; k < fitted.tests.size(); ++k)
        measured.test.file += ", " + fitted.tests[k].file;
    if (contact.static_friction > contact.kinetic_friction)
        measured.trace.all.static_friction.value = contact.static_friction;
    measured.trace.all.kinetic_friction.value = contact.kinetic_friction;
    return measured;
}

Json names_of(const analysis::FrictionFit& fit, const std::vector<std::size_t>& laws) {
    return json_parts::array_of(laws,
                                [&](std::size_t law) -> Json { return analysis::fitted_names[fit.laws[law].kind]; });
}

}  // namespace

std::vector<FrictionTexts> texts_of_files(const FrictionFitTexts& texts) {
    const std::size_t files = texts.files.size();
    const std::vector<std::string> preloads = listed_texts(texts.shared.preload, files, "--preload");
    const std::vector<std::string> velocities = listed_texts(texts.shared.velocity, files, "--velocity");
    std::vector<FrictionTexts> each(files, texts.shared);
    for (std::size_t k = 0; k < files; ++k) {
        each[k].file = texts.files[k];
        each[k].preload = preloads[k];
        each[k].velocity = velocities[k];
    }
    return each;
}

std::optional<analysis::MeasuringRig> measuring_rig(const FrictionFitTexts& texts) {
    if (texts.mass.empty() && texts.stiffness.empty()) return std::nullopt;
    if (texts.mass.empty() || texts.stiffness.empty())
        base::refuse("the rig's " + std::string(texts.mass.empty() ? "mass" : "stiffness") + " is missing",
                     "its slips need both", "Give --mass and --stiffness; fit in the place of a value fits it.");
    analysis::MeasuringRig rig;
    if (texts.mass != to_be_fitted) rig.mass = base::parse_quantity(texts.mass, "kg");
    if (texts.stiffness != to_be_fitted) rig.stiffness = base::parse_quantity(texts.stiffness, "N/m");
    if (!texts.damping.empty()) rig.damping = base::parse_quantity(texts.damping, "N*s/m");
    if (rig.mass <= 0.0 || rig.stiffness <= 0.0 || rig.damping < 0.0)
        base::refuse("the rig's mass and stiffness must be above zero, its damping not below", "", "");
    return rig;
}

FittedFriction fitted_friction(const FrictionFitTexts& texts, const std::function<void(const std::string&)>& note) {
    const analysis::FrictionTraceOptions options = trace_options(texts.shared);
    const std::optional<analysis::MeasuringRig> rig = measuring_rig(texts);
    const std::vector<double> temperatures = temperatures_of(texts);
    FittedFriction fitted;
    std::vector<analysis::FrictionAtTemperature> groups;
    for (const FrictionTexts& each : texts_of_files(texts)) {
        const std::size_t number = fitted.tests.size();
        analysis::FrictionPoints& points = points_at(groups, temperatures.empty() ? 0.0 : temperatures[number]);
        fitted.tests.push_back(add_recording(points, each, number, options, note));
    }
    for (const analysis::FrictionAtTemperature& group : groups)
        for (const std::string& each : group.data.notes)
            note(each);
    if (groups.size() == 1) {
        fitted.fit = analysis::friction_fit(std::move(groups.front().data), rig);
    } else {
        fitted.over = analysis::friction_over_temperature(std::move(groups), rig);
        fitted.fit = fitted.over->whole;
    }
    return fitted;
}

namespace {

// runs at one condition: the places of their files
struct ConditionRuns {
    PairConditions conditions;
    std::vector<std::size_t> files;
};

// in the order of the files
std::vector<ConditionRuns> runs_of_conditions(const FrictionFitTexts& texts, const std::vector<FrictionTexts>& each,
                                              const PairConditions& conditions) {
    const std::size_t files = texts.files.size();
    const std::vector<std::string> temperatures = listed_texts(conditions.temperature, files, "--temperature");
    const std::vector<std::string> humidities = listed_texts(conditions.humidity, files, "--humidity");
    std::vector<ConditionRuns> runs;
    for (std::size_t k = 0; k < files; ++k) {
        const auto is_alike = [&](const ConditionRuns& other) {
            return is_same(temperatures[k], other.conditions.temperature, "degC") &&
                   is_same(humidities[k], other.conditions.humidity, "%") &&
                   is_same(each[k].preload, each[other.files.front()].preload, "N");
        };
        const auto found = std::find_if(runs.begin(), runs.end(), is_alike);
        if (found == runs.end())
            runs.push_back({{conditions.name, temperatures[k], humidities[k]}, {k}});
        else
            found->files.push_back(k);
    }
    return runs;
}

std::string condition_text(const ConditionRuns& runs, const std::string& preload) {
    std::string text = "at ";
    for (const std::string& each : {runs.conditions.temperature, runs.conditions.humidity})
        if (!each.empty()) text += each + ", ";
    return text + preload;
}

// the numbers of a law as a row of a pair has them
std::string law_lines(const FittedLaw& law) {
    std::string lines;
    for (const parameters::PairColumn& column : parameters::pair_coefficients()) {
        const bool is_coefficient = column.follows == &parameters::Contact::static_friction ||
                                    column.follows == &parameters::Contact::kinetic_friction;
        const bool is_fitted = std::any_of(law.numbers.begin(), law.numbers.end(),
                                           [&](const FittedNumber& number) { return number.member == column.follows; });
        if (!is_coefficient && !is_fitted) continue;
        const std::string number = fmt::format("{:g}", to_four_figures(law.contact.*column.follows));
        lines += std::string(column.name) + " = " +
                 (column.unit == "1" ? number : "\"" + number + " " + std::string(column.unit) + "\"") + "\n";
    }
    return lines;
}

}  // namespace

std::string pair_rows(const FrictionFitTexts& texts, const PairConditions& conditions,
                      const std::function<void(const std::string&)>& note) {
    const std::vector<FrictionTexts> each = texts_of_files(texts);
    std::string rows;
    for (const ConditionRuns& runs : runs_of_conditions(texts, each, conditions))
        rows +=
            (rows.empty() ? "" : "\n") + pair_row(friction_of_group(texts, each, runs.files, note), runs.conditions);
    return rows;
}

std::string pair_rows_of_law(const FrictionFitTexts& texts, const PairConditions& conditions, const std::string& law,
                             const std::function<void(const std::string&)>& note) {
    const analysis::FrictionTraceOptions options = trace_options(texts.shared);
    const std::vector<FrictionTexts> each = texts_of_files(texts);
    const std::vector<ConditionRuns> runs = runs_of_conditions(texts, each, conditions);
    std::vector<analysis::FrictionAtCondition> data;
    std::vector<std::string> openings;
    for (const ConditionRuns& here : runs) {
        analysis::FrictionAtCondition& at = data.emplace_back(
            analysis::FrictionAtCondition{condition_text(here, each[here.files.front()].preload), {}});
        std::string source;
        double preload = 0.0;
        for (const std::size_t file : here.files) {
            const FrictionTest test = add_recording(at.data, each[file], file, options, note);
            source += (source.empty() ? "" : ", ") + test.file;
            preload = test.preload;
        }
        for (const std::string& each_note : at.data.notes)
            note(each_note);
        openings.push_back(pair_row_opening(here.conditions, source, preload));
    }
    const analysis::FrictionOverConditions over = analysis::friction_over_conditions(data, measuring_rig(texts));
    const std::size_t wanted = law == "best" ? over.whole.best : analysis::law_called(over.whole, law);
    const std::string_view name = analysis::fitted_names[over.whole.laws[wanted].kind];
    if (over.whole.laws[wanted].contact.friction == parameters::FrictionKind::table)
        base::refuse("a pair has no place for rows over the speed", "its numbers are those of a law",
                     "Ask for another law: --fit stribeck.");
    note(analysis::words_of(over));
    std::string rows;
    for (std::size_t k = 0; k < openings.size(); ++k)
        rows += (k == 0 ? "" : "\n") + openings[k] + law_lines(analysis::law_at(over, wanted, k)) +
                "# of the law friction = \"" + std::string(name) + "\"\n";
    return rows;
}

std::string friction_fit_json(const FittedFriction& fitted, std::size_t law) {
    const analysis::FrictionFit& fit = fitted.fit;
    Json document = json_parts::opening("friction-fit");
    Json units = Json::object();
    document["runs"] =
        json_parts::array_of(fitted.tests, [&](const FrictionTest& test) { return test_object(test, units); });
    document["laws"] = objects_of(law_members, fit.laws);
    document["not_fitted"] = json_parts::array_of(fit.unfitted, [](const analysis::UnfittedLaw& each) -> Json {
        return {{"law", analysis::fitted_names[each.kind]}, {"why", each.why}};
    });
    document["best"] = analysis::fitted_names[fit.laws[fit.best].kind];
    document["not_told_apart"] = names_of(fit, fit.rivals);
    document["no_better"] = names_of(fit, fit.richer);
    document["sentence"] = analysis::words_of(fit);
    document["asked"] = analysis::fitted_names[fit.laws[law].kind];
    document["independent"] = fit.independent;
    document["speeds"] = fit.speeds;
    document["slips"] = fit.slips;
    Json& points = document["points"] = Json::array();
    for (std::size_t k = 0; k < fit.data.points.size(); ++k) {
        const analysis::FrictionPoint& point = fit.data.points[k];
        points.push_back({{"run", point.run},
                          {"speed", analysis::mean_speed(point)},
                          {"friction", point.friction},
                          {"residual", fit.laws[law].residuals[k]}});
    }
    if (fitted.over) {
        const analysis::FrictionOverConditions& over = *fitted.over;
        document["sentence"] = analysis::words_of(over);
        document["gain"] = over.gain;
        Json& temperatures = document["temperatures"] = Json::array();
        for (std::size_t k = 0; k < over.temperatures.size(); ++k)
            temperatures.push_back({{"temperature", over.temperatures[k]},
                                    {"independent", over.fits[over.exponents[law]][k].independent},
                                    {"law", object_of(law_members, analysis::law_at(over, law, k))}});
        units["temperatures.temperature"] = "degC";
        units["gain"] = "1";
    }
    document["notes"] = fit.data.notes;
    put_units(units, "", law_members);
    units["independent"] = "1";
    units["points.speed"] = "m/s";
    units["points.friction"] = "1";
    units["points.residual"] = "1";
    document["units"] = units;
    return base::text_of(document);
}

namespace {

// the values of a number at each temperature; none where no temperature has it
std::vector<double> values_over(const analysis::FrictionOverConditions& over, std::size_t law,
                                double parameters::Contact::*member) {
    std::vector<double> values;
    bool is_there = false;
    for (std::size_t k = 0; k < over.temperatures.size(); ++k) {
        const FittedLaw& here = analysis::law_at(over, law, k);
        is_there = is_there || std::any_of(here.numbers.begin(), here.numbers.end(),
                                           [&](const FittedNumber& number) { return number.member == member; });
        values.push_back(to_four_figures(here.contact.*member));
    }
    return is_there ? values : std::vector<double>();
}

void expect_room_for_temperature(const parameters::Case& c, const FittedLaw& law) {
    if (law.contact.friction == parameters::FrictionKind::table)
        base::refuse("rows over the speed do not follow the temperature", "[temperature] has a list for each number",
                     "Ask for another law: --fit stribeck.");
    if (!c.temperature.at.empty())
        base::refuse("the case has a table over the temperature already", "its temperatures may be others",
                     "Take [temperature] out of it.");
}

// the numbers of a law as lists of [temperature], of each joint
void put_over_temperature(parameters::Case& c, const analysis::FrictionOverConditions& over, std::size_t law) {
    using parameters::Contact;
    constexpr std::array members{&Contact::static_friction, &Contact::kinetic_friction, &Contact::friction_slope,
                                 &Contact::stribeck_velocity, &Contact::viscous_friction};
    constexpr std::array<std::string_view, 5> keys{"contact.static_friction", "contact.kinetic_friction",
                                                   "contact.friction_slope", "contact.stribeck_velocity",
                                                   "contact.viscous_friction"};
    std::vector<parameters::TemperatureColumn> columns;
    for (std::size_t k = 0; k < members.size(); ++k) {
        const std::vector<double> values = values_over(over, law, members[k]);
        if (values.empty()) continue;
        for (std::size_t joint = 0; joint < c.joints.size(); ++joint)
            columns.push_back({parameters::key_at({c, joint}, *parameters::find_field(keys[k])), values});
    }
    parameters::set_temperature_table(c, over.temperatures, std::move(columns));
}

}  // namespace

std::string case_with_law(parameters::Case c, const FittedFriction& fitted, std::size_t law) {
    const FittedLaw& wanted = fitted.over ? analysis::law_at(*fitted.over, law, 0) : fitted.fit.laws[law];
    if (fitted.over) expect_room_for_temperature(c, wanted);
    std::string files;
    for (const FrictionTest& test : fitted.tests)
        files += (files.empty() ? "" : ", ") + test.file;
    const std::string words = fitted.over ? analysis::words_of(*fitted.over) : analysis::words_of(fitted.fit);
    const std::string heading = fmt::format("friction fitted: {}\n{}", files, words);
    parameters::share_friction(c);
    for (parameters::PlateJoint& joint : c.joints) {
        joint.contact.friction = wanted.contact.friction;
        joint.contact.interpolation = wanted.contact.interpolation;
        joint.contact.friction_table = wanted.contact.friction_table;
        for (std::vector<double>* values :
             {&joint.contact.friction_table.speeds, &joint.contact.friction_table.coefficients})
            for (double& value : *values)
                value = to_four_figures(value);
    }
    for (const FittedNumber& number : wanted.numbers)
        parameters::set_quantity(c, parameters::key_of(*number.field), to_four_figures(number.value));
    if (wanted.contact.friction == parameters::FrictionKind::table) {
        parameters::set_quantity(c, "contact.static_friction", to_four_figures(wanted.contact.static_friction));
    } else {
        parameters::set_quantity(c, "contact.kinetic_friction", to_four_figures(wanted.contact.kinetic_friction));
        parameters::set_quantity(c, "contact.static_friction", to_four_figures(wanted.contact.static_friction));
    }
    if (fitted.over) put_over_temperature(c, *fitted.over, law);
    return case_toml(c, {Comments::full, heading});
}

}  // namespace stridor::io
