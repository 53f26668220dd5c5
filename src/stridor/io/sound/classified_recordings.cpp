#include "stridor/io/sound/classified_recordings.hpp"

#include "stridor/base/csv_text.hpp"
#include "stridor/base/text.hpp"
#include "stridor/io/json_parts.hpp"
#include "stridor/signal/level.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

namespace stridor::io {

namespace {

using base::Json;

constexpr const char* classified_schema = "classified";

Json row_object(const ClassifiedRecording& row) {
    if (!row.refusal.empty()) return {{"file", row.file}, {"error", row.refusal}};
    Json object{{"file", row.file}, {"category", classification::name(row.category)}};
    if (row.probability > 0.0) object["probability"] = row.probability;
    object["shares"] = json_parts::named(classification::category_names, row.shares);
    object["channel"] = row.channel;
    object["channels"] = row.channels;
    object["duration"] = row.duration;
    object["rate"] = row.rate;
    object["level"] = row.level;
    object["level_unit"] = row.level_unit;
    object["dominant_frequency"] = row.frequency;
    object["other_channels"] = json_parts::array_of(row.others, [](const DifferingChannel& other) {
        Json each{{"channel", other.channel}, {"category", classification::name(other.category)}};
        if (other.probability > 0.0) each["probability"] = other.probability;
        return each;
    });
    object["reasons"] = row.reasons;
    object["notes"] = row.notes;
    return object;
}

std::vector<base::csv_text::TableColumn> classified_columns() {
    std::vector<base::csv_text::TableColumn> columns{{"file"}, {"category"}, {"probability"}};
    for (const std::string_view category : classification::category_names)
        columns.push_back({fmt::format("share_{}", category)});
    for (const auto& [name, unit] : {std::pair{"channel", ""},
                                     {"channels", ""},
                                     {"duration", "s"},
                                     {"rate", "Hz"},
                                     {"level", "dB"},
                                     {"level_unit", ""},
                                     {"dominant_frequency", "Hz"},
                                     {"other_channels", ""},
                                     {"reason", ""},
                                     {"note", ""},
                                     {"error", ""}})
        columns.push_back({name, unit});
    return columns;
}

// "2 creak 0.89; 3 squeak 0.71"
std::string others_text(const ClassifiedRecording& row) {
    std::string text;
    for (const DifferingChannel& other : row.others) {
        text += fmt::format("{}{} {}", text.empty() ? "" : "; ", other.channel, classification::name(other.category));
        if (other.probability > 0.0) text += fmt::format(" {:.2f}", other.probability);
    }
    return text;
}

}  // namespace

std::vector<DifferingChannel> differing_channels(const SoundReport& report) {
    const auto level = [&](std::size_t channel) {
        const sound::SoundAnalysis& analysis = report.channels[channel];
        return signal::level_of(analysis.mean_square, signal::reference_of(analysis.unit));
    };
    std::vector<DifferingChannel> others;
    for (std::size_t k = 0; k < report.channels.size(); ++k) {
        const classification::RecordingVerdict& verdict = report.verdicts[k];
        if (verdict.category == report.verdicts[report.loudest].category) continue;
        DifferingChannel other{k + 1, verdict.category, verdict.probability, {}};
        const double softer = level(report.loudest) - level(k);
        if (report.channels[k].unit == report.channels[report.loudest].unit && std::isfinite(softer))
            other.softer = softer;
        others.push_back(other);
    }
    return others;
}

std::string sentence_of(const DifferingChannel& other) {
    std::string sentence = fmt::format("channel {} is {}", other.channel, classification::name(other.category));
    if (other.probability > 0.0) sentence += fmt::format(", probability {:.2f}", other.probability);
    if (other.softer)
        sentence += fmt::format(", {:.1f} dB {}", std::abs(*other.softer), *other.softer < 0.0 ? "louder" : "softer");
    return sentence;
}

ClassifiedRecording classified(const std::string& file, const SoundReport& report) {
    const sound::SoundAnalysis& analysis = report.channels[report.loudest];
    const classification::RecordingVerdict& verdict = report.verdicts[report.loudest];
    const classification::SoundSegment* loudest = verdict.loudest();
    ClassifiedRecording row;
    row.file = file;
    row.category = verdict.category;
    row.probability = verdict.probability;
    row.shares = verdict.shares;
    row.channel = report.loudest + 1;
    row.channels = report.channels.size();
    row.duration = analysis.duration;
    row.rate = analysis.rate;
    row.level = signal::level_of(analysis.mean_square, signal::reference_of(analysis.unit));
    row.level_unit = signal::level_unit(analysis.unit);
    row.frequency = loudest == nullptr ? std::numeric_limits<double>::quiet_NaN() : loudest->verdict.features.frequency;
    row.notes = report.notes;
    row.reasons = verdict.reasons;
    row.others = differing_channels(report);
    for (const DifferingChannel& other : row.others)
        row.reasons.push_back(sentence_of(other));
    return row;
}

std::string classified_json(std::span<const ClassifiedRecording> rows, const parameters::SoundThresholds& thresholds) {
    Json document = json_parts::opening(classified_schema);
    document["recordings"] = json_parts::array_of(rows, row_object);
    document["thresholds"] = json_parts::thresholds_object(thresholds);
    document["units"] = {{"duration", "s"}, {"rate", "Hz"}, {"dominant_frequency", "Hz"}};
    for (const parameters::SoundThreshold& threshold : parameters::sound_thresholds())
        document["units"]["thresholds." + std::string(threshold.name)] = threshold.unit;
    return base::text_of(document);
}

std::string classified_csv(std::span<const ClassifiedRecording> rows, const parameters::SoundThresholds& thresholds) {
    base::csv_text::Facts facts = base::csv_text::origin(classified_schema);
    const parameters::SoundThresholds usual;
    for (const parameters::SoundThreshold& threshold : parameters::sound_thresholds())
        if (const double value = thresholds.*(threshold.member); value != usual.*(threshold.member))
            facts.emplace_back(threshold.name, base::shortest(value));
    base::csv_text::Table table(facts, classified_columns());
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    for (const ClassifiedRecording& row : rows) {
        const bool is_heard = row.refusal.empty();
        const auto number = [&](double value) { table.number(is_heard ? value : unknown); };
        table.word(row.file);
        table.word(is_heard ? classification::name(row.category) : "");
        number(row.probability > 0.0 ? row.probability : unknown);
        for (const double share : row.shares)
            number(share);
        number(static_cast<double>(row.channel));
        number(static_cast<double>(row.channels));
        number(row.duration);
        number(row.rate);
        number(row.level);
        table.word(row.level_unit);
        number(row.frequency);
        table.word(others_text(row));
        table.word(fmt::format("{}", fmt::join(row.reasons, "; ")));
        table.word(fmt::format("{}", fmt::join(row.notes, "; ")));
        table.word(row.refusal);
        table.end_row();
    }
    return table.take();
}

}  // namespace stridor::io
