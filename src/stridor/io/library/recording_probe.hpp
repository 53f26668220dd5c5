#pragma once

#include "stridor/noise_library/add_recordings.hpp"
#include "stridor/noise_library/entry.hpp"
#include "stridor/noise_library/library.hpp"
#include "stridor/recordings/open_signal.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

/// Examines a recording that comes into a library: its own words, its sound, its measurements.
namespace stridor::io {

/// Is told notes for the user, a sentence at a time.
using Notes = std::function<void(const std::string& sentence)>;

/// Writes the facts in the file into fields that the user left empty, and notes which and from where. For a simulated
/// sound the case in the file gives them.
///
/// Throws `Error` (input) for a simulated sound that the user calls a recording.
void take_facts(const recordings::SignalFacts& facts, noise_library::Entry& entry, const Notes& note);

/// Whether a verdict by ear is made.
enum class Judging { by_ear, none };

/// How recordings are listened to and judged.
struct JudgingOptions {
    Judging judging = Judging::by_ear;
    std::string channel;                   // the sound: name or number; empty: by unit, the loudest
    std::vector<std::string> full_scales;  // "2 Pa"
    Notes note = [](const std::string&) { /* nobody listens */ };  // notes for the user
};

/// Is told the share of a recording that is analysed [1].
using Heard = std::function<void(double share)>;

/// Listens to an open recording, and writes category, verdict and figures into its entry; figures of the user's stay.
///
/// Notes the reason if nothing in it can be heard. Throws `Error` (input) for a damaged file or an unknown channel.
void judge(const recordings::SignalInput& input, const JudgingOptions& options, noise_library::Entry& entry,
           const Heard& heard = {});

/// Adds friction coefficients and force drops as figures, if there is a friction force and the preload is known.
void measure_friction(const recordings::SignalInput& input, noise_library::Entry& entry, const Notes& note);

/// Returns a probe that does all of this for an added file.
noise_library::Probe probe_of(const JudgingOptions& options, const Heard& heard);

/// Says whether an entry has no verdict, or one of another version of this program.
bool has_outdated_verdict(const noise_library::Entry& entry);

/// The verdicts that are made anew.
enum class Rejudged { outdated, all };

/// Returns the entries that meet a query and whose verdict is to be made anew.
std::vector<std::int64_t> ids_to_judge(noise_library::Library& library, noise_library::Query query, Rejudged which);

/// Listens again to an entry, on the channel of its verdict if none is named, and returns the changed entry.
noise_library::Entry judge_again(noise_library::Library& library, std::int64_t id, const JudgingOptions& options,
                                 const Heard& heard);

}  // namespace stridor::io
