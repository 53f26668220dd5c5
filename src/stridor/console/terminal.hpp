#pragma once

#include "stridor/base/error.hpp"

#include <string>
#include <string_view>

/// The program's only doors to the terminal: data goes to stdout, messages to stderr.
namespace stridor::console {

/// Opens stdin, stdout and stderr if they are closed: otherwise the next opened file would get the number of a closed
/// one, and messages would go into that file.
void open_standard_streams();

/// Writes text to stdout; throws `Error` (io) if it cannot be written (a full disk behind a redirection), and ends the
/// process by SIGPIPE if nobody reads any more.
///
/// The text may hold content of files and names, which must not steer the terminal: control characters are made
/// visible, as `base::visible` does. JSON is not changed, since it has no raw control characters.
void print(std::string_view text);

/// Writes data that others read byte by byte to stdout: a table, a case file, a path. Control characters are made
/// visible only in a terminal. Throws `Error` (io) if it cannot be written.
void print_data(std::string_view bytes);

/// Writes a message to stderr, with a line end; control characters are made visible.
void say(std::string_view text);

/// Writes a note for the user: "stridor: note: ...".
void say_note(const std::string& sentence);

/// Returns text without control characters, except those of `styled` and line ends.
std::string shown(std::string_view text);

/// Writes each complaint as "file:line:col: error: what (why)", the line with a caret, and "help: ..."; twenty at most.
/// In a terminal they are wrapped at its width.
void say_error(const Error& error);

/// Writes "file:line:col: warning: what (why)".
void say_warning(const base::Complaint& warning);

/// Says whether stderr is a terminal that a person sees.
bool has_terminal();

/// Returns the columns of the terminal behind a file descriptor, stderr by default: from COLUMNS, else from the
/// terminal; else 80.
int terminal_columns(int file_descriptor = 2);

/// The style of text in a terminal.
enum class Style { plain, bold, dim, red };

/// Returns the text in a style for stdout or stderr, plain if that is not a terminal or NO_COLOR is set.
std::string styled(std::string_view text, Style style, int file_descriptor);

/// Writes a file that the user asked for, or stdout for an empty name or "-".
void write_output(const std::string& path, std::string_view text);

}  // namespace stridor::console
