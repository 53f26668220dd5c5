#pragma once

#include <string>

namespace stridor::io {

/// Returns a JSON Schema (draft 2020-12) of case and chart files, generated from the field table, for completion in
/// editors.
///
/// It says what a file may hold: sections, keys, their sentences, ranges and choices, what must be there, and which
/// keys a drive needs. Units in text are left to the reader.
std::string json_schema();

}  // namespace stridor::io
