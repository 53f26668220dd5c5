#pragma once

#include "stridor/noise_library/field.hpp"
#include "stridor/noise_library/library.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What is shown of a library where nobody says more: columns, words to choose from.
namespace stridor::noise_library {

/// The fields of a list of entries, with commas between.
inline constexpr const char* usual_columns =
    "id,system,denomination,category,recorded,preload,velocity,temperature,duration,file";

/// Names parted at commas.
std::vector<std::string> parse_columns(const std::string& text);

/// How much of each entry these columns show.
EntryExtent extent_for(std::span<const std::string> columns);

/// The field of this name; throws `Error` (input) with the nearest one.
const EntryField& field_named(const std::string& name);

/// The words of a field that one would choose from: usual ones, then what this library adds to them. "id" is the
/// numbers of the entries. A library that is not there adds nothing. Throws what opening it throws otherwise.
std::vector<std::string> words_to_choose(const std::filesystem::path& library, const std::string& field);

/// The figures in a library; none where it is not there. Throws what opening it throws otherwise.
std::vector<FigureKind> figures_in(const std::filesystem::path& library);

}  // namespace stridor::noise_library
