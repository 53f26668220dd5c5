#include "stridor/hearing/sound_comparison.hpp"

#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/classification/recording_verdict.hpp"
#include "stridor/hearing/rendered_sound.hpp"
#include "stridor/hearing/run_sound.hpp"
#include "stridor/parameters/fields/sound_thresholds.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/signal/resample.hpp"
#include "stridor/sound/analysis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

namespace stridor::hearing {

namespace {

using classification::ComparedSound;

constexpr double motion_rate = 48000.0;        // [Hz] of simulations among themselves
constexpr double least_motion_rate = 8000.0;   // [Hz] beside recordings of any rate
constexpr double most_motion_rate = 192000.0;  // [Hz]
constexpr std::size_t most_frames = std::size_t{1} << 40U;

std::unique_ptr<signal::Source> opened(const RecordedSound& recorded, double rate,
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
    const std::size_t first = base::whole_near(from * source.layout().rate, most_frames);
    const std::size_t count = base::whole_near(duration * source.layout().rate, most_frames);
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
    const std::size_t size = base::whole_near(detail * sound.analysis.rate, most_frames);
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

void judge_alike(ComparedSound& sound, sound::SoundAnalysis analysis) {
    const parameters::SoundThresholds thresholds;
    sound.analysis = std::move(analysis);
    sound.heard = classification::verdict_on(sound.analysis, thresholds);
    sound.profile = classification::profile_of(sound.analysis.stretches, sound.heard, thresholds);
}

ComparedSound read_sound(const RecordedSound& recorded, const ComparisonSettings& settings) {
    ComparedSound sound;
    std::vector<sound::SoundAnalysis> channels = sound::analyse(*opened(recorded, settings.rate));
    const std::size_t loudest = sound::loudest(channels);
    if (channels.size() > 1) sound.what = fmt::format("channel {}, the loudest of {}", loudest + 1, channels.size());
    judge_alike(sound, std::move(channels[loudest]));
    if (sound.what.empty()) sound.what = sound.analysis.name;
    sound.rate = recorded.rate;
    sound.length = sound.analysis.duration;
    set_spectrogram(sound, *opened(recorded, settings.rate, loudest + 1));
    set_detail(sound, *opened(recorded, settings.rate, loudest + 1), settings.detail);
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

// of several contacts of an own structure the one that is heard, or else the one that leads
std::vector<std::size_t> shown_contacts(const parameters::Case& c, const HeardMotion& motion,
                                        const classification::KnownContact& known) {
    std::vector<std::size_t> shown(parameters::contact_count(c));
    std::iota(shown.begin(), shown.end(), std::size_t{0});
    if (parameters::has_plate(c)) return shown;
    if (motion.contact) return {*motion.contact};
    const classification::Verdict* loudest = classification::loudest_phase(known);
    return {loudest != nullptr ? loudest->evidence.contact : 0};
}

ComparedSound simulate_sound(const SimulatedSound& simulated, const ComparisonSettings& comparison,
                             const std::stop_token& stop) {
    sound::AuralisationSettings settings;
    const HeardMotion motion = heard_motion(simulated.c, comparison.motion, stop);
    settings.pickup = motion.pickup;
    settings.rate = std::clamp(comparison.rate, least_motion_rate, most_motion_rate);
    settings.stretches = simulated.stretches;
    if (settings.stretches.empty()) settings.stretches = {{0.0, simulated.c.run.duration}};
    const Rendering rendering = render(simulated.c, settings, record::KeepHistory::yes, stop, {});
    ComparedSound sound;
    judge_alike(sound, std::move(sound::analyse(*rendering.sound).front()));
    if (sound.analysis.peak < least_motion) {
        sound.profile = {};
        sound.heard = {};
        sound.heard.category = classification::Category::none;
        sound.heard.reasons = {"nothing moves but by rounding"};
    }
    sound.what = motion_words(motion);
    sound.rate = settings.rate;
    sound.length = sound.analysis.duration;
    rendering.sound->rewind();
    set_spectrogram(sound, *rendering.sound);
    rendering.sound->rewind();
    set_detail(sound, *rendering.sound, comparison.detail);
    sound.contact.verdicts = classification::classify_phases(rendering.record.phases, simulated.c.verdict,
                                                             classification::contact_names(simulated.c));
    for (const std::size_t contact : shown_contacts(simulated.c, motion, sound.contact))
        sound.contact.histories.push_back(heard_history(rendering.record.histories[contact], settings.stretches,
                                                        sound.detail.from,
                                                        sound.detail.from + signal::duration(sound.detail.signal)));
    return sound;
}

}  // namespace

void require_comparable(std::size_t sounds) {
    if (sounds >= least_compared && sounds <= most_compared) return;
    base::refuse(fmt::format("{} sound{} cannot be laid side by side", sounds, sounds == 1 ? "" : "s"),
                 fmt::format("it takes {} to {}", least_compared, most_compared), "");
}

double common_rate(std::span<const NamedSound> sounds) {
    double lowest = most_motion_rate;
    bool is_recorded = false;
    for (const NamedSound& sound : sounds)
        if (const auto* recorded = std::get_if<RecordedSound>(&sound.source)) {
            lowest = std::min(lowest, recorded->rate);
            is_recorded = true;
        }
    return is_recorded ? lowest : motion_rate;
}

bool is_resampled(const NamedSound& sound, double rate) {
    const auto* recorded = std::get_if<RecordedSound>(&sound.source);
    return recorded != nullptr && recorded->rate != rate;
}

ComparedSound compared(const NamedSound& named, const ComparisonSettings& settings, const std::stop_token& stop) {
    const auto* recorded = std::get_if<RecordedSound>(&named.source);
    ComparedSound sound = recorded != nullptr ? read_sound(*recorded, settings)
                                              : simulate_sound(std::get<SimulatedSound>(named.source), settings, stop);
    sound.name = named.name;
    sound.label = named.label;
    sound.origin = named.origin;
    return sound;
}

}  // namespace stridor::hearing
