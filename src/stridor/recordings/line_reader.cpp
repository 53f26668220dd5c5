#include "stridor/recordings/line_reader.hpp"

#include "stridor/base/text.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace stridor::recordings {

namespace {

std::size_t find_end(const char* text, std::size_t from, std::size_t to) {
    while (from < to && text[from] != '\n' && text[from] != '\r')
        ++from;
    return from;
}

}  // namespace

base::Place place_of(const std::string& file, const TextLine& line, int column) {
    return {file, line.number, column, std::string(line.text.substr(0, 500))};
}

LineReader::LineReader(std::shared_ptr<const Bytes> bytes, std::string name, std::uint64_t offset, int number)
    : bytes_(std::move(bytes)),
      name_(std::move(name)),
      start_(offset),
      number_(number) {
    const std::uint64_t left = bytes_->size() - std::min(offset, bytes_->size());
    // short texts need no long block
    block_.resize(static_cast<std::size_t>(std::min<std::uint64_t>(left + 1, 2 * longest)));
}

// moves what is left to the front and reads on behind it; false at the end of the text
bool LineReader::fill() {
    std::memmove(block_.data(), block_.data() + begin_, end_ - begin_);
    start_ += begin_;
    end_ -= begin_;
    begin_ = 0;
    const std::size_t count = bytes_->read_at(start_ + end_, std::span<char>(block_).subspan(end_));
    end_ += count;
    return count > 0;
}

std::optional<TextLine> LineReader::next() {
    std::size_t length = 0;  // of the line, as far as it was looked at
    for (;;) {
        const std::size_t found = find_end(block_.data(), begin_ + length, end_);
        length = found - begin_;
        if (length > longest)
            throw Error(ErrorKind::input,
                        {"the line has more than " + std::to_string(longest) + " bytes", "this is no table", ""},
                        base::Place{name_, number_, 0, ""});
        // a CR may have its LF behind the end of the block
        const bool is_whole = found + 1 < end_ || (found < end_ && block_[found] == '\n');
        if (is_whole || !fill()) break;
    }
    if (begin_ == end_) return std::nullopt;
    const TextLine line{{block_.data() + begin_, length}, number_, start_ + begin_};
    begin_ += length;
    const bool has_return = begin_ < end_ && block_[begin_] == '\r';
    if (has_return) ++begin_;
    const bool has_feed = begin_ < end_ && block_[begin_] == '\n';
    if (has_feed) ++begin_;
    ++number_;
    return line;
}

std::vector<std::string_view> words(std::string_view line) {
    constexpr std::string_view blanks = " \t\r";
    std::vector<std::string_view> found;
    for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;) {
        const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
        found.push_back(line.substr(at, end - at));
        at = line.find_first_not_of(blanks, end);
    }
    return found;
}

std::optional<double> fortran_number(std::string_view text) {
    text = base::trimmed(text);
    if (text.starts_with('+')) text.remove_prefix(1);
    constexpr std::size_t longest = 60;
    if (text.empty() || text.size() > longest || text.starts_with('+')) return std::nullopt;
    std::string numeral(text);
    std::replace_if(
        numeral.begin(), numeral.end(), [](char c) { return c == 'D' || c == 'd'; }, 'E');
    // an exponent of three digits leaves no room for its letter
    const std::size_t sign = numeral.find_first_of("+-", 1);
    const bool lacks_letter = sign != std::string::npos && numeral.find_first_of("eE") == std::string::npos;
    if (lacks_letter) numeral.insert(sign, 1, 'E');
    double number = 0.0;
    const auto [end, code] = std::from_chars(numeral.data(), numeral.data() + numeral.size(), number);
    if (code == std::errc::invalid_argument || end != numeral.data() + numeral.size()) return std::nullopt;
    return code == std::errc::result_out_of_range ? std::strtod(numeral.c_str(), nullptr) : number;
}

}  // namespace stridor::recordings
