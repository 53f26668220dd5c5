#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// Bytes of a sound that is not over: from a pipe, a program that records, a file that another program writes.
namespace stridor::recordings {

/// What came from a flow.
struct Arrival {
    enum class Kind {
        bytes,    // `count` of them
        nothing,  // none within the time
        lost,     // the source says that it lost sound, here or up to half a second before
        end       // the flow is over
    };
    Kind kind = Kind::nothing;
    std::size_t count = 0;            // [bytes]
    std::optional<double> seconds{};  // [s] that the source says it lost
    std::string words{};              // of the source: why something was lost, or why it is over
};

/// Bytes as they come.
class ByteFlow {
public:
    virtual ~ByteFlow() = default;

    /// Waits for bytes, at most so long, and puts those that are there into `into`, which is not empty. Throws `Error`
    /// (io) if reading fails.
    virtual Arrival next(std::span<char> into, std::chrono::milliseconds longest) = 0;
};

/// Returns the bytes of an open descriptor, which stays the caller's: standard input.
std::unique_ptr<ByteFlow> flow_of_descriptor(int descriptor);

/// Returns the bytes of a file that another program may still be writing. It is over if the file became shorter, was
/// replaced or removed. Throws `Error` (io) if it cannot be opened, or is a folder.
std::unique_ptr<ByteFlow> flow_of_growing_file(const std::string& path);

/// Returns what a program writes to its standard output, and what it says of lost sound on its standard error. It is
/// ended with this object. A program that fails throws `Error` (io) with its words.
std::unique_ptr<ByteFlow> flow_of_program(const std::vector<std::string>& command);

}  // namespace stridor::recordings
