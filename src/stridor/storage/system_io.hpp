#pragma once

#include "stridor/base/error.hpp"

#include <filesystem>
#include <string>
#include <string_view>

/// The tasks that the system's file calls leave to their callers: writing everything, flushing, and naming a failure.
/// Errors call the file `shown`.
namespace stridor::storage {

/// An open file, closed on the way out.
class Descriptor {
public:
    /// Takes over a descriptor; a negative one is none.
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    Descriptor(Descriptor&& other) noexcept;
    Descriptor& operator=(Descriptor&&) = delete;
    ~Descriptor();

    /// Returns the descriptor; negative if there is none.
    int number() const { return number_; }
    /// Says whether there is one.
    bool is_open() const { return number_ >= 0; }

    /// Closes it. Throws `Error` (io) if closing reports a late failure of a write; the descriptor is gone in any case.
    void close(const std::string& shown);

private:
    int number_;
};

/// Returns an error number (errno) in words: "permission denied".
std::string reason_of(int code);

/// Returns "cannot write library.sqlite (the disk is full)" (io) for an error number (errno).
Error system_failure(const std::string& doing, const std::string& shown, int code, std::string suggestion = "");

/// Writes all bytes; throws `Error` (io).
void write_all(int descriptor, std::string_view bytes, const std::string& shown);

/// Brings an open file to the disk; throws `Error` (io). A file system that cannot do so is no error: the rename is
/// then the only protection.
void flush(int descriptor, const std::string& shown);

/// Brings the names in a folder to the disk; throws `Error` (io).
void flush_folder(const std::filesystem::path& folder, const std::string& shown);

}  // namespace stridor::storage
