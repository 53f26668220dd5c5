#pragma once

#include "stridor/io/case/toml_section.hpp"
#include "stridor/parameters/own_structure.hpp"

#include <span>
#include <string_view>

namespace stridor::io {

/// A key of a builder.
struct BuilderKey {
    std::string_view name;
    std::string_view unit;  // empty: text
    std::string_view sentence;
};

/// A builder of structures and the keys that it takes.
struct StructureBuilder {
    std::string_view name;
    std::span<const BuilderKey> keys;
    parameters::OwnStructure (*build)(const TomlSection& section);
};

/// What it builds, with the lines that say so. Throws `Error` (input) at the key that is missing or wrong.
parameters::OwnStructure built_structure(const StructureBuilder& builder, const TomlSection& section);

/// chain, string, beam.
std::span<const StructureBuilder> structure_builders();

}  // namespace stridor::io
