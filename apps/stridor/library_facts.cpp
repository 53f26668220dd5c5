#include "library_hearing.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/noise_library/field.hpp"
#include "terminal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace stridor::app {

namespace {

using noise_library::Entry;
using noise_library::Field;
using Metadata = std::vector<std::pair<std::string, std::string>>;

constexpr std::string_view simulated = "simulated by stridor";

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

const Field* field_for(const std::string& key) {
    const auto synonym =
        std::find_if(synonyms.begin(), synonyms.end(), [&](const auto& each) { return each.first == key; });
    const Field* field = noise_library::find_field(synonym == synonyms.end() ? key : synonym->second);
    const bool is_ours = field != nullptr && field->writer == noise_library::Writer::user && !is_document(*field);
    return is_ours ? field : nullptr;
}

bool is_known(const Entry& entry, const Field& field) {
    return std::holds_alternative<noise_library::Quantity>(field.kind)
               ? !std::isnan(noise_library::quantity_in(entry, field))
               : !noise_library::words_in(entry, field).empty();
}

/// Fills an entry, and remembers with what.
class Filler {
public:
    explicit Filler(Entry& entry) : entry_(&entry) {}

    void take(const std::string& name, const std::string& text) {
        const auto [key, value] = unit_at_value(name, text);
        const Field* field = field_for(key_of(key));
        if (field == nullptr || base::trimmed(value).empty() || is_known(*entry_, *field)) return;
        try {
            noise_library::set_from_text(*entry_, *field, without_degree_sign(value));
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::input) throw;
            misread_.push_back(std::string(field->name) + " is \"" + value + "\"");
            return;
        }
        if (is_known(*entry_, *field)) remember(*field);
    }

    void take(const char* name, double value) {
        const Field& field = *noise_library::find_field(name);
        if (is_known(*entry_, field) || !std::isfinite(value)) return;
        noise_library::set_quantity(*entry_, field, value);
        remember(field);
    }

    void say_what(const std::string& source) const {
        if (!taken_.empty()) say(fmt::format("stridor: note: {} says {}", source, joined(taken_)));
        if (!misread_.empty())
            say(fmt::format("stridor: note: {} says what is not understood and left out: {}", source,
                            joined(misread_)));
    }

private:
    static std::string joined(const std::vector<std::string>& parts) {
        std::string text;
        for (const std::string& part : parts)
            text += (text.empty() ? "" : ", ") + part;
        return text;
    }

    void remember(const Field& field) {
        taken_.push_back(std::string(field.name) + " " + noise_library::value_text(*entry_, field));
    }

    Entry* entry_;
    std::vector<std::string> taken_{};
    std::vector<std::string> misread_{};
};

// ID lines of a UFF file: "preload: 20 N; temperature = 23 degC"
void take_line(const std::string& line, Filler& filler) {
    std::size_t begin = 0;
    while (begin < line.size()) {
        const std::size_t end = std::min(line.find_first_of(";,", begin), line.size());
        const std::string part = line.substr(begin, end - begin);
        if (const std::size_t sign = part.find_first_of(":="); sign != std::string::npos)
            filler.take(part.substr(0, sign), std::string(base::trimmed(part.substr(sign + 1))));
        begin = end + 1;
    }
}

bool is_id_line(const std::string& key) {
    return key.size() == 3 && key.starts_with("id") && key[2] >= '1' && key[2] <= '5';
}

std::string value_of(const Metadata& metadata, std::string_view key) {
    for (const auto& [name, value] : metadata)
        if (name == key) return value;
    return "";
}

bool is_simulated(const Metadata& metadata) {
    for (const char* key : {"description", "comment"})
        if (value_of(metadata, key).starts_with(simulated)) return true;
    return value_of(metadata, "origin") == "simulation" || value_of(metadata, "schema") == "stridor.trace/1";
}

// a trace tells each key of its case as a line
std::string case_of_trace(const Metadata& metadata) {
    io::TomlSource source{"", "the trace", {}};
    for (const auto& [key, value] : metadata) {
        if (key.find('.') != std::string::npos) source.overrides.push_back(key + "=" + value);
        if (key == "title") source.overrides.push_back("title=" + value);
    }
    try {
        return io::case_toml(io::read_case(source), {io::Comments::none, ""});
    } catch (const Error&) {
        return "";
    }
}

// preload and motion as the case has them
void take_case(Entry& entry) {
    parameters::Case c;
    try {
        c = io::read_case(io::TomlSource{entry.case_text, "the case", {}});
    } catch (const Error&) {
        say("stridor: note: the case that came with " + entry.file +
            " cannot be simulated by this program; it is kept");
        return;
    }
    Filler filler(entry);
    filler.take("preload", c.contact.preload);
    filler.take("velocity", peak_velocity(c.drive));
    filler.take("velocity_profile", profile_of(c.drive));
    filler.say_what(entry.file + " is a simulation; its case");
}

void expect_simulation(Entry& entry) {
    if (!entry.recorded.empty() && entry.recorded != "simulation")
        throw Error(ErrorKind::input,
                    {entry.file + " was not recorded in a " + entry.recorded + " but simulated",
                     "it says so itself, and a library that mixes the two proves nothing", "Leave --recorded out."});
    entry.recorded = "simulation";
}

}  // namespace

double peak_velocity(const parameters::Drive& drive) {
    constexpr double two_pi = 6.28318530717958647692;
    const bool is_constant = drive.kind == parameters::DriveKind::constant;
    if (!is_constant && drive.kind != parameters::DriveKind::sinusoidal) return noise_library::unknown;
    const double velocity = is_constant ? std::abs(drive.velocity) : two_pi * drive.frequency * drive.amplitude;
    return base::parse_quantity(fmt::format("{:.6g}", velocity), "1");
}

std::string profile_of(const parameters::Drive& drive) {
    if (drive.kind == parameters::DriveKind::constant) return "constant";
    if (drive.kind == parameters::DriveKind::sinusoidal) return fmt::format("sinusoidal {:g} Hz", drive.frequency);
    return "";
}

void take_facts(const recordings::SignalFacts& facts, Entry& entry) {
    const bool is_simulation = is_simulated(facts.metadata);
    if (is_simulation) {
        const bool is_said = !entry.recorded.empty();
        expect_simulation(entry);
        if (entry.case_text.empty()) entry.case_text = value_of(facts.metadata, "case");
        if (entry.case_text.empty()) entry.case_text = case_of_trace(facts.metadata);
        if (entry.case_text.empty() && !is_said) say("stridor: note: " + entry.file + " says it is a simulation");
    }
    // what a simulation is like is the case's to say
    if (!entry.case_text.empty() && entry.recorded == "simulation") take_case(entry);
    Filler filler(entry);
    for (const auto& [key, value] : facts.metadata)
        if (is_id_line(key))
            take_line(value, filler);
        else if (!recordings::calibration_in(value) && !value.starts_with(simulated))
            filler.take(key, value);
    filler.say_what(entry.file);
}

}  // namespace stridor::app
