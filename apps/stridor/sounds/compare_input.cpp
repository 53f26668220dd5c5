#include "sounds/compare_input.hpp"

#include "interrupt.hpp"
#include "sounds/compare_argument.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/classification/sound_rules.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/hearing/rendered_sound.hpp"
#include "stridor/hearing/run_sound.hpp"
#include "stridor/parameters/sound_thresholds.hpp"
#include "stridor/signal/resample.hpp"
#include "stridor/sound/analysis.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

namespace stridor::app {

namespace {

using classification::ComparedSound;

constexpr std::size_t least_sounds = 2;
constexpr std::size_t most_sounds = 8;
constexpr double motion_rate = 48000.0;        // [Hz] of simulations among themselves
constexpr double least_motion_rate = 8000.0;   // [Hz] beside recordings of any rate
constexpr double most_motion_rate = 192000.0;  // [Hz]
constexpr double least_detail = 1e-3;          // [s]
constexpr double most_detail = 2.0;            // [s]

// --- one rate for all

// the lowest of all recordings: a band that one of them lacks would tell them apart by their recorders
double common_rate(const std::vector<Asked>& all) {
    double lowest = most_motion_rate;
    bool is_recorded = false;
    for (const Asked& asked : all)
        if (const auto* recorded = std::get_if<Recorded>(&asked.source)) {
            lowest = std::min(lowest, recorded->rate);
            is_recorded = true;
        }
    return is_recorded ? lowest : motion_rate;
}

bool is_resampled(const Asked& asked, double rate) {
    const auto* recorded = std::get_if<Recorded>(&asked.source);
    return recorded != nullptr && recorded->rate != rate;
}

std::unique_ptr<signal::Source> opened(const Recorded& recorded, double rate,
                                       std::optional<std::size_t> channel = std::nullopt) {
    recordings::OpenOptions open = recorded.open;
    if (channel && open.channel_name.empty()) open.channel = channel;
    std::unique_ptr<signal::Source> source = recordings::open_signal(recorded.input, open);
    if (recorded.rate == rate) return source;
    return signal::resampled(std::move(source), rate);
}

// --- what is found in it

const sound::SoundFeatures* loudest_stretch(const ComparedSound& sound) {
    if (const classification::SoundSegment* segment = sound.heard.loudest()) return &segment->verdict.features;
    const sound::SoundFeatures* best = nullptr;
    for (const sound::SoundStretch& stretch : sound.analysis.stretches)
        if (best == nullptr || stretch.features.mean_square > best->mean_square) best = &stretch.features;
    return best;
}

// so many frames from an instant on of a source of one channel, which stands at its beginning
std::vector<double> frames_from(signal::Source& source, double from, double duration) {
    const auto first = static_cast<std::uint64_t>(std::max(0.0, std::round(from * source.layout().rate)));
    const auto count = static_cast<std::uint64_t>(std::round(duration * source.layout().rate));
    std::vector<double> kept;
    std::vector<double> block(16384);
    std::uint64_t place = 0;
    while (const std::size_t read = source.read(block)) {
        for (std::size_t k = 0; k < read; ++k)
            if (place + k >= first && kept.size() < count) kept.push_back(block[k]);
        place += read;
        if (kept.size() >= count) break;
    }
    return kept;
}

// around the largest sample of the loudest stretch
void set_detail(ComparedSound& sound, signal::Source& source, double detail) {
    const sound::SoundFeatures* stretch = loudest_stretch(sound);
    const double duration = sound.analysis.duration;
    const double from = stretch == nullptr ? 0.0 : stretch->from;
    const double length = std::min(std::max(detail, stretch == nullptr ? duration : stretch->duration), 1.0);
    sound.detail.signal = {sound.analysis.rate, sound.analysis.unit, frames_from(source, from, length)};
    std::vector<double>& samples = sound.detail.signal.samples;
    const auto size = static_cast<std::size_t>(std::round(detail * sound.analysis.rate));
    const auto greatest =
        std::max_element(samples.begin(), samples.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    std::size_t begin = static_cast<std::size_t>(greatest - samples.begin());
    begin -= std::min(begin, size / 3);
    if (begin + size > samples.size()) begin = samples.size() > size ? samples.size() - size : 0;
    samples = {samples.begin() + static_cast<std::ptrdiff_t>(begin),
               samples.begin() + static_cast<std::ptrdiff_t>(std::min(begin + size, samples.size()))};
    sound.detail.from = from + static_cast<double>(begin) / sound.analysis.rate;
}

// of a short sound with frames of about 25 ms: single impulses of a creak are told apart
void set_spectrogram(ComparedSound& sound, signal::Source& source) {
    constexpr double short_sound = 30.0;  // [s]
    constexpr double frame = 0.025;       // [s]
    if (sound.analysis.duration > short_sound) return;
    std::size_t size = 64;
    while (static_cast<double>(size) < 0.75 * frame * sound.analysis.rate)
        size *= 2;
    std::vector<signal::Signal> channel = signal::read_all(source);
    if (channel.front().samples.size() >= size) sound.analysis.spectrogram = signal::spectrogram(channel.front(), size);
}

void judge(ComparedSound& sound, sound::SoundAnalysis analysis) {
    const parameters::SoundThresholds thresholds;
    sound.analysis = std::move(analysis);
    sound.heard = classification::classify_recording(sound.analysis.stretches, thresholds);
    sound.profile = classification::profile_of(sound.analysis.stretches, sound.heard, thresholds);
}

ComparedSound read_recording(const Recorded& recorded, double rate, double detail) {
    ComparedSound sound;
    std::vector<sound::SoundAnalysis> channels = sound::analyse(*opened(recorded, rate));
    const std::size_t loudest = sound::loudest(channels);
    if (channels.size() > 1) sound.what = fmt::format("channel {}, the loudest of {}", loudest + 1, channels.size());
    judge(sound, std::move(channels[loudest]));
    if (sound.what.empty()) sound.what = sound.analysis.name;
    sound.rate = recorded.rate;
    sound.length = sound.analysis.duration;
    set_spectrogram(sound, *opened(recorded, rate, loudest + 1));
    set_detail(sound, *opened(recorded, rate, loudest + 1), detail);
    return sound;
}

// the states within a stretch of the sound, in the sound's own time
record::ContactHistory heard_history(const record::ContactHistory& run, std::vector<sound::Stretch> stretches,
                                     double from, double to) {
    if (stretches.empty() && !run.empty()) stretches = {{0.0, run.back().to}};
    record::ContactHistory heard;
    double begun = 0.0;  // [s] of sound before the stretch
    for (const sound::Stretch& stretch : stretches) {
        const double shift = begun - stretch.from;
        const double first = std::max(stretch.from, from - shift);
        const double last = std::min(stretch.to, to - shift);
        for (const record::ContactInterval& interval : run) {
            if (interval.to <= first || interval.from >= last) continue;
            heard.push_back(interval);
            heard.back().from = std::max(first, interval.from) + shift;
            heard.back().to = std::min(last, interval.to) + shift;
        }
        begun += stretch.to - stretch.from;
    }
    return heard;
}

ComparedSound loaded(const Asked& asked, double rate, const MotionOptions& motion, double detail) {
    ComparedSound sound;
    if (const auto* recorded = std::get_if<Recorded>(&asked.source)) {
        sound = read_recording(*recorded, rate, detail);
    } else {
        SimulatedSound simulated = std::get<SimulatedSound>(asked.source);
        simulated.rate = std::max(rate, least_motion_rate);
        sound = simulate_sound(simulated, motion, detail);
    }
    sound.name = asked.name;
    sound.label = asked.label;
    sound.origin = asked.origin;
    return sound;
}

void require_number(std::size_t number) {
    if (number >= least_sounds && number <= most_sounds) return;
    base::refuse(fmt::format("{} sound{} cannot be laid side by side", number, number == 1 ? "" : "s"),
                 fmt::format("it takes {} to {}", least_sounds, most_sounds), "");
}

double detail_of(const std::string& text) {
    const double detail = base::parse_quantity(text, "s");
    if (!(detail >= least_detail && detail <= most_detail))
        base::refuse("--detail " + text + " is too short or too long", "it goes from 1 ms to 2 s", "");
    return detail;
}

}  // namespace

void add_motion_options(CLI::App& command, MotionOptions& options) {
    command.add_option("--of", options.of, "whose motion stands for the sound of a simulation")
        ->check(CLI::IsMember({"joint", "plate"}))
        ->capture_default_str();
    command.add_option("--quantity", options.quantity, "what of it")
        ->check(CLI::IsMember({"velocity", "acceleration"}))
        ->capture_default_str();
}

sound::Pickup pickup_of(const MotionOptions& options) {
    const signal::MotionQuantity quantity =
        options.quantity == "velocity" ? signal::MotionQuantity::velocity : signal::MotionQuantity::acceleration;
    return {options.of == "joint" ? 0U : 2U, quantity};
}

std::string motion_words(const MotionOptions& options) {
    return options.of + " " + options.quantity + " along " + (options.of == "joint" ? "x" : "y");
}

void add_compare_options(CLI::App& command, CompareOptions& options) {
    command.add_option("sounds", options.sounds, "2 to 8 sounds: recordings, cases, cells of charts, library:ID")
        ->required();
    command.add_option("--label", options.labels, "what a sound is called; once for each, in their order")
        ->type_name("TEXT")
        ->allow_extra_args(false);
    add_library_option(command, options.library);
    add_motion_options(command, options.motion);
}

std::vector<ComparedSound> load_sounds(const CompareOptions& options) {
    require_number(options.sounds.size());
    if (!options.labels.empty() && options.labels.size() != options.sounds.size())
        base::refuse(fmt::format("{} labels for {} sounds", options.labels.size(), options.sounds.size()),
                     "each sound needs its own", "");
    if (std::count(options.sounds.begin(), options.sounds.end(), "-") > 1)
        base::refuse("standard input is asked for twice", "it can be read once", "");
    const double detail = detail_of(options.detail);
    std::vector<Asked> all;
    for (const std::string& text : options.sounds)
        all.push_back(asked_sound(text, options.library));
    const double rate = common_rate(all);
    std::vector<ComparedSound> sounds;
    for (const Asked& asked : all)
        sounds.push_back(loaded(asked, rate, options.motion, detail));
    for (std::size_t k = 0; k < options.labels.size(); ++k)
        sounds[k].label = options.labels[k];
    if (std::any_of(all.begin(), all.end(), [&](const Asked& asked) { return is_resampled(asked, rate); }))
        console::say(fmt::format("stridor: note: all sounds are compared at the lowest rate, {:g} Hz", rate));
    return sounds;
}

ComparedSound load_recording(const std::string& text, const LibraryOption& library) {
    if (text.ends_with(".toml") || text.find(".toml:") != std::string::npos)
        base::refuse("\"" + text + "\" is no recording", "it is a case or a chart",
                     "`stridor compare` lays simulations side by side; `stridor listen -o` makes a recording of one.");
    const Asked asked = asked_sound(text, library);
    return loaded(asked, std::get<Recorded>(asked.source).rate, {}, 0.05);
}

ComparedSound simulate_sound(const SimulatedSound& simulated, const MotionOptions& motion, double detail) {
    sound::AuralisationSettings settings;
    settings.pickup = pickup_of(motion);
    settings.rate = std::min(simulated.rate, most_motion_rate);
    settings.stretches = simulated.stretches;
    if (settings.stretches.empty()) settings.stretches = {{0.0, simulated.c.run.duration}};
    const Interrupt interrupt;
    const hearing::Rendering rendering =
        hearing::render(simulated.c, settings, record::KeepHistory::yes, interrupt.token(), {});
    ComparedSound sound;
    judge(sound, std::move(sound::analyse(*rendering.sound).front()));
    if (sound.analysis.peak < hearing::least_motion) {
        sound.profile = {};
        sound.heard = {classification::Category::none, {}, {}, {"nothing moves but by rounding"}};
    }
    sound.what = motion_words(motion);
    sound.rate = settings.rate;
    sound.length = sound.analysis.duration;
    rendering.sound->rewind();
    set_spectrogram(sound, *rendering.sound);
    rendering.sound->rewind();
    set_detail(sound, *rendering.sound, detail);
    sound.contact.verdicts = classification::classify_phases(rendering.record.phases, simulated.c.verdict);
    for (const record::ContactHistory& history : rendering.record.histories)
        sound.contact.histories.push_back(heard_history(history, settings.stretches, sound.detail.from,
                                                        sound.detail.from + signal::duration(sound.detail.signal)));
    return sound;
}

}  // namespace stridor::app
