#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::io::structure {

/// Fields of a Fortran format: "(10I8)", "1P,3E23.16", "(d25.15)", "(1X,8I9)", "(3(1P,E24.16))". Numbers that fill
/// their columns touch each other.
struct FortranFormat {
    std::size_t count = 1;    // [1] on a line
    std::size_t width = 0;    // [1] columns of each
    std::size_t skipped = 0;  // [1] columns before the first
};

/// Nothing for what is no such format, or one of fields wider than 60 columns.
std::optional<FortranFormat> fortran_format(std::string_view text);

/// The fields of a line, blanks cut off; no empty ones at the end.
std::vector<std::string_view> fields_of(std::string_view line, const FortranFormat& format);

}  // namespace stridor::io::structure
