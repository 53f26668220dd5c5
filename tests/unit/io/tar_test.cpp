#include "stridor/io/library/tar.hpp"

#include "stridor/base/hash.hpp"
#include "support/counter_random.hpp"
#include "support/error_text.hpp"
#include "support/scratch_folder.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

// libarchive 3.6 loses 66 bytes of a writer that is given up; only the writers of this test are
extern "C" const char* __lsan_default_suppressions() {  // NOLINT
    return "leak:libarchive\n";
}
extern "C" const char* __lsan_default_options() {  // NOLINT
    return "print_suppressions=0";
}

namespace stridor::io {
namespace {

using support::thrown_by;

using Choice = int (*)(archive*);  // of a format or a compression

struct OtherFile {
    std::string name;
    std::string bytes;
    std::int64_t size = -1;  // [bytes] with a hole after them; negative: without one
};

la_ssize_t append(archive*, void* text, const void* bytes, std::size_t count) {
    static_cast<std::string*>(text)->append(static_cast<const char*>(bytes), count);
    return static_cast<la_ssize_t>(count);
}

// what another program would write: libarchive's writers share no code with ours
std::string written_by_another(const std::vector<OtherFile>& files, Choice format,
                               Choice compression = archive_write_add_filter_none) {
    std::string text;
    archive* const writer = archive_write_new();
    EXPECT_EQ(format(writer), ARCHIVE_OK);
    EXPECT_EQ(compression(writer), ARCHIVE_OK);
    EXPECT_EQ(archive_write_set_bytes_per_block(writer, 0), ARCHIVE_OK);  // no padding
    EXPECT_EQ(archive_write_open(writer, &text, nullptr, append, nullptr), ARCHIVE_OK);
    for (const OtherFile& file : files) {
        archive_entry* const entry = archive_entry_new();
        archive_entry_set_pathname(entry, file.name.c_str());
        archive_entry_set_mode(entry, AE_IFREG | 0644);
        archive_entry_set_size(entry, file.size < 0 ? static_cast<std::int64_t>(file.bytes.size()) : file.size);
        archive_entry_set_mtime(entry, 1'600'000'000, 123'456'789);
        archive_entry_set_uname(entry, "m\xc3\xbcller");
        if (file.size >= 0) archive_entry_sparse_add_entry(entry, 0, static_cast<std::int64_t>(file.bytes.size()));
        EXPECT_GE(archive_write_header(writer, entry), ARCHIVE_WARN) << archive_error_string(writer);
        EXPECT_EQ(archive_write_data(writer, file.bytes.data(), file.bytes.size()), std::ssize(file.bytes));
        archive_entry_free(entry);
    }
    if (files.size() == 1 && files[0].size >= 0)
        archive_write_fail(writer);  // does not write the hole's bytes
    else
        EXPECT_EQ(archive_write_close(writer), ARCHIVE_OK);
    archive_write_free(writer);
    return text;
}

std::string compressed(const std::string& bytes, Choice compression) {
    return written_by_another({{"", bytes}}, archive_write_set_format_raw, compression);
}

using Files = std::vector<std::pair<std::string, std::string>>;  // names, and bytes or their hashes

Files hashed(Files files) {
    for (auto& [name, bytes] : files)
        bytes = base::sha256_text(bytes);
    return files;
}

Files files_of(const std::string& bytes) {
    TarReader tar(bytes, "given.tar");
    Files files;
    while (const std::optional<TarMember> member = tar.next()) {
        base::Sha256 hash;
        for (std::string_view piece = tar.read(); !piece.empty(); piece = tar.read())
            hash.add(piece);
        files.emplace_back(member->name, hash.text());
    }
    return files;
}

std::string refusal(const std::string& bytes) {
    const support::Thrown thrown = thrown_by([&] { files_of(bytes); });
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    return thrown.message;
}

void expect_refused(const std::string& bytes, const std::string& words) {
    const std::string message = refusal(bytes);
    EXPECT_NE(message.find(words), std::string::npos) << "\"" << words << "\" is not in: " << message;
}

// does not fit into a header's first field
const std::string long_name = "audio/" + std::string(60, 'a') + "/" + std::string(60, 'b') + ".wav";
const std::string bytes_of_many_blocks = [] {
    std::string bytes;
    for (support::CounterRandom random(7); bytes.size() < 300'000;)
        bytes += static_cast<char>(random.next());
    return bytes;
}();
const std::vector<Choice> compressions{archive_write_add_filter_none, archive_write_add_filter_gzip,
                                       archive_write_add_filter_xz, archive_write_add_filter_zstd};

std::string written_by_us() {
    const support::ScratchFolder folder;
    {
        storage::PiecewiseFile file((folder / "ours.tar").string());
        TarWriter tar(file);
        for (const auto& [name, bytes] : Files{{"manifest.jsonl", "abc"}, {"audio/long.wav", bytes_of_many_blocks}}) {
            tar.begin({name, bytes.size()});
            tar.write(bytes);
            tar.end();
        }
        tar.finish();
        file.commit();
    }
    std::ifstream stream(folder / "ours.tar", std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

// the hash is that of the bytes that Python's struct and hashlib make of the format's description
TEST(TarWriter, GivesTheSameBytesOnEveryMachine) {
    const std::string bytes = written_by_us();
    EXPECT_EQ(base::sha256_text(bytes.substr(0, 1024)),
              "f0cf2463a28713bc230b3514f187b565afff8c4a07fdb737375f3bf5256e84df");
    EXPECT_EQ(files_of(bytes), hashed({{"manifest.jsonl", "abc"}, {"audio/long.wav", bytes_of_many_blocks}}));
}

TEST(TarReader, ReadsEveryDialectAndCompression) {
    const Choice dialects[] = {archive_write_set_format_ustar, archive_write_set_format_gnutar,
                               archive_write_set_format_pax, archive_write_set_format_pax_restricted};
    const Files files{{"manifest.jsonl", "abc"}, {"empty", ""}, {long_name, bytes_of_many_blocks}};
    for (const Choice dialect : dialects)
        for (const Choice compression : compressions) {
            const std::string bytes = written_by_another(
                {{"./manifest.jsonl", "abc"}, {"empty", ""}, {long_name, bytes_of_many_blocks}}, dialect, compression);
            EXPECT_EQ(files_of(bytes), hashed(files));
        }
    EXPECT_EQ(files_of(written_by_another({{"manifest.jsonl", "abc"}}, archive_write_set_format_v7tar)),
              hashed({{"manifest.jsonl", "abc"}}));
}

// the two blocks at the end are part of it
TEST(TarReader, RefusesWhatIsCutShort) {
    const Files whole = hashed({{"manifest.jsonl", "abc"}, {"other", "def"}});
    for (const Choice compression : compressions) {
        const std::string bytes = written_by_another({{"manifest.jsonl", "abc"}, {"other", "def"}},
                                                     archive_write_set_format_ustar, compression);
        const std::size_t step = bytes.size() > 2048 ? 61 : 1;
        for (std::size_t size = 0; size < std::min<std::size_t>(bytes.size(), 3072); size += step)
            try {
                // a compression's last bytes stand after all that is read
                EXPECT_EQ(files_of(bytes.substr(0, size)), whole) << size;
                EXPECT_NE(compression, compressions.front()) << size;
                EXPECT_GE(size + 64, bytes.size());
            } catch (const Error& error) {
                EXPECT_EQ(error.kind(), ErrorKind::input) << size << ": " << error.what();
            }
    }
}

TEST(TarReader, RefusesWhatGrowsWithoutEnd) {
    const std::string zeros(66U << 20U, '\0');
    const std::string tar = written_by_another({{"zeros", zeros}}, archive_write_set_format_ustar);
    EXPECT_EQ(files_of(tar), hashed({{"zeros", zeros}})) << "without compression it does not grow";
    for (const Choice compression : {archive_write_add_filter_gzip, archive_write_add_filter_zstd}) {
        const std::string bomb = compressed(tar, compression);
        EXPECT_LT(bomb.size(), tar.size() / 900);
        expect_refused(bomb, "it grows to more than 16 times its size");
        // whether or not anyone looks into its files
        TarReader reader(bomb, "given.tar");
        EXPECT_TRUE(reader.next());
        EXPECT_TRUE(thrown_by([&] { reader.next(); }).says("it grows"));
        expect_refused(compressed(bomb, compression), "compressed more than once");
    }
    // what stays below 64 MiB may grow as it likes
    const std::string fewer = zeros.substr(0, 1U << 20U);
    EXPECT_EQ(
        files_of(written_by_another({{"zeros", fewer}}, archive_write_set_format_ustar, archive_write_add_filter_zstd)),
        hashed({{"zeros", fewer}}));
}

// a header that goes on in block after block, each of which takes memory
TEST(TarReader, RefusesHeadersWithoutEnd) {
    std::string header = written_by_another({{"sparse", ""}}, archive_write_set_format_gnutar).substr(0, 512);
    header[156] = 'S';
    header.replace(386, 24, "000000000000000000000001");
    header[482] = 1;  // a block with more of the map follows
    header.replace(148, 8, 8, ' ');
    unsigned sum = 0;
    for (const char c : header)
        sum += static_cast<unsigned char>(c);
    std::string digits;
    for (unsigned place = 1U << 15U; place > 0; place >>= 3U)
        digits += static_cast<char>('0' + sum / place % 8);
    header.replace(148, 8, digits + '\0' + ' ');
    std::string map(512, '\0');
    map.replace(0, 24, "000000000000000000000001");
    map[504] = 1;
    std::string tar = header;
    for (int block = 0; block < 40'000; ++block)
        tar += map;
    expect_refused(tar, "a header in it is longer than 256 KiB");
    expect_refused(compressed(tar, archive_write_add_filter_zstd), "a header in it is longer than 256 KiB");
}

TEST(TarReader, RefusesHolesAndNamesWithoutEnd) {
    for (const std::int64_t size : {std::int64_t{4096}, std::int64_t{1} << 40U})
        expect_refused(
            written_by_another({{"sparse", "abc", size}}, archive_write_set_format_pax) + std::string(2048, '\0'),
            "sparse has holes");
    for (const Choice dialect : {archive_write_set_format_gnutar, archive_write_set_format_pax})
        expect_refused(written_by_another({{std::string(1000, 'a'), "abc"}}, dialect), "too long");
}

TEST(TarReader, SaysWhichFileCannotBeRead) {
    const support::ScratchFolder folder;
    EXPECT_EQ(thrown_by([&] { TarReader tar(folder / "missing.tar"); }).kind, ErrorKind::io);
    EXPECT_TRUE(thrown_by([&] { TarReader tar(folder / "missing.tar"); }).says("missing.tar"));
    EXPECT_TRUE(thrown_by([&] { TarReader tar(folder / ""); }).says("it is no file"));
}

TEST(TarReader, TellsHowFarItIs) {
    const support::ScratchFolder folder;
    const std::string bytes = written_by_another({{"a", bytes_of_many_blocks}}, archive_write_set_format_ustar,
                                                 archive_write_add_filter_gzip);
    std::ofstream(folder / "a.tar.gz", std::ios::binary) << bytes;
    std::vector<std::uint64_t> seen;
    TarReader tar(folder / "a.tar.gz", [&](std::uint64_t done, std::uint64_t total) {
        EXPECT_EQ(total, bytes.size());
        seen.push_back(done);
    });
    while (tar.next())
        continue;
    EXPECT_GT(seen.size(), 3U);
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
    EXPECT_EQ(seen.back(), bytes.size());
}

}  // namespace
}  // namespace stridor::io
