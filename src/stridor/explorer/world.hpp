#pragma once

#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/sweep/study.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stridor::explorer {

/// A case with which the explorer can begin.
struct Preset {
    std::string name;                      // "squeal"
    std::string toml;                      // its text
    std::string file{};                    // the file of its text; empty: one of the paper's
    std::vector<std::string> overrides{};  // "section.key=value", over the file's values
    std::string samples_file{};            // of its sampled drive, as read when the program started
    recordings::SampledMotion samples{};   // the content of that file
    // its tables, as read then, by the paths of their files; of pairs by path and name
    std::map<std::string, recordings::SampledFriction> friction{};
    std::map<std::string, recordings::SampledForce> force{};
    std::map<std::pair<std::string, std::string>, parameters::MaterialPair> pairs{};
    std::shared_ptr<const parameters::OwnStructure> structure{};  // its own, as read then; null: none
    std::optional<sweep::Study> study{};                          // the chart of its file, if it has one
};

/// The data of the explorer's answers; it never changes.
struct World {
    std::vector<Preset> presets;
    std::filesystem::path library;  // empty: none
    int threads = 0;                // [1] for charts; 0: one per processor
};

/// Returns a preset as the text from which a case is read.
io::TomlSource source_of(const Preset& preset);

/// Returns readers that have the preset's own files, and open none: a visitor of the page must not make the program
/// open files. A structure from a builder is built anew, from numbers that a request may vary.
io::CaseReaders readers_of(const Preset& preset);

/// Returns the four cases of Table 1.
std::vector<Preset> paper_presets();

/// Returns the preset of a file, with its samples, tables and structure, as these readers read them, and its chart. If
/// the friction depends on the temperature, the preset has a chart over that; for an own structure it has one over a
/// quantity of the structure. Throws `Error` for a file that is not a case.
Preset preset_of(const io::TomlSource& source, const io::CaseReaders& readers);

/// Returns the preset of this name. Throws `Error` (input) for an unknown name.
const Preset& preset_named(const World& world, std::string_view name);

}  // namespace stridor::explorer
