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

/// Makes recordings and simulations comparable: at one rate, analysed and judged alike.
namespace stridor::hearing {

/// A recording that is known but not read yet.
struct RecordedSound {
    recordings::SignalInput input;
    recordings::OpenOptions open{};
    double rate = 0.0;  // [Hz]
};

/// A case that is not run yet.
struct SimulatedSound {
    parameters::Case c;
    std::vector<sound::Stretch> stretches{};  // heard; empty: the whole run
};

/// A sound for a comparison. The words are those of `classification::ComparedSound`.
struct NamedSound {
    std::string name{};
    std::string label{};
    std::string origin{};
    std::variant<RecordedSound, SimulatedSound> source;
};

/// The number of sounds in one comparison.
inline constexpr std::size_t least_compared = 2;  // [1]
inline constexpr std::size_t most_compared = 8;   // [1]

/// Throws `Error` (input) for fewer or more sounds.
void require_comparable(std::size_t sounds);

/// How sounds are compared.
struct ComparisonSettings {
    AskedMotion motion{};   // the motion of a simulation that is heard
    double rate = 48000.0;  // [Hz] of all sounds
    double detail = 0.05;   // [s] length of the stretch that is kept sample by sample
};

/// Returns the rate of a comparison [Hz]: the lowest of all recordings, since a band that one recorder lacks would
/// distinguish them; 48 kHz among simulations alone.
double common_rate(std::span<const NamedSound> sounds);

/// Says whether a sound is a recording of another rate, which is then resampled.
bool is_resampled(const NamedSound& sound, double rate);

/// Reads or simulates a sound, analyses its loudest channel, and judges it. A simulation is made at 8 kHz to 192 kHz;
/// if it nowhere moves by more than `least_motion`, it is silence.
///
/// Throws the errors of reading a recording, and `Error` for a run without a result or one that was stopped.
classification::ComparedSound compared(const NamedSound& sound, const ComparisonSettings& settings,
                                       const std::stop_token& stop = {});

}  // namespace stridor::hearing
