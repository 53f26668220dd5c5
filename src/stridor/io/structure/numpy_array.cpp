#include "stridor/io/structure/numpy_array.hpp"

#include "stridor/recordings/raw_signal.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

namespace stridor::io::structure {

namespace {

using recordings::refusal;

constexpr std::string_view magic = "\x93NUMPY";
constexpr std::uint64_t largest_index = 0x7fffffff;  // of a matrix here

/// Walks through the literal of Python that the header is.
class NumpyHeader {
public:
    NumpyHeader(std::string_view text, NumpyArray& array) : text_(text), array_(array) {}

    void read() {
        expect('{');
        while (!take('}')) {
            const std::string_view key = quoted();
            expect(':');
            if (key == "descr")
                read_kind();
            else if (key == "fortran_order")
                array_.is_column_major = truth();
            else if (key == "shape")
                read_shape();
            else
                throw damage(fmt::format("\"{}\" is no key of it", key));
            ++keys_;
            take(',');
        }
        if (keys_ != 3) throw damage("it does not say descr, fortran_order and shape");
    }

private:
    base::Error damage(const std::string& why) const {
        return refusal(array_.shown, "the header of the array is damaged", why);
    }

    void skip_blanks() {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n'))
            ++at_;
    }

    bool take(char mark) {
        skip_blanks();
        if (at_ >= text_.size() || text_[at_] != mark) return false;
        ++at_;
        return true;
    }

    void expect(char mark) {
        if (!take(mark)) throw damage(fmt::format("\"{}\" is missing in it", mark));
    }

    std::string_view quoted() {
        skip_blanks();
        const char mark = at_ < text_.size() ? text_[at_] : ' ';
        const std::size_t end = text_.find(mark, at_ + 1);
        // a list of fields stands where a name should
        if (mark == '[') throw refusal(array_.shown, "its elements have several fields", "a matrix holds numbers");
        if ((mark != '\'' && mark != '"') || end == std::string_view::npos) throw damage("a name is missing in it");
        const std::string_view name = text_.substr(at_ + 1, end - at_ - 1);
        at_ = end + 1;
        return name;
    }

    bool truth() {
        skip_blanks();
        for (const std::string_view word : {std::string_view("True"), std::string_view("False")})
            if (text_.substr(at_).starts_with(word)) {
                at_ += word.size();
                return word == "True";
            }
        throw damage("fortran_order is neither True nor False");
    }

    // "<f8": order of bytes, kind, width
    void read_kind() {
        const std::string_view descr = quoted();
        const bool has_order = !descr.empty() && std::string_view("<>|=").find(descr[0]) != std::string_view::npos;
        const std::string_view rest = descr.substr(has_order ? 1 : 0);
        if (rest.starts_with('c'))
            throw refusal(array_.shown, "its numbers are complex", "the matrices of a structure are real");
        const std::optional<std::uint64_t> width = rest.empty() ? std::nullopt : digits(rest.substr(1));
        const bool is_float = rest.starts_with('f') && width && (*width == 4 || *width == 8);
        const bool is_whole = (rest.starts_with('i') || rest.starts_with('u')) && width &&
                              (*width == 1 || *width == 2 || *width == 4 || *width == 8);
        const bool is_other =
            (rest.starts_with('b') && width == 1) || (rest.starts_with('S') && width && *width >= 1 && *width < 100);
        if (!is_float && !is_whole && !is_other)
            throw refusal(array_.shown, fmt::format("its elements are of type \"{}\"", descr),
                          "a matrix holds reals of 4 or 8 bytes or whole numbers",
                          "Convert it: matrix.astype(numpy.float64).");
        array_.kind = rest[0];
        array_.width = static_cast<std::size_t>(*width);
        array_.is_big_endian = descr[0] == '>';
    }

    static std::optional<std::uint64_t> digits(std::string_view text) {
        if (text.empty() || text.size() > 12) return std::nullopt;
        std::uint64_t value = 0;
        for (const char digit : text) {
            if (digit < '0' || digit > '9') return std::nullopt;
            value = 10 * value + static_cast<std::uint64_t>(digit - '0');
        }
        return value;
    }

    void read_shape() {
        expect('(');
        array_.shape.clear();
        array_.size = 1;
        while (!take(')')) {
            skip_blanks();
            const std::size_t end = std::min(text_.find_first_not_of("0123456789", at_), text_.size());
            const auto length = digits(text_.substr(at_, end - at_));
            if (!length || *length > largest_index) throw damage("a length of its shape is missing or too large");
            at_ = end;
            array_.shape.push_back(*length);
            if (array_.shape.size() > 2)
                throw refusal(array_.shown, "the array has more than two indices", "a matrix has rows and columns");
            array_.size *= *length;  // below 2^62
            take(',');
        }
    }

    std::string_view text_;
    NumpyArray& array_;
    std::size_t at_ = 0;
    int keys_ = 0;
};

// the bits of an element as a whole number
std::uint64_t bits_at(const NumpyArray& array, std::uint64_t index) {
    std::uint64_t bits = 0;
    const char* const first = array.bytes.data() + index * array.width;
    for (std::size_t k = 0; k < array.width; ++k) {
        const std::size_t at = array.is_big_endian ? k : array.width - 1 - k;
        bits = bits << 8U | static_cast<unsigned char>(first[at]);
    }
    return bits;
}

std::int64_t integer_at(const NumpyArray& array, std::uint64_t index) {
    const std::uint64_t bits = bits_at(array, index);
    if (array.kind != 'i' || array.width == 8) return std::bit_cast<std::int64_t>(bits);
    const std::uint64_t sign = std::uint64_t{1} << (8 * array.width - 1);
    return std::bit_cast<std::int64_t>((bits ^ sign) - sign);
}

double real_at(const NumpyArray& array, std::uint64_t index) {
    const std::uint64_t bits = bits_at(array, index);
    if (array.kind != 'f') return static_cast<double>(integer_at(array, index));
    if (array.width == 4) return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    return std::bit_cast<double>(bits);
}

}  // namespace

bool is_numpy_array(std::string_view beginning) {
    return beginning.starts_with(magic);
}

NumpyArray read_numpy_array(std::string_view bytes, const std::string& shown) {
    NumpyArray array{.shown = shown};
    if (!is_numpy_array(bytes) || bytes.size() < 12) throw refusal(shown, "it is no array of NumPy");
    const auto byte = [&](std::size_t at) { return static_cast<std::size_t>(static_cast<unsigned char>(bytes[at])); };
    const std::size_t version = byte(6);
    if (version < 1 || version > 3) throw refusal(shown, fmt::format("version {} of .npy is not known", version));
    const std::size_t start = version == 1 ? 10 : 12;
    std::size_t length = byte(8) + (byte(9) << 8U);
    if (version > 1) length += (byte(10) << 16U) + (byte(11) << 24U);
    if (length > bytes.size() - start) throw refusal(shown, "the array is cut off", "the file ends within its header");
    NumpyHeader(bytes.substr(start, length), array).read();
    array.bytes = bytes.substr(start + length);
    if (array.size > array.bytes.size() / array.width || array.size * array.width != array.bytes.size())
        throw refusal(shown,
                      fmt::format("the array says {} elements of {} bytes, and holds {} bytes", array.size, array.width,
                                  array.bytes.size()),
                      "", "Is the file cut off?");
    return array;
}

std::vector<double> reals_of(const NumpyArray& array) {
    if (array.kind != 'f' && array.kind != 'i' && array.kind != 'u')
        throw refusal(array.shown, "it holds no numbers", "a matrix does");
    std::vector<double> values;
    values.reserve(array.size);
    for (std::uint64_t k = 0; k < array.size; ++k) {
        values.push_back(real_at(array, k));
        if (!std::isfinite(values.back()))
            throw refusal(array.shown, fmt::format("element {} is {}", k, values.back()), "it is no finite number");
    }
    return values;
}

std::vector<std::int64_t> integers_of(const NumpyArray& array) {
    if (array.kind != 'i' && array.kind != 'u')
        throw refusal(array.shown, "it holds no whole numbers", "rows and columns are");
    std::vector<std::int64_t> values;
    values.reserve(array.size);
    for (std::uint64_t k = 0; k < array.size; ++k)
        values.push_back(integer_at(array, k));
    return values;
}

}  // namespace stridor::io::structure
