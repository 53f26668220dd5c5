#pragma once

#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/sweep/study.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::explorer {

/// A case the explorer can begin with.
struct Preset {
    std::string name;                      // "squeal"
    std::string toml;                      // its text
    std::string file{};                    // the file it came from; empty: one of the paper's
    std::vector<std::string> overrides{};  // "section.key=value", over the file's values
    std::string samples_file{};            // of its sampled drive, as it was read when the program started
    recordings::SampledMotion samples{};   // what stood in it
    std::shared_ptr<const parameters::OwnStructure> structure{};  // its own, as it was read then; null: none
    std::optional<sweep::Study> study{};                          // the chart of its file, should it have one
};

/// What the explorer's answers are made from; it never changes.
struct World {
    std::vector<Preset> presets;
    std::filesystem::path library;  // empty: none
    int threads = 0;                // [1] for charts; 0: one per processor
};

/// A preset as the text that a case is read from.
io::TomlSource source_of(const Preset& preset);

/// Gives what came with a preset, and opens nothing: whoever reaches the page must not make the program
/// open files. What a builder made is built anew, from numbers that a request may vary.
io::CaseReaders readers_of(const Preset& preset);

/// The four cases of Table 1.
std::vector<Preset> paper_presets();

/// The file that somebody named when the program started, with its samples, its structure and its chart; where the
/// friction follows the temperature, with a chart over that; of an own structure with one over what it has. Throws
/// `Error` for what is no case.
Preset preset_of(const io::TomlSource& source);

/// About how long one core runs a case with a structure of its own [s]; the case must have one. Measured within a
/// factor of three of a string of 41 rows, and of 24 rows with 12 contacts.
double structure_seconds(const parameters::Case& c);

/// The cases of Table 1 and a noise library: the one named, or the user's own if there is one. Throws `Error` for a
/// named one that cannot be opened.
World world_of(const std::filesystem::path& library);

/// Throws `Error` (input) for a name that is none.
const Preset& preset_named(const World& world, std::string_view name);

}  // namespace stridor::explorer
