#include "stridor/io/chart/toml_study.hpp"

#include "stridor/base/field_table.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/io/case/complaints.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/chart/range_text.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/sweep/starts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stridor::io {

namespace {

constexpr std::array<std::string_view, 16> chart_keys{
    "chart.x.parameter", "chart.x.from", "chart.x.to",     "chart.x.points", "chart.x.scale",    "chart.y.parameter",
    "chart.y.from",      "chart.y.to",   "chart.y.points", "chart.y.scale",  "chart.directions", "chart.quantities",
    "chart.x",           "chart.y",      "chart.refine",   "chart.starts"};
constexpr std::array<std::string_view, 4> required_axis_keys{"parameter", "from", "to", "points"};

base::Place whole_file(const TomlDocument& document) {
    return {document.name, 0, 0, ""};
}

Error wrong_type(const TomlEntry& entry, const std::string& expected) {
    return {ErrorKind::input,
            {entry.key + " is " + std::string(type_name(entry.value)), "expected " + expected, ""},
            entry.value_place};
}

void check_chart_keys(const TomlDocument& document, Complaints& complaints) {
    for (const TomlEntry& entry : document.entries) {
        if (!entry.key.starts_with("chart.")) continue;
        const bool is_axis = entry.key == "chart.x" || entry.key == "chart.y";
        if (is_axis && !std::holds_alternative<TomlTable>(entry.value))
            complaints.add(wrong_type(entry, "an axis: { parameter, from, to, points, scale }"));
        if (std::find(chart_keys.begin(), chart_keys.end(), entry.key) != chart_keys.end()) continue;
        const std::string_view near = base::nearest_name(entry.key, chart_keys);
        complaints.add({ErrorKind::input,
                        {"unknown key " + entry.key, "", near.empty() ? "" : "Did you mean " + std::string(near) + "?"},
                        entry.key_place});
    }
}

bool has_axis(const TomlDocument& document, std::string_view prefix) {
    return std::any_of(document.entries.begin(), document.entries.end(),
                       [&](const TomlEntry& entry) { return entry.key.starts_with(prefix); });
}

// a diagram over x alone: the command line or the file says nothing of y
bool is_over_x_alone(const TomlDocument& document, const AxisTexts& axes) {
    return axes.y.empty() && (!axes.x.empty() || !has_axis(document, "chart.y"));
}

void check_chart_complete(const TomlDocument& document, const AxisTexts& axes) {
    const TomlEntry* chart = document.find("chart");
    if (chart != nullptr && !std::holds_alternative<TomlTable>(chart->value)) throw wrong_type(*chart, "a section");
    std::string missing;
    bool has_any = chart != nullptr;
    for (const auto& [axis, text] : {std::pair("chart.x.", axes.x), std::pair("chart.y.", axes.y)}) {
        if (axis == std::string_view("chart.y.") && is_over_x_alone(document, axes)) continue;
        has_any = has_any || !text.empty();
        for (const std::string_view name : required_axis_keys) {
            const std::string key = axis + std::string(name);
            const bool is_there = !text.empty() || document.find(key) != nullptr;
            has_any = has_any || is_there;
            if (!is_there) missing += (missing.empty() ? "" : ", ") + key;
        }
    }
    if (!has_any)
        throw Error(
            ErrorKind::input,
            {"there is no section [chart]", "it says which two parameters span the chart",
             "Name them: stridor chart " + document.name +
                 " --x preload=1:40 --y mu_d=0.2:0.8. `stridor init noise-chart` prints a section to start from."},
            whole_file(document));
    if (!missing.empty())
        throw Error(ErrorKind::input,
                    {"missing in [chart]: " + missing, "an axis without them is not defined",
                     "`stridor init noise-chart` prints a complete chart."},
                    chart != nullptr ? chart->key_place : whole_file(document));
}

std::string text_of(const TomlEntry& entry, const std::string& expected) {
    if (const auto* text = std::get_if<std::string>(&entry.value)) return *text;
    throw wrong_type(entry, expected);
}

double number_of(const TomlEntry& entry, std::string_view unit) {
    if (const auto* number = std::get_if<double>(&entry.value)) return *number;
    const std::string text = text_of(
        entry, "a number" + (unit == "1" ? std::string() : " in " + std::string(unit) + ", or text with a unit"));
    try {
        return base::parse_quantity(text, unit);
    } catch (const Error& error) {
        throw located(error, entry.key, entry.value_place);
    }
}

// an index into names
std::size_t place_of_name(const std::string& text, const TomlEntry& entry, std::span<const std::string_view> names) {
    return base::place_of_choice(entry.key, text, names, entry.value_place);
}

std::string axis_key(const TomlEntry& entry) {
    const std::string name = text_of(entry, "the key of a quantity such as \"contact.preload\"");
    try {
        return parameters::quantity_key_called(name);
    } catch (const Error& error) {
        throw located(error, entry.key, entry.value_place);
    }
}

// refuses an axis along a joint that is not there
void expect_joint_of(const parameters::Case& c, const TomlDocument& document, const std::string& key) {
    const TomlEntry* entry = document.find(key);
    const auto* name = entry == nullptr ? nullptr : std::get_if<std::string>(&entry->value);
    if (name == nullptr) return;
    try {
        parameters::expect_joint_of(c, *name);
    } catch (const Error& error) {
        throw located(error, key, entry->value_place);
    }
}

// a whole number of things from 0 to the most there may be
int count_of(const TomlEntry& entry, int most, const std::string& things) {
    const double number = number_of(entry, "1");
    const bool is_count = number >= 0.0 && number <= most && number == std::floor(number);
    if (is_count) return static_cast<int>(number);
    throw Error(ErrorKind::input,
                {entry.key + " = " + base::shortest(number) + " is not a number of " + things,
                 "it must be a whole number up to " + std::to_string(most), ""},
                entry.value_place);
}

// what of an axis is there and right
sweep::Axis read_axis(const TomlDocument& document, const std::string& prefix, Complaints& complaints) {
    sweep::Axis axis;
    const auto read = [&](std::string_view name, auto&& part) {
        const TomlEntry* entry = document.find(prefix + "." + std::string(name));
        return entry != nullptr && complaints.keep([&] { part(*entry); });
    };
    const bool has_unit = read("parameter", [&](const TomlEntry& entry) { axis.parameter = axis_key(entry); });
    const std::string unit(parameters::unit_of(axis.parameter));
    if (has_unit) read("from", [&](const TomlEntry& entry) { axis.from = number_of(entry, unit); });
    if (has_unit) read("to", [&](const TomlEntry& entry) { axis.to = number_of(entry, unit); });
    read("points", [&](const TomlEntry& entry) { axis.points = count_of(entry, sweep::most_points, "points"); });
    read("scale", [&](const TomlEntry& entry) {
        axis.scale = static_cast<sweep::Scale>(place_of_name(text_of(entry, "text"), entry, sweep::scale_names));
    });
    return axis;
}

// overrides write lists as "going,coming" or as TOML does
std::vector<std::string> list_of(const TomlEntry& entry) {
    if (const auto* list = std::get_if<std::vector<std::string>>(&entry.value)) return *list;
    return listed(text_of(entry, "a list of text"));
}

// names of an enumeration out of a list, if the document has it
template <typename Value>
void read_names(const TomlDocument& document, std::string_view key, std::span<const std::string_view> names,
                std::vector<Value>& values) {
    const TomlEntry* entry = document.find(key);
    if (entry == nullptr) return;
    values.clear();
    for (const std::string& name : list_of(*entry))
        values.push_back(static_cast<Value>(place_of_name(name, *entry, names)));
}

// the entry that an error of the sweep is about: the key its words name first
const TomlEntry* culprit(const TomlDocument& document, const std::string& what) {
    const TomlEntry* best = nullptr;
    std::size_t best_position = std::string::npos;
    for (const TomlEntry& entry : document.entries) {
        const std::size_t position = what.find(entry.key);
        const bool is_earlier = position < best_position;
        const bool is_longer = position == best_position && best != nullptr && entry.key.size() >= best->key.size();
        const bool is_word = entry.key.find('.') == std::string::npos;  // a section or the title
        if (is_word || position == std::string::npos || !(is_earlier || is_longer)) continue;
        best = &entry;
        best_position = position;
    }
    return best != nullptr ? best : document.find("chart");
}

}  // namespace

sweep::Study read_study(const TomlSource& source, const AxisTexts& axes) {
    return read_study(parse_toml(source), axes);
}

sweep::Study read_study(const TomlDocument& document, const AxisTexts& axes, const CaseReaders& readers) {
    Complaints complaints;
    sweep::Study study;
    check_chart_keys(document, complaints);
    if (complaints.empty()) complaints.keep([&] { check_chart_complete(document, axes); });
    const bool has_case = complaints.keep([&] { study.base = read_base_case(document, readers); });
    const bool is_over_x = is_over_x_alone(document, axes);
    const auto axis = [&](const std::string& text, const std::string& name, sweep::Axis& into) {
        if (text.empty()) {
            into = read_axis(document, "chart." + name, complaints);
            if (has_case)
                complaints.keep([&] { expect_joint_of(study.base, document, "chart." + name + ".parameter"); });
        } else if (has_case)
            complaints.keep([&] {
                into = read_axis_text(study.base, text, is_over_x ? usual_points_alone : usual_points, "--" + name);
            });
    };
    axis(axes.x, "x", study.x);
    if (!is_over_x) axis(axes.y, "y", study.y);
    complaints.keep([&] { read_names(document, "chart.directions", parameters::direction_names, study.directions); });
    complaints.keep([&] { read_names(document, "chart.starts", sweep::start_names(), study.starts); });
    // a chart's file may be looked at along one axis: what it says of areas means nothing then
    if (const TomlEntry* entry = document.find("chart.refine"); entry != nullptr && !is_over_x)
        complaints.keep([&] { study.refine = count_of(*entry, sweep::most_refinement, "halvings"); });
    if (const TomlEntry* entry = document.find("chart.quantities"))
        complaints.keep([&] { study.quantities = list_of(*entry); });
    complaints.throw_any();
    if (is_over_x) study.y = sweep::resting_axis(study.base, study.x);
    try {
        sweep::check(study);
    } catch (const Error& error) {
        const TomlEntry* entry = culprit(document, error.problem().what);
        throw Error(error.kind(), error.problem(), entry != nullptr ? entry->value_place : whole_file(document));
    }
    return study;
}

sweep::Study read_study(const std::string& path, std::vector<std::string> overrides) {
    return read_study(load_toml(path, std::move(overrides)));
}

}  // namespace stridor::io
