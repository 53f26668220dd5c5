#pragma once

#include "stridor/base/error.hpp"
#include "stridor/recordings/bytes.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::recordings {

/// A line of a text.
struct TextLine {
    std::string_view text;     // without its end; valid until the next line is read
    int number = 0;            // [1] counted from where reading began
    std::uint64_t offset = 0;  // [bytes] of its first character
};

/// Returns the place of a line in a file, and of a character in the line.
base::Place place_of(const std::string& file, const TextLine& line, int column);

/// The lines of a long text, one after the other; they end in LF, CR LF or CR.
///
/// It holds one block of the text, and refuses lines of more than `longest` bytes: no table has them, but other files
/// do.
class LineReader {
public:
    static constexpr std::size_t longest = 1U << 16U;  // [bytes]

    /// Reads from `offset` on, where line `number` begins; `name` is the file's, for messages.
    LineReader(std::shared_ptr<const Bytes> bytes, std::string name, std::uint64_t offset = 0, int number = 1);

    /// Returns the next line, or `std::nullopt` at the end. Throws `Error` (input) for a line that is too long.
    std::optional<TextLine> next();

    /// Returns the place at which the next line begins [bytes].
    std::uint64_t offset() const { return start_ + begin_; }
    /// Returns the number of the next line.
    int number() const { return number_; }

    /// Returns the name of the text in messages.
    const std::string& name() const { return name_; }

private:
    bool fill();

    std::shared_ptr<const Bytes> bytes_;
    std::string name_;
    std::vector<char> block_;
    std::uint64_t start_;    // [bytes] where the block begins in the text
    std::size_t begin_ = 0;  // [bytes] of the next line in the block
    std::size_t end_ = 0;    // [bytes] filled of the block
    int number_;
};

/// Returns a number as Fortran prints it: "1.5D-05", "-.5E+3", "1.0-105"; `std::nullopt` for any other text.
std::optional<double> fortran_number(std::string_view text);

/// Splits a line at blanks.
std::vector<std::string_view> words(std::string_view line);

}  // namespace stridor::recordings
