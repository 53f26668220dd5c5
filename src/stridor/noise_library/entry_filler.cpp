#include "stridor/noise_library/entry_filler.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace stridor::noise_library {

namespace {

// other words for fields, as keys are written below
constexpr std::array<std::pair<std::string_view, std::string_view>, 19> synonyms{{
    {"contact_preload", "preload"},
    {"normal_load", "preload"},
    {"normal_force", "preload"},
    {"load", "preload"},
    {"sliding_velocity", "velocity"},
    {"speed", "velocity"},
    {"profile", "velocity_profile"},
    {"motion", "velocity_profile"},
    {"temp", "temperature"},
    {"ambient_temperature", "temperature"},
    {"relative_humidity", "humidity"},
    {"rh", "humidity"},
    {"material", "materials"},
    {"part", "parts"},
    {"microphone", "sensor"},
    {"operator", "author"},
    {"artist", "author"},
    {"license", "licence"},
    {"comment", "notes"},
}};

// "Normal load" -> "normal_load"
std::string key_of(std::string_view text) {
    std::string key(base::trimmed(text));
    for (char& c : key) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
        if (c == ' ' || c == '-' || c == '.') c = '_';
    }
    return key;
}

// a key's unit goes to its value: "preload [N]" = "20"
std::pair<std::string, std::string> unit_at_value(const std::string& key, const std::string& value) {
    const std::size_t open = key.find('[');
    const std::size_t close = key.find(']');
    if (open == std::string::npos || close == std::string::npos || close < open) return {key, value};
    const bool is_bare = !value.empty() && ((value.back() >= '0' && value.back() <= '9') || value.back() == '.');
    return {key.substr(0, open), is_bare ? value + " " + key.substr(open + 1, close - open - 1) : value};
}

std::string without_degree_sign(std::string text) {
    for (std::size_t at = text.find("\u00b0"); at != std::string::npos; at = text.find("\u00b0"))
        text.replace(at, 2, "deg");
    return text;
}

const EntryField* field_for(const std::string& key) {
    const auto synonym =
        std::find_if(synonyms.begin(), synonyms.end(), [&](const auto& each) { return each.first == key; });
    const EntryField* field = find_field(synonym == synonyms.end() ? key : synonym->second);
    const bool is_ours = field != nullptr && field->writer == Writer::user && !is_document(*field);
    return is_ours ? field : nullptr;
}

bool is_known(const Entry& entry, const EntryField& field) {
    return std::holds_alternative<EntryQuantity>(field.kind) ? !std::isnan(quantity_in(entry, field))
                                                             : !words_in(entry, field).empty();
}

std::string joined(const std::vector<std::string>& parts) {
    std::string text;
    for (const std::string& part : parts)
        text += (text.empty() ? "" : ", ") + part;
    return text;
}

}  // namespace

void EntryFiller::take(const std::string& name, const std::string& text) {
    const auto [key, value] = unit_at_value(name, text);
    const EntryField* field = field_for(key_of(key));
    if (field == nullptr || base::trimmed(value).empty() || is_known(*entry_, *field)) return;
    try {
        set_from_text(*entry_, *field, without_degree_sign(value));
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::input) throw;
        misread_.push_back(std::string(field->name) + " is \"" + value + "\"");
        return;
    }
    if (is_known(*entry_, *field)) remember(*field);
}

void EntryFiller::take(const char* name, double value) {
    const EntryField& field = *find_field(name);
    if (is_known(*entry_, field) || !std::isfinite(value)) return;
    set_quantity(*entry_, field, value);
    remember(field);
}

void EntryFiller::take_line(const std::string& line) {
    std::size_t begin = 0;
    while (begin < line.size()) {
        const std::size_t end = std::min(line.find_first_of(";,", begin), line.size());
        const std::string part = line.substr(begin, end - begin);
        if (const std::size_t sign = part.find_first_of(":="); sign != std::string::npos)
            take(part.substr(0, sign), std::string(base::trimmed(part.substr(sign + 1))));
        begin = end + 1;
    }
}

std::vector<std::string> EntryFiller::notes(const std::string& source) const {
    std::vector<std::string> notes;
    if (!taken_.empty()) notes.push_back(fmt::format("{} says {}", source, joined(taken_)));
    if (!misread_.empty())
        notes.push_back(fmt::format("{} says what is not understood and left out: {}", source, joined(misread_)));
    return notes;
}

void EntryFiller::remember(const EntryField& field) {
    taken_.push_back(std::string(field.name) + " " + value_text(*entry_, field));
}

double peak_velocity(const parameters::Drive& drive) {
    const double velocity = parameters::greatest_speed(drive);
    return std::isnan(velocity) ? unknown : base::parse_quantity(fmt::format("{:.6g}", velocity), "1");
}

std::string profile_of(const parameters::Drive& drive) {
    if (parameters::is_of_file(drive)) return "";
    const double rate = parameters::repetition_rate(drive);
    return std::string(parameters::kind_name(drive)) + (rate > 0.0 ? fmt::format(" {:g} Hz", rate) : "");
}

}  // namespace stridor::noise_library
