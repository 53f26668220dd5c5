#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Text that came from somebody else, made harmless for what shows it: a terminal, a shell, a spreadsheet, a page.
namespace stridor::base {

/// Bytes of the character a text begins with; 0 where it begins with none. Well-formed UTF-8 only: no stray or missing
/// bytes, nothing spelt longer than needed, no surrogates.
std::size_t utf8_length(std::string_view text);

/// Is all of it well-formed UTF-8?
bool is_utf8(std::string_view text);

/// Does it hold a character that steers a terminal, or turns the order of what it shows around? These are the control
/// characters C0, DEL and C1, line ends and tabs among them, the separators of lines, and the marks of direction.
bool has_control(std::string_view text);

/// Text as a terminal may show it: such characters stand as `\u001b`, as in JSON; bytes that are no UTF-8 as `\xff`.
/// Line ends and tabs stay.
std::string visible(std::string_view text);

/// Text as one word of a shell: as it is where nothing in it is special, else in single quotes. Control characters and
/// bytes that are no UTF-8 stand as escapes in `$'..'` (POSIX 2024, bash, zsh), so that pasting types nothing by
/// itself.
std::string shell_word(std::string_view text);

/// Text as a cell that no spreadsheet takes for a formula: an apostrophe stands before what begins with = + - @, a tab
/// or a line end (OWASP, CSV injection), unless it is a number, or a sign alone. Text that begins with apostrophes
/// before such a character has one more, so that `from_spreadsheet_text` gives back what was there.
std::string spreadsheet_text(std::string_view text);

/// The same for each piece of a line that spreadsheets part at commas, semicolons and tabs.
std::string spreadsheet_line(std::string_view line);

/// The text of such a cell.
std::string from_spreadsheet_text(std::string_view cell);

/// Text for HTML or XML: the characters that mean something there are written so that they do not.
std::string markup_text(std::string_view text);

}  // namespace stridor::base
