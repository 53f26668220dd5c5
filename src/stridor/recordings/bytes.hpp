#pragma once

#include "stridor/base/error.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace stridor::recordings {

/// Bytes that can be read at any place, of any length: a file, a text in memory, what came through a pipe.
///
/// Readers of long files work on it, so that they can be tried on texts in memory.
class Bytes {
public:
    virtual ~Bytes() = default;

    /// How many there are [bytes].
    virtual std::uint64_t size() const = 0;

    /// Fills `into` from `offset` on and returns how many bytes there were: fewer only at the end.
    ///
    /// Throws `Error` (io) where reading fails.
    virtual std::size_t read_at(std::uint64_t offset, std::span<char> into) const = 0;

    /// The open file that they stand in, for libraries that want one; nothing where it has no name.
    virtual std::optional<int> descriptor() const { return std::nullopt; }
};

/// Opens a file. "-" is standard input; that and any other pipe is first copied into a nameless temporary file, so its
/// memory is bounded too.
///
/// Throws `Error` (io) with the name and the reason: missing, a folder, not readable.
std::shared_ptr<const Bytes> open_bytes(const std::string& path);

/// Opens what is a file and neither a pipe nor a device, however it is named: reading it ends.
///
/// Throws `Error` (io) as `open_bytes` does.
std::shared_ptr<const Bytes> open_plain_bytes(const std::string& path);

/// A text in memory.
std::shared_ptr<const Bytes> bytes_of(std::string content);

/// Reads `length` bytes from `offset` on, fewer at the end.
std::string text_at(const Bytes& bytes, std::uint64_t offset, std::size_t length);

/// A nameless temporary file: what is appended can be read again, and is gone with it.
class Spool final : public Bytes {
public:
    /// Begins an empty file. Throws `Error` (io) where none can be made.
    Spool();
    ~Spool() override;
    Spool(const Spool&) = delete;
    Spool& operator=(const Spool&) = delete;

    /// Adds bytes at the end. Throws `Error` (io) where the disk is full.
    void append(std::string_view bytes);
    std::uint64_t size() const override { return size_; }
    std::size_t read_at(std::uint64_t offset, std::span<char> into) const override;

private:
    Error failure(const std::string& doing, int code) const;

    std::string shown_;  // what errors call it
    int descriptor_;
    std::uint64_t size_ = 0;
};

}  // namespace stridor::recordings
