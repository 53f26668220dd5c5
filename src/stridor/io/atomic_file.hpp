#pragma once

#include <string>
#include <string_view>

namespace stridor::io {

/// The name that stands for standard input among file names.
inline constexpr std::string_view standard_input = "-";

/// The whole content of a file; "-" reads standard input to its end.
///
/// Throws `Error` (io) with the name and the reason: missing, a folder, not readable.
std::string read_file(const std::string& path);

/// Writes a whole file so that its name never holds half of it.
///
/// The bytes go to a temporary name in the same folder, are flushed to the disk and renamed; then the folder is flushed.
/// A file that was there before stays untouched until the rename and keeps its permissions; a symbolic link is followed;
/// a device or a pipe is written directly. On any failure the temporary is removed and `Error` (io) names the file and
/// the reason. A program that wants the error of a file size limit rather than its signal ignores SIGXFSZ.
void write_file(const std::string& path, std::string_view bytes);

}  // namespace stridor::io
