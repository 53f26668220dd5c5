#include "stridor/io/case/toml_writer.hpp"

#include "stridor/base/text.hpp"
#include "stridor/io/case/own_structure/built_structure.hpp"
#include "stridor/parameters/contact_field.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/parameters/temperature_table.hpp"
#include "stridor/sweep/starts.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <span>
#include <sstream>
#include <string_view>
#include <variant>

namespace stridor::io {

namespace {

using parameters::Case;
using parameters::Choice;
using parameters::ContactField;
using parameters::Field;
using parameters::Quantity;

// a basic string: quotes, backslashes and control characters escaped
std::string basic_string(std::string_view text) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string result = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            result += '\\';
            result += c;
        } else if (code < 0x20U || code == 0x7FU) {
            result += "\\u00";
            result += digits[code >> 4U];
            result += digits[code & 15U];
        } else {
            result += c;
        }
    }
    return result + "\"";
}

// 1e7 for "1e+07", as people write it
std::string number_text(double value) {
    std::string text = base::shortest(value);
    const std::size_t exponent = text.find('e');
    if (exponent == std::string::npos) return text;
    const std::size_t first_digit = text.find_first_not_of("+-0", exponent + 1);
    const std::string sign = text[exponent + 1] == '-' ? "-" : "";
    return text.substr(0, exponent + 1) + sign + text.substr(std::min(first_digit, text.size() - 1));
}

std::string quantity_text(double value, std::string_view unit) {
    const std::string number = number_text(value);
    return unit == "1" ? number : basic_string(number + " " + std::string(unit));
}

std::string toml_value(parameters::CaseView at, const Field& field) {
    if (parameters::damping_ratio(at, field)) return basic_string(parameters::value_text(at, field));
    if (const auto* quantity = std::get_if<Quantity>(&field.kind))
        return quantity_text(quantity->get(at), quantity->unit);
    return basic_string(parameters::value_text(at, field));
}

std::string range_text(const parameters::Range& range) {
    const std::string low =
        (range.low_end == parameters::Range::Low::open ? "above " : "at least ") + base::shortest(range.low);
    if (range.zero == parameters::Range::Zero::excluded) return "not 0";
    if (std::isinf(range.low) && std::isinf(range.high)) return {};
    if (std::isinf(range.high)) return low;
    return base::shortest(range.low) + " to " + base::shortest(range.high);
}

std::string names_text(std::span<const std::string_view> names) {
    std::string text;
    for (std::size_t k = 0; k < names.size(); ++k) {
        const bool is_last = k + 1 == names.size();
        text += (k == 0 ? "" : is_last ? " or " : ", ") + basic_string(names[k]);
    }
    return text;
}

constexpr std::size_t widest_line = 120;  // [1] columns

constexpr char kept_blank = '\x1f';  // where no line may be broken

// a sentence in lines behind "#"
std::string comment_lines(const std::string& sentence) {
    const std::string lines = base::wrapped(sentence, {.columns = widest_line - 2, .indent = 2});
    std::string text = "# ";
    for (const char letter : lines)
        text += letter == '\n' ? "\n# " : std::string(1, letter == kept_blank ? ' ' : letter);
    return text + "\n";
}

// unit and range, in one piece
std::string values_text(const Field& field) {
    std::string values = describe_values(field);
    if (!std::holds_alternative<Quantity>(field.kind)) return ": " + values;
    std::replace(values.begin(), values.end(), ' ', kept_blank);
    return values.empty() ? "" : " [" + values + "]";
}

// `when`: the choice that gives it a meaning, if this case does not
std::string comment(const Field& field, const std::string& when = {}) {
    std::string text = (when.empty() ? "" : "with " + when + ": ") + std::string(field.sentence);
    if (!field.symbol.empty()) text += " (" + std::string(field.symbol) + ")";
    return comment_lines(std::holds_alternative<parameters::Text>(field.kind) ? text : text + values_text(field));
}

std::string heading(const TomlOptions& options) {
    std::string text;
    std::istringstream lines(options.heading);
    for (std::string line; std::getline(lines, line);)
        text += line.empty() ? "#\n" : "# " + line + "\n";
    return text.empty() ? text : text + "\n";
}

std::string axis_text(const sweep::Axis& axis) {
    const std::string_view unit = parameters::unit_of(axis.parameter);
    return "{ parameter = " + basic_string(axis.parameter) + ", from = " + quantity_text(axis.from, unit) +
           ", to = " + quantity_text(axis.to, unit) + ", points = " + std::to_string(axis.points) +
           ", scale = " + basic_string(sweep::scale_names[static_cast<std::size_t>(axis.scale)]) + " }";
}

template <typename Items, typename Name>
std::string list_text(const Items& items, Name name) {
    std::string text;
    for (const auto& item : items)
        text += (text.empty() ? "" : ", ") + basic_string(name(item));
    return "[" + text + "]";
}

// the table below temperature.value
std::string table_lines(const Case& c, const TomlOptions& options) {
    const std::string about = options.comments == Comments::full
                                  ? "# what follows the temperature: its values at these, linear between them\n"
                                  : "";
    const auto line = [](std::string_view key, std::string_view unit, const std::vector<double>& values) {
        std::string list;
        for (const double value : values)
            list += (list.empty() ? "" : ", ") + quantity_text(value, unit);
        return std::string(key) + " = [" + list + "]\n";
    };
    std::string text = about + line("at", "degC", c.temperature.at);
    for (const parameters::TemperatureColumn& column : c.temperature.columns)
        text += column.holds == parameters::TemperatureColumn::Holds::damping_ratio
                    ? column.key + " = " + list_text(parameters::value_texts(column), std::identity{}) + "\n"
                    : line(column.key, parameters::unit_of(column.key), column.values);
    return text;
}

// does a file of this case have a line for it, be it as a comment?
bool has_line(parameters::CaseView at, const Field& field, const TomlOptions& options) {
    if (parameters::temperature_column(at, field) != nullptr) return false;
    if (parameters::is_of_builder(field)) return false;  // said where the builder is
    if (options.comments == Comments::full) return field.belongs(at) || !parameters::home_of(at, field).empty();
    return field.belongs(at) && !parameters::goes_without_saying(at, field);
}

}  // namespace

std::string describe_values(const parameters::Field& field) {
    if (const auto* quantity = std::get_if<Quantity>(&field.kind)) {
        const std::string range = range_text(quantity->range);
        if (quantity->unit == "1") return range;
        return std::string(quantity->unit) + (range.empty() ? "" : ", " + range);
    }
    if (const auto* choice = std::get_if<Choice>(&field.kind)) return names_text(choice->names);
    return "text";
}

std::string toml_line(parameters::CaseView at, const Field& field) {
    const bool is_unknown_file = parameters::names_file(field) && parameters::value_text(at, field).empty();
    return std::string(field.name) + " = " + (is_unknown_file ? basic_string("velocity.csv") : toml_value(at, field));
}

namespace {

enum class Sections { all, of_joint, but_joint };

std::string section_lines(parameters::CaseView at, const TomlOptions& options, Sections sections,
                          std::string text = {}) {
    std::string_view section;
    for (const Field& field : parameters::fields()) {
        const bool is_of_joint = parameters::is_of_joint(field);
        const bool is_wanted =
            is_of_joint ? sections == Sections::of_joint : !field.section.empty() && sections == Sections::but_joint;
        if (sections != Sections::all && !is_wanted) continue;
        if (!has_line(at, field, options)) continue;
        const bool is_used = field.belongs(at);
        if (field.section != section) text += (text.empty() ? "[" : "\n[") + std::string(field.section) + "]\n";
        section = field.section;
        if (options.comments == Comments::full) text += comment(field, is_used ? "" : parameters::home_of(at, field));
        text += (is_used ? "" : "#") + toml_line(at, field) + "\n";
        if (section == "temperature") text += table_lines(at.c, options);
    }
    return text;
}

std::string numbers_text(std::span<const double> numbers) {
    std::string items;
    for (const double number : numbers)
        items += (items.empty() ? "" : ", ") + number_text(number);
    return "[" + items + "]";
}

// a structure of the user's own with all its numbers, whatever it was made from
std::string matrix_lines(const parameters::OwnStructure& own) {
    const std::size_t rows = own.row.size();
    std::string text;
    const auto matrix = [&](std::string_view key, const std::vector<double>& numbers) {
        if (numbers.empty()) return;
        text += std::string(key) + " = [";
        for (std::size_t row = 0; row < rows; ++row)
            text += (row > 0 ? ",\n  " : "\n  ") + numbers_text(std::span(numbers).subspan(row * rows, rows));
        text += "\n]\n";
    };
    const auto number = [&](std::string_view key, double value, std::string_view unit) {
        if (value != 0.0) text += std::string(key) + " = " + quantity_text(value, unit) + "\n";
    };
    const auto vector = [&](std::string_view key, const std::vector<double>& numbers) {
        if (!numbers.empty()) text += std::string(key) + " = " + numbers_text(numbers) + "\n";
    };
    if (own.recipe) {
        vector("force", own.force);
        vector("initial_displacement", own.initial_displacement);
        return recipe_lines(*own.recipe) + text;
    }
    text += "rows = " + list_text(own.row, std::identity{}) + "\n";
    matrix("mass", own.mass);
    matrix("stiffness", own.stiffness);
    matrix("damping", own.damping);
    number("damping_ratio", own.following.ratio, "1");
    number("loss_factor", own.following.loss_factor, "1");
    number("rayleigh_mass", own.following.rayleigh_mass, "1/s");
    number("rayleigh_stiffness", own.following.rayleigh_stiffness, "s");
    number("left_out_above", own.left_out_above, "Hz");
    vector("load", own.load);
    vector("force", own.force);
    vector("initial_displacement", own.initial_displacement);
    vector("initial_velocity", own.initial_velocity);
    return text;
}

std::string output_tables(const parameters::OwnStructure& own) {
    std::string text;
    for (const parameters::OwnOutput& output : own.outputs)
        text += "\n[[structure.output]]\nname = " + basic_string(output.name) +
                "\ndirection = " + numbers_text(output.weights) + "\n";
    return text;
}

std::string contact_tables(const parameters::OwnStructure& own) {
    const auto text_of = [](const parameters::ContactValue& value, std::string_view unit) {
        if (const auto* words = std::get_if<std::string>(&value)) return basic_string(*words);
        if (const auto* number = std::get_if<double>(&value)) return quantity_text(*number, unit);
        return numbers_text(std::get<std::vector<double>>(value));
    };
    std::string text;
    for (const parameters::OwnContact& contact : own.contacts) {
        text += "\n[[structure.contact]]\n";
        for (const ContactField& field : parameters::contact_fields())
            if (field.key == "name" || field.need == ContactField::Need::required || !is_usual(contact, field))
                text += std::string(field.key) + " = " + text_of(value_of(contact, field), field.unit) + "\n";
    }
    return text;
}

void replace_line(std::string& text, std::string_view line, std::string_view by) {
    if (const std::size_t at = text.find(line); at != std::string::npos) text.replace(at, line.size(), by);
}

// [joint] and [contact] of one joint as [[joint]], with its name, and [joint.contact]
std::string joint_table(const Case& c, std::size_t joint, const TomlOptions& options) {
    std::string text = section_lines({c, joint}, options, Sections::of_joint);
    replace_line(text, "[joint]\n", "[[joint]]\nname = " + basic_string(parameters::joint_name(c, joint)) + "\n");
    replace_line(text, "\n[contact]\n", "\n[joint.contact]\n");
    return text;
}

}  // namespace

std::string case_toml(const parameters::Case& c, const TomlOptions& options) {
    if (c.own_structure) {
        std::string text = section_lines(c, options, Sections::all, heading(options));
        replace_line(text, "[structure]\n", "[structure]\n" + matrix_lines(*c.own_structure));
        if (!c.own_structure->recipe) text += contact_tables(*c.own_structure);
        return text + output_tables(*c.own_structure);
    }
    if (!parameters::has_several_joints(c)) return section_lines(c, options, Sections::all, heading(options));
    std::string text = heading(options);
    if (!c.title.empty()) text += toml_line(c, *parameters::find_field("title")) + "\n\n";
    for (std::size_t joint = 0; joint < parameters::joint_count(c); ++joint)
        text += joint_table(c, joint, options) + "\n";
    Case shared = c;
    shared.title.clear();
    return text + section_lines(shared, options, Sections::but_joint);
}

std::string study_toml(const sweep::Study& study, const TomlOptions& options) {
    const auto say = [&](std::string_view sentence) {
        return options.comments == Comments::full ? "# " + std::string(sentence) + "\n" : std::string();
    };
    std::string text = case_toml(study.base, options) + "\n[chart]\n";
    text += say("the axes: any quantity above; ends in its unit, both included; scale \"linear\" or \"log\"");
    text += "x = " + axis_text(study.x) + "\n";
    if (!sweep::has_one_axis(study)) text += "y = " + axis_text(study.y) + "\n";
    text += say("which way the plate moves: going is V > 0, coming V < 0");
    text += "directions = " +
            list_text(study.directions,
                      [](parameters::Direction direction) {
                          return parameters::direction_names[static_cast<std::size_t>(direction)];
                      }) +
            "\n";
    text += say("what to draw: \"category\" or any figure of a cell, such as \"separation\" or \"frequency\"");
    text += "quantities = " + list_text(study.quantities, [](const std::string& name) { return name; }) + "\n";
    if (!sweep::has_one_axis(study)) {
        text +=
            say("0 computes every cell; 1 to 6 begin with every 2nd to 64th point and halve that where cells differ");
        text += "refine = " + std::to_string(study.refine) + "\n";
    }
    text += say("each cell is run from all of these instead of run.initial, and shows the worst");
    if (study.starts.empty()) return text + say("starts = " + list_text(sweep::start_names(), std::identity{}));
    return text + "starts = " +
           list_text(study.starts,
                     [](parameters::Initial start) { return sweep::start_names()[static_cast<std::size_t>(start)]; }) +
           "\n";
}

}  // namespace stridor::io
