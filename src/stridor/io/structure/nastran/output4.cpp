#include "stridor/io/structure/nastran/output4.hpp"

#include "stridor/base/text.hpp"
#include "stridor/io/structure/fortran_format.hpp"
#include "stridor/recordings/refusal.hpp"

#include <fmt/format.h>

#include <cstdlib>

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
    bool is_big = false;    // BIGMAT: strings begin with two integers
    std::int64_t form = 0;
    std::int64_t type = 0;
    std::string name;
    FortranFormat values;
};

std::optional<Output4Header> header_in(std::string_view line) {
    if (line.size() < 33 || line.size() > 200) return std::nullopt;
    const auto number = [&](std::size_t field) { return integer_in(base::trimmed(line.substr(8 * field, 8))); };
    const auto columns = number(0);
    const auto rows = number(1);
    const auto form = number(2);
    const auto type = number(3);
    constexpr std::int64_t most = 2'000'000'000;
    if (!columns || !rows || !form || !type || *columns < 1 || *rows == 0 || *columns > most || std::abs(*rows) > most)
        return std::nullopt;
    const std::string name(base::trimmed(line.substr(32, 8)));
    const std::string_view format = line.size() > 40 ? line.substr(40) : std::string_view("1P,3E23.16");
    const auto values = fortran_format(format);
    if (name.empty() || (name[0] >= '0' && name[0] <= '9') || !values) return std::nullopt;
    return Output4Header{*columns, std::abs(*rows), *rows < 0, *form, *type, name, *values};
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
            ListedMatrix matrix = read_matrix(*header);
            if (is_wanted(*header)) matrices.push_back(std::move(matrix));
        }
        return matrices;
    }

private:
    static bool is_wanted(const Output4Header& header) {
        return header.rows == header.columns && role_of_name(header.name) != MatrixRole::load;
    }

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

    ListedMatrix read_matrix(const Output4Header& header) {
        if (is_wanted(header) && header.type != 1 && header.type != 2)
            throw complaint(fmt::format("the matrix {} is complex", header.name),
                            "those of a structure are real: type 1 or 2");
        ListedMatrix matrix{.file = file_,
                            .name = header.name,
                            .role = role_of_name(header.name),
                            .triangles = header.form == 6 ? Triangles::untold : Triangles::both,
                            .rows = is_wanted(header) ? static_cast<Eigen::Index>(header.rows) : 0};
        for (;;) {
            expect_more(header.name);
            const std::int64_t column = integer(0);
            const std::int64_t first = integer(1);
            const std::int64_t words = integer(2);
            if (column == header.columns + 1) {
                expect_more(header.name);  // a dummy value
                return matrix;
            }
            if (column < 1 || column > header.columns || words < 1)
                throw complaint(fmt::format("there is no column {}", column),
                                fmt::format("the matrix {} has {}", header.name, header.columns));
            if (first > 0)
                read_string(header, matrix, column, {first, words});
            else
                read_strings(header, matrix, column, words);
        }
    }

    /// Values of a column that stand one below the other.
    struct ValueString {
        std::int64_t first_row;
        std::int64_t words;
    };

    // all strings of a sparse column: each has its header among the column's words
    void read_strings(const Output4Header& header, ListedMatrix& matrix, std::int64_t column, std::int64_t words) {
        while (words > 0) {
            expect_more(header.name);
            ValueString string{};
            if (header.is_big) {
                string = {integer(1), integer(0) - 1};
                words -= 2;
            } else {
                constexpr std::int64_t pack = 65536;  // IS = row + 65536 (words + 1)
                const std::int64_t packed = integer_in(base::trimmed(line_.text)).value_or(0);
                string = {packed % pack, packed / pack - 1};
                words -= 1;
            }
            if (string.words < 1 || string.words > words)
                throw complaint(fmt::format("a string of {} words does not fit its column", string.words));
            read_string(header, matrix, column, string);
            words -= string.words;
        }
    }

    void read_string(const Output4Header& header, ListedMatrix& matrix, std::int64_t column,
                     const ValueString& string) {
        const std::int64_t words_per_value = header.type == 1 ? 1 : header.type == 4 ? 4 : 2;
        const std::int64_t count = string.words / words_per_value;
        const bool is_complex = header.type > 2;
        if (string.first_row < 1 || string.first_row + count - 1 > header.rows || count < 1)
            throw complaint(fmt::format("there is no row {}", string.first_row + count - 1),
                            fmt::format("the matrix {} has {}", header.name, header.rows));
        std::int64_t row = string.first_row;
        std::int64_t left = is_complex ? 2 * count : count;
        while (left > 0) {
            expect_more(header.name);
            const auto fields = fields_of(line_.text, header.values);
            if (fields.empty() || static_cast<std::int64_t>(fields.size()) > left)
                throw complaint(fmt::format("here should stand {} more values", left));
            for (const std::string_view field : fields) {
                const auto value = real_in(field);
                if (!value) throw complaint(fmt::format("\"{}\" is no finite number", field));
                if (is_wanted(header))
                    matrix.entries.emplace_back(static_cast<int>(row - 1), static_cast<int>(column - 1), *value);
                ++row;
                --left;
            }
        }
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
