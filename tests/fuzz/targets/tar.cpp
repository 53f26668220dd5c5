#include "stridor/io/library/tar.hpp"

#include "fuzz/targets/targets.hpp"
#include "stridor/base/error.hpp"
#include "stridor/io/library/archive_manifest.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

namespace stridor::fuzz {

namespace {

constexpr std::size_t block = 512;
constexpr std::size_t checksum_at = 148;
constexpr std::size_t magic_at = 257;

// nobody guesses a checksum: with a right one the bytes behind it are looked at, too
void mend_checksum(std::string& bytes, std::size_t header) {
    std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(header + checksum_at), 8, ' ');
    unsigned sum = 0;
    for (std::size_t k = 0; k < block; ++k)
        sum += static_cast<unsigned char>(bytes[header + k]);
    std::array<char, 8> digits{};
    static_cast<void>(std::snprintf(digits.data(), digits.size(), "%06o", sum % 0777777U));
    bytes.replace(header + checksum_at, 7, std::string(digits.data(), 7));
}

std::string mended(std::string bytes) {
    for (std::size_t header = 0; header + block <= bytes.size(); header += block)
        if (bytes.compare(header + magic_at, 5, "ustar") == 0) mend_checksum(bytes, header);
    return bytes;
}

std::string as_archive(std::string_view manifest) {
    std::string bytes(block, '\0');
    bytes.replace(0, 14, "manifest.jsonl");
    std::array<char, 16> size{};
    static_cast<void>(std::snprintf(size.data(), size.size(), "%011zo", manifest.size()));
    bytes.replace(124, 11, std::string(size.data(), 11));
    bytes[156] = '0';
    bytes.replace(magic_at, 5, "ustar");
    mend_checksum(bytes, 0);
    bytes += manifest;
    bytes.append((block - manifest.size() % block) % block + 2 * block, '\0');
    return bytes;
}

// reads it to its end, or says that its hash is not that of its lines
void look_at_hash(const std::string& bytes) {
    try {
        io::TarReader tar(bytes, "input");
        io::expect_whole_manifest(tar, "input");
    } catch (const Error& error) {
        require(error.kind() == ErrorKind::input || error.kind() == ErrorKind::io);
    }
}

void read_manifest(io::TarReader& tar) {
    io::Manifest entries(tar, "input");
    while (const std::optional<io::Announced> each = entries.next()) {
        // the name of a file, if it is ever used as one, stays below its folder
        const std::string member = io::archive_member({each->entry.audio, each->entry.format});
        require(member.starts_with("audio/") && member.find("..") == std::string::npos);
        // what was read can be written, and reads back as the same
        const std::string lines = io::manifest_opening(1) + io::manifest_line(each->entry, each->bytes);
        const std::string written = as_archive(lines + io::manifest_closing(lines));
        io::TarReader again(written, "written");
        io::Manifest back(again, "written");
        const std::optional<io::Announced> entry = back.next();
        require(entry && entry->bytes == each->bytes && entry->entry.figures == each->entry.figures);
        require(io::manifest_line(entry->entry, 0) == io::manifest_line(each->entry, 0) && !back.next());
    }
}

void read_archive(const std::string& bytes) {
    look_at_hash(bytes);
    try {
        io::TarReader tar(bytes, "input");
        read_manifest(tar);
        std::uint64_t total = 0;
        while (const std::optional<io::TarMember> member = tar.next()) {
            std::uint64_t size = 0;
            for (std::string_view piece = tar.read(); !piece.empty(); piece = tar.read())
                size += piece.size();
            total += size;
            require(size == member->size && total <= io::longest_expanded(bytes.size()));
        }
    } catch (const Error& error) {
        require(error.kind() == ErrorKind::input && !error.problem().what.empty());
    }
}

}  // namespace

void tar(std::string_view bytes) {
    read_archive(std::string(bytes));
    read_archive(mended(std::string(bytes)));
}

void manifest(std::string_view bytes) {
    read_archive(as_archive(bytes));
}

}  // namespace stridor::fuzz
