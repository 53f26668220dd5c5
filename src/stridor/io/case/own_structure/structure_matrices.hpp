#pragma once

#include "stridor/io/case/own_structure/toml_section.hpp"
#include "stridor/io/structure/field_scanner.hpp"
#include "stridor/io/structure/part_files.hpp"

#include <string>

namespace stridor::io {

/// Returns the matrices of [structure] with the labels of their rows: in the file itself (`mass = [[...]]`, `rows`), as
/// CSV or Matrix Market (`mass = "m.mtx"`, `labels`), or a part of a finite-element program, reduced or not (`file`,
/// `units`).
///
/// Throws `Error` (input) for what does not fit or is no structure.
NamedPart part_in(const TomlSection& section);

/// Returns a file that an entry names. Throws `Error` (io) with its place where it cannot be opened.
structure::StructureInput opened(const std::string& path, const TomlEntry& entry);

}  // namespace stridor::io
