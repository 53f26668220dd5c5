#include "stridor/io/structure/zip_archive.hpp"

#include "stridor/recordings/raw_signal.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <memory>

namespace stridor::io::structure {

namespace {

using recordings::refusal;

constexpr std::uint64_t largest_zip = std::uint64_t{2} << 30U;  // [bytes] as it is, and expanded
constexpr std::size_t most_members = 100;                       // NumPy's archives hold five, or as many as matrices
constexpr std::size_t longest_member_name = 200;                // [bytes]

class ZipReader {
public:
    explicit ZipReader(const StructureInput& input)
        : file_(input.name),
          bytes_(recordings::text_at(*input.bytes, 0, sized(input))) {
        expect(archive_read_support_format_zip_seekable(reader_.get()));
        expect(archive_read_open_memory2(reader_.get(), bytes_.data(), bytes_.size(), bytes_.size()));
    }

    // nothing at the end
    archive_entry* next() {
        archive_entry* entry = nullptr;
        if (!expect(archive_read_next_header(reader_.get(), &entry))) return nullptr;
        // libarchive knows a dozen compressions, some of which ask for gigabytes before the first byte; NumPy uses two
        const char* const format = archive_format_name(reader_.get());
        const std::string_view said = format == nullptr ? "" : format;
        if (said.find("(deflation)") == std::string_view::npos && said.find("(uncompressed)") == std::string_view::npos)
            throw damage("its files are compressed in a way that NumPy does not");
        return entry;
    }

    std::string name_of(archive_entry* entry) const {
        const char* const path = archive_entry_pathname(entry);
        std::string name = path == nullptr ? "" : path;
        const bool is_file = archive_entry_filetype(entry) == AE_IFREG;
        if (name.empty() || name.size() > longest_member_name || !is_file)
            throw damage("it holds something else than files with names");
        return name;
    }

    std::string content() {
        std::string text;
        for (;;) {
            const void* piece = nullptr;
            std::size_t count = 0;
            std::int64_t offset = 0;
            if (!expect(archive_read_data_block(reader_.get(), &piece, &count, &offset))) return text;
            grown_ += count;
            if (grown_ > largest_zip)
                throw refusal(file_, "it grows beyond 2 GiB", "its matrices would not fit into memory", reduce_first);
            text.append(static_cast<const char*>(piece), count);
        }
    }

    base::Error damage(const std::string& why) const { return refusal(file_, "it is no whole zip archive", why); }

private:
    static constexpr const char* reduce_first = "Reduce the part in your finite-element program first.";

    static std::size_t sized(const StructureInput& input) {
        if (input.bytes->size() > largest_zip)
            throw refusal(input.name, "it is larger than 2 GiB", "its matrices would not fit into memory",
                          reduce_first);
        return static_cast<std::size_t>(input.bytes->size());
    }

    // false at the end
    bool expect(int result) const {
        if (result == ARCHIVE_OK || result == ARCHIVE_EOF) return result == ARCHIVE_OK;
        const char* const said = archive_error_string(reader_.get());
        throw damage(said == nullptr ? "it is damaged" : said);
    }

    const std::string& file_;
    std::string bytes_;
    std::uint64_t grown_ = 0;  // [bytes] expanded so far
    std::unique_ptr<archive, decltype(&::archive_read_free)> reader_{archive_read_new(), archive_read_free};
};

}  // namespace

bool is_zip(std::string_view beginning) {
    return beginning.starts_with("PK\x03\x04");
}

std::map<std::string, std::string> read_zip(const StructureInput& input) {
    ZipReader reader(input);
    std::map<std::string, std::string> members;
    while (archive_entry* const entry = reader.next()) {
        std::string name = reader.name_of(entry);
        if (members.size() == most_members)
            throw reader.damage(fmt::format("it holds more than {} files", most_members));
        if (!members.try_emplace(name, reader.content()).second)
            throw reader.damage(fmt::format("it holds {} twice", name));
    }
    return members;
}

}  // namespace stridor::io::structure
