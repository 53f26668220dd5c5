#pragma once

#include "stridor/base/error.hpp"

#include <string>
#include <string_view>

/// The program's only doors to the terminal: data goes to stdout, messages to stderr.
namespace stridor::console {

/// Makes sure that the numbers of stdin, stdout and stderr are taken: with one of them closed, the next file opened
/// would have its number, and messages would go into that file.
void open_standard_streams();

/// Writes text to stdout; throws `Error` (io) where it cannot be written (a full disk behind a redirection), and ends
/// the process by SIGPIPE where nobody reads any more.
///
/// What came from files and names stands in it, too, and must not steer the terminal: control characters are shown, as
/// `base::visible` does. JSON stays what it is, for none stand in it as they are.
void print(std::string_view text);

/// The same for what others read byte by byte: a table, a case file, a path. Control characters are shown where a
/// terminal is.
void print_data(std::string_view bytes);

/// Writes a message to stderr, with a line end; control characters are shown.
void say(std::string_view text);

/// Says what is noteworthy: "stridor: note: ...".
void say_note(const std::string& sentence);

/// Text without control characters but those of `styled`, with line ends.
std::string shown(std::string_view text);

/// Of each complaint "file:line:col: error: what (why)", the line with a caret, and "help: ..."; twenty at most. Where
/// stderr is a terminal they are wrapped at its width.
void say_error(const Error& error);

/// "file:line:col: warning: what (why)".
void say_warning(const base::Complaint& warning);

/// Is stderr a terminal a person looks at?
bool has_terminal();

/// Columns of the terminal behind a file descriptor, stderr by default: as COLUMNS says, else as the terminal does; 80
/// where neither does.
int terminal_columns(int file_descriptor = 2);

/// How text stands out.
enum class Style { plain, bold, dim, red };

/// The text in a style for stdout or stderr, plain where it is no terminal or NO_COLOR is set.
std::string styled(std::string_view text, Style style, int file_descriptor);

/// Writes a file the user asked for, or stdout for an empty name or "-".
void write_output(const std::string& path, std::string_view text);

}  // namespace stridor::console
