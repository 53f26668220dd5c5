#include "stridor/noise_library/add_recordings.hpp"

#include "stridor/base/error.hpp"
#include "unit/noise_library/library_folder.hpp"

namespace stridor::noise_library {
namespace {

namespace fs = std::filesystem;

// files that say "broken" are
void probe(const fs::path& file, Entry& entry) {
    if (bytes_of(file) == "broken") throw Error(ErrorKind::input, {"it is broken", "", ""});
    entry.duration = 1.0;
}

Adding adding() {
    Adding adding;
    adding.probe = probe;
    adding.begin = [](const fs::path&) {};
    adding.added = [](const Entry&) {};
    adding.end = [] {};
    return adding;
}

class AddRecordings : public LibraryFile {
protected:
    fs::path file(const std::string& name, const std::string& bytes) {
        std::ofstream(folder_ / name) << bytes;
        return folder_ / name;
    }
    support::ScratchFolder folder_;
};

ErrorKind kind_of(const std::exception_ptr& error) {
    try {
        std::rethrow_exception(error);
    } catch (const Error& each) {
        return each.kind();
    }
}

TEST_F(AddRecordings, GoesPastWhatIsKnownAndWhatIsBroken) {
    Library library = open();
    recordings::RecordingFiles files;
    files.files = {file("a.wav", "one"), file("b.wav", "broken"), file("c.wav", "one"), file("d.wav", "two")};
    const Added added = add_recordings(library, files, adding());
    EXPECT_EQ(added.arrivals.added.size(), 2U);
    ASSERT_EQ(added.arrivals.known.size(), 1U);
    EXPECT_EQ(added.arrivals.known[0].id, added.arrivals.added[0]);
    ASSERT_EQ(added.arrivals.refused.size(), 1U);
    EXPECT_EQ(added.arrivals.refused[0].reason, files.files[1].string() + ": it is broken");
    EXPECT_EQ(added.arrivals.left, 0U);
    EXPECT_EQ(kind_of(added.ended_by), ErrorKind::input);  // what was refused is told at the end
}

TEST_F(AddRecordings, AddsAgainWhatIsAskedFor) {
    Library library = open();
    Adding again = adding();
    again.known = Known::added_again;
    recordings::RecordingFiles files;
    files.files = {file("a.wav", "one"), file("b.wav", "one")};
    const Added added = add_recordings(library, files, again);
    EXPECT_EQ(added.arrivals.added.size(), 2U);
    EXPECT_FALSE(added.ended_by);
}

TEST_F(AddRecordings, ThrowsTheErrorOfAFileThatIsAlone) {
    Library library = open();
    Adding alone = adding();
    alone.refused = Refused::thrown;
    recordings::RecordingFiles files;
    files.files = {file("b.wav", "broken")};
    const Added added = add_recordings(library, files, alone);
    EXPECT_TRUE(added.arrivals.refused.empty());
    EXPECT_EQ(added.arrivals.left, 1U);
    EXPECT_EQ(kind_of(added.ended_by), ErrorKind::input);
}

TEST_F(AddRecordings, KeepsWhatIsInWhenItIsStopped) {
    Library library = open();
    std::stop_source stop;
    Adding stopped = adding();
    stopped.stop = stop.get_token();
    stopped.end = [&] { stop.request_stop(); };
    recordings::RecordingFiles files;
    files.files = {file("a.wav", "one"), file("b.wav", "two")};
    const Added added = add_recordings(library, files, stopped);
    EXPECT_EQ(added.arrivals.added.size(), 1U);
    EXPECT_EQ(added.arrivals.left, 1U);
    EXPECT_EQ(kind_of(added.ended_by), ErrorKind::interrupted);
    EXPECT_EQ(library.size(), 1);
}

}  // namespace
}  // namespace stridor::noise_library
