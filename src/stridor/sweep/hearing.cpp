#include "stridor/sweep/hearing.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/classification/sound_rules.hpp"
#include "stridor/parameters/check.hpp"
#include "stridor/record/schedule.hpp"
#include "stridor/signal/perturb.hpp"
#include "stridor/signal/resample.hpp"
#include "stridor/signal/sound_analysis.hpp"
#include "stridor/sweep/evaluate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <list>
#include <utility>

namespace stridor::sweep {

namespace {

using classification::Category;
using parameters::Case;
using parameters::Direction;
using record::Phase;
using signal::Signal;

constexpr double least_motion = 1e-9;  // [m/s, m/s²] what is smaller is rounding
constexpr double lead_in = 0.1;        // [s] before the sound begins, for the high pass at 20 Hz to forget its start

constexpr std::array<Perturbation, 12> all_perturbations{{
    {.name = "noise at 30 dB", .noise = 30.0},
    {.name = "noise at 20 dB", .noise = 20.0},
    {.name = "noise at 10 dB", .noise = 10.0},
    {.name = "noise at 0 dB", .noise = 0.0},
    {.name = "gain -60 dB", .gain = -60.0},
    {.name = "gain +40 dB", .gain = 40.0},
    {.name = "by 44.1 kHz", .rate = 44100.0},
    {.name = "by 22.05 kHz", .rate = 22050.0},
    {.name = "by 16 kHz", .rate = 16000.0},
    {.name = "up to 4 kHz", .high = 4000.0},
    {.name = "100 Hz to 8 kHz", .low = 100.0, .high = 8000.0},
    {.name = "300 Hz to 3.4 kHz", .low = 300.0, .high = 3400.0},
}};

Phase phase_of(const Case& c, Direction direction) {
    if (c.drive.kind == parameters::DriveKind::constant) return Phase::all;
    return direction == Direction::going ? Phase::going : Phase::coming;
}

// one direction of a run while it goes on
struct Listener {
    signal::AuralisationSettings settings;
    signal::Auralisation auralisation;
    Signal sound;

    explicit Listener(signal::AuralisationSettings the_settings)
        : settings(std::move(the_settings)),
          auralisation(settings),
          sound{settings.rate, signal::unit_of(settings.pickup.quantity), {}} {}

    void take(const std::vector<double>& block) {
        sound.samples.insert(sound.samples.end(), block.begin(), block.end());
    }
};

using Listeners = std::list<Listener>;  // they stay where they are; one per direction

Listeners listeners_for(const Case& c, std::span<const Direction> directions, const HearingSettings& settings) {
    Listeners listeners;
    const record::Schedule schedule = record::schedule(c);
    for (const Direction direction : directions) {
        signal::AuralisationSettings of_direction;
        of_direction.pickup = settings.pickup;
        of_direction.rate = settings.rate;
        of_direction.fade = 0.0;
        of_direction.stretches = signal::stretches_of(schedule, phase_of(c, direction), record::Use::judged);
        listeners.emplace_back(std::move(of_direction));
    }
    return listeners;
}

// a listener without stretches has nothing to hear
bool hears(const Listener& listener) {
    return !listener.settings.stretches.empty();
}

record::Request request_for(const Case& c, double rate, Listeners& listeners) {
    double from = c.run.duration;
    double to = 0.0;
    for (const Listener& listener : listeners) {
        if (!hears(listener)) continue;
        from = std::min(from, listener.settings.stretches.front().from - lead_in);
        to = std::max(to, listener.settings.stretches.back().to);
    }
    record::Request request;
    if (to == 0.0) return request;
    request.trace = {std::max(0.0, from), to, 1.0 / (rate * signal::trace_density),
                     [&listeners](const record::Trace& trace) {
                         for (Listener& listener : listeners)
                             if (hears(listener)) listener.take(listener.auralisation.add(trace));
                     }};
    return request;
}

classification::RecordingVerdict verdict_on(const Signal& sound, const parameters::SoundThresholds& thresholds) {
    signal::ChannelAnalyser analyser(sound.rate, {"", sound.unit});
    analyser.push(sound.samples);
    return classification::classify_recording(analyser.finish().stretches, thresholds);
}

void judge(HeardSound& heard, const Signal& sound, const parameters::SoundThresholds& thresholds) {
    const classification::RecordingVerdict verdict = verdict_on(sound, thresholds);
    heard.heard = verdict.category;
    heard.reason = verdict.reasons.empty() ? "" : verdict.reasons.back();
    const classification::SoundSegment* loudest = verdict.loudest();
    if (loudest == nullptr) return;
    heard.features = loudest->verdict.features;
    if (!loudest->verdict.reasons.empty()) heard.reason = loudest->verdict.reasons.back();
}

}  // namespace

std::span<const Perturbation> perturbations() {
    return all_perturbations;
}

Signal perturbed(Signal sound, const Perturbation& perturbation, std::uint64_t seed) {
    if (perturbation.noise) sound = signal::with_noise(std::move(sound), *perturbation.noise, seed);
    if (perturbation.gain != 0.0) sound = signal::amplified(std::move(sound), perturbation.gain);
    if (perturbation.rate > 0.0) sound = signal::resampled(signal::resampled(sound, perturbation.rate), sound.rate);
    if (perturbation.low > 0.0 || perturbation.high > 0.0)
        sound = signal::band_limited(sound, perturbation.low, perturbation.high);
    return sound;
}

void check_audible(const Case& c, const HearingSettings& settings) {
    if (c.run.engine != parameters::Engine::beta_2) return;
    // engines sample at their own steps
    const double wanted = 1.0 / (settings.rate * signal::trace_density * c.run.step);
    const double interval = std::max(1.0, std::round(wanted)) * c.run.step;
    if (4.0 * interval * settings.rate <= 1.0) return;
    throw Error(ErrorKind::input, {"run.step = " + base::shortest(c.run.step) + " s is too long for a sound of " +
                                       base::shortest(settings.rate) + " Hz",
                                   "at least four steps must fall on each of its samples",
                                   "Use run.engine = \"exact\", or shorter steps."});
}

std::vector<HeardSound> hear(const Case& c, std::span<const Direction> directions, const HearingSettings& settings,
                             const std::stop_token& stop, integration::Workspace& workspace) {
    Listeners listeners;
    record::Request request;
    if (parameters::findings(c).empty()) {
        check_audible(c, settings);
        listeners = listeners_for(c, directions, settings);
        request = request_for(c, settings.rate, listeners);
    }
    const std::optional<Attempt> run = attempt(c, request, stop, workspace);
    if (!run) return {};
    std::vector<HeardSound> sounds;
    auto listener = listeners.begin();
    for (const Direction direction : directions) {
        HeardSound& heard = sounds.emplace_back();
        heard.cell = cell_of(c, direction, *run);
        if (heard.cell.status != Status::done) continue;
        Listener& here = *listener++;
        heard.reason = "no part of the motion is judged";
        if (!hears(here)) continue;
        here.take(here.auralisation.finish());
        Signal& sound = here.sound;
        if (signal::peak(sound.samples) < least_motion) std::fill(sound.samples.begin(), sound.samples.end(), 0.0);
        judge(heard, sound, settings.thresholds);
        if (!settings.seed) continue;
        for (std::size_t k = 0; k < all_perturbations.size(); ++k) {
            const std::uint64_t seed =
                (*settings.seed * directions.size() + sounds.size()) * all_perturbations.size() + k;
            const Signal changed = perturbed(sound, all_perturbations[k], seed);
            heard.perturbed.push_back(verdict_on(changed, settings.thresholds).category);
        }
    }
    return sounds;
}

classification::Confusion confusion(std::span<const HeardSound> sounds, Half half) {
    classification::Confusion table;
    for (const HeardSound& sound : sounds) {
        const bool is_even = sound.index % 2 == 0;
        const bool counts = half == Half::both || (half == Half::even) == is_even;
        if (counts && sound.cell.status == Status::done)
            table = classification::counted(table, sound.cell.category, sound.heard);
    }
    return table;
}

classification::Confusion perturbed_confusion(std::span<const HeardSound> sounds,
                                              std::optional<std::size_t> perturbation) {
    classification::Confusion table;
    for (const HeardSound& sound : sounds) {
        if (sound.perturbed.empty()) continue;
        const Category heard = perturbation ? sound.perturbed[*perturbation] : sound.heard;
        table = classification::counted(table, sound.cell.category, heard);
    }
    return table;
}

}  // namespace stridor::sweep
