#include "stridor/io/library/tar.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/error.hpp"
#include "stridor/storage/system_io.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

namespace stridor::io {

namespace {

constexpr std::size_t block_size = tar_block;
constexpr std::uint64_t size_limit = std::uint64_t{1} << 33U;  // eleven octal digits

using Header = std::array<char, block_size>;

// where a header's parts stand
struct HeaderPart {
    std::size_t from;
    std::size_t length;
};
constexpr HeaderPart name_part{0, 100};
constexpr HeaderPart mode_part{100, 8};
constexpr HeaderPart size_part{124, 12};
constexpr HeaderPart checksum_part{148, 8};
constexpr std::size_t type_place = 156;
constexpr char folder_type = '5';
constexpr HeaderPart magic_part{257, 6};
constexpr HeaderPart prefix_part{345, 155};

void put_octal(Header& header, HeaderPart part, std::uint64_t value) {
    for (std::size_t k = part.length - 1; k-- > 0; value /= 8)
        header[part.from + k] = static_cast<char>('0' + value % 8);
}

void put_text(Header& header, HeaderPart part, std::string_view text) {
    std::copy_n(text.begin(), std::min(text.size(), part.length),
                header.begin() + static_cast<std::ptrdiff_t>(part.from));
}

std::string_view text_of(const Header& header, HeaderPart part) {
    const std::string_view whole(header.data() + part.from, part.length);
    return whole.substr(0, whole.find('\0'));
}

// nothing for what is no octal number
std::optional<std::uint64_t> octal_of(const Header& header, HeaderPart part) {
    std::string_view digits = text_of(header, part);
    while (digits.starts_with(' '))
        digits.remove_prefix(1);
    while (digits.ends_with(' '))
        digits.remove_suffix(1);
    std::uint64_t value = 0;
    for (const char c : digits) {
        if (c < '0' || c > '7') return std::nullopt;
        value = value * 8 + static_cast<std::uint64_t>(c - '0');
    }
    return digits.empty() ? std::nullopt : std::optional(value);
}

// the sum of a header's bytes, its own field counted as blanks
std::uint64_t checksum(Header header) {
    std::fill_n(header.begin() + checksum_part.from, checksum_part.length, ' ');
    std::uint64_t sum = 0;
    for (const char c : header)
        sum += static_cast<unsigned char>(c);
    return sum;
}

std::uint64_t padding_after(std::uint64_t size) {
    return (block_size - size % block_size) % block_size;
}

}  // namespace

void TarWriter::begin(const TarMember& member) {
    STRIDOR_EXPECT(member.name.size() <= name_part.length);
    if (member.size >= size_limit)
        throw Error(ErrorKind::input,
                    {member.name + " does not fit into an archive", "it is larger than 8 GiB", "Leave it out."});
    Header header{};
    put_text(header, name_part, member.name);
    put_octal(header, mode_part, 0644);
    put_octal(header, {108, 8}, 0);  // user
    put_octal(header, {116, 8}, 0);  // group
    put_octal(header, size_part, member.size);
    put_octal(header, {136, 12}, 0);  // time of change: the same library gives the same bytes
    header[type_place] = '0';
    put_text(header, magic_part, std::string_view("ustar\0", 6));
    put_text(header, {263, 2}, "00");
    put_octal(header, {checksum_part.from, checksum_part.length - 1}, checksum(header));
    header[checksum_part.from + checksum_part.length - 1] = ' ';
    file_->write({header.data(), header.size()});
    written_ = 0;
}

void TarWriter::write(std::string_view bytes) {
    file_->write(bytes);
    written_ += bytes.size();
}

void TarWriter::end() {
    file_->write(std::string(padding_after(written_), '\0'));
}

void TarWriter::finish() {
    file_->write(std::string(2 * block_size, '\0'));
}

TarReader::TarReader(const std::filesystem::path& file, TarProgress progress)
    : file_(file),
      stream_(std::make_unique<std::ifstream>(file, std::ios::binary)),
      progress_(std::move(progress)),
      block_(std::size_t{1} << 18U) {
    std::error_code error;
    const bool is_regular = std::filesystem::is_regular_file(file, error);
    if (!error && is_regular) left_in_file_ = std::filesystem::file_size(file, error);
    if (error) throw storage::system_failure("read", file.string(), error.value());
    if (!is_regular) refuse("it is no file");
    if (!*stream_) throw storage::system_failure("read", file.string(), EACCES);
    size_ = left_in_file_;
}

TarReader::TarReader(std::string_view bytes, const std::string& name)
    : file_(name),
      stream_(std::make_unique<std::istringstream>(std::string(bytes))),
      size_(bytes.size()),
      left_in_file_(bytes.size()),
      block_(std::size_t{1} << 12U) {}

void TarReader::refuse(const std::string& why) const {
    throw Error(ErrorKind::input, {file_.string() + " is no whole archive of a noise library", why, ""});
}

void TarReader::fill(char* bytes, std::uint64_t count) {
    if (count > left_in_file_) refuse("its end is missing");
    stream_->read(bytes, static_cast<std::streamsize>(count));
    if (!*stream_) throw storage::system_failure("read", file_.string(), EIO);
    left_in_file_ -= count;
    if (progress_) progress_(size_ - left_in_file_, size_);
}

std::optional<TarMember> TarReader::next() {
    // folders tell nothing, and an archive may hold any number of them
    while (true) {
        const std::optional<Header> header = next_header();
        if (!header) return std::nullopt;
        TarMember member = member_of(*header);
        if ((*header)[type_place] == folder_type) continue;
        left_in_member_ = member.size;
        padding_ = padding_after(member.size);
        return member;
    }
}

// nothing at the end of the archive
std::optional<TarReader::Header> TarReader::next_header() {
    while (!read().empty())
        continue;
    if (padding_ > left_in_file_) refuse("its end is missing");
    fill(block_.data(), padding_);
    padding_ = 0;

    Header header{};
    fill(header.data(), header.size());
    const bool is_end = std::all_of(header.begin(), header.end(), [](char c) { return c == '\0'; });
    return is_end ? std::nullopt : std::optional(header);
}

TarMember TarReader::member_of(const Header& header) const {
    const std::optional<std::uint64_t> sum = octal_of(header, checksum_part);
    const std::optional<std::uint64_t> size = octal_of(header, size_part);
    if (!text_of(header, magic_part).starts_with("ustar") || !sum || *sum != checksum(header))
        refuse("it is not in the ustar format, or damaged");
    const char type = header[type_place];
    const bool is_folder = type == folder_type;
    if (type != '0' && type != '\0' && !is_folder) refuse("it holds something else than files");
    std::string name(text_of(header, name_part));
    if (const std::string_view prefix = text_of(header, prefix_part); !prefix.empty())
        name = std::string(prefix) + "/" + name;
    if (!size || (is_folder && *size > 0)) refuse("the size of " + name + " is no number");
    if (*size > left_in_file_) refuse(name + " says it is longer than the archive");
    return {name.starts_with("./") ? name.substr(2) : name, *size};
}

std::string_view TarReader::read() {
    const std::uint64_t count = std::min<std::uint64_t>(left_in_member_, block_.size());
    fill(block_.data(), count);
    left_in_member_ -= count;
    return {block_.data(), static_cast<std::size_t>(count)};
}

}  // namespace stridor::io
