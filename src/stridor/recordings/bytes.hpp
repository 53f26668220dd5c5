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

/// Bytes of any length that can be read at any place: a file, a text in memory, the content of a pipe.
///
/// Readers of long files use it, so that tests can run them on texts in memory.
class Bytes {
public:
    virtual ~Bytes() = default;

    /// Returns the number of bytes.
    virtual std::uint64_t size() const = 0;

    /// Fills `into` from `offset` on and returns the number of bytes read: fewer than asked only at the end.
    ///
    /// Throws `Error` (io) if reading fails.
    virtual std::size_t read_at(std::uint64_t offset, std::span<char> into) const = 0;

    /// Returns the open file with the bytes, for libraries that need one, or `std::nullopt` if there is none.
    virtual std::optional<int> descriptor() const { return std::nullopt; }
};

/// Opens a file. "-" is standard input. Standard input and any other pipe is first copied into a nameless temporary
/// file, so its memory is bounded too.
///
/// Throws `Error` (io) with the name and the reason: missing, a folder, not readable.
std::shared_ptr<const Bytes> open_bytes(const std::string& path);

/// Opens a regular file by any name, never a pipe or a device: reading it ends.
///
/// Throws `Error` (io) as `open_bytes` does.
std::shared_ptr<const Bytes> open_plain_bytes(const std::string& path);

/// Returns a text as bytes in memory.
std::shared_ptr<const Bytes> bytes_of(std::string content);

/// Reads `length` bytes from `offset` on, fewer at the end.
std::string text_at(const Bytes& bytes, std::uint64_t offset, std::size_t length);

/// A nameless temporary file: appended bytes can be read again, and end with this object.
class Spool final : public Bytes {
public:
    /// Begins an empty file. Throws `Error` (io) if none can be made.
    Spool();
    ~Spool() override;
    Spool(const Spool&) = delete;
    Spool& operator=(const Spool&) = delete;

    /// Adds bytes at the end. Throws `Error` (io) if the disk is full.
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
