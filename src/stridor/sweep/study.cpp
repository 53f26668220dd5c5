#include "stridor/sweep/study.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/escapes.hpp"
#include "stridor/base/field_table.hpp"
#include "stridor/base/text.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/rules/check.hpp"
#include "stridor/parameters/rules/resolution.hpp"
#include "stridor/parameters/tables/material_pair.hpp"
#include "stridor/sweep/cell.hpp"
#include "stridor/sweep/refinement.hpp"
#include "stridor/sweep/starts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace stridor::sweep {

namespace {

using base::shortest;
using parameters::Case;
using parameters::Direction;
using parameters::Field;

// widest logarithmic axis: what base::power_of_2 computes
constexpr double most_octaves = 1000.0;

constexpr std::string_view initial_key = "run.initial";

std::string in_quotes(std::string_view text) {
    return "\"" + std::string(text) + "\"";
}

bool is_constant(const Study& study) {
    return parameters::has_one_phase(study.base.drive);
}

std::string_view direction_name(Direction direction) {
    return parameters::direction_names[static_cast<std::size_t>(direction)];
}

std::string_view start_name(parameters::Initial start) {
    return start_names()[static_cast<std::size_t>(start)];
}

// the base case with a start that all keys belong to which mean something for one of the starts
Case widest_case(const Study& study) {
    Case c = study.base;
    if (study.starts.empty()) return c;
    const bool slides =
        std::find(study.starts.begin(), study.starts.end(), parameters::Initial::sliding) != study.starts.end();
    c.run.initial = slides ? parameters::Initial::sliding : study.starts.front();
    return c;
}

double octaves(const Axis& axis) {
    return base::logarithm_2(axis.to) - base::logarithm_2(axis.from);
}

// refuses an axis named "chart.x" or "chart.y" along what is no quantity of the case
void check_quantity(const Study& study, const Axis& axis, const std::string& name) {
    const Field* field = parameters::field_of(axis.parameter);
    const bool is_quantity = field != nullptr && std::holds_alternative<parameters::Quantity>(field->kind);
    if (!is_quantity) {
        base::refuse(name + ".parameter = " + in_quotes(axis.parameter) + " is no quantity",
                     field == nullptr ? "a case has no such key" : "it has no numbers an axis could run through",
                     base::did_you_mean(axis.parameter, parameters::quantity_keys()));
    }
    try {
        parameters::expect_joint_of(study.base, axis.parameter);
    } catch (const Error& error) {
        base::refuse(name + ".parameter: " + error.problem().what, error.problem().why, error.problem().suggestion);
    }
    if (!parameters::belongs(widest_case(study), axis.parameter))
        base::refuse(name + ".parameter = " + in_quotes(axis.parameter) + " changes nothing",
                     "this case, with its kind of drive and start, does not use it", "Choose another quantity.");
}

void check_end(const Study& study, const Axis& axis, double value, const std::string& name) {
    Case probe = study.base;
    try {
        parameters::set_quantity(probe, axis.parameter, value);
    } catch (const Error& error) {
        throw Error(error.kind(),
                    {name + ": " + error.problem().what, error.problem().why, error.problem().suggestion});
    }
    // every cell beyond would be invalid, and a logarithmic axis is drawn half a cell longer: up to infinity
    if (std::abs(value) > parameters::largest_number)
        base::refuse(name + " = " + shortest(value) + " is beyond 1e75",
                     "products of such numbers leave double precision", "Check its unit.");
}

void check_axis(const Study& study, const Axis& axis, const std::string& name) {
    check_quantity(study, axis, name);
    if (axis.points < 2)
        base::refuse(name + ".points = " + std::to_string(axis.points) + " makes no axis",
                     "both ends belong to it, so it has two at least", "");
    if (axis.points > most_points)
        base::refuse(name + ".points = " + std::to_string(axis.points) + " is too many",
                     "an axis has at most " + std::to_string(most_points) + " points", "");
    check_end(study, axis, axis.from, name + ".from");
    check_end(study, axis, axis.to, name + ".to");
    if (!(axis.from < axis.to))
        base::refuse(name + ".from = " + shortest(axis.from) + " is not below " + name + ".to = " + shortest(axis.to),
                     "an axis rises", axis.from > axis.to ? "Swap them?" : "");
    if (axis.scale == Scale::linear) return;
    if (!(axis.from > 0.0))
        base::refuse(name + ".from = " + shortest(axis.from) + " has no logarithm",
                     "a logarithmic axis holds positive values only", "Set " + name + ".scale = \"linear\"?");
    if (octaves(axis) >= most_octaves)
        base::refuse(name + " runs from " + shortest(axis.from) + " to " + shortest(axis.to),
                     "a logarithmic axis spans less than 1000 octaves", "");
}

void check_size(const Study& study) {
    if (cell_count(study) > most_cells)
        base::refuse("a chart of " + std::to_string(cell_count(study)) + " cells is too large",
                     "it has at most " + std::to_string(most_cells), "Cut it into several charts.");
}

void check_directions(const Study& study) {
    if (study.directions.empty())
        base::refuse("chart.directions is empty", "there would be nothing to compute",
                     "Write directions = [\"going\", \"coming\"]?");
    for (auto it = study.directions.begin(); it != study.directions.end(); ++it)
        if (std::find(study.directions.begin(), it, *it) != it)
            base::refuse("chart.directions names " + in_quotes(direction_name(*it)) + " twice", "each is computed once",
                         "");
}

void check_starts(const Study& study) {
    for (auto it = study.starts.begin(); it != study.starts.end(); ++it)
        if (std::find(study.starts.begin(), it, *it) != it)
            base::refuse("chart.starts names " + in_quotes(start_name(*it)) + " twice", "each is computed once", "");
}

void check_refinement(const Study& study) {
    if (has_one_axis(study) && study.refine != 0)
        base::refuse("chart.refine = " + std::to_string(study.refine) + " refines nothing",
                     "it follows the boundaries between areas, and this chart has one axis", "Leave chart.refine out.");
    if (study.refine < 0 || study.refine > most_refinement)
        base::refuse(
            "chart.refine = " + std::to_string(study.refine) + " is out of range",
            "the base grid has every 2^refine-th point, and refine is from 0 to " + std::to_string(most_refinement),
            "");
}

void check_quantities(const Study& study) {
    std::vector<std::string_view> names{"category"};
    for (const CellFigure& figure : cell_figures())
        names.push_back(figure.name);
    for (const std::string& quantity : study.quantities)
        if (std::find(names.begin(), names.end(), quantity) == names.end())
            base::refuse("chart.quantities names " + in_quotes(quantity), "a cell has no such figure",
                         base::did_you_mean(quantity, names));
}

// the one value of y of a study over x alone
void check_resting(const Study& study) {
    const Axis rests = resting_axis(study.base, study.x);
    const bool is_so = study.y.parameter == rests.parameter && study.y.from == rests.from && study.y.to == rests.to;
    if (!is_so)
        base::refuse("chart.y.points = 1 makes no axis", "both ends belong to it, so it has two at least",
                     "Leave chart.y out for a diagram over x alone.");
}

// A finding that reads the same at all four corners does not come from the axes: every cell would be invalid.
void check_corners(const Study& study, std::size_t start) {
    const auto findings_at = [&](int iy, int ix) { return parameters::findings(case_at(study, {0, iy, ix, start})); };
    const std::vector<parameters::Finding> others[] = {findings_at(0, study.x.points - 1),
                                                       findings_at(study.y.points - 1, 0),
                                                       findings_at(study.y.points - 1, study.x.points - 1)};
    for (const parameters::Finding& finding : findings_at(0, 0)) {
        const auto has_it = [&](const std::vector<parameters::Finding>& found) {
            return std::any_of(found.begin(), found.end(), [&](const parameters::Finding& other) {
                return other.key == finding.key && other.problem.what == finding.problem.what;
            });
        };
        if (std::all_of(std::begin(others), std::end(others), has_it)) throw Error(ErrorKind::input, finding.problem);
    }
}

std::string axis_line(const std::string& name, const Axis& axis) {
    return name + " = " + axis.parameter + ", " + std::to_string(axis.points) + " points from " + shortest(axis.from) +
           " to " + shortest(axis.to) + ", " + std::string(scale_names[static_cast<std::size_t>(axis.scale)]) + "\n";
}

// the line "key = value", if there is one
void remove_line(std::string& text, std::string_view key) {
    const std::string start = std::string(key) + " = ";
    std::size_t from = text.rfind(start, 0) == 0 ? 0 : text.find("\n" + start);
    if (from == std::string::npos) return;
    if (from > 0) ++from;
    text.erase(from, text.find('\n', from) - from + 1);
}

std::string setting(const Case& c, const std::string& key) {
    return " --set " + key + "=" + shortest(parameters::get_quantity(c, key));
}

}  // namespace

double value_at(const Axis& axis, int index) {
    STRIDOR_EXPECT(index >= 0 && index < axis.points);
    if (index == 0) return axis.from;
    if (index == axis.points - 1) return axis.to;
    const double share = static_cast<double>(index) / (axis.points - 1);
    const double value = axis.scale == Scale::logarithmic ? axis.from * base::power_of_2(share * octaves(axis))
                                                          : axis.from + share * (axis.to - axis.from);
    // rounding must not carry a value out of the field's range
    return std::clamp(value, axis.from, axis.to);
}

Axis resting_axis(const Case& c, const Axis& x) {
    constexpr std::array<std::string_view, 5> resting{"contact.preload", "contact.kinetic_friction",
                                                      "joint.incidence_angle", "structure.stiffness_scale",
                                                      "structure.damping_scale"};
    // what x leaves alone and does not follow the temperature; of several joints the first one's
    const auto rests = [&](std::string_view key) {
        return parameters::belongs(c, key) && !parameters::overlap(c, x.parameter, key) &&
               !parameters::follows_table(c, key);
    };
    const auto found = std::find_if(resting.begin(), resting.end(), rests);
    STRIDOR_EXPECT(found != resting.end());
    const std::string key = parameters::single_keys(c, *found).front();
    const double value = parameters::get_quantity(c, key);
    return {key, value, value, 1, Scale::linear};
}

bool has_one_axis(const Study& study) {
    return study.y.points == 1;
}

double own_value(const Study& study, const Axis& axis) {
    const double value = parameters::get_quantity(study.base, axis.parameter);
    return axis.parameter == "drive.velocity" && is_constant(study) ? std::abs(value) : value;
}

bool holds_design(const Study& study) {
    const auto holds = [&](const Axis& axis) {
        const double value = own_value(study, axis);
        return parameters::has_one_value(study.base, axis.parameter) && value >= axis.from && value <= axis.to;
    };
    return holds(study.x) && holds(study.y);
}

std::size_t cell_count(const Study& study) {
    return static_cast<std::size_t>(study.x.points) * static_cast<std::size_t>(study.y.points) *
           study.directions.size();
}

std::size_t directions_per_run(const Study& study) {
    return is_constant(study) ? 1 : study.directions.size();
}

std::size_t run_of(const Study& study, std::size_t index) {
    const std::size_t points = cell_count(study) / study.directions.size();
    const std::size_t direction = index / points;
    return index - direction % directions_per_run(study) * points;
}

CellPlace place_of(const Study& study, std::size_t index) {
    const auto columns = static_cast<std::size_t>(study.x.points);
    const auto rows = static_cast<std::size_t>(study.y.points);
    return {index / (columns * rows), static_cast<int>(index / columns % rows), static_cast<int>(index % columns)};
}

std::size_t index_of(const Study& study, const CellPlace& place) {
    const auto columns = static_cast<std::size_t>(study.x.points);
    const auto rows = static_cast<std::size_t>(study.y.points);
    return (place.direction * rows + static_cast<std::size_t>(place.iy)) * columns + static_cast<std::size_t>(place.ix);
}

Case case_at(const Study& study, const CellPlace& place) {
    Case c = study.base;
    parameters::set_quantity(c, study.x.parameter, value_at(study.x, place.ix));
    parameters::set_quantity(c, study.y.parameter, value_at(study.y, place.iy));
    const double sign = study.directions[place.direction] == Direction::going ? 1.0 : -1.0;
    if (is_constant(study)) c.drive.velocity = std::copysign(c.drive.velocity, sign);
    if (!study.starts.empty()) c.run.initial = study.starts[place.start];
    return c;
}

void check(const Study& study) {
    check_axis(study, study.x, "chart.x");
    if (has_one_axis(study))
        check_resting(study);
    else
        check_axis(study, study.y, "chart.y");
    if (study.x.parameter == study.y.parameter)
        base::refuse("chart.x and chart.y are both " + study.x.parameter, "a chart needs two different quantities", "");
    if (parameters::overlap(study.base, study.x.parameter, study.y.parameter))
        base::refuse("chart.x = " + study.x.parameter + " and chart.y = " + study.y.parameter + " overlap",
                     "a key without a joint's name is that of all joints", "Name a joint in both.");
    check_directions(study);
    check_starts(study);
    check_refinement(study);
    check_size(study);
    check_quantities(study);
    for (std::size_t start = 0; start < std::max<std::size_t>(1, study.starts.size()); ++start)
        check_corners(study, start);
}

Study preview(Study study) {
    constexpr int points = 64;
    constexpr int refinement = 3;
    constexpr double shorter = 0.25;
    constexpr double periods = 2.0;
    for (Axis* axis : {&study.x, &study.y})
        axis->points = std::min(axis->points, points);
    if (!has_one_axis(study)) study.refine = std::max(study.refine, sound_refinement(study, refinement));
    if (is_constant(study)) {
        study.base.run.duration *= shorter;
        study.base.run.window = 0.5 * study.base.run.duration;
    } else if (const double rate = parameters::repetition_rate(study.base.drive); rate > 0.0) {
        study.base.run.duration = std::min(study.base.run.duration, periods / rate);
        study.base.run.window = std::min(study.base.run.window, study.base.run.duration);
    }
    return study;
}

std::string canonical_text(const Study& study) {
    Case c = widest_case(study);
    if (is_constant(study)) c.drive.velocity = std::abs(c.drive.velocity);
    // the structure's content is that of one cell: what the case says besides changes no cell
    for (const Axis* axis : {&study.x, &study.y})
        if (parameters::is_of_builder(*parameters::field_of(axis->parameter)))
            parameters::set_quantity(c, axis->parameter, axis->from);
    std::string text = parameters::canonical_text(c);
    for (const Axis* axis : {&study.x, &study.y})
        for (const std::string& key : parameters::single_keys(study.base, axis->parameter))
            remove_line(text, key);
    if (!study.starts.empty()) remove_line(text, initial_key);
    text += axis_line("chart.x", study.x) + axis_line("chart.y", study.y) + "chart.directions =";
    for (const Direction direction : study.directions)
        text += " " + std::string(direction_name(direction));
    text += "\n";
    if (study.refine > 0) text += "chart.refine = " + std::to_string(study.refine) + "\n";
    if (study.starts.empty()) return text;
    text += "chart.starts =";
    for (const parameters::Initial start : study.starts)
        text += " " + std::string(start_name(start));
    return text + "\n";
}

std::string reproduce_command(const Study& study, const CellPlace& place, const std::string& file) {
    const Case c = case_at(study, place);
    constexpr std::string_view velocity = "drive.velocity";
    // a name with a dash in front would be an option
    const bool is_option = file.starts_with('-') && file != "-";
    std::string command =
        "stridor simulate " + base::shell_word((is_option ? "./" : "") + file) + setting(c, study.x.parameter);
    if (!has_one_axis(study)) command += setting(c, study.y.parameter);
    const bool is_axis = study.x.parameter == velocity || study.y.parameter == velocity;
    if (parameters::is_steady(c.drive) && !is_axis) command += setting(c, std::string(velocity));
    if (!study.starts.empty())
        command += " --set " + std::string(initial_key) + "=" + std::string(start_name(c.run.initial));
    return command;
}

}  // namespace stridor::sweep
