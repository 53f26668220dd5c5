#include "stridor/io/case/toml_writer.hpp"

#include "stridor/base/text.hpp"
#include "stridor/io/case/case_document.hpp"
#include "stridor/io/case/own_structure/built_structure.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/fields/contact_field.hpp"
#include "stridor/parameters/fields/spring_field.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/sweep/starts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <span>
#include <sstream>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace stridor::io {

namespace {

using parameters::Case;
using parameters::Choice;
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
    const auto* text = std::get_if<parameters::Text>(&field.kind);
    const bool is_unsaid = text != nullptr && !text->example.empty() && text->get(at).empty();
    return std::string(field.name) + " = " + (is_unsaid ? basic_string(text->example) : toml_value(at, field));
}

namespace {

// the case as the joint is asked of it whose table a key stands in: "joint.2.mass"
parameters::CaseView view_of(const Case& c, std::string_view key) {
    const auto of_list = parameters::joint_key(key);
    return {c, of_list ? std::stoul(of_list->joint) - 1 : 0};
}

// "joint.1.contact" as [joint.contact], "structure.output.2" as [[structure.output]]
std::string header_line(std::string_view table) {
    std::string name;
    bool is_of_list = false;
    for (std::size_t begin = 0, end = 0; end != std::string_view::npos; begin = end + 1) {
        end = table.find('.', begin);
        const std::string_view part = table.substr(begin, end == std::string_view::npos ? end : end - begin);
        is_of_list = part.find_first_not_of("0123456789") == std::string_view::npos;
        if (!is_of_list) name += (name.empty() ? "" : ".") + std::string(part);
    }
    return is_of_list ? "[[" + name + "]]\n" : "[" + name + "]\n";
}

// of what is no field: the unit in which its number is written
std::string_view unit_of_entry(const std::string& table, std::string_view name) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 3> of_matrices{
        {{"rayleigh_mass", "1/s"}, {"rayleigh_stiffness", "s"}, {"left_out_above", "Hz"}}};
    if (table == "temperature") return name == "at" ? "degC" : parameters::unit_of(name);
    if (table.starts_with("structure.contact.")) return parameters::contact_field(name).unit;
    if (table.starts_with("structure.spring.")) return parameters::spring_field(name).unit;
    for (const auto& [key, unit] : of_matrices)
        if (key == name) return unit;
    return parameters::unit_of(table + "." + std::string(name));
}

std::string numbers_text(const std::vector<double>& numbers, std::string_view unit) {
    std::string items;
    for (const double number : numbers)
        items += (items.empty() ? "" : ", ") + quantity_text(number, unit);
    return "[" + items + "]";
}

std::string rows_text(const TomlRows& rows) {
    std::string lines;
    for (const std::vector<double>& row : rows)
        lines += (lines.empty() ? "\n  " : ",\n  ") + numbers_text(row, "1");
    return "[" + lines + "\n]";
}

// a number of a list has a unit where it follows the temperature
std::string text_of_entry(const TomlValue& value, const std::string& table, std::string_view name) {
    if (const auto* words = std::get_if<std::string>(&value)) return basic_string(*words);
    if (const auto* list = std::get_if<std::vector<std::string>>(&value)) return list_text(*list, std::identity{});
    if (const auto* rows = std::get_if<TomlRows>(&value)) return rows_text(*rows);
    if (const auto* number = std::get_if<double>(&value)) return quantity_text(*number, unit_of_entry(table, name));
    return numbers_text(std::get<std::vector<double>>(value),
                        table == "temperature" ? unit_of_entry(table, name) : "1");
}

// what a line of [structure] or [temperature] is about
std::string comment_of_entry(const Case& c, const std::string& table, std::string_view name,
                             const TomlOptions& options) {
    const bool is_full = options.comments == Comments::full;
    if (is_full && table == "temperature" && name == "at")
        return "# what follows the temperature: its values at these, linear between them\n";
    if (table != "structure" || !c.own_structure->recipe) return {};
    for (const BuilderKey& key : builder_keys(c.own_structure->recipe->builder))
        if (key.name == name) return "# " + std::string(sentence_of(key)) + "\n";
    return {};
}

std::string field_lines(parameters::CaseView at, const Field& field, const TomlOptions& options) {
    const bool is_used = field.belongs(at);
    const bool is_explained =
        options.comments == Comments::full && (!field.section.empty() || !parameters::has_several_joints(at.c));
    return (is_explained ? comment(field, is_used ? "" : parameters::home_of(at, field)) : "") + (is_used ? "" : "#") +
           toml_line(at, field) + "\n";
}

// a line, and beside it what the field is
std::string explained(std::string line, const Field& field) {
    constexpr std::size_t column = 36;  // where comments begin
    line.pop_back();
    const std::string sentence(field.sentence);
    const std::string words = field.symbol.empty() ? sentence : sentence + " (" + std::string(field.symbol) + ")";
    std::string text = line + std::string(line.size() < column ? column - line.size() : 1, ' ') + "# ";
    for (const char letter : base::wrapped(words, {.columns = 74}))
        text += letter == '\n' ? "\n" + std::string(column, ' ') + "# " : std::string(1, letter);
    return text + "\n";
}

// is it of a structure that no builder makes, and for programs only: a list of numbers or names, an output?
bool is_of_matrices(const TomlEntry& entry) {
    const bool is_list = !std::holds_alternative<double>(entry.value) &&
                         !std::holds_alternative<TomlTable>(entry.value) &&
                         !std::holds_alternative<std::string>(entry.value);
    return entry.key.starts_with("structure.output") || (is_list && entry.key.starts_with("structure."));
}

}  // namespace

std::string case_toml(const parameters::Case& c, const TomlOptions& options) {
    const TomlDocument document =
        document_of(c, options.comments == Comments::full ? CaseDepth::whole_and_idle : CaseDepth::whole);
    const auto opens = [](const TomlEntry& entry) { return std::holds_alternative<TomlTable>(entry.value); };
    const bool is_beside = options.comments == Comments::beside;
    const bool has_matrices = parameters::has_given_structure(c);
    std::string text = heading(options);
    std::string table;
    for (auto entry = document.entries.begin(); entry != document.entries.end(); ++entry) {
        if (is_beside && has_matrices && is_of_matrices(*entry)) continue;
        if (opens(*entry)) {
            table = entry->key;
            // a list is opened by its tables
            if (opens(*std::next(entry))) continue;
            text += (text.empty() || text.ends_with("\n\n") ? "" : "\n") + header_line(table);
            if (is_beside && has_matrices && table == "structure")
                text += "# " + c.own_structure->origin + ": " + std::to_string(c.own_structure->row.size()) +
                        " rows, content " + parameters::content_hash(*c.own_structure) + "\n";
            continue;
        }
        const std::string name = table.empty() ? entry->key : entry->key.substr(table.size() + 1);
        const Field* field = parameters::field_of(entry->key);
        const bool is_built = field != nullptr && parameters::is_of_builder(*field);
        if (field == nullptr || is_built) text += comment_of_entry(c, table, name, options);
        std::string line = field != nullptr && !is_built
                               ? field_lines(view_of(c, entry->key), *field, options)
                               : name + " = " + text_of_entry(entry->value, table, name) + "\n";
        const bool is_told = is_beside && field != nullptr && !(is_built && has_matrices);
        text += is_told ? explained(std::move(line), *field) : line;
    }
    return text;
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
