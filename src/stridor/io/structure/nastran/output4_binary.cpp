// A binary OUTPUT4 file is a list of Fortran records: length [bytes], content, the same length again. All words, of 4
// or 8 bytes, stand in one order of bytes.
//
//     columns, rows (negative: BIGMAT), form, type, name of two words          opens a matrix
//     column, first row, words, values                                         a dense column
//     column, 0, words, strings                                                a sparse one
//     columns + 1, 1, words, a dummy                                           ends it
//
// A string is L+1 and its first row (BIGMAT), or both in one word, row + 65536 (L+1); then L words of values.
// Source: MSC Nastran, DMAP module OUTPUT4.

#include "stridor/io/structure/nastran/output4_binary.hpp"

#include "stridor/base/text.hpp"
#include "stridor/recordings/raw_signal.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdlib>

namespace stridor::io::structure {

namespace {

using recordings::refusal;

constexpr std::size_t marker_size = 4;   // [bytes] of the lengths around a record
constexpr std::size_t header_words = 6;  // [1] of a matrix' first record
constexpr std::int64_t most_rows_of_binary = 2'000'000'000;

/// How the words of a file stand.
struct WordOrder {
    std::size_t width = 4;  // [bytes]
    bool is_big_endian = false;
};

std::uint64_t bits_in(std::string_view bytes, bool is_big_endian) {
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < bytes.size(); ++k)
        bits = bits << 8U | static_cast<unsigned char>(bytes[is_big_endian ? k : bytes.size() - 1 - k]);
    return bits;
}

std::optional<WordOrder> word_order(std::string_view beginning) {
    for (const bool is_big_endian : {false, true})
        for (const std::size_t width : {std::size_t{4}, std::size_t{8}}) {
            const std::size_t length = header_words * width;
            if (beginning.size() < length + 2 * marker_size) continue;
            const auto marker = [&](std::size_t at) {
                return bits_in(beginning.substr(at, marker_size), is_big_endian);
            };
            if (marker(0) == length && marker(marker_size + length) == length) return WordOrder{width, is_big_endian};
        }
    return std::nullopt;
}

/// A Fortran record, taken word by word.
class FortranRecord {
public:
    FortranRecord(std::string bytes, WordOrder order, const std::string& file)
        : bytes_(std::move(bytes)),
          order_(order),
          file_(file) {}

    std::size_t words_left() const { return (bytes_.size() - at_) / order_.width; }

    std::int64_t integer() {
        const std::uint64_t bits = bits_in(take(order_.width), order_.is_big_endian);
        if (order_.width == 8) return std::bit_cast<std::int64_t>(bits);
        return std::bit_cast<std::int32_t>(static_cast<std::uint32_t>(bits));
    }

    /// Of one word or two: a double fills two words of four bytes.
    double real(std::size_t words) {
        const std::uint64_t bits = bits_in(take(words * order_.width), order_.is_big_endian);
        const double value = words * order_.width == 4
                                 ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)))
                                 : std::bit_cast<double>(bits);
        if (!std::isfinite(value)) throw refusal(file_, fmt::format("it holds {}", value), "it is no finite number");
        return value;
    }

    std::string_view text(std::size_t words) { return take(words * order_.width); }

private:
    std::string_view take(std::size_t count) {
        if (count > bytes_.size() - at_) throw refusal(file_, "a record is too short", "it holds less than it says");
        const std::string_view piece = std::string_view(bytes_).substr(at_, count);
        at_ += count;
        return piece;
    }

    std::string bytes_;
    WordOrder order_;
    const std::string& file_;
    std::size_t at_ = 0;
};

class BinaryOutput4Reader {
public:
    explicit BinaryOutput4Reader(const StructureInput& input) : bytes_(*input.bytes), file_(input.name) {
        const auto order = word_order(recordings::text_at(bytes_, 0, 64));
        if (!order) throw refusal(file_, "it is no binary OUTPUT4 file");
        order_ = *order;
    }

    std::vector<ListedMatrix> read() {
        std::vector<ListedMatrix> matrices;
        while (at_ < bytes_.size()) {
            matrices.push_back(read_matrix());
        }
        return matrices;
    }

private:
    /// Values of a column that stand one below the other.
    struct Run {
        std::int64_t column;
        std::int64_t first_row;
        std::int64_t words;
    };

    base::Error complaint(const std::string& what, const std::string& why = "") const {
        return refusal(file_, "matrix " + name_ + ": " + what, why);
    }

    FortranRecord next_record() {
        const auto marker = [&](std::uint64_t at) {
            const std::string bytes = recordings::text_at(bytes_, at, marker_size);
            if (bytes.size() < marker_size)
                throw refusal(file_, "the file is cut off", name_.empty() ? "" : "it ends within matrix " + name_);
            return bits_in(bytes, order_.is_big_endian);
        };
        const std::uint64_t length = marker(at_);
        if (length > bytes_.size() - at_ - marker_size || marker(at_ + marker_size + length) != length)
            throw refusal(file_, fmt::format("the record at byte {} does not end where it says", at_),
                          "lengths stand before and behind it");
        std::string content = recordings::text_at(bytes_, at_ + marker_size, static_cast<std::size_t>(length));
        at_ += 2 * marker_size + length;
        return {std::move(content), order_, file_};
    }

    ListedMatrix read_matrix() {
        name_.clear();
        FortranRecord header = next_record();
        columns_ = header.integer();
        const std::int64_t rows = header.integer();
        const std::int64_t form = header.integer();
        type_ = header.integer();
        name_ = printable(header.text(2));
        is_big_ = rows < 0 || rows >= 65536;
        rows_ = is_big_ && rows >= -most_rows_of_binary ? -rows : rows;
        if (columns_ < 1 || rows_ < 1 || columns_ > most_rows_of_binary || rows_ > most_rows_of_binary || type_ < 1 ||
            type_ > 4 || header.words_left() != 0)
            throw complaint("its first record is damaged", "it should hold columns, rows, form, type and name");
        ListedMatrix matrix{.file = file_,
                            .name = name_,
                            .role = role_of_name(name_),
                            .triangles = form == 6 ? Triangles::untold : Triangles::both,
                            .is_passed_over = rows_ != columns_ || type_ > 2,
                            .rows = static_cast<Eigen::Index>(rows_)};
        while (read_column(matrix)) {
        }
        return matrix;
    }

    static std::string printable(std::string_view text) {
        std::string name(base::trimmed(text));
        for (char& letter : name)
            if (letter < ' ' || letter > '~') letter = '?';
        return name;
    }

    // false at the record that ends the matrix
    bool read_column(ListedMatrix& matrix) {
        FortranRecord record = next_record();
        const std::int64_t column = record.integer();
        const std::int64_t first = record.integer();
        const std::int64_t words = record.integer();
        if (column == columns_ + 1) return false;
        if (column < 1 || column > columns_)
            throw complaint(fmt::format("there is no column {}", column), fmt::format("it has {}", columns_));
        if (words < 1 || static_cast<std::uint64_t>(words) != record.words_left())
            throw complaint(fmt::format("column {} says {} words, and holds {}", column, words, record.words_left()));
        if (first != 0) {
            read_run(matrix, record, {column, first, words});
            return true;
        }
        while (record.words_left() > 0)
            read_string(matrix, record, column);
        return true;
    }

    void read_string(ListedMatrix& matrix, FortranRecord& record, std::int64_t column) {
        constexpr std::int64_t pack = 65536;
        Run run{column, 0, 0};
        const std::int64_t word = record.integer();
        if (is_big_) {
            run.words = word - 1;
            run.first_row = record.integer();
        } else {
            run.words = word / pack - 1;
            run.first_row = word % pack;
        }
        if (run.words < 1 || static_cast<std::uint64_t>(run.words) > record.words_left())
            throw complaint(fmt::format("a string of {} words does not fit its column", run.words));
        read_run(matrix, record, run);
    }

    void read_run(ListedMatrix& matrix, FortranRecord& record, const Run& run) const {
        const bool is_double = type_ == 2 || type_ == 4;
        const std::int64_t words_per_real = is_double && order_.width == 4 ? 2 : 1;
        const std::int64_t words_per_value = type_ > 2 ? 2 * words_per_real : words_per_real;
        const std::int64_t count = run.words / words_per_value;
        if (run.words % words_per_value != 0)
            throw complaint(fmt::format("{} words are no whole number of values", run.words));
        if (run.first_row < 1 || run.first_row > rows_ || count > rows_ - run.first_row + 1)
            throw complaint(fmt::format("there is no row {}", run.first_row + count - 1),
                            fmt::format("it has {}", rows_));
        for (std::int64_t k = 0; k < count * (type_ > 2 ? 2 : 1); ++k) {
            const double value = record.real(static_cast<std::size_t>(words_per_real));
            if (!matrix.is_passed_over && value != 0.0)
                matrix.entries.emplace_back(static_cast<int>(run.first_row + k - 1), static_cast<int>(run.column - 1),
                                            value);
        }
    }

    const recordings::Bytes& bytes_;
    const std::string& file_;
    WordOrder order_;
    std::uint64_t at_ = 0;  // [bytes]
    // the matrix at hand
    std::string name_;
    std::int64_t columns_ = 0;
    std::int64_t rows_ = 0;
    std::int64_t type_ = 0;
    bool is_big_ = false;
};

}  // namespace

bool is_output4_binary(std::string_view beginning) {
    return word_order(beginning).has_value();
}

std::vector<ListedMatrix> read_output4_binary(const StructureInput& input) {
    return BinaryOutput4Reader(input).read();
}

}  // namespace stridor::io::structure
