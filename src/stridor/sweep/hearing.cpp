#include "stridor/sweep/hearing.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/classification/sound_rules.hpp"
#include "stridor/parameters/check.hpp"
#include "stridor/record/schedule.hpp"
#include "stridor/signal/perturb.hpp"
#include "stridor/signal/resample.hpp"
#include "stridor/signal/sound_analysis.hpp"
#include "stridor/sweep/cell_sound.hpp"
#include "stridor/sweep/evaluate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace stridor::sweep {

namespace {

using classification::Category;
using parameters::Case;
using parameters::Direction;
using signal::Signal;

constexpr double lead_in = 0.1;  // [s] before the sound begins, for the high pass at 20 Hz to forget its start
// trace samples per sample of the sound: what folds back lies 92 dB below the tone (docs/methods/auralisation.md)
constexpr int density = 8;

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

// the sound of a run from somewhat before its first part that is heard on
class Recorder {
public:
    Recorder(const Case& c, const record::Schedule& schedule, const HearingSettings& settings)
        : auralisation_({.pickup = settings.pickup, .rate = settings.rate}),
          sound_{settings.rate, signal::unit_of(settings.pickup.quantity), {}} {
        const auto is_heard = [](const record::Span& span) { return span.use != record::Use::unused; };
        const auto first = std::find_if(schedule.spans.begin(), schedule.spans.end(), is_heard);
        if (first == schedule.spans.end()) return;
        request_.trace = {std::max(0.0, first->from - lead_in), c.run.duration, 1.0 / (settings.rate * density),
                          [this](const record::Trace& trace) { take(trace); }};
    }
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    const record::Request& request() const { return request_; }

    /// After the run.
    void finish() { append(auralisation_.finish()); }

    Signal part(const signal::Stretch& stretch) const {
        const auto index = [&](double time) {
            const double samples = std::ceil(std::max(0.0, time - begin_) * sound_.rate - 1e-6);
            return std::min(sound_.samples.size(), static_cast<std::size_t>(samples));
        };
        const auto at = [&](double time) { return sound_.samples.begin() + static_cast<std::ptrdiff_t>(index(time)); };
        return {sound_.rate, sound_.unit, {at(stretch.from), at(stretch.to)}};
    }

private:
    void take(const record::Trace& trace) {
        if (!has_begun_ && !trace.time.empty()) begin_ = trace.time.front();
        has_begun_ = has_begun_ || !trace.time.empty();
        append(auralisation_.add(trace));
    }

    void append(const std::vector<double>& block) {
        sound_.samples.insert(sound_.samples.end(), block.begin(), block.end());
    }

    signal::Auralisation auralisation_;
    Signal sound_;
    record::Request request_;
    double begin_ = 0.0;  // [s] instant of the sound's first sample
    bool has_begun_ = false;
};

// what is not next to each other in time is described by itself: no splice is heard
classification::RecordingVerdict verdict_on(std::span<const Signal> parts,
                                            const parameters::SoundThresholds& thresholds) {
    std::vector<signal::SoundStretch> stretches;
    double from = 0.0;  // [s] one part after the other
    for (const Signal& part : parts) {
        signal::ChannelAnalyser analyser(part.rate, {"", part.unit});
        analyser.push(part.samples);
        for (signal::SoundStretch& stretch : analyser.finish().stretches) {
            stretch.features.from += from;
            stretches.push_back(std::move(stretch));
        }
        from += signal::duration(part);
    }
    return classification::classify_recording(stretches, thresholds);
}

void judge(HeardSound& heard, std::span<const Signal> parts, const parameters::SoundThresholds& thresholds) {
    const classification::RecordingVerdict verdict = verdict_on(parts, thresholds);
    heard.heard = verdict.category;
    heard.reason = verdict.reasons.empty() ? "" : verdict.reasons.back();
    const classification::SoundSegment* loudest = verdict.loudest();
    if (loudest == nullptr) return;
    heard.features = loudest->verdict.features;
    if (!loudest->verdict.reasons.empty()) heard.reason = loudest->verdict.reasons.back();
}

Category heard_after(const Perturbation& perturbation, std::vector<Signal> parts, std::uint64_t seed,
                     const parameters::SoundThresholds& thresholds) {
    for (Signal& part : parts)
        part = perturbed(std::move(part), perturbation, seed++);
    return verdict_on(parts, thresholds).category;
}

std::vector<Signal> audible(std::vector<Signal> parts) {
    for (Signal& part : parts)
        if (signal::peak(part.samples) < least_motion) std::fill(part.samples.begin(), part.samples.end(), 0.0);
    return parts;
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
    const double wanted = 1.0 / (settings.rate * density * c.run.step);
    const double interval = std::max(1.0, std::round(wanted)) * c.run.step;
    if (4.0 * interval * settings.rate <= 1.0) return;
    throw Error(ErrorKind::input, {"run.step = " + base::shortest(c.run.step) + " s is too long for a sound of " +
                                       base::shortest(settings.rate) + " Hz",
                                   "at least four steps must fall on each of its samples",
                                   "Use run.engine = \"exact\", or shorter steps."});
}

std::vector<HeardSound> hear(const Case& c, std::span<const Direction> directions, const HearingSettings& settings,
                             const std::stop_token& stop, integration::Workspace& workspace) {
    const bool is_valid = parameters::findings(c).empty();
    const record::Schedule schedule = is_valid ? record::schedule(c) : record::Schedule{};
    if (is_valid) check_audible(c, settings);
    Recorder recorder(c, schedule, settings);
    const std::optional<Attempt> run = attempt(c, recorder.request(), stop, workspace);
    if (!run) return {};
    recorder.finish();
    std::vector<HeardSound> sounds;
    for (const Direction direction : directions) {
        HeardSound& heard = sounds.emplace_back();
        heard.cell = cell_of(c, direction, *run);
        if (heard.cell.status != Status::done) continue;
        std::vector<Signal> parts;
        for (const signal::Stretch& stretch : heard_stretches(c, direction))
            parts.push_back(recorder.part(stretch));
        parts = audible(std::move(parts));
        judge(heard, parts, settings.thresholds);
        if (!settings.seed) continue;
        // each change of each sound has a noise of its own
        const std::uint64_t number = *settings.seed * directions.size() + sounds.size();
        for (std::size_t k = 0; k < all_perturbations.size(); ++k)
            heard.perturbed.push_back(heard_after(all_perturbations[k], parts,
                                                  (number * all_perturbations.size() + k) << 16U, settings.thresholds));
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
