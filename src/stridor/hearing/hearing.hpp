#pragma once

#include "stridor/classification/recording_verdict.hpp"
#include "stridor/classification/verdict.hpp"
#include "stridor/hearing/heard_motion.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/parameters/fields/sound_thresholds.hpp"
#include "stridor/signal/source.hpp"
#include "stridor/sound/auralisation.hpp"
#include "stridor/sweep/cell.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

/// The verdict by ear compared with the verdict by contact states of the same run: a motion judged by its sound alone.
/// docs/methods/sound.md, section 6.
namespace stridor::hearing {

/// A disturbance that a recording may add to a sound.
struct Perturbation {
    std::string_view name;          // "noise at 20 dB"
    std::optional<double> noise{};  // [dB] sound over white noise that is added
    double gain = 0.0;              // [dB]
    double rate = 0.0;              // [Hz] to this rate and back; 0: unchanged
    double low = 0.0;               // [Hz] lower end of the remaining band; 0: open
    double high = 0.0;              // [Hz] upper end; 0: open
};

/// Returns the noise, gains, rates and bands that a verdict should survive.
std::span<const Perturbation> perturbations();

/// Returns the disturbed sound; the noise depends on `seed` alone.
signal::Signal perturbed(signal::Signal sound, const Perturbation& perturbation, std::uint64_t seed);

/// How motions are made audible and judged.
struct HearingSettings {
    AskedMotion motion{};
    // its pickup and stretches follow from each case. What folds back at this density lies 92 dB below the tone
    // (docs/methods/auralisation.md).
    sound::AuralisationSettings sound{.fade = 0.0, .density = 8};
    parameters::SoundThresholds thresholds{};
    std::optional<std::uint64_t> seed{};  // of the noise; `std::nullopt`: the sounds are not perturbed
};

/// One direction of a run, judged twice.
struct HeardSound {
    std::size_t index = 0;  // of the cell in its study
    sweep::Cell cell;       // its verdict by contact states, with figures; only a done cell is heard
    classification::Category heard = classification::Category::undecided;  // its verdict by ear
    sound::SoundFeatures features{};                    // of the loudest stretch of that category; all 0 if none
    std::string reason;                                 // why it is of that category
    std::vector<classification::Category> perturbed{};  // by ear after each of `perturbations()`; may be empty
};

/// Runs a case and judges each direction by its contact states and, from the sound of the same motion, by ear; shape
/// [direction], or empty if it was stopped. The caller sets the index.
///
/// With a constant drive the window is heard, from which the contact-state verdict is made, too. With any other drive
/// each phase is heard as a whole, described by itself, as a stretch without fades (`sound_of_run`). Throws what
/// `check_audible` throws.
std::vector<HeardSound> hear(const parameters::Case& c, std::span<const parameters::Direction> directions,
                             const HearingSettings& settings, const std::stop_token& stop,
                             integration::Workspace& workspace);

/// The cells of a study to count. Thresholds were chosen on the even ones.
enum class Half { both, even, odd };

/// Returns how often the ear agrees with the contact states, done cells only.
classification::Confusion confusion(std::span<const HeardSound> sounds, Half half = Half::both);

/// Returns how often the ear agrees with the contact states for the perturbed sounds, after perturbation number
/// `perturbation`; `std::nullopt`: before all of them.
classification::Confusion perturbed_confusion(std::span<const HeardSound> sounds,
                                              std::optional<std::size_t> perturbation);

}  // namespace stridor::hearing
