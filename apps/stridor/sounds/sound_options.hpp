#pragma once

#include "input_options.hpp"
#include "stridor/io/sound/json_sound.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace stridor::app {

/// What every command that listens to a recording takes.
struct SoundOptions {
    std::string file;  // "-" is stdin
    InputOptions recording;
    std::vector<std::string> thresholds;  // "squeal_regularity=0.7"
};

/// Adds the file, --full-scale, --channel, --dataset, --rate and --set.
void add_sound_options(CLI::App& command, SoundOptions& options);

/// Reads, analyses and judges the recording that the options name; says on stderr what is noteworthy, and how far it
/// is. With a field the channels in Pa get their sound quality, heard in it.
io::SoundReport listen_to(const SoundOptions& options, std::optional<sound::SoundField> field = {});

}  // namespace stridor::app
