#include "stridor/noise_library/field.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/field_table.hpp"
#include "stridor/base/hash.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/classification/verdict.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace stridor::noise_library {

namespace {

// the systems of the paper's database, and others from the practice of squeak and rattle
constexpr std::array<std::string_view, 22> systems{
    "brake",   "wiper",      "sunroof",     "seat",          "dashboard",  "door hinge",      "latch",          "seal",
    "clutch",  "belt",       "window lift", "steering gear", "suspension", "convertible top", "center console", "trim",
    "armrest", "cup holder", "glove box",   "pedal",         "sun visor",  "trunk lid"};
constexpr std::array<std::string_view, 3> places{"vehicle", "rig", "simulation"};

const std::array table{
    EntryField{"system", "vehicle system that makes the noise",
               EntryText{&Entry::system, EntryText::Shape::line, systems}},
    EntryField{"parts", "parts in contact", EntryText{&Entry::parts}},
    EntryField{"materials", "materials in contact", EntryText{&Entry::materials}},
    EntryField{"operation", "how it was operated", EntryText{&Entry::operation}},
    EntryField{"recorded", "where it was recorded", EntryChoice{&Entry::recorded, places}},
    EntryField{"denomination", "what the engineer calls the noise",
               EntryText{&Entry::denomination, EntryText::Shape::line, classification::category_names}},
    EntryField{"preload", "force that presses the surfaces together", EntryQuantity{&Entry::preload, "N", 0.0}},
    EntryField{"velocity", "relative velocity of the surfaces; of a motion to and fro its peak",
               EntryQuantity{&Entry::velocity, "m/s"}},
    EntryField{"velocity_profile", "course of the velocity, such as constant or sinusoidal 5 Hz",
               EntryText{&Entry::velocity_profile}},
    EntryField{"temperature", "temperature of the surfaces or the room",
               EntryQuantity{&Entry::temperature, "degC", -273.15}},
    EntryField{"humidity", "relative humidity", EntryQuantity{&Entry::humidity, "%", 0.0, 100.0}},
    EntryField{"sensor", "microphone or accelerometer, and where it stood", EntryText{&Entry::sensor}},
    EntryField{"calibration", "what full scale is", EntryText{&Entry::calibration}},
    EntryField{"date", "when it was recorded, YYYY-MM-DD", EntryDate{&Entry::date}},
    EntryField{"author", "who recorded it", EntryText{&Entry::author}},
    EntryField{"licence", "what others may do with it", EntryText{&Entry::licence}},
    EntryField{"notes", "anything else", EntryText{&Entry::notes, EntryText::Shape::lines}},
    EntryField{"case", "case file (TOML) that a simulated sound came from",
               EntryText{&Entry::case_text, EntryText::Shape::document}},
    EntryField{"file", "name of the file before it was added", EntryText{&Entry::file}, Writer::stridor},
    EntryField{"format", "kind of the file, its extension", EntryText{&Entry::format}, Writer::stridor},
    EntryField{"duration", "how long it lasts", EntryQuantity{&Entry::duration, "s", 0.0}, Writer::stridor},
    EntryField{"rate", "samples per second", EntryQuantity{&Entry::rate, "Hz", 0.0}, Writer::stridor},
    EntryField{"channels", "number of channels", EntryQuantity{&Entry::channels, "1", 0.0}, Writer::stridor},
    EntryField{"audio", "SHA-256 of the file", EntryText{&Entry::audio}, Writer::stridor},
    EntryField{"category", "Stridor's verdict", EntryChoice{&Entry::category, classification::category_names},
               Writer::stridor},
    EntryField{"verdict", "Stridor's verdict in full (JSON)", EntryText{&Entry::verdict, EntryText::Shape::document},
               Writer::stridor},
};

bool is_unknown(std::string_view text) {
    return text.empty() || text == "unknown";
}

// the digits of a part of a date as a number; -1 if they are none
int digits(std::string_view text) {
    int value = 0;
    for (const char c : text) {
        if (c < '0' || c > '9') return -1;
        value = 10 * value + (c - '0');
    }
    return text.empty() ? -1 : value;
}

bool is_date(std::string_view text) {
    constexpr std::array<int, 12> days{31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    const bool has_shape = (text.size() == 4 || text.size() == 7 || text.size() == 10) &&
                           (text.size() < 7 || text[4] == '-') && (text.size() < 10 || text[7] == '-');
    if (!has_shape) return false;
    const int year = digits(text.substr(0, 4));
    const int month = text.size() < 7 ? 1 : digits(text.substr(5, 2));
    const int day = text.size() < 10 ? 1 : digits(text.substr(8, 2));
    if (year < 0 || month < 1 || month > 12) return false;
    const bool is_leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
    return day >= 1 && day <= days[static_cast<std::size_t>(month - 1)] + (month == 2 && is_leap ? 1 : 0);
}

void expect_text(const EntryField& field, const EntryText& kind, std::string_view text) {
    const bool has_control = std::any_of(text.begin(), text.end(), [&](char c) {
        const bool is_break = c == '\n' || c == '\t' || c == '\r';
        return static_cast<unsigned char>(c) < 0x20 && !(is_break && kind.shape != EntryText::Shape::line);
    });
    if (has_control)
        throw Error(ErrorKind::input,
                    {std::string(field.name) + " holds a control character",
                     kind.shape == EntryText::Shape::line ? "it is a single line" : "it is text", ""});
}

// a figure may have a unit that this program has no word for ("dB", "sone")
bool is_known_unit(std::string_view unit) {
    try {
        base::parse_unit(unit);
        return true;
    } catch (const Error&) {
        return false;
    }
}

// number and unit of a temperature on another scale than Celsius; the offset makes them no mere factor
double celsius(std::string_view text) {
    const std::string_view given = base::trimmed(text);
    if (given.ends_with("degF")) return (base::parse_quantity(given.substr(0, given.size() - 4), "1") - 32.0) / 1.8;
    const bool is_kelvin = given.ends_with('K') && given.size() > 1 && given[given.size() - 2] != 'm';
    if (is_kelvin) return base::parse_quantity(given.substr(0, given.size() - 1), "1") - 273.15;
    return base::parse_quantity(given, "degC");
}

}  // namespace

std::span<const EntryField> fields() {
    return table;
}

const EntryField* find_field(std::string_view name) {
    return base::find_named(table, name);
}

std::string option_of(const EntryField& field) {
    std::string option = "--" + std::string(field.name);
    std::replace(option.begin(), option.end(), '_', '-');
    return option;
}

std::string_view unit_of(const EntryField& field) {
    const auto* quantity = std::get_if<EntryQuantity>(&field.kind);
    return quantity == nullptr ? std::string_view() : quantity->unit;
}

bool is_document(const EntryField& field) {
    const auto* text = std::get_if<EntryText>(&field.kind);
    return text != nullptr && text->shape == EntryText::Shape::document;
}

const std::string& words_in(const Entry& entry, const EntryField& field) {
    if (const auto* text = std::get_if<EntryText>(&field.kind)) return entry.*(text->member);
    if (const auto* choice = std::get_if<EntryChoice>(&field.kind)) return entry.*(choice->member);
    return entry.*(std::get<EntryDate>(field.kind).member);
}

std::string& words_in(Entry& entry, const EntryField& field) {
    return const_cast<std::string&>(words_in(std::as_const(entry), field));
}

double& quantity_in(Entry& entry, const EntryField& field) {
    return entry.*(std::get<EntryQuantity>(field.kind).member);
}

double quantity_in(const Entry& entry, const EntryField& field) {
    return entry.*(std::get<EntryQuantity>(field.kind).member);
}

double parse_value(std::string_view text, std::string_view unit) {
    const std::string_view given = base::trimmed(text);
    if (is_unknown(given)) return unknown;
    if (unit == "degC") return celsius(given);
    if (is_known_unit(unit)) return base::parse_quantity(given, unit);
    // "dB" for "dB re 20 uPa", too
    const std::string_view short_unit = unit.substr(0, unit.find(" re "));
    for (const std::string_view each : {unit, short_unit})
        if (given.ends_with(each)) return base::parse_quantity(given.substr(0, given.size() - each.size()), "1");
    return base::parse_quantity(given, "1");
}

void set_quantity(Entry& entry, const EntryField& field, double value) {
    const auto& quantity = std::get<EntryQuantity>(field.kind);
    const bool is_inside = std::isnan(value) || (value >= quantity.lowest && value <= quantity.highest);
    if (!is_inside || std::isinf(value))
        throw Error(ErrorKind::input,
                    {std::string(field.name) + " = " + base::quantity_text(value, quantity.unit) + " is out of range",
                     "it must be " + base::limits_text(quantity.lowest, quantity.highest, quantity.unit), ""});
    quantity_in(entry, field) = value;
}

void set_from_text(Entry& entry, const EntryField& field, std::string_view text) {
    try {
        if (std::holds_alternative<EntryQuantity>(field.kind))
            return set_quantity(entry, field, parse_value(text, unit_of(field)));
    } catch (const Error& error) {
        const base::Problem& problem = error.problem();
        if (problem.what.starts_with(field.name)) throw;
        throw Error(ErrorKind::input, {std::string(field.name) + ": " + problem.what, problem.why, problem.suggestion});
    }
    std::string& member = words_in(entry, field);
    const std::string_view given = is_document(field) ? text : base::trimmed(text);
    if (is_unknown(given)) {
        member.clear();
    } else if (std::holds_alternative<EntryChoice>(field.kind)) {
        const auto& names = std::get<EntryChoice>(field.kind).names;
        member = names[base::place_of_choice(field.name, given, names)];
    } else if (std::holds_alternative<EntryDate>(field.kind)) {
        if (!is_date(given))
            throw Error(ErrorKind::input, {std::string(field.name) + " = \"" + std::string(given) + "\" is no date",
                                           "a date is YYYY-MM-DD, YYYY-MM or YYYY", ""});
        member = given;
    } else {
        expect_text(field, std::get<EntryText>(field.kind), given);
        member = given;
    }
}

std::string value_text(const Entry& entry, const EntryField& field) {
    if (!std::holds_alternative<EntryQuantity>(field.kind)) return words_in(entry, field);
    const double value = quantity_in(entry, field);
    if (std::isnan(value)) return {};
    return base::quantity_text(value, unit_of(field));
}

bool is_figure_name(std::string_view name) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
    return !name.empty() && name.size() <= 64 && name != "id" && std::all_of(name.begin(), name.end(), is_letter) &&
           find_field(name) == nullptr;
}

Figure parse_figure(std::string_view text) {
    const std::size_t equals = text.find('=');
    const std::string name(base::trimmed(text.substr(0, equals)));
    if (const EntryField* field = find_field(name))
        throw Error(ErrorKind::input,
                    {"a figure cannot be called " + name, "that is a field of every entry",
                     field->writer == Writer::user ? "Write " + option_of(*field) + " instead." : ""});
    if (equals == std::string_view::npos || !is_figure_name(name))
        throw Error(ErrorKind::input,
                    {"\"" + std::string(text) + "\" is no figure",
                     "a figure is NAME=VALUE UNIT, its name a-z, 0-9 and _", "Write, for example, level=\"62 dB\"."});
    const std::string_view value = base::trimmed(text.substr(equals + 1));
    const std::size_t end = value.find_first_not_of("+-0123456789.eE");
    const std::string_view unit = end == std::string_view::npos ? "1" : base::trimmed(value.substr(end));
    try {
        return {name, std::string(unit), base::parse_quantity(value.substr(0, end), "1")};
    } catch (const Error& error) {
        const base::Problem& problem = error.problem();
        throw Error(ErrorKind::input, {name + ": " + problem.what, problem.why, problem.suggestion});
    }
}

void set_figure(Entry& entry, const Figure& figure) {
    std::vector<Figure>& figures = entry.figures;
    const auto place = std::lower_bound(figures.begin(), figures.end(), figure.name,
                                        [](const Figure& a, const std::string& name) { return a.name < name; });
    if (place != figures.end() && place->name == figure.name)
        *place = figure;
    else
        figures.insert(place, figure);
}

double number_of(const Entry& entry, std::string_view name) {
    const EntryField* field = find_field(name);
    if (field != nullptr)
        return std::holds_alternative<EntryQuantity>(field->kind) ? quantity_in(entry, *field) : unknown;
    for (const Figure& figure : entry.figures)
        if (figure.name == name) return figure.value;
    return unknown;
}

std::vector<std::string> field_names(bool (*wanted)(const EntryField&)) {
    std::vector<std::string> names;
    for (const EntryField& field : table)
        if (wanted(field)) names.emplace_back(field.name);
    return names;
}

std::string digest(const Entry& entry) {
    base::Sha256 hash;
    // lengths part the pieces, so that no text can pass for two others
    const auto add = [&](std::string_view piece) {
        hash.add(std::to_string(piece.size()) + ":");
        hash.add(piece);
    };
    for (const EntryField& field : table) {
        add(field.name);
        add(value_text(entry, field));
    }
    for (const Figure& figure : entry.figures) {
        add(figure.name);
        add(figure.unit);
        add(base::shortest(figure.value));
    }
    return hash.text();
}

void set_figure_from_text(Entry& entry, const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || text.substr(equals) != "=unknown") return set_figure(entry, parse_figure(text));
    std::erase_if(entry.figures, [&](const Figure& figure) { return figure.name == text.substr(0, equals); });
}

void set_case(Entry& entry, std::string_view text) {
    set_from_text(entry, *find_field("case"), text);
    if (entry.recorded.empty()) entry.recorded = "simulation";
}

}  // namespace stridor::noise_library
