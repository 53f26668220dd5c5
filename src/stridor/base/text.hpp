#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace stridor::base {

/// The shortest decimal text that reads back as the same double ("0.1", "1e-07", "nan").
std::string shortest(double value);

/// The candidate nearest to a misspelt name, within two edits (insert, delete, replace, swap neighbours); else empty.
std::string_view nearest_name(std::string_view name, std::span<const std::string_view> candidates);

/// How deep brackets and braces stand in each other outside of quotes, as JSON has them [1]. Whoever reads text of
/// others looks first: what copies, writes or destroys a deep document calls itself once per level, and the stack
/// ends.
std::size_t nesting(std::string_view text);

/// Text without leading and trailing blanks.
std::string_view trimmed(std::string_view text);

}  // namespace stridor::base
