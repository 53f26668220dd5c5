#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>

namespace stridor::storage {

/// The name that stands for standard input among file names.
inline constexpr std::string_view standard_input = "-";

/// The whole content of a file; "-" reads standard input to its end.
///
/// Throws `Error` (io) with the name and the reason: missing, a folder, not readable.
std::string read_file(const std::string& path);

/// Writes a whole file so that its name never holds half of it.
///
/// The bytes go to a temporary name in the same folder, are flushed to the disk and renamed; then the folder is
/// flushed. A file that was there before stays untouched until the rename and keeps its permissions; a symbolic link is
/// followed; a device or a pipe is written directly. On any failure the temporary is removed and `Error` (io) names the
/// file and the reason; that of a process that was killed is removed by the next one that writes into the folder. A
/// program that wants the error of a file size limit rather than its signal ignores SIGXFSZ.
void write_file(const std::string& path, std::string_view bytes);

/// Makes a folder, and those above it, where it is not there. Throws `Error` (io) with the reason and this suggestion.
void make_folder(const std::filesystem::path& folder, const std::string& suggestion);

/// A file that is written piece by piece, for what is too long to stand in memory, and that appears under its name only
/// as a whole: the same promises as `write_file`, kept at `commit()`. Gone without a trace if it is never committed.
class PiecewiseFile {
public:
    /// Throws `Error` (io) where no file can be begun in the folder.
    explicit PiecewiseFile(const std::string& path);
    ~PiecewiseFile();
    PiecewiseFile(const PiecewiseFile&) = delete;
    PiecewiseFile& operator=(const PiecewiseFile&) = delete;

    /// Appends. Pieces are gathered into blocks, so they may be small.
    void write(std::string_view bytes);

    /// Writes over bytes that were appended before: a size in a header that is known only at the end.
    ///
    /// Throws `Error` (io) for a pipe, where nothing can be taken back.
    void overwrite(std::uint64_t offset, std::string_view bytes);

    /// Bytes appended so far.
    std::uint64_t size() const;

    /// The name that the file has until then, for another library to write it by:
    /// the file has had `room` bytes on the disk.
    ///
    /// Throws `Error` (io) where the room is missing, and for a device or a pipe.
    std::string temporary_name(std::uint64_t room);

    /// Gives the file its name; nothing is written after it.
    void commit();

private:
    class Target;
    std::unique_ptr<Target> target_;
    std::string pending_;
    std::uint64_t size_ = 0;  // [bytes] pending ones included
};

/// Throws `Error` (input) for a file of an option whose ending is none of these, which choose its format. A name
/// without an ending is taken as it is: /dev/stdout, or - for standard output.
void expect_ending(const std::string& option, const std::string& file, std::initializer_list<std::string_view> endings);

}  // namespace stridor::storage
