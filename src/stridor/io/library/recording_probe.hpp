#pragma once

#include "stridor/noise_library/add_recordings.hpp"
#include "stridor/noise_library/entry.hpp"
#include "stridor/noise_library/library.hpp"
#include "stridor/recordings/open_signal.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

/// What a recording tells of itself when it comes into a library: its own words, what is heard in it, what was
/// measured.
namespace stridor::io {

/// Is told what is noteworthy, a sentence at a time.
using Notes = std::function<void(const std::string& sentence)>;

/// Puts what the file says of itself where the user said nothing, and tells what and from where. Of a simulated sound
/// the case that came along says what it was like.
///
/// Throws `Error` (input) for a simulated sound that is said to be a recording.
void take_facts(const recordings::SignalFacts& facts, noise_library::Entry& entry, const Notes& note);

/// Is a verdict made by ear, or none?
enum class Judging { by_ear, none };

/// How recordings are listened to and judged.
struct JudgingOptions {
    Judging judging = Judging::by_ear;
    std::string channel;                   // the sound: name or number; empty: by unit, the loudest
    std::vector<std::string> full_scales;  // "2 Pa"
    Notes note = [](const std::string&) { /* nobody listens */ };  // what is noteworthy
};

/// How much of a recording is analysed [1].
using Heard = std::function<void(double share)>;

/// Listens to a recording that lies open, and puts category, verdict and figures into its entry;
/// figures of the user's stay.
///
/// Notes why, where nothing in it can be heard. Throws `Error` (input)
/// for a damaged file or an unknown channel.
void judge(const recordings::SignalInput& input, const JudgingOptions& options, noise_library::Entry& entry,
           const Heard& heard = {});

/// Friction coefficients and force drops as figures, where there is a friction force and the preload is known.
void measure_friction(const recordings::SignalInput& input, noise_library::Entry& entry, const Notes& note);

/// All of this for a file that is added.
noise_library::Probe probe_of(const JudgingOptions& options, const Heard& heard);

/// Is there no verdict, or one that another version of this program made?
bool has_outdated_verdict(const noise_library::Entry& entry);

/// Which verdicts are made anew.
enum class Rejudged { outdated, all };

/// The entries that meet a query and whose verdict is to be made anew.
std::vector<std::int64_t> ids_to_judge(noise_library::Library& library, noise_library::Query query, Rejudged which);

/// Listens again to an entry, on the channel of its verdict where none is named, and gives it back as it then is.
noise_library::Entry judge_again(noise_library::Library& library, std::int64_t id, const JudgingOptions& options,
                                 const Heard& heard);

}  // namespace stridor::io
