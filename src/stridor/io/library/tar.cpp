#include "stridor/io/library/tar.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/error.hpp"
#include "stridor/storage/system_io.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <cerrno>
#include <exception>
#include <numeric>
#include <system_error>
#include <utility>

namespace stridor::io {

// ---- writing

namespace {

constexpr std::size_t block_size = 512;                        // [bytes]
constexpr std::uint64_t size_limit = std::uint64_t{1} << 33U;  // [bytes] eleven octal digits

std::string padding_after(std::uint64_t size) {
    return std::string((block_size - size % block_size) % block_size, '\0');
}

}  // namespace

void TarWriter::begin(const TarMember& member) {
    STRIDOR_EXPECT(member.name.size() <= 100);
    if (member.size >= size_limit)
        throw Error(ErrorKind::input,
                    {member.name + " does not fit into an archive", "it is larger than 8 GiB", "Leave it out."});
    std::string header(block_size, '\0');
    const auto put = [&](std::size_t at, const std::string& text) { header.replace(at, text.size(), text); };
    put(0, member.name);
    put(100, "0000644");  // mode
    put(108, "0000000");  // user
    put(116, "0000000");  // group
    put(124, fmt::format("{:011o}", member.size));
    put(136, "00000000000");  // time of change: the same library gives the same bytes
    put(148, "        ");     // the checksum counts itself as blanks
    put(156, "0");            // a regular file
    put(257, "ustar");
    put(263, "00");
    // the format sums unsigned bytes, and names are ASCII
    put(148, fmt::format("{:06o}", std::accumulate(header.begin(), header.end(), 0)) + '\0');
    file_->write(header);
    written_ = 0;
}

void TarWriter::write(std::string_view bytes) {
    file_->write(bytes);
    written_ += bytes.size();
}

void TarWriter::end() {
    file_->write(padding_after(written_));
}

void TarWriter::finish() {
    file_->write(std::string(2 * block_size, '\0'));
}

// ---- reading

namespace {

constexpr std::size_t piece_size = std::size_t{1} << 16U;          // [bytes] read from a file at a time
constexpr std::uint64_t longest_header = std::uint64_t{1} << 18U;  // [bytes] with all that extends it
constexpr std::size_t longest_name = 255;                          // [bytes] of a file, as in the ustar dialect

[[noreturn]] void refuse(const std::string& file, const std::string& why, const std::string& suggestion = "") {
    throw Error(ErrorKind::input, {file + " is no whole archive of a noise library", why, suggestion});
}

}  // namespace

std::uint64_t longest_expanded(std::uint64_t size) {
    return (std::uint64_t{64} << 20U) + 16 * size;
}

/// One reader of libarchive expands the file, another takes it apart. So what goes between them is counted: a file of a
/// megabyte may grow to many gigabytes, even within a single header.
class TarReader::Source {
public:
    Source(std::string file, std::uint64_t size, TarProgress progress, const std::function<int(archive*)>& open)
        : file_(std::move(file)),
          size_(size),
          progress_(std::move(progress)) {
        for (const auto support : {archive_read_support_filter_gzip, archive_read_support_filter_xz,
                                   archive_read_support_filter_zstd, archive_read_support_format_raw})
            expect(whole_, support(whole_.get()));
        expect(whole_, open(whole_.get()));
        // the file as it is counts as one
        if (archive_filter_count(whole_.get()) > 2) refuse(file_, "it is compressed more than once");
        archive_entry* everything = nullptr;
        expect(whole_, archive_read_next_header(whole_.get(), &everything));
        expect(tar_, archive_read_support_format_tar(tar_.get()));
        expect(tar_, archive_read_open(tar_.get(), this, nullptr, feed, nullptr));
    }

    // null at the end
    archive_entry* next_header() {
        header_room_ = longest_header;
        archive_entry* entry = nullptr;
        const int result = archive_read_next_header(tar_.get(), &entry);
        header_room_.reset();
        // a warning is about what we do not use, such as the name of a user
        if (expect(tar_, result == ARCHIVE_WARN ? ARCHIVE_OK : result)) return entry;
        if (has_ended_) refuse(file_, "its end is missing");
        return nullptr;
    }

    struct Piece {
        std::string_view bytes;
        std::int64_t offset = 0;  // [bytes] where they stand in what is read
    };
    // the next bytes of a file of the archive; none at its end
    Piece read() { return read_from(tar_); }

    const std::string& file() const { return file_; }

private:
    using Reader = std::unique_ptr<archive, decltype(&::archive_read_free)>;

    // called by libarchive, which knows no exceptions
    static la_ssize_t feed(archive*, void* self, const void** bytes) {
        auto& source = *static_cast<Source*>(self);
        try {
            const std::string_view piece = source.next_expanded();
            *bytes = piece.data();
            return static_cast<la_ssize_t>(piece.size());
        } catch (...) {
            source.failure_ = std::current_exception();
            return ARCHIVE_FATAL;
        }
    }

    std::string_view next_expanded() {
        const std::string_view piece = read_from(whole_).bytes;
        if (progress_) progress_(static_cast<std::uint64_t>(archive_filter_bytes(whole_.get(), -1)), size_);
        has_ended_ = piece.empty();
        grown_ += piece.size();
        if (grown_ > longest_expanded(size_))
            refuse(file_, "it grows to more than 16 times its size when it is expanded",
                   "Expand it yourself if you trust it.");
        if (header_room_ && piece.size() > *header_room_) refuse(file_, "a header in it is longer than 256 KiB");
        if (header_room_) *header_room_ -= piece.size();
        return piece;
    }

    Piece read_from(const Reader& reader) const {
        const void* bytes = nullptr;
        std::size_t count = 0;
        std::int64_t offset = 0;
        while (count == 0)
            if (!expect(reader, archive_read_data_block(reader.get(), &bytes, &count, &offset))) return {{}, offset};
        return {{static_cast<const char*>(bytes), count}, offset};
    }

    // false at the end
    bool expect(const Reader& reader, int result) const {
        if (failure_) std::rethrow_exception(failure_);
        if (result == ARCHIVE_OK || result == ARCHIVE_EOF) return result == ARCHIVE_OK;
        // what is not of libarchive's own is the system's word on the file
        const int code = archive_errno(reader.get());
        if (reader == whole_ && code > 0 && code != EILSEQ && code != EINVAL && code != ENOMEM)
            throw storage::system_failure("read", file_, code);
        const char* const said = archive_error_string(reader.get());
        refuse(file_, std::string("it is no tar archive, or damaged: ") + (said == nullptr ? "unknown" : said));
    }

    std::string file_;
    std::uint64_t size_ = 0;  // [bytes]
    TarProgress progress_;
    std::uint64_t grown_ = 0;                     // [bytes] expanded so far
    std::optional<std::uint64_t> header_room_{};  // [bytes] that the header at hand may still take
    bool has_ended_ = false;                      // more was asked for than there is
    std::exception_ptr failure_{};                // of what expands
    Reader whole_{archive_read_new(), archive_read_free};
    Reader tar_{archive_read_new(), archive_read_free};
};

TarReader::TarReader(const std::filesystem::path& file, TarProgress progress) {
    std::error_code error;
    const bool is_regular = std::filesystem::is_regular_file(file, error);
    const std::uint64_t size = is_regular ? std::filesystem::file_size(file, error) : 0;
    if (error) throw storage::system_failure("read", file.string(), error.value());
    if (!is_regular) refuse(file.string(), "it is no file");
    source_ = std::make_unique<Source>(file.string(), size, std::move(progress), [&](archive* reader) {
        return archive_read_open_filename(reader, file.c_str(), piece_size);
    });
}

TarReader::TarReader(std::string_view bytes, const std::string& name)
    : source_(std::make_unique<Source>(name, bytes.size(), TarProgress(), [&](archive* reader) {
          return archive_read_open_memory2(reader, bytes.data(), bytes.size(), piece_size);
      })) {}

TarReader::~TarReader() = default;

std::optional<TarMember> TarReader::next() {
    while (!read().empty())
        continue;
    archive_entry* entry = source_->next_header();
    // folders tell nothing, and an archive may hold any number of them
    while (entry != nullptr && archive_entry_filetype(entry) == AE_IFDIR)
        entry = source_->next_header();
    if (entry == nullptr) return std::nullopt;
    if (archive_entry_filetype(entry) != AE_IFREG || archive_entry_hardlink(entry) != nullptr)
        refuse(source_->file(), "it holds something else than files");
    const char* const path = archive_entry_pathname(entry);
    const std::string_view name = path == nullptr ? "" : path;
    if (name.empty() || name.size() > longest_name)
        refuse(source_->file(), "the name of a file is missing or too long");
    member_ = {std::string(name.starts_with("./") ? name.substr(2) : name),
               static_cast<std::uint64_t>(archive_entry_size(entry))};
    given_ = 0;
    return member_;
}

std::string_view TarReader::read() {
    if (!member_) return {};
    const auto [bytes, offset] = source_->read();
    const bool has_hole = bytes.empty() ? given_ != member_->size : static_cast<std::uint64_t>(offset) != given_;
    if (has_hole) refuse(source_->file(), member_->name + " has holes");
    given_ += bytes.size();
    if (bytes.empty()) member_.reset();
    return bytes;
}

}  // namespace stridor::io
