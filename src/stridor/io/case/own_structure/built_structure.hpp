#pragma once

#include "stridor/io/case/own_structure/toml_section.hpp"
#include "stridor/parameters/own_structure.hpp"

#include <span>
#include <string>
#include <string_view>

namespace stridor::io {

/// A key of a builder. A quantity is a field of the field table, which has its unit, range and sentence.
struct BuilderKey {
    std::string_view name;
    enum class Holds { quantity, count, word } holds = Holds::quantity;
    enum class Need { required, optional } need = Need::required;
    int most = 0;                               // of a count
    std::span<const std::string_view> words{};  // of a word; without the key it is the first
    std::string_view sentence{};                // of what is no field
};

/// A builder of structures and the keys that it takes.
struct StructureBuilder {
    std::string_view name;
    std::span<const BuilderKey> keys;
    parameters::OwnStructure (*build)(const parameters::Recipe& recipe);
};

/// Returns what a key is, in a few words.
std::string_view sentence_of(const BuilderKey& key);

/// Returns what it builds. Throws `Error` (input) at the key that is missing or wrong.
parameters::OwnStructure built_structure(const StructureBuilder& builder, const TomlSection& section);

/// Returns the keys of one builder, which must be there.
std::span<const BuilderKey> builder_keys(std::string_view builder);

/// Returns the names of the builders: chain, string, beam.
std::span<const StructureBuilder> structure_builders();

}  // namespace stridor::io
