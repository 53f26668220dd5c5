#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Makes text from outside harmless for its reader: a terminal, a shell, a spreadsheet, a page.
namespace stridor::base {

/// Returns the length [bytes] of the first character of a text, or 0 if the text does not begin with well-formed UTF-8:
/// no stray or missing bytes, nothing spelt longer than needed, no surrogates.
std::size_t utf8_length(std::string_view text);

/// Says whether the whole text is well-formed UTF-8.
bool is_utf8(std::string_view text);

/// Says whether a text holds a character that steers a terminal or reverses the order of display. These are the control
/// characters C0, DEL and C1 with line ends and tabs, the separators of lines, and the marks of direction.
bool has_control(std::string_view text);

/// Returns a text as a terminal may show it: a control character becomes `\u001b`, as in JSON, a byte that is not UTF-8
/// becomes `\xff`. Line ends and tabs stay.
std::string visible(std::string_view text);

/// Returns a text as one word of a shell: unchanged if no character is special, else in single quotes. Control
/// characters and bytes that are not UTF-8 become escapes in `$'..'` (POSIX 2024, bash, zsh), so that pasted text runs
/// no command.
std::string shell_word(std::string_view text);

/// Returns a text as a cell that no spreadsheet takes for a formula: an apostrophe is put before a text that begins
/// with = + - @, a tab or a line end (OWASP, CSV injection), unless the text is a number or a sign alone. A text that
/// begins with apostrophes before such a character gets one more, so that `from_spreadsheet_text` restores it.
std::string spreadsheet_text(std::string_view text);

/// Returns a line of text whose pieces between commas, semicolons and tabs are each made harmless by
/// `spreadsheet_text`.
std::string spreadsheet_line(std::string_view line);

/// Returns the text that `spreadsheet_text` made a cell of.
std::string from_spreadsheet_text(std::string_view cell);

/// Returns text for HTML or XML, in which the special characters are written as entities.
std::string markup_text(std::string_view text);

}  // namespace stridor::base
