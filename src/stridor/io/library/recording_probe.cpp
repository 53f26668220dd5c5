#include "stridor/io/library/recording_probe.hpp"

#include "stridor/analysis/friction/trace.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/classification/recording_verdict.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/sound/json_sound.hpp"
#include "stridor/noise_library/entry_filler.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/recordings/rig_channels.hpp"
#include "stridor/signal/source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

namespace stridor::io {

namespace {

using noise_library::Entry;
using Metadata = std::vector<std::pair<std::string, std::string>>;

constexpr std::string_view simulated = "simulated by stridor";

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

// a trace tells each key of its case as a line; of several joints each begins with its name
std::string case_of_trace(const Metadata& metadata) {
    TomlSource source{"", "the trace", {}};
    std::vector<std::string> joints;
    for (const auto& [key, value] : metadata) {
        const std::optional<parameters::JointKey> of_joint = parameters::joint_key(key);
        const bool is_name = of_joint && parameters::names_a_joint(of_joint->joint);
        if (is_name && std::find(joints.begin(), joints.end(), of_joint->joint) == joints.end()) {
            joints.push_back(of_joint->joint);
            source.text += "[[joint]]\nname = \"" + of_joint->joint + "\"\n";
        }
        if (key.find('.') != std::string::npos) source.overrides.push_back(key + "=" + value);
        if (key == "title") source.overrides.push_back("title=" + value);
    }
    try {
        return case_toml(read_case(parse_toml(source), readers_without_files()), {Comments::none, ""});
    } catch (const Error&) {
        return "";
    }
}

// preload and motion as the case has them
void take_case(Entry& entry, const Notes& note) {
    parameters::Case c;
    try {
        c = read_case(parse_toml({entry.case_text, "the case", {}}), readers_without_files());
    } catch (const Error&) {
        note("the case that came with " + entry.file + " cannot be simulated by this program; it is kept");
        return;
    }
    noise_library::EntryFiller filler(entry);
    // of several joints that differ there is no one preload
    if (parameters::has_one_value(c, "contact.preload")) filler.take("preload", c.contact().preload);
    filler.take("velocity", noise_library::peak_velocity(c.drive));
    filler.take("velocity_profile", noise_library::profile_of(c.drive));
    for (const std::string& sentence : filler.notes(entry.file + " is a simulation; its case"))
        note(sentence);
}

void expect_simulation(Entry& entry) {
    if (!entry.recorded.empty() && entry.recorded != "simulation")
        throw Error(ErrorKind::input,
                    {entry.file + " was not recorded in a " + entry.recorded + " but simulated",
                     "it says so itself, and a library that mixes the two proves nothing", "Leave --recorded out."});
    entry.recorded = "simulation";
}

using noise_library::Figure;

constexpr std::uint64_t most_friction_samples = 30'000'000;  // of all channels: ten minutes at 16 kHz of three
constexpr std::size_t most_channels = 64;
constexpr double lowest_rate = 1e3;   // [Hz] what is slower is no sound
constexpr double highest_rate = 1e7;  // [Hz]

recordings::OpenOptions open_options(const std::string& calibration, const std::vector<std::string>& full_scales) {
    recordings::OpenOptions open;
    open.full_scales =
        full_scales.empty() ? recordings::full_scales_in(calibration) : recordings::parse_full_scales(full_scales);
    return open;
}

// empty, and said why, where nothing is a sound
std::vector<std::size_t> channels_to_hear(const signal::ChannelLayout& layout, const std::string& named,
                                          const Entry& entry, const Notes& note) {
    if (!named.empty()) return {signal::channel_named(layout, named)};
    std::vector<std::size_t> places = recordings::audible_channels(layout);
    const auto without_verdict = [&](const std::string& why) {
        note(entry.file + " has no verdict: " + why);
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

sound::AnalysisProgress progress_of(const signal::ChannelLayout& layout, const Heard& heard) {
    if (!heard || !layout.frames) return {};
    const double whole = std::max(1.0, static_cast<double>(*layout.frames));
    return [whole, heard](std::uint64_t frames) { heard(static_cast<double>(frames) / whole); };
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

void take_facts(const recordings::SignalFacts& facts, Entry& entry, const Notes& note) {
    const bool is_simulation = is_simulated(facts.metadata);
    if (is_simulation) {
        const bool is_said = !entry.recorded.empty();
        expect_simulation(entry);
        if (entry.case_text.empty()) entry.case_text = value_of(facts.metadata, "case");
        if (entry.case_text.empty()) entry.case_text = case_of_trace(facts.metadata);
        if (entry.case_text.empty() && !is_said) note(entry.file + " says it is a simulation");
    }
    // what a simulation is like is the case's to say
    if (!entry.case_text.empty() && entry.recorded == "simulation") take_case(entry, note);
    noise_library::EntryFiller filler(entry);
    for (const auto& [key, value] : facts.metadata)
        if (is_id_line(key))
            filler.take_line(value);
        else if (!recordings::calibration_in(value) && !value.starts_with(simulated))
            filler.take(key, value);
    for (const std::string& sentence : filler.notes(entry.file))
        note(sentence);
}

void judge(const recordings::SignalInput& input, const JudgingOptions& options, Entry& entry, const Heard& heard) {
    const std::unique_ptr<recordings::SignalFile> file =
        recordings::open_signal(input, open_options(entry.calibration, options.full_scales));
    const std::vector<std::size_t> places = channels_to_hear(file->layout(), options.channel, entry, options.note);
    if (places.empty()) return;
    SoundReport report;
    report.file = entry.file;
    recordings::PickedChannels picked(*file, places);
    report.channels =
        sound::analyse(picked, progress_of(file->layout(), heard), sound::one_after_the_other, sound::SoundField::free);
    for (const sound::SoundAnalysis& analysis : report.channels)
        report.verdicts.push_back(classification::verdict_on(analysis, report.thresholds));
    report.loudest = sound::loudest(report.channels);

    entry = without_verdict(std::move(entry));
    const std::vector<Figure> figures =
        noise_library::figures_of(report.channels[report.loudest], report.verdicts[report.loudest]);
    entry.category = classification::name(report.verdicts[report.loudest].category);
    entry.verdict = verdict_json(report, places[report.loudest] + 1, figures);
    noise_library::add_missing(entry, figures);
    if (std::isnan(entry.duration)) entry.duration = report.channels[report.loudest].duration;
}

void measure_friction(const recordings::SignalInput& input, Entry& entry, const Notes& note) {
    const std::unique_ptr<recordings::SignalFile> file =
        recordings::open_signal(input, open_options(entry.calibration, {}));
    const signal::ChannelLayout& layout = file->layout();
    const std::optional<recordings::FrictionChannels> channels = recordings::friction_channels(layout);
    if (!channels || !(entry.preload > 0.0)) return;
    std::vector<std::size_t> places{channels->force};
    if (channels->velocity) places.push_back(*channels->velocity);
    if (channels->normal) places.push_back(*channels->normal);
    const auto left_out = [&](const std::string& why) {
        note(fmt::format("{} has no friction figures: {}", entry.file, why));
    };
    if (layout.frames && *layout.frames * places.size() > most_friction_samples)
        return left_out("it is too long; `stridor rig friction` reads a part of it");
    try {
        recordings::PickedChannels picked(*file, places);
        const std::vector<signal::Signal> signals = signal::read_all(picked, most_friction_samples);
        analysis::FrictionMeasurement measurement;
        measurement.rate = layout.rate;
        measurement.preload = entry.preload;
        measurement.force = signals[0].samples;
        if (channels->velocity) measurement.velocity = signals[1].samples;
        if (channels->normal) measurement.normal_force = signals.back().samples;
        const analysis::FrictionFigures found = analysis::friction_trace(measurement).all;
        noise_library::add_missing(entry, noise_library::figures_of(found));
        if (std::isnan(entry.velocity) && channels->velocity) {
            entry.velocity =
                base::parse_quantity(fmt::format("{:.4g}", recordings::usual_speed(measurement.velocity)), "1");
            note(fmt::format("{} shows a velocity of {:g} m/s", entry.file, entry.velocity));
        }
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::input) throw;
        left_out(error.problem().what + (error.problem().why.empty() ? "" : " (" + error.problem().why + ")"));
    }
}

noise_library::Probe probe_of(const JudgingOptions& options, const Heard& heard) {
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
        for (const std::string& sentence : file->facts().notes)
            options.note(entry.file + ": " + sentence);
        take_facts(file->facts(), entry, options.note);
        // the entry keeps what the sidecar says: the sidecar does not come along
        if (entry.calibration.empty()) entry.calibration = recordings::given_calibration(file->facts());
        measure_friction(input, entry, options.note);
        if (options.judging == Judging::by_ear) judge(input, options, entry, heard);
    };
}

bool has_outdated_verdict(const Entry& entry) {
    const std::optional<KeptVerdict> kept = kept_verdict(entry.verdict);
    return !kept || !kept->is_current;
}

std::vector<std::int64_t> ids_to_judge(noise_library::Library& library, noise_library::Query query, Rejudged which) {
    query.extent = noise_library::EntryExtent::whole;
    std::vector<std::int64_t> ids;
    library.visit(query, [&](const Entry& entry) {
        if (which == Rejudged::all || has_outdated_verdict(entry)) ids.push_back(entry.id);
    });
    return ids;
}

// heard before the library is locked: others may write meanwhile
Entry judge_again(noise_library::Library& library, std::int64_t id, const JudgingOptions& options, const Heard& heard) {
    const std::array<std::int64_t, 1> only{id};
    Entry entry = library.get(only).front();
    JudgingOptions judging = options;
    if (const std::optional<KeptVerdict> kept = kept_verdict(entry.verdict);
        judging.channel.empty() && kept && kept->channel > 0)
        judging.channel = std::to_string(kept->channel);
    judge(recordings::open_input(library.sound_file(entry).string()), judging, entry, heard);
    const auto put = [&](Entry& each) {
        each.category = entry.category;
        each.verdict = entry.verdict;
        each.figures = entry.figures;
        each.duration = entry.duration;
    };
    return library.edit(only, put).front();
}

}  // namespace stridor::io
