#pragma once

#include "stridor/noise_library/library.hpp"
#include "stridor/noise_library/recording.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/recordings/open_signal.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

/// What a recording tells of itself when it comes into a library: its own words,
/// what is heard in it, what was measured.
namespace stridor::app {

enum class Judging { by_ear, none };

/// How recordings are listened to.
struct HearingOptions {
    Judging judging = Judging::by_ear;
    std::string channel;                   // the sound: name or number; empty: by unit, the loudest
    std::vector<std::string> full_scales;  // "2 Pa"
};

/// How much of a recording is analysed [1].
using Heard = std::function<void(double share)>;

/// What an entry's calibration says the number 1 of its file stands for, of every channel or of each; nothing if that
/// is no calibration a program reads.
std::vector<recordings::FullScale> full_scales_in(const std::string& calibration);

/// The greatest velocity of a drive [m/s] to six digits, for 2 pi f A has no short text; unknown of a sampled one.
double peak_velocity(const parameters::Drive& drive);

/// "constant", "sinusoidal 5 Hz"; empty for a sampled drive.
std::string profile_of(const parameters::Drive& drive);

/// Puts what the file says of itself where the user said nothing, and tells on stderr what and from where.
///
/// Throws `Error` (input) for a simulated sound that is said to be a recording.
void take_facts(const recordings::SignalFacts& facts, noise_library::Entry& entry);

/// Listens to a recording that lies open, and puts category, verdict and figures into its entry;
/// figures of the user's stay.
///
/// Says on stderr why, where nothing in it can be heard. Throws `Error` (input)
/// for a damaged file or an unknown channel.
void judge(const recordings::SignalInput& input, const HearingOptions& options, noise_library::Entry& entry,
           const Heard& heard = {});

/// Friction coefficients and force drops as figures, where there is a friction force and the preload is known.
void measure_friction(const recordings::SignalInput& input, noise_library::Entry& entry);

/// All of this for a file that is added.
noise_library::Probe probe_of(const HearingOptions& options, const Heard& heard);

}  // namespace stridor::app
