#pragma once

#include "stridor/base/error.hpp"

#include <filesystem>
#include <string>
#include <string_view>

/// What the system's calls for files leave to their callers: writing everything, flushing, and saying in words what
/// failed. `shown` is what errors call the file.
namespace stridor::storage {

/// An open file, closed on the way out.
class Descriptor {
public:
    /// Takes it over; a negative one is none.
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    Descriptor(Descriptor&& other) noexcept;
    Descriptor& operator=(Descriptor&&) = delete;
    ~Descriptor();

    /// The descriptor itself; negative: none.
    int number() const { return number_; }
    /// Is there one?
    bool is_open() const { return number_ >= 0; }

    /// Throws `Error` (io) where closing reports a write that failed late; the descriptor is gone either way.
    void close(const std::string& shown);

private:
    int number_;
};

/// "permission denied": a number of the system's (errno) in words.
std::string reason_of(int code);

/// "cannot write library.sqlite (the disk is full)" (io) from a number of the system's (errno).
Error system_failure(const std::string& doing, const std::string& shown, int code, std::string suggestion = "");

/// Writes all bytes; throws `Error` (io).
void write_all(int descriptor, std::string_view bytes, const std::string& shown);

/// Brings an open file to the disk; throws `Error` (io). Some file systems cannot, which is no error: there the rename
/// is all that can be had.
void flush(int descriptor, const std::string& shown);

/// The same for the names in a folder.
void flush_folder(const std::filesystem::path& folder, const std::string& shown);

}  // namespace stridor::storage
