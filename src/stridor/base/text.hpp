#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace stridor::base {

/// Returns the shortest decimal text that reads back as the same double ("0.1", "1e-07", "nan").
std::string shortest(double value);

/// Returns the candidate nearest to a misspelt name within `most_edits` edits (insert, delete, replace, swap
/// neighbours), or an empty text.
std::string_view nearest_name(std::string_view name, std::span<const std::string_view> candidates,
                              std::size_t most_edits = 2);

/// How to break a text at blanks into lines of `columns` characters. A longer word stands in a line of its own. The
/// first line begins at column `first`, the others after `indent` blanks.
struct Wrapping {
    std::size_t columns = 80;
    std::size_t first = 0;
    std::size_t indent = 0;
};

/// Returns the text in such lines, without a line end behind the last. Line ends in the text stay.
std::string wrapped(std::string_view text, const Wrapping& wrapping);

/// Returns the number of characters of a UTF-8 text [1].
std::size_t character_count(std::string_view text);

/// Returns how deep brackets and braces nest outside of quotes, as in JSON [1]. Ask this before you parse text from
/// outside: copying, writing or destroying a document takes one call per level, and a deep document exhausts the stack.
std::size_t nesting(std::string_view text);

/// Returns "a, b, c".
std::string listed(std::span<const std::string> texts);

/// Returns the text without leading and trailing blanks.
std::string_view trimmed(std::string_view text);

}  // namespace stridor::base
