#include "stridor/io/sound/json_verdict.hpp"

#include "stridor/base/version.hpp"
#include "stridor/io/json_parts.hpp"
#include "stridor/signal/level.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace stridor::io {

namespace {

using base::Json;
using classification::RecordingVerdict;
using classification::SoundSegment;

constexpr const char* schema = "stridor.verdict/1";

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

std::string verdict_json(const SoundReport& report, std::size_t channel,
                         std::span<const noise_library::Figure> figures) {
    const RecordingVerdict& verdict = report.verdicts[report.loudest];
    const sound::SoundAnalysis& analysis = report.channels[report.loudest];
    Json document{{"schema", schema},
                  {"version", base::version()},
                  {"commit", base::commit()},
                  {"channel", channel},
                  {"name", analysis.name},
                  {"unit", analysis.unit},
                  {"category", classification::name(verdict.category)}};
    Json& shares = document["shares"] = Json::object();
    for (std::size_t k = 0; k < verdict.shares.size(); ++k)
        shares[std::string(classification::category_names[k])] = verdict.shares[k];
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
    if (!document.is_object() || document.value("schema", Json()) != schema) return std::nullopt;
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
