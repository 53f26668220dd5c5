#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/classification/recording_verdict.hpp"
#include "stridor/explorer/answers/answers.hpp"
#include "stridor/explorer/sent_columns.hpp"
#include "stridor/hearing/heard_motion.hpp"
#include "stridor/hearing/run_sound.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/recordings/audio/wav.hpp"
#include "stridor/recordings/open_signal.hpp"
#include "stridor/sound/analysis.hpp"
#include "stridor/sound/tracks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace stridor::explorer {

namespace {

constexpr double most_samples = 1e6;     // of a trace
constexpr double most_numbers = 1.2e7;   // of all its columns: of many contacts the samples are fewer
constexpr double least_interval = 1e-7;  // [s] between them

record::TraceRequest trace_in(const Json& body, const parameters::Case& c, std::size_t columns) {
    const double from = std::max(0.0, number_in(body, "from", 0.0));
    const double to = std::min(c.run.duration, number_in(body, "to", c.run.duration));
    const double interval = number_in(body, "interval", std::max(least_interval, (to - from) / most_samples));
    const bool is_possible = from < to && interval >= least_interval && (to - from) / interval <= 1.01 * most_samples;
    if (!is_possible)
        throw Error(ErrorKind::input, {"there is no such trace",
                                       "its times must rise within the run, and a million samples "
                                       "are the most",
                                       ""});
    record::TraceRequest request;
    request.from = from;
    request.to = to;
    request.interval = std::max(interval, (to - from) * static_cast<double>(columns) / most_numbers);
    return request;
}

void pad(std::string& bytes) {
    bytes.resize((bytes.size() + 7) / 8 * 8, '\0');
}

// points of the line as which the structure is drawn, at rest
Json outline_array(std::span<const parameters::OutlinePoint> points) {
    Json outline = Json::array();
    for (const parameters::OutlinePoint& point : points)
        outline.push_back(point.position);
    return outline;
}

std::string motion_header(const parameters::Case& c, const record::TraceRequest& trace,
                          const std::vector<SentColumn>& columns, std::size_t samples,
                          const std::vector<record::ContactHistory>& histories) {
    Json header{{"schema", "stridor.explorer.motion/1"},
                {"samples", samples},
                {"start", trace.from},
                {"interval", trace.interval},
                {"columns", Json::array()}};
    for (const SentColumn& column : columns)
        header["columns"].push_back({{"name", column.name}, {"unit", column.unit}, {"sentence", column.sentence}});
    header["contacts"] = Json::array();
    for (std::size_t k = 0; k < histories.size(); ++k)
        header["contacts"].push_back({{"name", parameters::contact_name(c, k)}, {"intervals", histories[k].size()}});
    const std::span<const parameters::OutlinePoint> outline = parameters::outline_of(c);
    if (!outline.empty()) header["outline"] = outline_array(outline);
    header["states"] = model::contact_state_names;
    std::string text = header.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.resize((text.size() + 4 + 7) / 8 * 8 - 4, ' ');  // the arrays after it begin at a multiple of 8
    return text;
}

std::string history_bytes(const record::ContactHistory& history) {
    std::vector<double> times;
    std::vector<std::uint8_t> states;
    for (const record::ContactInterval& interval : history) {
        times.push_back(interval.from);
        states.push_back(static_cast<std::uint8_t>(interval.state));
    }
    times.push_back(history.empty() ? 0.0 : history.back().to);
    return bytes_of<double>(times) + bytes_of<std::uint8_t>(states);
}

constexpr double longest_sound = 20.0;    // [s]
constexpr double loudest_sample = 0.891;  // [1] -1 dBFS
constexpr std::size_t most_marks = 2000;  // of a track over a spectrogram
constexpr double floor_level = -200.0;    // [dB] what stands for silence, which has no logarithm

struct Listening {
    parameters::Case c;
    hearing::AskedMotion motion;
    sound::AuralisationSettings settings;
};

Error none_of(const std::string& choices, const std::string& given) {
    return {ErrorKind::input, {"\"" + given + "\" is none of " + choices, "", ""}};
}

double number_between(const Json& body, const std::string& name, double low, double high, double otherwise) {
    const double number = number_in(body, name, otherwise);
    if (number >= low && number <= high) return number;
    throw Error(ErrorKind::input,
                {"\"" + name + "\" must be from " + base::shortest(low) + " to " + base::shortest(high), "", ""});
}

Listening listening_in(const World& world, const Json& body) {
    Listening listening{case_in(world, body), {}, {}};
    const std::string of = text_in(body, "of", "joint");
    const std::string quantity = text_in(body, "quantity", "velocity");
    const std::string direction = text_in(body, "direction", "whole");
    sound::AuralisationSettings& settings = listening.settings;
    if (quantity != "velocity" && quantity != "acceleration") throw none_of("velocity, acceleration", quantity);
    listening.motion = {
        of, "", quantity == "velocity" ? signal::MotionQuantity::velocity : signal::MotionQuantity::acceleration};
    settings.rate = number_between(body, "rate", 8000.0, 96000.0, settings.rate);
    parameters::Run& run = listening.c.run;
    const double seconds = number_between(body, "seconds", 0.01, longest_sound, run.duration);
    // longer than the run: it goes on, and is judged by the same last part
    run.window += std::max(0.0, seconds - run.duration);
    run.duration = std::max(run.duration, seconds);
    if (direction == "going")
        settings.stretches = hearing::heard_stretches(listening.c, parameters::Direction::going);
    else if (direction == "coming")
        settings.stretches = hearing::heard_stretches(listening.c, parameters::Direction::coming);
    else if (direction != "whole")
        throw none_of("going, coming, whole", direction);
    return listening;
}

constexpr std::size_t most_modal_rows = 400;  // more take minutes to be taken apart
constexpr std::size_t most_shares = 4;        // of a line
constexpr double least_share = 0.03;          // [1] of one that is told

// the modes that have most of a line
Json shares_array(const analysis::ModalLine& line, const analysis::OpenModes& modes) {
    std::vector<std::size_t> order(line.shares.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return std::abs(line.shares[a]) > std::abs(line.shares[b]); });
    Json shares = Json::array();
    for (const std::size_t mode : order) {
        if (shares.size() == most_shares || std::abs(line.shares[mode]) < least_share) break;
        shares.push_back({{"mode", mode + 1}, {"frequency", modes.frequencies[mode]}, {"share", line.shares[mode]}});
    }
    return shares;
}

signal::Signal sound_of(const Listening& listening, const std::stop_token& stop) {
    sound::AuralisationSettings settings = listening.settings;
    settings.pickup = hearing::heard_motion(listening.c, listening.motion, stop).pickup;
    return hearing::sound_of_case(listening.c, settings, stop);
}

// levels to a tenth of a decibel
Json rounded(std::span<const double> decibels) {
    Json array = Json::array();
    for (const double level : decibels)
        array.push_back(std::max(floor_level, std::round(10.0 * level) / 10.0));
    return array;
}

std::vector<double> levels_of(std::vector<double> squares, double reference) {
    for (double& square : squares)
        square = signal::level_of(square, reference);
    return squares;
}

// the middles of equal steps
Json middles(std::size_t count, double step, double from = 0.0) {
    Json array = Json::array();
    for (std::size_t k = 0; k < count; ++k)
        array.push_back(from + (static_cast<double>(k) + 0.5) * step);
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
            {"time", middles(spectrogram.columns(), spectrogram.column, spectrogram.from)},
            {"frequency", middles(spectrogram.rows, spectrogram.row)},
            {"level", base64_of<float>(levels)}};
}

// the loudest passage through short frames; null for a motion, and for silence
Json impulses_object(const sound::SoundAnalysis& sound, double reference) {
    return sound.impulses.columns() == 0 ? Json() : spectrogram_object(sound.impulses, reference);
}

// what the ear follows, to 0.1 ms and 0.1 Hz; a motion has none
Json tracks_object(const sound::SoundAnalysis& sound) {
    const auto to_step = [](double value, double steps) { return std::round(value * steps) / steps; };
    Json tracks{{"pitch", {{"time", Json::array()}, {"frequency", Json::array()}}}, {"onsets", Json::array()}};
    for (const sound::TonePoint& point : sound::pitch_track(sound, most_marks)) {
        tracks["pitch"]["time"].push_back(to_step(point.time, 1e4));
        tracks["pitch"]["frequency"].push_back(to_step(point.frequency, 10.0));
    }
    for (const double instant : sound::onset_track(sound, most_marks))
        tracks["onsets"].push_back(to_step(instant, 1e4));
    return tracks;
}

Json verdict_object(const classification::RecordingVerdict& verdict) {
    Json segments = Json::array();
    for (const classification::SoundSegment& segment : verdict.segments)
        segments.push_back({{"from", segment.from},
                            {"to", segment.to},
                            {"category", classification::name(segment.verdict.category)},
                            {"reasons", segment.verdict.reasons}});
    return {{"category", classification::name(verdict.category)},
            {"probability", verdict.passages.empty() ? Json() : Json(verdict.probability)},
            {"reasons", verdict.reasons},
            {"segments", std::move(segments)}};
}

// of a recording, or of a run of a case
Response heard_sound(signal::Source& source, const parameters::Case* c) {
    const std::vector<sound::SoundAnalysis> channels = sound::analyse(source);
    const sound::SoundAnalysis& sound = channels[sound::loudest(channels)];
    const double reference = signal::reference_of(sound.unit);
    const std::vector<double> lines = signal::line_squares(sound.spectrum);
    const std::size_t instants = sound.level.decibels.size();
    const std::string unit = signal::level_unit(sound.unit);
    classification::RecordingVerdict verdict = classification::verdict_on(sound, {});
    if (c != nullptr) verdict = hearing::borne(*c, std::move(verdict));
    const Json document{{"schema", "stridor.explorer.analysis/1"},
                        {"unit", sound.unit},
                        {"rate", sound.rate},
                        {"duration", sound.duration},
                        {"level",
                         {{"time", multiples(instants, sound.level.interval, 1)},
                          {"decibels", rounded(sound.level.decibels)},
                          {"unit", unit}}},
                        {"spectrum",
                         {{"frequency", multiples(lines.size(), sound.spectrum.spacing, 0)},
                          {"level", rounded(levels_of(lines, reference))},
                          {"unit", unit}}},
                        {"spectrogram", spectrogram_object(sound.spectrogram, reference)},
                        {"impulses", impulses_object(sound, reference)},
                        {"tracks", tracks_object(sound)},
                        {"verdict", verdict_object(verdict)}};
    return json(document.dump());
}

}  // namespace

Response motion(const World& world, const Json& body, const std::stop_token& stop) {
    const parameters::Case c = case_in(world, body);
    const std::vector<SentColumn> columns = sent_columns(c);
    record::Request request{record::KeepHistory::yes, trace_in(body, c, columns.size())};
    std::vector<std::vector<float>> values(columns.size());
    // block by block into the half as large numbers that are sent: a trace of doubles would be 100 MB
    request.trace.taker = [&](const record::Trace& trace) {
        for (std::size_t k = 0; k < columns.size(); ++k)
            columns[k].add(trace, values[k]);
    };
    const integration::Motion motion = run_case(c, request, stop);
    const std::string header = motion_header(c, request.trace, columns, values.front().size(), motion.record.histories);
    const auto length = static_cast<std::uint32_t>(header.size());
    std::string bytes = bytes_of<std::uint32_t>({&length, 1}) + header;
    for (const std::vector<float>& column : values) {
        bytes += bytes_of<float>(column);
        pad(bytes);
    }
    for (const record::ContactHistory& history : motion.record.histories) {
        bytes += history_bytes(history);
        pad(bytes);
    }
    return {200, "application/octet-stream", std::move(bytes)};
}

Response analysis_of(signal::Source& source) {
    return heard_sound(source, nullptr);
}

Response sound(const World& world, const Json& body, const std::stop_token& stop) {
    const Listening listening = listening_in(world, body);
    const signal::Signal sound = sound_of(listening, stop);
    double peak = hearing::least_motion;
    for (const double sample : sound.samples)
        peak = std::max(peak, std::abs(sample));
    return {200, "audio/wav", recordings::wav_bytes(sound, {peak / loudest_sample, sound.unit})};
}

Response modal_lines(const World& world, const Json& body, const std::stop_token& stop) {
    const parameters::Case c = case_in(world, body);
    const std::size_t rows = parameters::coordinate_count(c);
    if (rows > most_modal_rows)
        throw Error(ErrorKind::input, {"the modes of " + std::to_string(rows) + " rows are not found while you wait",
                                       "", "Run it on the command line: stridor figure modal-spectrum."});
    const hearing::HeardModes heard = hearing::heard_modes(c, {text_in(body, "of", "joint")}, stop);
    Json document{{"schema", "stridor.explorer.modal/1"}, {"of", heard.of}, {"lines", Json::array()}};
    for (const analysis::ModalLine& line : analysis::modal_lines(heard.spectrum))
        document["lines"].push_back({{"frequency", line.frequency}, {"shares", shares_array(line, heard.modes)}});
    return json(document.dump());
}

Response analysis(const World& world, const Json& body, const std::stop_token& stop) {
    const Listening listening = listening_in(world, body);
    const auto source = signal::source_of({sound_of(listening, stop)});
    return heard_sound(*source, &listening.c);
}

}  // namespace stridor::explorer
