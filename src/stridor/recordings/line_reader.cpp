#include "stridor/recordings/line_reader.hpp"

#include <algorithm>
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

}  // namespace stridor::recordings
