#include "stridor/io/sound/json_sound.hpp"

#include "stridor/base/version.hpp"
#include "stridor/io/json_parts.hpp"
#include "stridor/io/sound/verdict_object.hpp"
#include "stridor/signal/level.hpp"
#include "stridor/signal/spectrum.hpp"
#include "stridor/sound/feature_table.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace stridor::io {

namespace {

using base::Json;
using base::text_of;
using sound::SoundAnalysis;
using sound::SoundFeatures;

Json opening(std::string_view what, const SoundReport& report) {
    Json document = json_parts::opening(what);
    document.update(Json{
        {"file", report.file}, {"format", report.format}, {"notes", report.notes}, {"channel", report.loudest + 1}});
    return document;
}

Json features_object(const SoundFeatures& f, double reference) {
    Json object{{"level", signal::level_of(f.mean_square, reference)}};
    for (const sound::SoundFeature& feature : sound::feature_table) {
        // the count of the impulses stands before what their instants tell
        if (feature.member == &SoundFeatures::impulse_interval) object["impulses"] = f.impulses;
        object[std::string(feature.name)] = f.*feature.member;
    }
    return object;
}

Json segment_object(const classification::SoundSegment& segment, double reference) {
    return {{"from", segment.from},
            {"to", segment.to},
            {"category", classification::name(segment.verdict.category)},
            {"level", signal::level_of(segment.mean_square, reference)},
            {"impulses", segment.impulses.size()},
            {"impulse_interval", segment.impulse_interval},
            {"impulse_regularity", segment.impulse_regularity},
            {"loudest_stretch",
             {{"from", segment.verdict.features.from},
              {"duration", segment.verdict.features.duration},
              {"features", features_object(segment.verdict.features, reference)}}},
            {"margins", json_parts::margins_array(segment.verdict.margins)},
            {"reasons", segment.verdict.reasons}};
}

Json passage_object(const classification::HeardPassage& passage) {
    Json figures = Json::object();
    Json reasons = Json::object();
    for (std::size_t k = 0; k < classification::ear_figure_count; ++k) {
        const std::string name(classification::ear_figures()[k].name);
        figures[name] = passage.ear.values[k];
        reasons[name] = passage.ear.reasons[k];
    }
    return {{"from", passage.from},
            {"to", passage.to},
            {"category", classification::name(passage.category)},
            {"energy", passage.energy},
            {"probabilities", json_parts::named(classification::heard_names, passage.ear.probabilities)},
            {"heard", classification::heard_names[static_cast<std::size_t>(passage.ear.heard)]},
            {"against", classification::heard_names[static_cast<std::size_t>(passage.ear.rival)]},
            {"figures", std::move(figures)},
            {"reasons", std::move(reasons)}};
}

}  // namespace

Json verdict_object(const classification::RecordingVerdict& verdict, double reference) {
    Json segments = json_parts::array_of(verdict.segments, [&](const classification::SoundSegment& segment) {
        return segment_object(segment, reference);
    });
    Json object{{"category", classification::name(verdict.category)},
                {"shares", json_parts::named(classification::category_names, verdict.shares)},
                {"reasons", verdict.reasons},
                {"segments", std::move(segments)}};
    if (verdict.passages.empty()) return object;  // by the rules
    object["probability"] = verdict.probability;
    object["passages"] = json_parts::array_of(verdict.passages, [](const auto& each) { return passage_object(each); });
    return object;
}

namespace {

Json channel_opening(const SoundAnalysis& analysis) {
    return {{"name", analysis.name},
            {"unit", analysis.unit},
            {"level_unit", signal::level_unit(analysis.unit)},
            {"rate", analysis.rate},
            {"duration", analysis.duration}};
}

Json units_object() {
    Json units{{"rate", "Hz"}, {"duration", "s"}, {"from", "s"}, {"to", "s"}, {"frequency", "Hz"}};
    for (const sound::SoundFeature& feature : sound::feature_table)
        if (feature.unit != "1") units[std::string(feature.name)] = feature.unit;
    for (const parameters::SoundThreshold& threshold : parameters::sound_thresholds())
        units["thresholds." + std::string(threshold.name)] = threshold.unit;
    return units;
}

Json bands_array(const std::vector<signal::Band>& bands, double reference) {
    return json_parts::array_of(bands, [&](const signal::Band& band) -> Json {
        return {{"centre", band.nominal},
                {"low", band.low},
                {"high", band.high},
                {"level", signal::level_of(band.mean_square, reference)}};
    });
}

Json spectrum_object(const SoundAnalysis& analysis, double reference) {
    const auto level = [&](double mean_square) { return signal::level_of(mean_square, reference); };
    const auto peak_object = [&](const signal::SpectrumPeak& peak) -> Json {
        return {{"frequency", peak.frequency}, {"level", level(peak.mean_square)}, {"prominence", peak.prominence}};
    };
    return {{"spacing", analysis.spectrum.spacing},
            {"noise_bandwidth", analysis.spectrum.bandwidth},
            {"frames", analysis.spectrum.frames},
            {"window", "hann"},
            {"peaks", json_parts::array_of(signal::strongest_peaks(analysis.spectrum), peak_object)},
            {"levels", json_parts::array_of(signal::line_squares(analysis.spectrum), level)}};
}

Json named_bands(const SoundAnalysis& analysis, double reference) {
    const signal::Spectrum weighted = signal::a_weighted(analysis.spectrum);
    return json_parts::array_of(signal::named_bands, [&](const signal::NamedBand& band) -> Json {
        const auto level = [&](const signal::Spectrum& spectrum) {
            return signal::level_of(signal::mean_square_between(spectrum, band.low, band.high), reference);
        };
        return {{"name", band.name},
                {"source", band.source},
                {"low", band.low},
                {"high", band.high},
                {"level", level(analysis.spectrum)},
                {"level_a", level(weighted)}};
    });
}

Json quality_object(const SoundAnalysis& analysis, double reference) {
    const sound::SoundQuality& q = *analysis.quality;
    Json thirds = Json::array();
    for (std::size_t k = 0; k < signal::third_octave_count; ++k)
        if (sound::holds_third_octave(analysis.rate, k))
            thirds.push_back({{"centre", signal::third_octave_names[k]},
                              {"level", signal::level_of(q.third_octaves[k], reference)}});
    return {{"field", sound::sound_field_names[static_cast<std::size_t>(q.field)]},
            {"loudness", q.loudness},
            {"loudness_level", sound::loudness_level(q.loudness)},
            {"loudness_5", q.loudness_5},
            {"loudness_10", q.loudness_10},
            {"greatest_loudness", q.greatest_loudness},
            {"sharpness", q.sharpness},
            {"roughness", q.roughness},
            {"roughness_5", q.roughness_5},
            {"third_octaves", std::move(thirds)}};
}

Json levels_object(const SoundAnalysis& analysis, double reference) {
    const signal::Spectrum weighted = signal::a_weighted(analysis.spectrum);
    const double limit = 0.5 * analysis.rate;
    return {{"mean", signal::level_of(analysis.mean_square, reference)},
            {"mean_a", signal::level_of(signal::mean_square_between(weighted, 0.0, limit), reference)},
            {"greatest_fast", analysis.level.greatest},
            {"greatest_frame_a", signal::level_of(analysis.greatest_weighted, reference)},
            {"peak", analysis.peak},
            {"history", {{"interval", analysis.level.interval}, {"levels", analysis.level.decibels}}}};
}

using classification::RecordingVerdict;
using classification::SoundSegment;

constexpr const char* verdict_schema = "stridor.verdict/1";

// places of the loudest segments, in time
std::vector<std::size_t> loudest_segments(const std::vector<SoundSegment>& segments) {
    std::vector<std::size_t> places(segments.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    if (places.size() <= most_kept_segments) return places;
    std::stable_sort(places.begin(), places.end(),
                     [&](std::size_t a, std::size_t b) { return segments[a].mean_square > segments[b].mean_square; });
    places.resize(most_kept_segments);
    std::sort(places.begin(), places.end());
    return places;
}

// digits that a reader can use: a millisecond, a hundredth of a decibel
double rounded(double value, double step) {
    return std::round(value / step) * step;
}

Json segments_array(const RecordingVerdict& verdict, double reference) {
    Json segments = Json::array();
    for (const std::size_t place : loudest_segments(verdict.segments)) {
        const SoundSegment& segment = verdict.segments[place];
        segments.push_back({{"from", rounded(segment.from, 1e-3)},
                            {"to", rounded(segment.to, 1e-3)},
                            {"category", classification::name(segment.verdict.category)},
                            {"level", rounded(signal::level_of(segment.mean_square, reference), 0.01)}});
    }
    return segments;
}

}  // namespace

std::string classify_json(const SoundReport& report) {
    Json document = opening("classify", report);
    document["category"] = classification::name(report.verdicts[report.loudest].category);
    Json channels = Json::array();
    for (std::size_t k = 0; k < report.channels.size(); ++k) {
        Json channel = channel_opening(report.channels[k]);
        channel["verdict"] = verdict_object(report.verdicts[k], signal::reference_of(report.channels[k].unit));
        channels.push_back(std::move(channel));
    }
    document["channels"] = std::move(channels);
    document["thresholds"] = json_parts::thresholds_object(report.thresholds);
    document["units"] = units_object();
    return text_of(document);
}

std::string analyse_json(const SoundReport& report) {
    Json document = opening("analyse", report);
    Json channels = Json::array();
    for (std::size_t k = 0; k < report.channels.size(); ++k) {
        const SoundAnalysis& analysis = report.channels[k];
        const double reference = signal::reference_of(analysis.unit);
        Json channel = channel_opening(analysis);
        channel["levels"] = levels_object(analysis, reference);
        channel["spectrum"] = spectrum_object(analysis, reference);
        channel["octaves"] = bands_array(signal::bands(analysis.spectrum, signal::BandWidth::octave), reference);
        channel["third_octaves"] =
            bands_array(signal::bands(analysis.spectrum, signal::BandWidth::third_octave), reference);
        channel["named_bands"] = named_bands(analysis, reference);
        if (analysis.quality) channel["sound_quality"] = quality_object(analysis, reference);
        channel["verdict"] = verdict_object(report.verdicts[k], reference);
        channels.push_back(std::move(channel));
    }
    document["channels"] = std::move(channels);
    document["units"] = units_object();
    for (const char* key : {"loudness", "loudness_5", "loudness_10", "greatest_loudness"})
        document["units"][key] = "sone";
    document["units"]["loudness_level"] = "phon";
    document["units"]["sharpness"] = "acum";
    return text_of(document);
}

std::string verdict_json(const SoundReport& report, std::size_t channel,
                         std::span<const noise_library::Figure> figures) {
    const RecordingVerdict& verdict = report.verdicts[report.loudest];
    const sound::SoundAnalysis& analysis = report.channels[report.loudest];
    Json document{{"schema", verdict_schema},
                  {"version", base::version()},
                  {"commit", base::commit()},
                  {"channel", channel},
                  {"name", analysis.name},
                  {"unit", analysis.unit},
                  {"category", classification::name(verdict.category)}};
    document["shares"] = json_parts::named(classification::category_names, verdict.shares);
    if (verdict.probability > 0.0) document["probability"] = verdict.probability;
    document["reasons"] = verdict.reasons;
    Json& kept = document["figures"] = Json::object();
    for (const noise_library::Figure& figure : figures)
        kept[figure.name] = figure.value;
    if (const SoundSegment* loudest = verdict.loudest()) {
        document["loudest"] = {{"from", loudest->from},
                               {"to", loudest->to},
                               {"reasons", loudest->verdict.reasons},
                               {"margins", json_parts::margins_array(loudest->verdict.margins)}};
    }
    document["segments"] = segments_array(verdict, signal::reference_of(analysis.unit));
    document["segments_left_out"] = verdict.segments.size() - std::min(verdict.segments.size(), most_kept_segments);
    document["thresholds"] = json_parts::thresholds_object(report.thresholds);
    return document.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<KeptVerdict> kept_verdict(std::string_view text) {
    const Json document = base::foreign_document(text);
    if (!document.is_object() || document.value("schema", Json()) != verdict_schema) return std::nullopt;
    KeptVerdict kept;
    kept.is_current = document.value("version", Json()) == Json(base::version()) &&
                      document.value("commit", Json()) == Json(base::commit());
    if (const Json channel = document.value("channel", Json()); channel.is_number_unsigned())
        kept.channel = channel.get<std::size_t>();
    if (const Json figures = document.value("figures", Json()); figures.is_object())
        for (const auto& [name, value] : figures.items())
            if (value.is_number()) kept.figures.push_back({name, "", value.get<double>()});
    return kept;
}

noise_library::Entry without_verdict(noise_library::Entry entry) {
    if (const std::optional<KeptVerdict> kept = kept_verdict(entry.verdict))
        for (const noise_library::Figure& old : kept->figures)
            std::erase_if(entry.figures, [&](const noise_library::Figure& figure) {
                return figure.name == old.name && figure.value == old.value;
            });
    entry.category.clear();
    entry.verdict.clear();
    return entry;
}

}  // namespace stridor::io
