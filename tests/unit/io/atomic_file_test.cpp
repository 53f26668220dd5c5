#include "stridor/io/atomic_file.hpp"

#include "io_support.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

namespace stridor::io {
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

TEST(AtomicFile, SaysThatTheDiskIsFull) {
    const auto error = error_of([] { write_file("/dev/full", "x"); });
    expect_error(error, "cannot write \"/dev/full\" (the disk is full)", "");
    EXPECT_EQ(error->kind(), ErrorKind::io);
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
}  // namespace stridor::io
