#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace stridor::storage {

/// Throws `Error` (input) for a file of an option whose ending is none of these, which choose its format. A name
/// without an ending is taken as it is: /dev/stdout, or - for standard output.
void expect_ending(const std::string& option, const std::string& file, std::initializer_list<std::string_view> endings);

}  // namespace stridor::storage
