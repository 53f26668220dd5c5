#pragma once

#include "stridor/base/error.hpp"
#include "stridor/recordings/line_reader.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Fields of a line of numbers, whatever parts them. Private to this folder.
namespace stridor::io::structure {

/// A file of matrices or labels: its bytes, and what messages call it.
struct StructureInput {
    std::shared_ptr<const recordings::Bytes> bytes;
    std::string name;
};

/// A real as any of these programs writes it: "1.5e3", "1.5D+03", "2.5+10"; nothing for any other text, and for what is
/// not finite.
std::optional<double> real_in(std::string_view text);

/// A whole number, with a sign or without; nothing for any other text.
std::optional<std::int64_t> integer_in(std::string_view text);

/// ASCII letters made large.
std::string upper(std::string_view text);

/// Walks through the words of a line, which blanks and commas part.
class FieldScanner {
public:
    FieldScanner(const recordings::TextLine& line, const std::string& file) : line_(line), file_(file) {}

    /// The next word; empty at the end of the line.
    std::string_view word();
    /// The next word as a number; `what` is what it should be: "a value". Throws `Error` (input) at its place.
    std::int64_t integer(const char* what);
    double real(const char* what);
    /// Is there no further word?
    bool is_at_end() const;
    /// Throws `Error` (input) if there is anything more.
    void expect_end();

    /// An error at the last word.
    base::Error refusal(std::string what, std::string why = "", std::string suggestion = "") const;

private:
    const recordings::TextLine& line_;
    const std::string& file_;
    std::size_t at_ = 0;
    std::size_t begin_ = 0;  // of the last word
};

/// Fields of a Fortran format: "(10I8)", "1P,3E23.16", "(d25.15)", "(1X,8I9)", "(3(1P,E24.16))". Numbers that fill
/// their columns touch each other.
struct FortranFormat {
    std::size_t count = 1;    // [1] on a line
    std::size_t width = 0;    // [1] columns of each
    std::size_t skipped = 0;  // [1] columns before the first
};

/// Nothing for what is no such format, or one of fields wider than 60 columns.
std::optional<FortranFormat> fortran_format(std::string_view text);

/// The fields of a line, blanks cut off; no empty ones at the end.
std::vector<std::string_view> fields_of(std::string_view line, const FortranFormat& format);

}  // namespace stridor::io::structure
