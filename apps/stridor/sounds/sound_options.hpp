#pragma once

#include "stridor/io/sound/json_sound.hpp"
#include "stridor/recordings/open_signal.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace stridor::app {

/// Facts that the user of a command knows better than the recording.
struct InputOptions {
    std::vector<std::string> full_scales;  // "2 Pa"
    std::string channel;                   // name or number from 1; empty: all
    std::size_t dataset = 0;               // of a UFF file, from 1; 0: all
    std::string rate;                      // of a CSV table
};

/// Adds --full-scale.
void add_full_scale_option(CLI::App& command, std::vector<std::string>& full_scales);

/// Adds --full-scale, --channel, --dataset and --rate.
void add_input_options(CLI::App& command, InputOptions& options);

/// Returns the options for opening a recording. Throws `Error` (input) for an invalid full scale or rate.
recordings::OpenOptions open_options(const InputOptions& options);

/// The options of every command that listens to a recording.
struct SoundOptions {
    std::string file;  // "-" is stdin
    InputOptions recording;
    std::vector<std::string> thresholds;  // "certainty=0.6"
};

/// Adds --full-scale, --channel, --dataset, --rate and --set.
void add_listening_options(CLI::App& command, SoundOptions& options);

/// Adds the file, --full-scale, --channel, --dataset, --rate and --set.
void add_sound_options(CLI::App& command, SoundOptions& options);

/// Returns the thresholds by ear. Throws `Error` (input) for an unknown name or a value that does not fit.
parameters::SoundThresholds thresholds_of(const SoundOptions& options);

/// Who judges channels: the ear what is heard through air, the rules motions and forces.
struct Judges {
    bool ear = false;
    bool rules = false;
};

/// Returns the judges of channels that will be heard, or those of a recording that was.
Judges judges_of(std::span<const signal::Channel> channels);
Judges judges_of(const io::SoundReport& report);

/// Says of each threshold that was set, and that none of the judges asks for, that it changes nothing.
void say_unused(const SoundOptions& options, Judges judges);

/// Reads, analyses and judges the recording of the options; says notes and progress on stderr. If `field` is given, the
/// channels in Pa get their sound quality, heard in that field.
io::SoundReport listen_to(const SoundOptions& options, std::optional<sound::SoundField> field = {});

/// Reads, analyses and judges the recording of the options. Says nothing: `progress` gets the share [1] that is done,
/// where the recording tells its length, else 0.
io::SoundReport listen_quietly_to(const SoundOptions& options, const std::function<void(double share)>& progress);

}  // namespace stridor::app
