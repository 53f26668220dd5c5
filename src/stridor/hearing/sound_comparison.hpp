#pragma once

#include "stridor/classification/compared_sound.hpp"
#include "stridor/hearing/heard_motion.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/recordings/open_signal.hpp"
#include "stridor/sound/auralisation.hpp"

#include <span>
#include <stop_token>
#include <string>
#include <variant>
#include <vector>

/// Recordings and simulations made comparable: brought to one rate, analysed and judged alike.
namespace stridor::hearing {

/// A recording, known but not read.
struct RecordedSound {
    recordings::SignalInput input;
    recordings::OpenOptions open{};
    double rate = 0.0;  // [Hz]
};

/// A case, not run yet.
struct SimulatedSound {
    parameters::Case c;
    std::vector<sound::Stretch> stretches{};  // heard; empty: the whole run
};

/// A sound that is to stand beside others. The words are those of `classification::ComparedSound`.
struct NamedSound {
    std::string name{};
    std::string label{};
    std::string origin{};
    std::variant<RecordedSound, SimulatedSound> source;
};

/// Sounds that can be laid side by side.
inline constexpr std::size_t least_compared = 2;  // [1]
inline constexpr std::size_t most_compared = 8;   // [1]

/// Throws `Error` (input) for fewer or more.
void require_comparable(std::size_t sounds);

/// How sounds are compared.
struct ComparisonSettings {
    AskedMotion motion{};   // which motion of a simulation stands for its sound
    double rate = 48000.0;  // [Hz] of all sounds
    double detail = 0.05;   // [s] how long the stretch is that is kept sample by sample
};

/// The rate of a comparison [Hz]: the lowest of all recordings, since a band that one of them lacks would tell them
/// apart by their recorders; 48 kHz among simulations alone.
double common_rate(std::span<const NamedSound> sounds);

/// Is a recording of another rate? Then it is resampled.
bool is_resampled(const NamedSound& sound, double rate);

/// Reads or simulates a sound, analyses its loudest channel, and judges it. A simulation is made at 8 kHz to 192 kHz;
/// one that nowhere moves by more than `least_motion` is silence.
///
/// Throws `Error`: what reading a recording throws, and for a run without a result or one that was stopped.
classification::ComparedSound compared(const NamedSound& sound, const ComparisonSettings& settings,
                                       const std::stop_token& stop = {});

}  // namespace stridor::hearing
