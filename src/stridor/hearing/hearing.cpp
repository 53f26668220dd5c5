#include "stridor/hearing/hearing.hpp"

#include "stridor/hearing/run_sound.hpp"
#include "stridor/signal/perturb.hpp"
#include "stridor/signal/resample.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace stridor::hearing {

namespace {

using classification::Category;
using parameters::Case;
using parameters::Direction;
using signal::Signal;

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

void judge(HeardSound& heard, const Case& c, std::span<const Signal> parts,
           const parameters::SoundThresholds& thresholds) {
    const classification::RecordingVerdict verdict = judged(c, parts, thresholds).verdict;
    heard.heard = verdict.category;
    heard.reason = verdict.reasons.empty() ? "" : verdict.reasons.back();
    const classification::SoundSegment* loudest = verdict.loudest();
    if (loudest == nullptr) return;
    heard.features = loudest->verdict.features;
    if (!loudest->verdict.reasons.empty()) heard.reason = loudest->verdict.reasons.back();
}

Category heard_after(const Perturbation& perturbation, const Case& c, std::vector<Signal> parts, std::uint64_t seed,
                     const parameters::SoundThresholds& thresholds) {
    for (Signal& part : parts)
        part = perturbed(std::move(part), perturbation, seed++);
    return judged(c, parts, thresholds).verdict.category;
}

// each change of each sound has a noise of its own
std::vector<Category> heard_after_all(const Case& c, const std::vector<Signal>& parts, std::uint64_t number,
                                      const parameters::SoundThresholds& thresholds) {
    std::vector<Category> heard;
    for (std::size_t k = 0; k < all_perturbations.size(); ++k)
        heard.push_back(
            heard_after(all_perturbations[k], c, parts, (number * all_perturbations.size() + k) << 16U, thresholds));
    return heard;
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

std::vector<HeardSound> hear(const Case& c, std::span<const Direction> directions, const HearingSettings& settings,
                             const std::stop_token& stop, integration::Workspace& workspace) {
    const std::optional<HeardMotion> motion = heard_motion(c, settings.motion, stop, workspace);
    if (!motion) return {};
    sound::AuralisationSettings sound = settings.sound;
    sound.pickup = motion->pickup;
    sound.stretches.clear();
    std::vector<std::size_t> ends;  // of each direction's stretches
    for (const Direction direction : directions) {
        const std::vector<sound::Stretch> heard = heard_stretches(c, direction);
        sound.stretches.insert(sound.stretches.end(), heard.begin(), heard.end());
        ends.push_back(sound.stretches.size());
    }
    std::optional<RunSound> run = sound_of_run(c, sound, stop, workspace);
    if (!run) return {};
    std::vector<HeardSound> sounds;
    std::size_t begin = 0;
    for (std::size_t k = 0; k < directions.size(); ++k) {
        HeardSound& heard = sounds.emplace_back();
        heard.cell = sweep::cell_of(c, directions[k], run->attempt);
        if (heard.cell.status != sweep::Status::done) continue;
        const std::size_t end = ends[k];
        const std::vector<Signal> parts(run->parts.begin() + static_cast<std::ptrdiff_t>(begin),
                                        run->parts.begin() + static_cast<std::ptrdiff_t>(end));
        begin = end;
        judge(heard, c, parts, settings.thresholds);
        if (settings.seed)
            heard.perturbed =
                heard_after_all(c, parts, *settings.seed * directions.size() + sounds.size(), settings.thresholds);
    }
    return sounds;
}

classification::Confusion confusion(std::span<const HeardSound> sounds, Half half) {
    classification::Confusion table;
    for (const HeardSound& sound : sounds) {
        const bool is_even = sound.index % 2 == 0;
        const bool counts = half == Half::both || (half == Half::even) == is_even;
        if (counts && sound.cell.status == sweep::Status::done)
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

}  // namespace stridor::hearing
