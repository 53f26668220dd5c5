#include "stridor/base/error.hpp"
#include "stridor/classification/sound_rules.hpp"
#include "stridor/explorer/answers.hpp"
#include "stridor/explorer/bytes.hpp"
#include "stridor/io/open_signal.hpp"
#include "stridor/io/wav.hpp"
#include "stridor/signal/sound_analysis.hpp"
#include "stridor/sweep/run_sound.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace stridor::explorer {

namespace {

constexpr double longest_sound = 20.0;    // [s]
constexpr double loudest_sample = 0.891;  // [1] -1 dBFS
constexpr double floor_level = -200.0;    // [dB] what stands for silence, which has no logarithm

struct Listening {
    parameters::Case c;
    signal::AuralisationSettings settings;
};

Error wrong(const std::string& name, const std::string& choices) {
    return {ErrorKind::input, {"\"" + name + "\" is none of " + choices, "", ""}};
}

Listening listening_in(const World& world, const Json& body) {
    Listening listening{case_in(world, body), {}};
    const std::string of = text_in(body, "of", "joint");
    const std::string quantity = text_in(body, "quantity", "velocity");
    const std::string direction = text_in(body, "direction", "whole");
    signal::AuralisationSettings& settings = listening.settings;
    if (of != "joint" && of != "plate") throw wrong(of, "joint, plate");
    if (quantity != "velocity" && quantity != "acceleration") throw wrong(quantity, "velocity, acceleration");
    settings.pickup.dof = of == "joint" ? 0 : 2;  // along the plate, or across it
    settings.pickup.quantity =
        quantity == "velocity" ? signal::MotionQuantity::velocity : signal::MotionQuantity::acceleration;
    settings.rate = number_in(body, "rate", settings.rate);
    if (!(settings.rate >= 8000.0 && settings.rate <= 96000.0)) throw wrong("rate", "8000 to 96000");
    parameters::Run& run = listening.c.run;
    const double seconds = number_in(body, "seconds", run.duration);
    if (!(seconds > 0.0 && seconds <= longest_sound)) throw wrong("seconds", "0 to 20");
    // longer than the run: it goes on, and is judged by the same last part
    run.window += std::max(0.0, seconds - run.duration);
    run.duration = std::max(run.duration, seconds);
    if (direction == "going")
        settings.stretches = sweep::heard_stretches(listening.c, parameters::Direction::going);
    else if (direction == "coming")
        settings.stretches = sweep::heard_stretches(listening.c, parameters::Direction::coming);
    else if (direction != "whole")
        throw wrong(direction, "going, coming, whole");
    return listening;
}

// the joint's sound as the contact-state verdict's counterpart, the analysis that `stridor classify` makes
Json decibels(std::span<const double> squares, double reference) {
    Json array = Json::array();
    for (const double square : squares) {
        const double level = signal::level_of(square, reference);
        array.push_back(std::max(floor_level, std::round(10.0 * level) / 10.0));
    }
    return array;
}

// the middles of equal steps from 0 on
Json middles(std::size_t count, double step) {
    Json array = Json::array();
    for (std::size_t k = 0; k < count; ++k)
        array.push_back((static_cast<double>(k) + 0.5) * step);
    return array;
}

// the ends of equal steps from `first` on
Json multiples(std::size_t count, double step, std::size_t first) {
    Json array = Json::array();
    for (std::size_t k = 0; k < count; ++k)
        array.push_back(static_cast<double>(k + first) * step);
    return array;
}

// a row per moment
Json spectrogram_object(const signal::Spectrogram& spectrogram, double reference) {
    std::vector<float> levels;
    levels.reserve(spectrogram.density.size());
    for (const double density : spectrogram.density)
        levels.push_back(
            static_cast<float>(std::max(floor_level, signal::level_of(density * spectrogram.row, reference))));
    return {{"rows", spectrogram.columns()},
            {"columns", spectrogram.rows},
            {"time", middles(spectrogram.columns(), spectrogram.column)},
            {"frequency", middles(spectrogram.rows, spectrogram.row)},
            {"level", base64_of<float>(levels)}};
}

Json verdict_object(const classification::RecordingVerdict& verdict) {
    Json segments = Json::array();
    for (const classification::SoundSegment& segment : verdict.segments)
        segments.push_back({{"from", segment.from},
                            {"to", segment.to},
                            {"category", classification::name(segment.verdict.category)},
                            {"reasons", segment.verdict.reasons}});
    return {{"category", classification::name(verdict.category)},
            {"reasons", verdict.reasons},
            {"segments", std::move(segments)}};
}

}  // namespace

Response analysis_of(signal::Source& source) {
    std::vector<signal::SoundAnalysis> channels = signal::analyse(source);
    const auto loudest = std::max_element(channels.begin(), channels.end(),
                                          [](const auto& a, const auto& b) { return a.mean_square < b.mean_square; });
    const signal::SoundAnalysis& sound = *loudest;
    const double reference = signal::reference_of(sound.unit);
    const std::vector<double> lines = signal::line_squares(sound.spectrum);
    Json levels = Json::array();
    for (const double level : sound.level.decibels)
        levels.push_back(std::max(floor_level, std::round(10.0 * level) / 10.0));
    const std::size_t instants = levels.size();
    const std::string unit = signal::level_unit(sound.unit);
    const Json document{{"schema", "stridor.explorer.analysis/1"},
                        {"unit", sound.unit},
                        {"rate", sound.rate},
                        {"duration", sound.duration},
                        {"level",
                         {{"time", multiples(instants, sound.level.interval, 1)},
                          {"decibels", std::move(levels)},
                          {"reference", unit}}},
                        {"spectrum",
                         {{"frequency", multiples(lines.size(), sound.spectrum.spacing, 0)},
                          {"level", decibels(lines, reference)},
                          {"unit", unit}}},
                        {"spectrogram", spectrogram_object(sound.spectrogram, reference)},
                        {"verdict", verdict_object(classification::classify_recording(sound.stretches,
                                                                                      parameters::SoundThresholds{}))}};
    return json(document.dump());
}

Response sound(const World& world, const Json& body, const std::stop_token& stop) {
    const Listening listening = listening_in(world, body);
    const signal::Signal sound = sweep::sound_of_case(listening.c, listening.settings, stop);
    double peak = sweep::least_motion;
    for (const double sample : sound.samples)
        peak = std::max(peak, std::abs(sample));
    return {200, "audio/wav", io::wav_bytes(sound, {peak / loudest_sample, sound.unit})};
}

Response analysis(const World& world, const Json& body, const std::stop_token& stop) {
    const Listening listening = listening_in(world, body);
    const auto source = signal::source_of({sweep::sound_of_case(listening.c, listening.settings, stop)});
    return analysis_of(*source);
}

}  // namespace stridor::explorer
