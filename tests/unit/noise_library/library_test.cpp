#include "stridor/noise_library/library.hpp"

#include "stridor/noise_library/field.hpp"
#include "support/error_text.hpp"
#include "unit/noise_library/library_folder.hpp"

#include <algorithm>
#include <cmath>

namespace stridor::noise_library {
namespace {

namespace fs = std::filesystem;
using support::Thrown;
using support::thrown_by;

TEST_F(LibraryFile, VisitsWhatItFindsInTheSameOrder) {
    Library library = open();
    for (int k = 0; k < 600; ++k) {
        Entry entry = full_entry();
        entry.preload = (k * 37) % 101;
        add_bytes(library, sound_, std::to_string(k), entry);
    }
    Query query = whole();
    query.sort = "preload";
    query.conditions = parse_conditions("preload < 90 N");
    for (const std::size_t limit : {std::size_t{0}, std::size_t{300}}) {
        query.limit = limit;
        const std::vector<Entry> found = library.find(query);
        EXPECT_EQ(found.size(), limit == 0 ? static_cast<std::size_t>(library.count(query)) : limit);
        std::size_t place = 0;
        library.visit(query, [&](const Entry& entry) {
            ASSERT_LT(place, found.size());
            EXPECT_EQ(entry.id, found[place].id);
            EXPECT_EQ(digest(entry), digest(found[place]));
            ++place;
        });
        EXPECT_EQ(place, found.size());
    }
}

TEST_F(LibraryFile, GivesBackAnEntryInEveryWordAndBit) {
    Entry added;
    {
        Library library = open();
        added = add_bytes(library, sound_, "bytes", full_entry());
    }
    Library library = open(Access::read);
    const std::vector<Entry> back = library.find(whole());
    ASSERT_EQ(back.size(), 1U);
    EXPECT_EQ(digest(back[0]), digest(added));
    EXPECT_EQ(back[0].id, added.id);
    EXPECT_EQ(back[0].figures, added.figures);
    EXPECT_EQ(back[0].file, "sound.wav");
    EXPECT_EQ(bytes_of(library.audio_file(back[0])), "bytes");
    EXPECT_EQ(broken_promise(library, has_its_bytes), "");
}

TEST_F(LibraryFile, NamesAudioByItsContentBesideIt) {
    Library library = open();
    const Entry entry = add_bytes(library, folder_ / "A.WAV", "abc");
    EXPECT_EQ(library.audio_file(entry), folder_ / "library.audio" / "ba" /
                                             "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad.wav");
    EXPECT_EQ(format_of("x.tar.gz"), "gz");
    EXPECT_EQ(format_of("x"), "audio");
    EXPECT_EQ(format_of("x.w/../v"), "audio");
    EXPECT_EQ(format_of("x.w v"), "audio");
}

TEST_F(LibraryFile, RefusesASoundItHasUnlessToldTo) {
    Library library = open();
    add_bytes(library, sound_, "bytes");
    const Thrown thrown = thrown_by([&] { add_bytes(library, sound_, "bytes"); });
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_TRUE(thrown.says("entry 1 has this sound")) << thrown.message;
    const Entry again = add_recording(library, {sound_, {}, Twins::accept}, probe_bytes);
    EXPECT_EQ(again.id, 2);
    EXPECT_EQ(files_of(library).size(), 1U);
    // the sound stays as long as one of them has it
    library.remove(std::vector<std::int64_t>{1});
    EXPECT_EQ(broken_promise(library, has_its_bytes), "");
    library.remove(std::vector<std::int64_t>{2});
    EXPECT_TRUE(files_of(library).empty());
}

TEST_F(LibraryFile, NeverUsesAnIdTwice) {
    Library library = open();
    const std::int64_t first = add_bytes(library, sound_, "one").id;
    library.remove(std::vector<std::int64_t>{first});
    EXPECT_GT(add_bytes(library, sound_, "two").id, first);
}

TEST_F(LibraryFile, KeepsNothingOfWhatIsNoSound) {
    Library library = open();
    write_bytes(sound_, "bytes");
    const Probe refuse = [](const fs::path&, Entry&) { throw Error(ErrorKind::input, {"no sound", "", ""}); };
    EXPECT_TRUE(thrown_by([&] { add_recording(library, {sound_, {}}, refuse); }).says("no sound"));
    EXPECT_EQ(library.size(), 0);
    EXPECT_TRUE(files_of(library).empty());
}

TEST_F(LibraryFile, RefusesAFileThatIsStillBeingWritten) {
    Library library = open();
    write_bytes(sound_, "bytes");
    const Probe grow = [](const fs::path& file, Entry&) { std::ofstream(file, std::ios::app) << "more"; };
    EXPECT_TRUE(thrown_by([&] { add_recording(library, {sound_, {}}, grow); }).says("still being written"));
    EXPECT_TRUE(files_of(library).empty());
}

TEST_F(LibraryFile, ChangesEntriesAllOrNone) {
    Library library = open();
    const std::vector<std::int64_t> ids{add_bytes(library, sound_, "one", full_entry()).id,
                                        add_bytes(library, sound_, "two").id};
    const std::vector<Entry> changed = library.edit(ids, [](Entry& entry) {
        entry.preload = 7.0;
        entry.audio = "cannot be changed";
        entry.figures.clear();
    });
    EXPECT_EQ(changed.at(0).preload, 7.0);
    const std::vector<Entry> back = library.get(ids);
    EXPECT_EQ(digest(back[0]), digest(changed[0]));
    EXPECT_TRUE(back[0].figures.empty());
    EXPECT_EQ(broken_promise(library, has_its_bytes), "");

    EXPECT_THROW(library.edit(ids,
                              [](Entry& entry) {
                                  if (entry.id == 2) throw Error(ErrorKind::input, {"no", "", ""});
                                  entry.preload = 9.0;
                              }),
                 Error);
    EXPECT_EQ(library.get(ids)[0].preload, 7.0);
}

TEST_F(LibraryFile, NamesAnIdThatIsNotThere) {
    Library library = open();
    EXPECT_TRUE(thrown_by([&] { library.get(std::vector<std::int64_t>{3}); }).says("the library is empty"));
    add_bytes(library, sound_, "one");
    const std::vector<std::int64_t> ids{1, 3};
    const Thrown thrown = thrown_by([&] { library.remove(ids); });
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_TRUE(thrown.says("there is no entry 3") && thrown.says("1 entry, the last is 1")) << thrown.message;
    EXPECT_EQ(library.size(), 1);
    EXPECT_EQ(broken_promise(library, has_its_bytes), "");
}

}  // namespace
}  // namespace stridor::noise_library
