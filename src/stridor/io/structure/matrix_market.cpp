#include "stridor/io/structure/matrix_market.hpp"

#include "stridor/base/text.hpp"
#include "stridor/recordings/raw_signal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace stridor::io::structure {

namespace {

using recordings::LineReader;
using recordings::refusal;
using recordings::TextLine;

/// What the first line says.
struct Banner {
    bool is_array = false;
    bool is_symmetric = false;
};

Banner banner_of(const TextLine& line, const std::string& file) {
    FieldScanner scanner(line, file);
    scanner.word();  // %%MatrixMarket
    const auto expect = [&](std::initializer_list<std::string_view> known, std::string_view what) {
        const std::string word = upper(scanner.word());
        for (const std::string_view each : known)
            if (word == each) return word;
        throw scanner.refusal(fmt::format("\"{}\" is no {} of a structure", word, what),
                              "its matrices are real, square and symmetric");
    };
    expect({"MATRIX"}, "object");
    const std::string format = expect({"COORDINATE", "ARRAY"}, "format");
    expect({"REAL", "INTEGER", "DOUBLE"}, "kind of numbers");
    const std::string symmetry = expect({"GENERAL", "SYMMETRIC"}, "symmetry");
    return {format == "ARRAY", symmetry == "SYMMETRIC"};
}

/// Lines that are neither empty nor comments.
class DataLines {
public:
    explicit DataLines(const StructureInput& input) : lines_(input.bytes, input.name) {}

    std::optional<TextLine> first() { return lines_.next(); }
    std::optional<TextLine> next() {
        while (const auto line = lines_.next())
            if (const std::string_view text = base::trimmed(line->text); !text.empty() && text.front() != '%')
                return line;
        return std::nullopt;
    }

private:
    LineReader lines_;
};

[[noreturn]] void refuse_count(const std::string& file, std::int64_t said, std::size_t found) {
    throw refusal(file, fmt::format("it says {} entries, and holds {}", said, found), "", "Is the file cut off?");
}

void read_coordinates(DataLines& lines, ListedMatrix& matrix, std::int64_t entries) {
    while (const auto line = lines.next()) {
        FieldScanner scanner(*line, matrix.file);
        const std::int64_t row = scanner.integer("a row");
        const std::int64_t column = scanner.integer("a column");
        if (row > matrix.rows || column > matrix.rows)
            throw scanner.refusal(fmt::format("there is no row {}, column {}", row, column),
                                  fmt::format("the matrix has {} rows", matrix.rows));
        add_entry(matrix, scanner, row, column, scanner.real("a value"));
        scanner.expect_end();
    }
    if (static_cast<std::int64_t>(matrix.entries.size()) != entries)
        refuse_count(matrix.file, entries, matrix.entries.size());
}

// column by column; of a symmetric one the lower triangle
void read_array(DataLines& lines, ListedMatrix& matrix, bool is_symmetric) {
    Eigen::Index row = 0;
    Eigen::Index column = 0;
    std::size_t found = 0;
    while (const auto line = lines.next()) {
        FieldScanner scanner(*line, matrix.file);
        const double value = scanner.real("a value");
        scanner.expect_end();
        if (column < matrix.rows) add_entry(matrix, scanner, row + 1, column + 1, value);
        ++found;
        if (++row == matrix.rows) {
            ++column;
            row = is_symmetric ? column : 0;
        }
    }
    const auto rows = matrix.rows;
    const Eigen::Index wanted = is_symmetric ? rows * (rows + 1) / 2 : rows * rows;
    if (static_cast<Eigen::Index>(found) != wanted) refuse_count(matrix.file, wanted, found);
}

}  // namespace

bool is_matrix_market(std::string_view beginning) {
    // some programs put a blank before it, or lose one of its marks
    const std::string_view text = beginning.substr(std::min(beginning.find_first_not_of(" \t"), beginning.size()));
    return upper(text.substr(0, 14)) == "%%MATRIXMARKET" || upper(text.substr(0, 13)) == "%MATRIXMARKET";
}

ListedMatrix read_matrix_market(const StructureInput& input) {
    DataLines lines(input);
    const auto first = lines.first();
    if (!first || !is_matrix_market(first->text))
        throw refusal(input.name, "it is no Matrix Market file", "its first line begins with %%MatrixMarket");
    const Banner banner = banner_of(*first, input.name);
    const auto size = lines.next();
    if (!size) throw refusal(input.name, "it ends before its size");
    FieldScanner scanner(*size, input.name);
    const std::int64_t rows = scanner.integer("the number of rows");
    const std::int64_t columns = scanner.integer("the number of columns");
    const std::int64_t entries = banner.is_array ? 0 : scanner.integer("the number of entries");
    scanner.expect_end();
    constexpr std::int64_t most_rows = 2'000'000'000;
    if (rows < 1 || rows != columns || rows > most_rows)
        throw scanner.refusal(fmt::format("the matrix has {} rows and {} columns", rows, columns),
                              "those of a structure are square");
    ListedMatrix matrix{.file = input.name,
                        .triangles = banner.is_symmetric ? Triangles::one : Triangles::both,
                        .rows = static_cast<Eigen::Index>(rows)};
    if (banner.is_array)
        read_array(lines, matrix, banner.is_symmetric);
    else
        read_coordinates(lines, matrix, entries);
    return matrix;
}

}  // namespace stridor::io::structure
