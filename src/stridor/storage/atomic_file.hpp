#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>

namespace stridor::storage {

/// The file name that stands for standard input.
inline constexpr std::string_view standard_input = "-";

/// Returns the whole content of a file; "-" reads standard input to its end.
///
/// Throws `Error` (io) with the name and the reason: missing, a folder, not readable.
std::string read_file(const std::string& path);

/// Writes a whole file so that its name never holds half of it.
///
/// The bytes go to a temporary name in the same folder, are flushed to the disk and renamed; then the folder is
/// flushed. An existing file stays untouched until the rename and keeps its permissions; a symbolic link is followed; a
/// device or a pipe is written directly. On any failure the temporary file is removed and `Error` (io) names the file
/// and the reason. The temporary file of a killed process is removed by the next process that writes into the folder. A
/// program that wants the error of a file size limit rather than its signal ignores SIGXFSZ.
void write_file(const std::string& path, std::string_view bytes);

/// Makes a folder and its parents if they are missing. Throws `Error` (io) with the reason and this suggestion.
void make_folder(const std::filesystem::path& folder, const std::string& suggestion);

/// A long file that is written piece by piece and appears under its name only as a whole. It keeps the promises of
/// `write_file` at `commit()`. Without a commit it leaves no trace.
class PiecewiseFile {
public:
    /// Begins the file. Throws `Error` (io) if no file can be begun in the folder.
    explicit PiecewiseFile(const std::string& path);
    ~PiecewiseFile();
    PiecewiseFile(const PiecewiseFile&) = delete;
    PiecewiseFile& operator=(const PiecewiseFile&) = delete;

    /// Appends bytes. Pieces are gathered into blocks, so they may be small.
    void write(std::string_view bytes);

    /// Overwrites bytes that were appended before: a size in a header that is known only at the end.
    ///
    /// Throws `Error` (io) for a pipe, which cannot be overwritten.
    void overwrite(std::uint64_t offset, std::string_view bytes);

    /// Returns the number of bytes appended so far.
    std::uint64_t size() const;

    /// Returns the name of the file until `commit`, under which another library can write it. The disk holds `room`
    /// bytes for it.
    ///
    /// Throws `Error` (io) if the room is missing, and for a device or a pipe.
    std::string temporary_name(std::uint64_t room);

    /// Gives the file its name; nothing may be written afterwards.
    void commit();

private:
    class Target;
    std::unique_ptr<Target> target_;
    std::string pending_;
    std::uint64_t size_ = 0;  // [bytes] pending ones included
};

/// Throws `Error` (input) if the ending of an option's file is none of these, which choose its format. A name without
/// an ending is accepted: /dev/stdout, or - for standard output.
void expect_ending(const std::string& option, const std::string& file, std::initializer_list<std::string_view> endings);

}  // namespace stridor::storage
