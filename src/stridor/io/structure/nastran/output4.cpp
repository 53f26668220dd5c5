#include "stridor/io/structure/nastran/output4.hpp"

#include "stridor/base/text.hpp"
#include "stridor/io/structure/field_scanner.hpp"
#include "stridor/recordings/raw_signal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace stridor::io::structure {

namespace {

using recordings::LineReader;
using recordings::place_of;
using recordings::refusal;
using recordings::TextLine;

constexpr FortranFormat integers{10, 8};

/// What a matrix' first line says.
struct Output4Header {
    std::int64_t columns = 0;
    std::int64_t rows = 0;  // without its sign
    bool is_big = false;    // BIGMAT, as of 65536 rows always: strings begin with two integers
    std::int64_t form = 0;
    std::int64_t type = 0;
    std::string name;
    FortranFormat values;
    bool has_format = false;

    bool is_square() const { return rows == columns; }
    bool is_complex() const { return type > 2; }
};

// columns and rows fill eight columns each, or 16 where the line ends in |I16; without a format it is 5E16.9, or what
// the first line of values shows
std::optional<Output4Header> header_in(std::string_view line) {
    const std::size_t width = base::trimmed(line).ends_with("|I16") ? 16 : 8;
    const std::size_t at = 2 * width;  // where the form stands
    if (line.size() < at + 17 || line.size() > 200) return std::nullopt;
    const auto number = [&](std::size_t from, std::size_t wide) {
        return integer_in(base::trimmed(line.substr(from, wide)));
    };
    const auto columns = number(0, width);
    const auto rows = number(width, width);
    const auto form = number(at, 8);
    const auto type = number(at + 8, 8);
    constexpr std::int64_t most = 2'000'000'000;
    if (!columns || !rows || !form || !type || *columns < 1 || *rows == 0 || *columns > most || std::abs(*rows) > most)
        return std::nullopt;
    const std::string name(base::trimmed(line.substr(at + 16, 8)));
    const std::string_view format = base::trimmed(line.substr(std::min(at + 24, line.size())));
    const auto values = fortran_format(format.empty() ? "5E16.9" : format);
    // a name may begin with a digit; but for the format it would be a row of numbers then
    const bool is_bare = format.empty() || format.find('.') < format.find_first_of("EeDd");
    const bool is_number = !name.empty() && name[0] >= '0' && name[0] <= '9';
    if (name.empty() || (is_number && is_bare) || !values) return std::nullopt;
    constexpr std::int64_t rows_of_big = 65536;
    const bool is_big = *rows < 0 || *rows >= rows_of_big;
    return Output4Header{*columns, std::abs(*rows), is_big, *form, *type, name, *values, !format.empty()};
}

// the width of each number is what one point has of the line
FortranFormat format_shown_by(std::string_view line, const FortranFormat& usual) {
    line = line.substr(0, line.find_last_not_of(" \r") + 1);
    const auto points = static_cast<std::size_t>(std::count(line.begin(), line.end(), '.'));
    if (points == 0 || line.size() % points != 0) return usual;
    constexpr std::size_t longest_line = 132;  // [1] columns that Nastran prints
    const std::size_t width = line.size() / points;
    return {std::max(longest_line / width, points), width};
}

class Output4Reader {
public:
    explicit Output4Reader(const StructureInput& input) : lines_(input.bytes, input.name), file_(input.name) {}

    std::vector<ListedMatrix> read() {
        std::vector<ListedMatrix> matrices;
        while (advance()) {
            const auto header = header_in(line_.text);
            if (!header)
                throw complaint("it is no header of a matrix",
                                "an ASCII OUTPUT4 file begins with columns, rows, form, "
                                "type and name in fields of eight columns");
            matrices.push_back(read_matrix(*header));
        }
        return matrices;
    }

private:
    bool advance() {
        while (const auto line = lines_.next())
            if (!base::trimmed(line->text).empty()) {
                text_ = line->text;
                line_ = {text_, line->number, line->offset};
                return true;
            }
        return false;
    }

    void expect_more(const std::string& name) {
        if (!advance()) throw refusal(file_, fmt::format("the matrix {} is cut off", name), "the file ends within it");
    }

    base::Error complaint(std::string what, std::string why = "") const {
        return refusal(place_of(file_, line_, 1), std::move(what), std::move(why));
    }

    std::int64_t integer(std::size_t field) const {
        const auto fields = fields_of(line_.text, integers);
        const auto value = field < fields.size() ? integer_in(fields[field]) : std::nullopt;
        if (!value) throw complaint("a whole number is missing", "columns and strings begin with whole numbers");
        return *value;
    }

    ListedMatrix read_matrix(Output4Header header) {
        ListedMatrix matrix{.file = file_,
                            .name = header.name,
                            .role = role_of_name(header.name),
                            .triangles = header.form == 6 ? Triangles::untold : Triangles::both,
                            .is_passed_over = !header.is_square() || header.is_complex(),
                            .rows = static_cast<Eigen::Index>(header.rows)};
        for (;;) {
            expect_more(header.name);
            const std::int64_t column = integer(0);
            const std::int64_t first = integer(1);
            const std::int64_t count = integer(2);  // of printed numbers, or of words in a sparse column
            if (column == header.columns + 1) {
                expect_more(header.name);  // a dummy value
                return matrix;
            }
            if (column < 1 || column > header.columns || count < 1)
                throw complaint(fmt::format("there is no column {}", column),
                                fmt::format("the matrix {} has {}", header.name, header.columns));
            if (first > 0)
                read_numbers(header, matrix, {column, first, count});
            else
                read_strings(header, matrix, column, count);
        }
    }

    /// Numbers of a column that stand one below the other; a complex value is two of them.
    struct NumberRun {
        std::int64_t column;
        std::int64_t first_row;
        std::int64_t count;
    };

    // all strings of a sparse column: each has its header among the column's words, and a double is two of them
    void read_strings(Output4Header& header, ListedMatrix& matrix, std::int64_t column, std::int64_t words) {
        while (words > 0) {
            expect_more(header.name);
            std::int64_t first = 0;
            std::int64_t its_words = 0;
            if (header.is_big) {
                first = integer(1);
                its_words = integer(0) - 1;
                words -= 2;
            } else {
                constexpr std::int64_t pack = 65536;  // IS = row + 65536 (words + 1)
                const std::int64_t packed = integer_in(base::trimmed(line_.text)).value_or(0);
                first = packed % pack;
                its_words = packed / pack - 1;
                words -= 1;
            }
            const std::int64_t words_per_number = header.type % 2 == 1 ? 1 : 2;
            if (its_words < 1 || its_words > words || its_words % words_per_number != 0)
                throw complaint(fmt::format("a string of {} words does not fit its column", its_words));
            read_numbers(header, matrix, {column, first, its_words / words_per_number});
            words -= its_words;
        }
    }

    void read_numbers(Output4Header& header, ListedMatrix& matrix, const NumberRun& run) {
        const std::int64_t rows = header.is_complex() ? run.count / 2 : run.count;
        if (run.first_row < 1 || rows > header.rows - run.first_row + 1)
            throw complaint(fmt::format("there is no row {}", run.first_row + rows - 1),
                            fmt::format("the matrix {} has {}", header.name, header.rows));
        std::int64_t row = run.first_row;
        std::int64_t left = run.count;
        while (left > 0) {
            expect_more(header.name);
            if (!std::exchange(header.has_format, true)) header.values = format_shown_by(line_.text, header.values);
            const auto fields = fields_of(line_.text, header.values);
            if (fields.empty() || static_cast<std::int64_t>(fields.size()) > left)
                throw complaint(fmt::format("here should stand {} more values", left), widths(header));
            for (const std::string_view field : fields) {
                const auto value = real_in(field);
                if (!value) throw complaint(fmt::format("\"{}\" is no finite number", field), widths(header));
                if (!matrix.is_passed_over && *value != 0.0)
                    matrix.entries.emplace_back(static_cast<int>(row - 1), static_cast<int>(run.column - 1), *value);
                ++row;
                --left;
            }
        }
    }

    static std::string widths(const Output4Header& header) {
        return fmt::format("by the header of {} a line holds {} numbers of {} columns", header.name,
                           header.values.count, header.values.width);
    }

    LineReader lines_;
    const std::string& file_;
    std::string text_;
    TextLine line_;
};

}  // namespace

bool is_output4(std::string_view first_line) {
    return header_in(first_line).has_value();
}

std::vector<ListedMatrix> read_output4(const StructureInput& input) {
    return Output4Reader(input).read();
}

}  // namespace stridor::io::structure
