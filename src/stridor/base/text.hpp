#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace stridor::base {

/// The shortest decimal text that reads back as the same double ("0.1", "1e-07", "nan").
std::string shortest(double value);

/// The candidate nearest to a misspelt name, within so many edits (insert, delete, replace, swap neighbours); else
/// empty.
std::string_view nearest_name(std::string_view name, std::span<const std::string_view> candidates,
                              std::size_t most_edits = 2);

/// Text broken at blanks into lines of so many columns, each character one; a longer word stands in a line of its own.
/// The first line begins at column `first`, the others after `indent` blanks. Line ends in the text stay.
struct Wrapping {
    std::size_t columns = 80;
    std::size_t first = 0;
    std::size_t indent = 0;
};

/// The text in such lines, without a line end behind the last. Line ends in the text stay.
std::string wrapped(std::string_view text, const Wrapping& wrapping);

/// How many characters a UTF-8 text has [1].
std::size_t character_count(std::string_view text);

/// How deep brackets and braces stand in each other outside of quotes, as JSON has them [1]. Whoever reads text of
/// others looks first: what copies, writes or destroys a deep document calls itself once per level, and the stack
/// ends.
std::size_t nesting(std::string_view text);

/// "a, b, c".
std::string listed(std::span<const std::string> texts);

/// Text without leading and trailing blanks.
std::string_view trimmed(std::string_view text);

}  // namespace stridor::base
