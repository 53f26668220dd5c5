#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace stridor::recordings {

/// A number as Fortran prints it: "1.5D-05", "-.5E+3", "1.0-105"; nothing for any other text.
std::optional<double> fortran_number(std::string_view text);

/// Splits at blanks.
std::vector<std::string_view> words(std::string_view line);

}  // namespace stridor::recordings
