#include "stridor/io/library/library_archive.hpp"

#include "stridor/base/hash.hpp"
#include "stridor/io/library/archive_manifest.hpp"
#include "stridor/io/library/tar.hpp"
#include "stridor/io/sound/json_sound.hpp"
#include "stridor/noise_library/field.hpp"
#include "support/bit_flips.hpp"
#include "support/counter_random.hpp"
#include "support/error_text.hpp"
#include "unit/noise_library/library_folder.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <functional>

namespace stridor::io {
namespace {

namespace fs = std::filesystem;
using namespace noise_library;
using support::CounterRandom;
using support::ScratchFolder;
using support::Thrown;
using support::thrown_by;

bool has_its_bytes(const Library& library, const Entry& entry) {
    return base::sha256_text(bytes_of(library.audio_file(entry))) == entry.audio;
}

Query everything() {
    Query query;
    query.extent = noise_library::EntryExtent::whole;
    return query;
}

struct Member {
    std::string name;
    std::string bytes;
};

// an archive written by code of its own
std::string tar_of(const std::vector<Member>& members, const std::function<void(std::string&)>& spoil = {}) {
    std::string tar;
    for (const Member& member : members) {
        std::string header(512, '\0');
        const auto put = [&](std::size_t at, const std::string& text) { header.replace(at, text.size(), text); };
        const auto octal = [](std::size_t value) {
            std::string digits(11, '0');
            for (std::size_t k = 11; k-- > 0; value /= 8)
                digits[k] = static_cast<char>('0' + value % 8);
            return digits;
        };
        put(0, member.name);
        put(100, "0000644");
        put(124, octal(member.bytes.size()));
        put(156, "0");
        put(257, std::string("ustar\0"
                             "00",
                             8));
        if (spoil) spoil(header);
        put(148, std::string(8, ' '));
        std::size_t sum = 0;
        for (const char c : header)
            sum += static_cast<unsigned char>(c);
        put(148, octal(sum).substr(5) + '\0');
        tar += header + member.bytes + std::string((512 - member.bytes.size() % 512) % 512, '\0');
    }
    return tar + std::string(1024, '\0');
}

const std::string sound = "sound bytes";
const std::string sound_hash = base::sha256_text(sound);
const std::string sound_name = "audio/" + sound_hash.substr(0, 2) + "/" + sound_hash + ".wav";
const std::string opening = "{\"schema\":\"stridor.library-archive/1\"}\n";

std::string line(const std::string& more = "", std::size_t bytes = sound.size(), const std::string& format = "wav") {
    return "{\"audio\":\"" + sound_hash + "\",\"format\":\"" + format + "\",\"bytes\":" + std::to_string(bytes) + more +
           "}\n";
}

class Archive : public testing::Test {
protected:
    Library open(const char* name = "library.sqlite") const { return Library(folder_ / name, {Access::fill}); }

    // why it is refused; nothing of it may stay
    std::string refusal(const std::string& bytes) {
        write_bytes(archive_, bytes);
        Library library = open();
        const Thrown thrown = thrown_by([&] { import_library(library, archive_); });
        EXPECT_EQ(thrown.kind, ErrorKind::input) << thrown.message;
        EXPECT_EQ(library.size(), 0);
        EXPECT_TRUE(files_of(library).empty());
        return thrown.message;
    }
    void expect_refused(const std::string& bytes, const std::string& words) {
        const std::string message = refusal(bytes);
        EXPECT_NE(message.find(words), std::string::npos) << "\"" << words << "\" is not in: " << message;
    }
    void expect_manifest_refused(const std::string& manifest, const std::string& words) {
        expect_refused(tar_of({{"manifest.jsonl", manifest}, {sound_name, sound}}), words);
    }

    ScratchFolder folder_;
    fs::path archive_ = folder_ / "archive.tar";
    fs::path sound_ = folder_ / "sound.wav";
};

TEST_F(Archive, CarriesEntriesFromLibraryToLibraryWhole) {
    Library library = open();
    for (int k = 0; k < 5; ++k) {
        Entry entry;
        entry.system = "Türdichtung \"" + std::to_string(k) + "\"";
        entry.notes = "two\nlines";
        entry.preload = 0.1 * k;
        entry.case_text = "[joint]\nmass = 0.1\n";
        entry.verdict = "{\"category\": \"squeal\"}";
        entry.category = "squeal";
        set_figure(entry, {"level", "dB", 1.0 / 3.0});
        add_bytes(library, sound_, std::string(static_cast<std::size_t>(k) * 700, 'x'), entry);
    }
    add_recording(library, {sound_, {}, Twins::accept}, probe_bytes);  // two entries of one sound
    const std::vector<Entry> before = library.find(everything());
    export_library(library, before, archive_);

    Library other = open("other.sqlite");
    const Import result = import_library(other, archive_);
    EXPECT_EQ(result.added, (std::vector<std::int64_t>{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(result.skipped, 0U);
    const std::vector<Entry> after = other.find(everything());
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t k = 0; k < after.size(); ++k)
        EXPECT_EQ(digest(after[k]), digest(before[k]));
    EXPECT_EQ(broken_promise(other, has_its_bytes), "");

    // once more changes nothing, and the same entries make the same bytes
    EXPECT_EQ(import_library(other, archive_).skipped, 6U);
    EXPECT_EQ(other.size(), 6);
    export_library(other, after, folder_ / "again.tar");
    EXPECT_EQ(bytes_of(folder_ / "again.tar"), bytes_of(archive_));
}

TEST_F(Archive, RefusesEveryFlippedBitAndKeepsNothingOfIt) {
    {
        Library library = open("source.sqlite");
        Entry entry;
        entry.system = "brake";
        entry.preload = 20.0;
        add_bytes(library, sound_, sound, entry);
        export_library(library, library.find(everything()), archive_);
    }
    const std::string bytes = bytes_of(archive_);
    const std::size_t manifest_end = 512 + static_cast<std::size_t>(std::stoul(bytes.substr(124, 11), nullptr, 8));
    Library library = open();
    const std::size_t step = support::flip_step(29, 113);
    for (std::size_t bit = 0; bit < 8 * bytes.size(); bit += step) {
        std::string damaged = bytes;
        damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
        write_bytes(archive_, damaged);
        const bool is_in_manifest = bit / 8 >= 512 && bit / 8 < manifest_end;
        try {
            import_library(library, archive_);
            // what stands between and behind the files means nothing
            ASSERT_FALSE(is_in_manifest) << bit;
            const std::vector<Entry> entries = library.find(everything());
            ASSERT_EQ(entries.size(), 1U) << bit;
            ASSERT_EQ(entries[0].system + entries[0].audio, "brake" + sound_hash) << bit;
            library.remove(std::vector<std::int64_t>{entries[0].id});
        } catch (const Error& error) {
            ASSERT_EQ(error.kind(), is_in_manifest ? ErrorKind::io : ErrorKind::input) << bit << ": " << error.what();
        }
        ASSERT_EQ(library.size(), 0) << bit;
        ASSERT_TRUE(files_of(library).empty()) << bit;
    }
}

TEST_F(Archive, EndsItsManifestWithItsHash) {
    const std::string lines = "{\"schema\":\"stridor.library-archive/2\"}\n" + line();
    const std::string closing = manifest_closing(lines);
    EXPECT_EQ(closing, "{\"sha256\":\"" + base::sha256_text(lines) + "\"}\n");
    const auto kind_of = [&](const std::string& manifest) {
        write_bytes(archive_, tar_of({{"manifest.jsonl", manifest}, {sound_name, sound}}));
        Library library = open();
        return thrown_by([&] { import_library(library, archive_); }).kind;
    };
    EXPECT_EQ(kind_of(lines), ErrorKind::io) << "without its hash";
    EXPECT_EQ(kind_of(lines + closing + line()), ErrorKind::io) << "with lines behind it";
    EXPECT_EQ(kind_of(opening + line() + closing), ErrorKind::io) << "with that of another";
    write_bytes(archive_, tar_of({{"manifest.jsonl", lines + closing}, {sound_name, sound}}));
    Library library = open();
    EXPECT_EQ(import_library(library, archive_).added.size(), 1U);
}

TEST_F(Archive, LeavesOutWhatWasOnlyJudgedAgain) {
    Library library = open();
    const auto judge = [&](std::int64_t id, const char* category, double level) {
        const auto put = [&](Entry& entry) {
            entry = without_verdict(std::move(entry));
            entry.category = category;
            entry.verdict = "{\"schema\":\"stridor.verdict/1\",\"figures\":{\"level\":" + std::to_string(level) + "}}";
            set_figure(entry, {"level", "dB", level});
        };
        return library.edit(std::array{id}, put).front();
    };
    const std::int64_t id = add_bytes(library, sound_, sound).id;
    const Entry old = judge(id, "squeak", 61.5);
    export_library(library, std::array{old}, archive_);
    const Entry now = judge(id, "squeal", 62.25);
    Import import = import_library(library, archive_);
    EXPECT_TRUE(import.added.empty());
    EXPECT_EQ(import.skipped, 1U);
    EXPECT_EQ(import.heard_otherwise, 1U);
    EXPECT_EQ(library.find(everything()).front().category, "squeal");
    // what a person wrote is no verdict
    export_library(library, std::array{now}, archive_);
    library.edit(std::array{id}, [](Entry& entry) { entry.notes = "the left one"; });
    import = import_library(library, archive_);
    EXPECT_EQ(import.added.size(), 1U);
    EXPECT_EQ(import.heard_otherwise, 0U);
}

TEST_F(Archive, IsReadFromOtherWritersOfTar) {
    write_bytes(archive_, tar_of({{"manifest.jsonl", opening + line(",\"preload\":20")}, {sound_name, sound}}));
    Library library = open();
    EXPECT_EQ(import_library(library, archive_).added.size(), 1U);
    EXPECT_EQ(library.find({}).front().preload, 20.0);
    EXPECT_EQ(broken_promise(library, has_its_bytes), "");
}

TEST_F(Archive, IsNotWrittenWithDamagedAudioNorOverTheLibrary) {
    Library library = open();
    const Entry entry = add_bytes(library, sound_, "bytes");
    EXPECT_TRUE(thrown_by([&] {
                    export_library(library, std::span(&entry, 1), library.file());
                }).says("is the library itself"));
    write_bytes(library.audio_file(entry), "other");
    EXPECT_TRUE(thrown_by([&] { export_library(library, std::span(&entry, 1), archive_); }).says("damaged"));
    fs::remove(library.audio_file(entry));
    EXPECT_TRUE(thrown_by([&] { export_library(library, std::span(&entry, 1), archive_); }).says("cannot be read"));
    EXPECT_FALSE(fs::exists(archive_));
    // adding the recording again mends it
    write_bytes(sound_, "bytes");
    add_recording(library, {sound_, {}, Twins::accept}, probe_bytes);
    EXPECT_EQ(broken_promise(library, has_its_bytes), "");
}

TEST_F(Archive, RefusesNamesThatLeadElsewhere) {
    const std::string manifest = opening + line();
    for (const char* name : {"../../evil.wav", "/etc/passwd", "audio/../../x.wav", "evil.sh"})
        expect_refused(tar_of({{"manifest.jsonl", manifest}, {name, sound}}), "no entry has the file");
    expect_manifest_refused(opening + line("", sound.size(), "../../x"), "does not name its audio");
    expect_manifest_refused(opening + line("", sound.size(), ""), "does not name its audio");
    EXPECT_FALSE(fs::exists(folder_ / "evil.sh"));
}

TEST_F(Archive, RefusesLinksAndDevices) {
    const std::string manifest = opening + line();
    const auto with_type = [&](char type, const std::string& target) {
        return tar_of({{"manifest.jsonl", manifest}, {sound_name, sound}}, [&](std::string& header) {
            if (!header.starts_with("audio")) return;
            header[156] = type;
            header.replace(157, target.size(), target);
        });
    };
    for (const char type : {'1', '2', '3', '4', '6'})
        for (const char* target : {"manifest.jsonl", "/etc/passwd"})
            expect_refused(with_type(type, target), "something else than files");
    // a link to nothing, and headers that tell of a file which does not follow
    for (const char type : {'1', 'x', 'g', 'K', 'L', 'V'})
        refusal(with_type(type, ""));
}

TEST_F(Archive, RefusesSizesAndBytesThatAreNotTrue) {
    const std::string manifest = opening + line();
    const auto with_size = [&](const std::string& size) {
        return tar_of({{"manifest.jsonl", manifest}, {sound_name, sound}}, [&](std::string& header) {
            if (header.starts_with("audio")) header.replace(124, 11, size);
        });
    };
    for (const char* size : {"77777777777", "99999999999"})
        expect_refused(with_size(size), "not as long as its entry says");
    expect_refused(with_size("-0000000001"), "negative size");
    expect_refused(tar_of({{"manifest.jsonl", manifest}, {sound_name, sound}}).substr(0, 2048 + 5), "Truncated");
    expect_refused(with_size("00000000012"), "not as long as its entry says");
    expect_refused(tar_of({{"manifest.jsonl", opening + line("", 3)}, {sound_name, sound}}), "not as long");
    expect_refused(tar_of({{"manifest.jsonl", manifest}, {sound_name, "other bytes"}}), "not those of its name");
    expect_refused(tar_of({{"manifest.jsonl", manifest}}), "is missing");
    expect_refused(tar_of({{"manifest.jsonl", manifest}, {sound_name, sound}, {sound_name, sound}}), "there twice");
    expect_refused(tar_of({{sound_name, sound}, {"manifest.jsonl", manifest}}), "first file is not");
    for (const std::string& bytes : {std::string(), std::string(4096, 'x')})
        expect_refused(bytes, "is no tar archive");
    expect_refused(std::string(4096, '\0'), "first file is not");
}

TEST_F(Archive, RefusesManifestsThatMeanNothing) {
    expect_manifest_refused("", "empty");
    expect_manifest_refused("{}\n", "schema is none");
    expect_manifest_refused("{\"schema\":\"stridor.library-archive/3\"}\n", "this program reads");
    expect_manifest_refused(opening + "[]\n", "no JSON object");
    expect_manifest_refused(opening + "{\"audio\n", "no JSON object");
    expect_manifest_refused(opening + std::string(100000, '[') + "\n", "no entry");
    expect_manifest_refused(opening + std::string(5U << 20U, ' ') + "\n", "longer than 4 MiB");
    expect_manifest_refused(opening + line(",\"color\":1"), "\"color\" is no field");
    expect_manifest_refused(opening + line(",\"preload\":\"20\""), "wrong kind");
    expect_manifest_refused(opening + line(",\"preload\":-20"), "out of range");
    expect_manifest_refused(opening + line(",\"preload\":1e999"), "");
    expect_manifest_refused(opening + line(",\"system\":\"a\\u001b[31m\""), "control character");
    expect_manifest_refused(opening + line(",\"recorded\":\"moon\""), "not one of its choices");
    expect_manifest_refused(opening + line(",\"figures\":[{\"name\":\"preload\",\"unit\":\"N\",\"value\":1}]"), "name");
    expect_manifest_refused(opening + line(",\"figures\":[{\"name\":\"a') --\",\"unit\":\"N\",\"value\":1}]"), "name");
    expect_manifest_refused(opening + line(",\"figures\":3"), "wrong kind");
    for (const char* bytes : {"-1", "1.5", "18446744073709551616", "1e96", "\"1\"", "null"})
        expect_manifest_refused(opening + line(std::string(",\"bytes\":") + bytes), "no number of bytes");
    expect_manifest_refused(opening + "{\"audio\":\"ab\",\"format\":\"wav\",\"bytes\":1}\n", "does not name its audio");
}

// whatever is damaged: the archive is refused and leaves nothing, or is taken whole
TEST_F(Archive, IsTakenWholeOrNotAtAllHoweverItIsDamaged) {
    const std::string good =
        tar_of({{"manifest.jsonl", opening + line(",\"system\":\"brake\",\"preload\":20.5")}, {sound_name, sound}});
    CounterRandom random(3);
    Library library = open();
    for (int trial = 0; trial < 1500; ++trial) {
        std::string bytes = good.substr(0, random.one_in(4) ? random.below(good.size()) : good.size());
        for (std::size_t k = random.below(3); k < 3 && !bytes.empty(); ++k)
            bytes[random.below(bytes.size())] = static_cast<char>(random.next());
        write_bytes(archive_, bytes);
        try {
            import_library(library, archive_);
            EXPECT_EQ(broken_promise(library, has_its_bytes), "");
            for (const Entry& entry : library.find({}))
                library.remove(std::span(&entry.id, 1));
        } catch (const Error&) {
        }
        ASSERT_EQ(library.size(), 0);
        ASSERT_TRUE(files_of(library).empty()) << trial;
    }
}

TEST_F(Archive, LeavesNothingOnAFullDisk) {
    const std::string large(300000, 'l');
    Library source = open("source.sqlite");
    const Entry entry = add_bytes(source, sound_, large);
    Library library = open();
    export_library(source, std::span(&entry, 1), archive_);
    {
        const support::FullDisk full(200000);
        EXPECT_EQ(thrown_by([&] { import_library(library, archive_); }).kind, ErrorKind::io);
        EXPECT_EQ(thrown_by([&] { export_library(source, std::span(&entry, 1), folder_ / "new.tar"); }).kind,
                  ErrorKind::io);
    }
    EXPECT_TRUE(files_of(library).empty());
    EXPECT_FALSE(fs::exists(folder_ / "new.tar"));
    EXPECT_EQ(import_library(library, archive_).added.size(), 1U);
}

}  // namespace
}  // namespace stridor::io
