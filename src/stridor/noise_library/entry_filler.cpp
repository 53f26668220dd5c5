#include "stridor/noise_library/entry_filler.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/signal/level.hpp"
#include "stridor/sound/feature_table.hpp"

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

using sound::SoundFeatures;

// six digits are more than any recording has, and print the same everywhere
double six_digits(double value) {
    return base::parse_quantity(fmt::format("{:.6g}", value), "1");
}

void add_figure(std::vector<Figure>& figures, const std::string& name, const std::string& unit, double value) {
    if (std::isfinite(value)) figures.push_back({name, unit, six_digits(value)});
}

// of a sound pressure as a whole, in a free field
void add_quality(std::vector<Figure>& figures, const sound::SoundQuality& quality) {
    add_figure(figures, "loudness_5", "sone", quality.loudness_5);
    add_figure(figures, "loudness_greatest", "sone", quality.greatest_loudness);
    add_figure(figures, "sharpness", "acum", quality.sharpness);
    add_figure(figures, "roughness", "asper", quality.roughness);
}

bool has_figure(const Entry& entry, const std::string& name) {
    return std::any_of(entry.figures.begin(), entry.figures.end(),
                       [&](const Figure& figure) { return figure.name == name; });
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

std::vector<Figure> figures_of(const sound::SoundAnalysis& analysis, const classification::RecordingVerdict& verdict) {
    std::vector<Figure> figures;
    if (const auto& quality = analysis.quality) add_quality(figures, *quality);
    const classification::SoundSegment* segment = verdict.loudest();
    if (segment == nullptr) return figures;
    const std::string& unit = analysis.unit;
    add_figure(figures, level_figure, signal::level_unit(unit),
               signal::level_of(segment->mean_square, signal::reference_of(unit)));
    const SoundFeatures& found = segment->verdict.features;
    if (found.frequency > 0.0) add_figure(figures, frequency_figure, "Hz", found.frequency);
    // silence has no features
    if (!(segment->mean_square > 0.0)) return figures;
    for (const sound::SoundFeature& feature : sound::feature_table)
        if (feature.told != sound::SoundFeature::Told::in_evaluations)
            add_figure(figures, std::string(feature.name), std::string(feature.unit), found.*feature.member);
    if (segment->impulse_interval > 0.0) {
        add_figure(figures, "impulses", "1", static_cast<double>(segment->impulses.size()));
        add_figure(figures, "impulse_interval", "s", segment->impulse_interval);
        add_figure(figures, "impulse_regularity", "1", segment->impulse_regularity);
    }
    return figures;
}

std::vector<Figure> figures_of(const analysis::FrictionFigures& found) {
    std::vector<Figure> figures;
    add_figure(figures, "static_friction", "1", found.static_friction.value);
    add_figure(figures, "kinetic_friction", "1", found.kinetic_friction.value);
    add_figure(figures, "mean_friction", "1", found.mean_friction);
    add_figure(figures, "force_drops", "1", static_cast<double>(found.drops));
    add_figure(figures, "drop_rate", "1/s", found.drop_rate);
    add_figure(figures, "mean_drop", "N", found.mean_drop);
    add_figure(figures, "largest_drop", "N", found.largest_drop);
    return figures;
}

void add_missing(Entry& entry, std::span<const Figure> figures) {
    for (const Figure& figure : figures)
        if (!has_figure(entry, figure.name)) set_figure(entry, figure);
}

}  // namespace stridor::noise_library
