#pragma once

#include "stridor/noise_library/field.hpp"
#include "stridor/noise_library/library.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The default view of a library: columns, words to choose from.
namespace stridor::noise_library {

/// The fields of a list of entries, separated by commas.
inline constexpr const char* usual_columns =
    "id,system,denomination,category,recorded,preload,velocity,temperature,duration,file";

/// Returns names separated by commas.
std::vector<std::string> parse_columns(const std::string& text);

/// Returns how much of each entry these columns show.
EntryExtent extent_for(std::span<const std::string> columns);

/// Returns the field of this name; throws `Error` (input) that suggests the nearest one.
const EntryField& field_named(const std::string& name);

/// Returns the words to choose from for a field: usual ones, then those that this library adds. For "id" they are the
/// numbers of the entries. A library that does not exist adds none. Throws the errors of opening it.
std::vector<std::string> words_to_choose(const std::filesystem::path& library, const std::string& field);

/// Returns the figures in a library; empty if it does not exist. Throws the errors of opening it.
std::vector<FigureKind> figures_in(const std::filesystem::path& library);

}  // namespace stridor::noise_library
