#include "stridor/storage/new_file.hpp"

#include "stridor/base/error.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "support/expected_error.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

namespace stridor::storage {
namespace {

using support::ScratchFolder;

TEST(WholeFolder, AppearsWhenItIsWhole) {
    const ScratchFolder scratch;
    const std::filesystem::path path = scratch / "chart.zarr";
    WholeFolder folder(path);
    write_file((folder.temporary() / "a").string(), "one");
    EXPECT_FALSE(std::filesystem::exists(path));
    folder.commit();
    EXPECT_EQ(read_file((path / "a").string()), "one");
    EXPECT_EQ(scratch.files(), 1);
}

TEST(WholeFolder, TakesThePlaceOfTheFormerOne) {
    const ScratchFolder scratch;
    const std::filesystem::path path = scratch / "chart.zarr";
    for (const char* name : {"first", "second"}) {
        WholeFolder folder(path);
        write_file((folder.temporary() / name).string(), name);
        folder.commit();
    }
    EXPECT_FALSE(std::filesystem::exists(path / "first"));
    EXPECT_EQ(read_file((path / "second").string()), "second");
    EXPECT_EQ(scratch.files(), 1);
}

TEST(WholeFolder, LeavesNothingBehindWhereItIsGivenUp) {
    const ScratchFolder scratch;
    const std::filesystem::path path = scratch / "chart.zarr";
    {
        WholeFolder folder(path);
        write_file((folder.temporary() / "a").string(), "one");
    }
    EXPECT_EQ(scratch.files(), 0);
}

TEST(WholeFolder, BeginsAnewAfterAKill) {
    const ScratchFolder scratch;
    const std::filesystem::path path = scratch / "chart.zarr";
    std::filesystem::create_directory(scratch / ".stridor-chart.zarr.tmp");
    write_file((scratch / ".stridor-chart.zarr.tmp/half").string(), "ha");
    WholeFolder folder(path);
    folder.commit();
    EXPECT_FALSE(std::filesystem::exists(path / "half"));
}

TEST(WholeFolder, SaysWhyItCannotBeBegun) {
    const ScratchFolder scratch;
    const auto error = support::error_of([&] { const WholeFolder folder(scratch / "no/chart.zarr"); });
    ASSERT_TRUE(error);
    EXPECT_EQ(error->kind(), ErrorKind::io);
}

}  // namespace
}  // namespace stridor::storage
