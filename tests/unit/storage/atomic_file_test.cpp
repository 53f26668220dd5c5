#include "stridor/storage/atomic_file.hpp"

#include "support/expected_error.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <fstream>
#include <thread>

namespace stridor::storage {

using support::error_of;
using support::expect_error;
using support::ScratchFolder;
namespace {

using support::FullDisk;

TEST(AtomicFile, GivesBackWhatWasWritten) {
    const ScratchFolder scratch;
    const std::string bytes("a\0b\r\n\xff", 6);
    write_file((scratch / "f").string(), bytes);
    EXPECT_EQ(read_file((scratch / "f").string()), bytes);
    write_file((scratch / "f").string(), "");
    EXPECT_EQ(read_file((scratch / "f").string()), "");
    EXPECT_EQ(scratch.files(), 1);
}

TEST(PiecewiseFile, AppearsAsAWholeOrNotAtAll) {
    const ScratchFolder scratch;
    const std::string path = (scratch / "f").string();
    write_file(path, "old");
    {
        PiecewiseFile file(path);
        file.write("half");
    }
    EXPECT_EQ(read_file(path), "old");
    EXPECT_EQ(scratch.files(), 1);
    PiecewiseFile file(path);
    std::string wanted;
    for (int k = 0; k < 3000; ++k) {
        const std::string piece(static_cast<std::size_t>(k % 100), static_cast<char>('a' + k % 26));
        file.write(piece);
        wanted += piece;
    }
    const std::string long_piece(200000, 'x');
    file.write(long_piece);
    wanted += long_piece;
    EXPECT_EQ(file.size(), wanted.size());
    for (const std::size_t offset : {std::size_t{0}, std::size_t{70000}, wanted.size() - 4}) {
        file.overwrite(offset, "HEAD");
        wanted.replace(offset, 4, "HEAD");
    }
    EXPECT_EQ(read_file(path), "old");
    file.commit();
    EXPECT_EQ(read_file(path), wanted);
    EXPECT_EQ(scratch.files(), 1);
}

TEST(PiecewiseFile, CannotGoBackInADevice) {
    PiecewiseFile file("/dev/full");
    file.write("x");
    EXPECT_EQ(error_of([&] { file.overwrite(0, "y"); })->kind(), ErrorKind::io);
}

TEST(AtomicFile, LeavesTheOldFileWhenTheDiskIsFull) {
    const ScratchFolder scratch;
    const std::string path = (scratch / "chart.csv").string();
    write_file(path, "old");
    std::optional<Error> error;
    {
        const FullDisk disk(4096);
        error = error_of([&] { write_file(path, std::string(100000, 'x')); });
    }
    ASSERT_TRUE(error);
    EXPECT_EQ(error->kind(), ErrorKind::io);
    EXPECT_NE(std::string(error->what()).find(path), std::string::npos);
    EXPECT_EQ(read_file(path), "old");
    EXPECT_EQ(scratch.files(), 1) << "the temporary file is still there";
}

TEST(AtomicFile, GivesAnotherWriterATemporaryName) {
    const ScratchFolder scratch;
    const std::string path = (scratch / "f").string();
    write_file(path, "old");
    PiecewiseFile file(path);
    const std::string temporary = file.temporary_name(10);
    EXPECT_EQ(std::filesystem::file_size(temporary), 10U);
    std::ofstream(temporary, std::ios::trunc) << "new";
    EXPECT_EQ(read_file(path), "old");
    file.commit();
    EXPECT_EQ(read_file(path), "new");
    EXPECT_EQ(scratch.files(), 1);
}

TEST(AtomicFile, GivesNoNameWhereTheRoomIsMissing) {
    const ScratchFolder scratch;
    {
        const FullDisk disk(4096);
        const auto error = error_of([&] { PiecewiseFile((scratch / "f").string()).temporary_name(10000); });
        ASSERT_TRUE(error);
        EXPECT_EQ(error->kind(), ErrorKind::io);
    }
    EXPECT_EQ(scratch.files(), 0);
    EXPECT_TRUE(error_of([] { PiecewiseFile("/dev/null").temporary_name(0); }));
}

// a process that writes half of a file and dies; it may wait until a byte comes
pid_t writer_that_dies(const std::string& path, int go = -1) {
    const pid_t id = fork();
    if (id != 0) return id;
    PiecewiseFile file(path);
    file.write(std::string(200000, 'h'));
    char byte = 0;
    if (go >= 0 && read(go, &byte, 1) == 1) {
        file.commit();
        _exit(0);
    }
    raise(SIGKILL);
    _exit(1);
}

TEST(AtomicFile, RemovesWhatTheDeadLeft) {
    const ScratchFolder scratch;
    for (int k = 0; k < 3; ++k)
        waitpid(writer_that_dies((scratch / "f").string()), nullptr, 0);
    EXPECT_EQ(scratch.files(), 1) << "each cleared up after the one before";
    write_file((scratch / "f").string(), "whole");
    EXPECT_EQ(scratch.files(), 1);
    EXPECT_EQ(read_file((scratch / "f").string()), "whole");
}

TEST(AtomicFile, SparesTheLiving) {
    const ScratchFolder scratch;
    std::array<int, 2> go{};
    ASSERT_EQ(pipe(go.data()), 0);
    const pid_t other = writer_that_dies((scratch / "theirs").string(), go[0]);
    // theirs is there and locked once its bytes are
    while (scratch.files() == 0 ||
           std::filesystem::file_size(*std::filesystem::directory_iterator(scratch.path())) == 0)
        std::this_thread::yield();
    PiecewiseFile ours((scratch / "ours").string());
    ours.write("ours");
    write_file((scratch / "f").string(), "whole");
    EXPECT_EQ(scratch.files(), 3);
    ours.commit();
    ASSERT_EQ(write(go[1], "g", 1), 1);
    int status = -1;
    waitpid(other, &status, 0);
    EXPECT_EQ(status, 0);
    EXPECT_EQ(read_file((scratch / "ours").string()), "ours");
    EXPECT_EQ(read_file((scratch / "theirs").string()).size(), 200000U);
    EXPECT_EQ(scratch.files(), 3);
    for (const int end : go)
        close(end);
}

TEST(AtomicFile, SparesWhatOnlyHasItsName) {
    const ScratchFolder scratch;
    std::string name;
    {
        PiecewiseFile file((scratch / "f").string());
        name = std::filesystem::path(file.temporary_name(1)).filename().string();
    }
    const std::string begins = name.substr(0, name.rfind('-', name.rfind('-') - 1) + 1);  // ".stridor-HOST-"
    const std::string mine = (scratch / "precious").string();
    write_file(mine, "precious");
    std::filesystem::create_symlink(mine, scratch / (begins + "7-0.tmp"));
    std::filesystem::create_hard_link(mine, scratch / (begins + "7-1.tmp"));
    std::filesystem::create_directory(scratch / (begins + "7-2.tmp"));
    ASSERT_EQ(mkfifo((scratch / (begins + "7-3.tmp")).c_str(), 0600), 0);
    for (const char* other : {".stridor-00000000-7-0.tmp", ".stridor-7-0.tmp", ".stridor-.tmp"})
        std::ofstream(scratch / other) << "x";
    for (const char* other : {"7.tmp", "7-0.txt", "7-.tmp", "-7.tmp", "7-0-1.tmp", "seven-0.tmp"})
        std::ofstream(scratch / (begins + other)) << "x";
    const long files = scratch.files();
    write_file((scratch / "f").string(), "whole");
    EXPECT_EQ(scratch.files(), files + 1);
    EXPECT_EQ(read_file(mine), "precious");
    std::ofstream(scratch / (begins + "7-9.tmp")) << "what a dead one left";
    write_file((scratch / "f").string(), "whole");
    EXPECT_EQ(scratch.files(), files + 1);
}

TEST(AtomicFile, SaysThatTheDiskIsFull) {
    const auto error = error_of([] { write_file("/dev/full", "x"); });
    expect_error(error, "cannot write \"/dev/full\" (the disk is full)", "");
    EXPECT_EQ(error->kind(), ErrorKind::io);
}

TEST(AtomicFile, IsNotWaitedForInAPipeOnceASignalCame) {
    const ScratchFolder scratch;
    const std::string pipe = (scratch / "pipe").string();
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    struct sigaction action {
    }, before{};
    action.sa_handler = [](int) {};
    action.sa_flags = SA_RESTART;
    ASSERT_EQ(sigaction(SIGALRM, &action, &before), 0);
    const itimerval often{{0, 20'000}, {0, 20'000}};
    const itimerval never{};
    setitimer(ITIMER_REAL, &often, nullptr);
    const auto error = error_of([&] { write_file(pipe, "x"); });
    setitimer(ITIMER_REAL, &never, nullptr);
    sigaction(SIGALRM, &before, nullptr);
    ASSERT_TRUE(error.has_value());
    EXPECT_EQ(error->kind(), ErrorKind::interrupted);
}

TEST(AtomicFile, WritesToADeviceInsteadOfReplacingIt) {
    write_file("/dev/null", "x");
    struct stat status {};
    ASSERT_EQ(stat("/dev/null", &status), 0);
    EXPECT_TRUE(S_ISCHR(status.st_mode));
}

TEST(AtomicFile, KeepsPermissionsAndFollowsLinks) {
    const ScratchFolder scratch;
    write_file((scratch / "target").string(), "old");
    ASSERT_EQ(chmod((scratch / "target").string().c_str(), 0640), 0);
    std::filesystem::create_symlink("target", (scratch / "link").string());
    write_file((scratch / "link").string(), "new");
    EXPECT_TRUE(std::filesystem::is_symlink((scratch / "link").string()));
    EXPECT_EQ(read_file((scratch / "target").string()), "new");
    struct stat status {};
    ASSERT_EQ(stat((scratch / "target").string().c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

TEST(AtomicFile, TakesTheLongestNameAFolderAllows) {
    const ScratchFolder scratch;
    const std::string path = (scratch / std::string(255, 'n')).string();
    write_file(path, "x");
    EXPECT_EQ(read_file(path), "x");
}

TEST(AtomicFile, NamesWhatIsWrongWithThePath) {
    const ScratchFolder scratch;
    write_file((scratch / "file").string(), "x");
    const std::string missing = (scratch / "missing/f").string();
    const std::string below_file = (scratch / "file/f").string();
    const std::string folder = (scratch / ".").string();
    expect_error(error_of([&] { write_file(missing, "x"); }), "no such file or folder", "");
    expect_error(error_of([&] { write_file(below_file, "x"); }), "a part of its path is not a folder", "");
    expect_error(error_of([&] { write_file(folder, "x"); }), "it is a folder", "");
    expect_error(error_of([&] { read_file(missing); }), "cannot read \"" + missing + "\" (no such file or folder)", "");
    expect_error(error_of([&] { read_file(folder); }), "it is a folder", "");
}

}  // namespace
}  // namespace stridor::storage
