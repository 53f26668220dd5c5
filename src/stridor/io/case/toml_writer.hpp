#pragma once

#include "stridor/parameters/case.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/sweep/study.hpp"

#include <string>

namespace stridor::io {

/// Does the file explain its keys?
enum class Comments {
    none,
    full,    // above each key what it is, its symbol, unit and range; and the keys of other kinds, to be uncommented
    beside,  // behind each value what it is; for people, who get no matrices but where those are from
};

/// How a file is written.
struct TomlOptions {
    Comments comments = Comments::full;
    std::string heading;  // lines put at the top as comments; may be empty
};

/// Returns a case as a TOML file, generated from the field table: every key that belongs to it, quantities with their
/// units. What follows the temperature stands in [temperature] alone.
///
/// Reading it back gives a case with an identical `parameters::canonical_text`, unless matrices were left out.
std::string case_toml(const parameters::Case& c, const TomlOptions& options = {});

/// Returns a chart: the case's sections and [chart]. Reading it back gives the same `sweep::canonical_text`.
std::string study_toml(const sweep::Study& study, const TomlOptions& options = {});

/// Returns one key with a value as a file has it: "preload = "20 N"". A file's name that is not known yet is
/// "velocity.csv".
std::string toml_line(parameters::CaseView at, const parameters::Field& field);

/// Returns which values a field takes, in words: "N, above 0", "\"rest\", \"stuck\" or \"sliding\"", "text".
std::string describe_values(const parameters::Field& field);

}  // namespace stridor::io
