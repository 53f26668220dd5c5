#pragma once

#include "stridor/base/error.hpp"
#include "stridor/recordings/line_reader.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Fields of a line of numbers with any separators.
namespace stridor::io::structure {

/// A file of matrices or labels: its bytes, and its name in messages.
struct StructureInput {
    std::shared_ptr<const recordings::Bytes> bytes;
    std::string name;
};

/// Returns a real as any of these programs writes it: "1.5e3", "1.5D+03", "2.5+10"; `std::nullopt` for any other text,
/// and for a number that is not finite.
std::optional<double> real_in(std::string_view text);

/// Returns a whole number, with a sign or without; `std::nullopt` for any other text.
std::optional<std::int64_t> integer_in(std::string_view text);

/// Returns the text with ASCII letters in upper case.
std::string upper(std::string_view text);

/// Walks through the words of a line, separated by blanks and commas.
class FieldScanner {
public:
    FieldScanner(const recordings::TextLine& line, const std::string& file) : line_(line), file_(file) {}

    /// Returns the next word; empty at the end of the line.
    std::string_view word();
    /// Returns the next word as a number; `what` names the expectation: "a value". Throws `Error` (input) at its place.
    std::int64_t integer(const char* what);
    double real(const char* what);
    /// Says whether there is no further word.
    bool is_at_end() const;
    /// Throws `Error` (input) if there is a further word.
    void expect_end();

    /// Returns an error at the last word.
    base::Error refusal(std::string what, std::string why = "", std::string suggestion = "") const;

private:
    const recordings::TextLine& line_;
    const std::string& file_;
    std::size_t at_ = 0;
    std::size_t begin_ = 0;  // of the last word
};

/// Fields of a Fortran format: "(10I8)", "1P,3E23.16", "(d25.15)", "(1X,8I9)", "(3(1P,E24.16))". Numbers that fill
/// their columns have no blanks between them.
struct FortranFormat {
    std::size_t count = 1;    // [1] on a line
    std::size_t width = 0;    // [1] columns of each
    std::size_t skipped = 0;  // [1] columns before the first
};

/// Reads such a format; returns `std::nullopt` for any other text, or if fields are wider than 60 columns.
std::optional<FortranFormat> fortran_format(std::string_view text);

/// Returns the fields of a line, without blanks, and without empty ones at the end.
std::vector<std::string_view> fields_of(std::string_view line, const FortranFormat& format);

}  // namespace stridor::io::structure
