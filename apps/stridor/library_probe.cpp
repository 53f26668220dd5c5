#include "input_options.hpp"
#include "library_hearing.hpp"
#include "rig_channels.hpp"
#include "stridor/analysis/friction_trace.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/classification/sound_rules.hpp"
#include "stridor/io/sound/json_verdict.hpp"
#include "stridor/noise_library/field.hpp"
#include "stridor/signal/channel_name.hpp"
#include "stridor/sound/feature_table.hpp"
#include "terminal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace stridor::app {

namespace {

using noise_library::Entry;
using noise_library::Figure;
using sound::SoundFeatures;

constexpr std::uint64_t most_friction_samples = 30'000'000;  // of all channels: ten minutes at 16 kHz of three
constexpr std::size_t most_channels = 64;
constexpr double lowest_rate = 1e3;   // [Hz] what is slower is no sound
constexpr double highest_rate = 1e7;  // [Hz]

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
}

// of the loudest segment of the recording's category
std::vector<Figure> figures_of(const io::SoundReport& report) {
    std::vector<Figure> figures;
    if (const auto& quality = report.channels[report.loudest].quality) add_quality(figures, *quality);
    const classification::SoundSegment* segment = report.verdicts[report.loudest].loudest();
    if (segment == nullptr) return figures;
    const std::string& unit = report.channels[report.loudest].unit;
    add_figure(figures, noise_library::level_figure, signal::level_unit(unit),
               signal::level_of(segment->mean_square, signal::reference_of(unit)));
    const SoundFeatures& found = segment->verdict.features;
    if (found.frequency > 0.0) add_figure(figures, noise_library::frequency_figure, "Hz", found.frequency);
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

bool has_figure(const Entry& entry, const std::string& name) {
    return std::any_of(entry.figures.begin(), entry.figures.end(),
                       [&](const Figure& figure) { return figure.name == name; });
}

void add_missing(Entry& entry, const std::vector<Figure>& figures) {
    for (const Figure& figure : figures)
        if (!has_figure(entry, figure.name)) noise_library::set_figure(entry, figure);
}

recordings::OpenOptions open_options(const std::string& calibration, const std::vector<std::string>& full_scales) {
    recordings::OpenOptions open;
    open.full_scales = full_scales.empty() ? full_scales_in(calibration) : parsed_full_scales(full_scales);
    return open;
}

// empty, and said why, where nothing is a sound
std::vector<std::size_t> channels_to_hear(const signal::ChannelLayout& layout, const std::string& named,
                                          const Entry& entry) {
    if (!named.empty()) return {signal::channel_named(layout, named)};
    std::vector<std::size_t> places = audible_channels(layout);
    const auto without_verdict = [&](const std::string& why) {
        say("stridor: note: " + entry.file + " has no verdict: " + why);
        places.clear();
    };
    if (places.empty())
        without_verdict("no channel is a sound or a vibration (" + signal::channel_list(layout) +
                        "); --channel names one to listen to");
    else if (!(layout.rate >= lowest_rate && layout.rate <= highest_rate))
        without_verdict(fmt::format("at {:g} Hz it is no sound", layout.rate));
    else if (places.size() > most_channels)
        without_verdict(fmt::format("{} channels are too many; --channel names one", places.size()));
    return places;
}

void choose_loudest(io::SoundReport& report) {
    double greatest = -1.0;
    for (std::size_t k = 0; k < report.channels.size(); ++k) {
        const double reference = signal::reference_of(report.channels[k].unit);
        const double square = report.channels[k].mean_square / (reference * reference);
        if (square > greatest) report.loudest = k;
        greatest = std::max(greatest, square);
    }
}

sound::AnalysisProgress progress_of(const signal::ChannelLayout& layout, const Heard& heard) {
    if (!heard || !layout.frames) return {};
    const double whole = std::max(1.0, static_cast<double>(*layout.frames));
    return [whole, heard](std::uint64_t frames) { heard(static_cast<double>(frames) / whole); };
}

// the entry keeps what the sidecar says: the sidecar does not come along
void keep_calibration(const recordings::SignalFacts& facts, Entry& entry) {
    if (!entry.calibration.empty()) return;
    bool is_given = false;
    bool is_one = true;
    std::string all;
    for (std::size_t k = 0; k < facts.full_scales.size(); ++k) {
        const recordings::Calibration origin = facts.calibrations[k];
        is_given |= origin == recordings::Calibration::option || origin == recordings::Calibration::sidecar ||
                    origin == recordings::Calibration::description;
        is_one = is_one && facts.full_scales[k] == facts.full_scales.front();
        all += fmt::format("{}full scale = {} {}", k > 0 ? "; " : "", base::shortest(facts.full_scales[k].value),
                           facts.full_scales[k].unit);
    }
    if (is_given) entry.calibration = is_one ? all.substr(0, all.find(';')) : all;
}

// of a file that does not say how long it is, by reading it
std::uint64_t counted_frames(recordings::SignalFile& file) {
    const std::size_t channels = file.layout().channels.size();
    std::vector<double> block(4096 * channels);
    std::uint64_t frames = 0;
    while (const std::size_t read = file.read(block))
        frames += read;
    return frames;
}

}  // namespace

std::vector<recordings::FullScale> full_scales_in(const std::string& calibration) {
    std::vector<recordings::FullScale> scales;
    constexpr std::string_view mark = "full scale = ";
    std::size_t begin = 0;
    try {
        while (calibration.compare(begin, mark.size(), mark) == 0) {
            const std::size_t end = std::min(calibration.find(';', begin), calibration.size());
            scales.push_back(recordings::parse_full_scale(
                base::trimmed(calibration.substr(begin + mark.size(), end - begin - mark.size()))));
            begin = std::min(end + 2, calibration.size());
        }
    } catch (const Error&) {
        scales.clear();  // words of a person
    }
    if (scales.empty())
        if (const std::optional<recordings::FullScale> scale = recordings::calibration_in(calibration))
            scales.push_back(*scale);
    return scales;
}

void judge(const recordings::SignalInput& input, const HearingOptions& options, Entry& entry, const Heard& heard) {
    const std::unique_ptr<recordings::SignalFile> file =
        recordings::open_signal(input, open_options(entry.calibration, options.full_scales));
    const std::vector<std::size_t> places = channels_to_hear(file->layout(), options.channel, entry);
    if (places.empty()) return;
    io::SoundReport report;
    report.file = entry.file;
    PickedChannels picked(*file, places);
    report.channels =
        sound::analyse(picked, progress_of(file->layout(), heard), sound::one_after_the_other, sound::SoundField::free);
    for (const sound::SoundAnalysis& analysis : report.channels)
        report.verdicts.push_back(classification::classify_recording(analysis.stretches, report.thresholds));
    choose_loudest(report);

    entry = io::without_verdict(std::move(entry));
    const std::vector<Figure> figures = figures_of(report);
    entry.category = classification::name(report.verdicts[report.loudest].category);
    entry.verdict = io::verdict_json(report, places[report.loudest] + 1, figures);
    add_missing(entry, figures);
    if (std::isnan(entry.duration)) entry.duration = report.channels[report.loudest].duration;
}

void measure_friction(const recordings::SignalInput& input, Entry& entry) {
    const std::unique_ptr<recordings::SignalFile> file =
        recordings::open_signal(input, open_options(entry.calibration, {}));
    const signal::ChannelLayout& layout = file->layout();
    const std::optional<FrictionChannels> channels = friction_channels(layout);
    if (!channels || !(entry.preload > 0.0)) return;
    std::vector<std::size_t> places{channels->force};
    if (channels->velocity) places.push_back(*channels->velocity);
    if (channels->normal) places.push_back(*channels->normal);
    const auto left_out = [&](const std::string& why) {
        say(fmt::format("stridor: note: {} has no friction figures: {}", entry.file, why));
    };
    if (layout.frames && *layout.frames * places.size() > most_friction_samples)
        return left_out("it is too long; `stridor rig friction` reads a part of it");
    try {
        PickedChannels picked(*file, places);
        const std::vector<signal::Signal> signals = signal::read_all(picked, most_friction_samples);
        analysis::FrictionMeasurement measurement;
        measurement.rate = layout.rate;
        measurement.preload = entry.preload;
        measurement.force = signals[0].samples;
        if (channels->velocity) measurement.velocity = signals[1].samples;
        if (channels->normal) measurement.normal_force = signals.back().samples;
        const analysis::FrictionFigures found = analysis::friction_trace(measurement).all;
        std::vector<Figure> figures;
        add_figure(figures, "static_friction", "1", found.static_friction.value);
        add_figure(figures, "kinetic_friction", "1", found.kinetic_friction.value);
        add_figure(figures, "mean_friction", "1", found.mean_friction);
        add_figure(figures, "force_drops", "1", static_cast<double>(found.drops));
        add_figure(figures, "drop_rate", "1/s", found.drop_rate);
        add_figure(figures, "mean_drop", "N", found.mean_drop);
        add_figure(figures, "largest_drop", "N", found.largest_drop);
        add_missing(entry, figures);
        if (std::isnan(entry.velocity) && channels->velocity) {
            entry.velocity = base::parse_quantity(fmt::format("{:.4g}", usual_speed(measurement.velocity)), "1");
            say(fmt::format("stridor: note: {} shows a velocity of {:g} m/s", entry.file, entry.velocity));
        }
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::input) throw;
        left_out(error.problem().what + (error.problem().why.empty() ? "" : " (" + error.problem().why + ")"));
    }
}

noise_library::Probe probe_of(const HearingOptions& options, const Heard& heard) {
    return [options, heard](const std::filesystem::path& path, Entry& entry) {
        const recordings::SignalInput input = recordings::open_input(path.string());
        const std::unique_ptr<recordings::SignalFile> file =
            recordings::open_signal(input, open_options(entry.calibration, options.full_scales));
        const signal::ChannelLayout& layout = file->layout();
        entry.rate = layout.rate;
        entry.channels = static_cast<double>(layout.channels.size());
        // judged by ear, it is read anyway, and its duration is known then
        if (layout.frames || options.judging == Judging::none)
            entry.duration = static_cast<double>(layout.frames ? *layout.frames : counted_frames(*file)) / layout.rate;
        for (const std::string& note : file->facts().notes)
            say("stridor: note: " + entry.file + ": " + note);
        take_facts(file->facts(), entry);
        keep_calibration(file->facts(), entry);
        measure_friction(input, entry);
        if (options.judging == Judging::by_ear) judge(input, options, entry, heard);
    };
}

}  // namespace stridor::app
