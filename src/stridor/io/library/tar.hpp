#pragma once

#include "stridor/storage/atomic_file.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

/// Archives in the tar format: headers of 512 bytes, each followed by a file padded to such blocks.
///
/// We write them in the ustar dialect (POSIX.1-1988), with fixed bytes, and read those of any writer through
/// libarchive.
namespace stridor::io {

/// A file of an archive.
struct TarMember {
    std::string name;
    std::uint64_t size = 0;  // [bytes]
};

/// Writes an archive file by file: regular files alone, names up to 100 bytes, sizes below 8 GiB. The same files give
/// the same bytes.
class TarWriter {
public:
    explicit TarWriter(storage::PiecewiseFile& file) : file_(&file) {}

    /// Begins a file, whose bytes follow. Throws `Error` (input) if it is too large for the format.
    void begin(const TarMember& member);
    void write(std::string_view bytes);

    /// Ends a file that has got all its bytes.
    void end();

    /// Ends the archive.
    void finish();

private:
    storage::PiecewiseFile* file_;
    std::uint64_t written_ = 0;  // [bytes] of the file begun last
};

/// Is told how many bytes of an archive are read, and of how many.
using TarProgress = std::function<void(std::uint64_t done, std::uint64_t total)>;

/// Returns how large an archive of `size` bytes may become when it is expanded [bytes]: audio hardly shrinks.
std::uint64_t longest_expanded(std::uint64_t size);

/// Reads an archive file by file, a piece at a time: any dialect of tar, as it is or compressed by gzip, xz or zstd.
///
/// A file that is not such an archive, is truncated, lies about its sizes, holds links, devices or files with holes, or
/// grows beyond `longest_expanded` throws `Error` (input). Memory does not grow with the archive. Use names for
/// comparison only: they may lead out of any folder.
class TarReader {
public:
    explicit TarReader(const std::filesystem::path& file, TarProgress progress = {});

    /// Reads bytes in memory as an archive; they must outlive this object. `name` is for messages.
    TarReader(std::string_view bytes, const std::string& name);

    ~TarReader();
    TarReader(const TarReader&) = delete;
    TarReader& operator=(const TarReader&) = delete;

    /// Goes to the next file and returns it; `std::nullopt` at the end.
    std::optional<TarMember> next();

    /// Returns the next bytes of this file; empty at its end.
    std::string_view read();

private:
    class Source;

    std::unique_ptr<Source> source_;
    std::optional<TarMember> member_{};  // whose bytes are not read to their end
    std::uint64_t given_ = 0;            // [bytes] of it
};

}  // namespace stridor::io
