#pragma once

#include <cstddef>
#include <functional>
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

/// Takes the next bytes of a file.
using Sink = std::function<void(std::string_view bytes)>;

/// The same for content that is made piece by piece: `make` is called once and hands its pieces to the sink. What it throws
/// goes on to the caller, and the file stays as it was.
void write_file(const std::string& path, const std::function<void(const Sink& sink)>& make);

/// The same for a file that another library writes: `make` is given the temporary name, of a file that has had `room` bytes
/// on the disk. A device or a pipe is refused.
void write_file_by_name(const std::string& path, std::size_t room,
                        const std::function<void(const std::string& temporary)>& make);

}  // namespace stridor::io
