#pragma once

#include "stridor/storage/atomic_file.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Archives in the ustar format (POSIX.1-1988): headers of 512 bytes, each followed by a file padded to such blocks.
///
/// Regular files alone, names up to 100 bytes, sizes below 8 GiB; no compression, so a small archive cannot hold much.
namespace stridor::io {

/// What an archive is made of [bytes]: a header is one such block, and files are padded to them.
inline constexpr std::size_t tar_block = 512;

/// A file of an archive.
struct TarMember {
    std::string name;
    std::uint64_t size = 0;  // [bytes]
};

/// Writes an archive file by file.
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

/// Is told how many bytes of an archive are read, of how many.
using TarProgress = std::function<void(std::uint64_t done, std::uint64_t total)>;

/// Reads an archive file by file, a block at a time. What is no such archive, is cut short or lies about its sizes
/// throws `Error` (input).
class TarReader {
public:
    explicit TarReader(const std::filesystem::path& file, TarProgress progress = {});

    /// Bytes in memory as an archive; `name` is for messages.
    TarReader(std::string_view bytes, const std::string& name);

    /// Goes to the next file; nothing at the end.
    std::optional<TarMember> next();

    /// The next bytes of this file; nothing at its end.
    std::string_view read();

private:
    using Header = std::array<char, tar_block>;

    std::optional<Header> next_header();
    TarMember member_of(const Header& header) const;
    [[noreturn]] void refuse(const std::string& why) const;
    void fill(char* bytes, std::uint64_t count);

    std::filesystem::path file_;
    std::unique_ptr<std::istream> stream_;
    TarProgress progress_{};
    std::uint64_t size_ = 0;            // [bytes]
    std::uint64_t left_in_file_ = 0;    // [bytes] after what was read
    std::uint64_t left_in_member_ = 0;  // [bytes]
    std::uint64_t padding_ = 0;         // [bytes] after the member
    std::vector<char> block_;
};

}  // namespace stridor::io
