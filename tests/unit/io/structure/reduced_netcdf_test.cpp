#include "stridor/io/structure/reduced_netcdf.hpp"

#include "stridor/reduction/craig_bampton.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "structure_texts.hpp"
#include "support/scratch_folder.hpp"

#include <cstdlib>

namespace stridor::io::structure {
namespace {

reduction::Reduction reduced_block() {
    reduction::ElasticPart part = block_part();
    part.damping = 1e-5 * part.stiffness;
    return craig_bampton(part,
                         {.boundary = named_rows(part, "FOOT"), .modes = 5, .recovered = named_rows(part, "1030")});
}

TEST(ReducedPart, ComesBackAsItWasWritten) {
    const support::ScratchFolder folder;
    const std::string path = folder / "block.nc";
    const reduction::Reduction wrote = reduced_block();
    write_reduced_part(path, wrote, "block.sti");
    EXPECT_TRUE(is_netcdf(storage::read_file(path)));
    const reduction::Reduction read = read_reduced_part(path);
    EXPECT_NO_THROW(expect_sound(read.part));
    EXPECT_EQ(read.part.labels, wrote.part.labels);
    EXPECT_EQ((read.part.stiffness - wrote.part.stiffness).norm(), 0.0);
    EXPECT_EQ((read.part.mass - wrote.part.mass).norm(), 0.0);
    EXPECT_EQ((read.part.damping - wrote.part.damping).norm(), 0.0);
    EXPECT_EQ(read.part.positions, wrote.part.positions);
    EXPECT_EQ(read.boundary_rows, 36);
    EXPECT_EQ(read.inertia, wrote.inertia);
    EXPECT_EQ(read.mode_frequencies, wrote.mode_frequencies);
    EXPECT_EQ(read.recovered, wrote.recovered);
    EXPECT_EQ((read.recovery - wrote.recovery).norm(), 0.0);
    ASSERT_NE(find_set(read.part, "FOOT"), nullptr);
    EXPECT_EQ(find_set(read.part, "FOOT")->nodes.size(), 12U);
}

TEST(ReducedPart, OfTheSameNumbersHasTheSameBytes) {
    const support::ScratchFolder folder;
    const std::string one = folder / "a.nc";
    const std::string two = folder / "b.nc";
    write_reduced_part(one, reduced_block(), "x");
    write_reduced_part(two, reduced_block(), "x");
    EXPECT_EQ(storage::read_file(one), storage::read_file(two));
}

TEST(ReducedPart, IsRefusedWhereItIsNone) {
    const support::ScratchFolder folder;
    const std::string path = folder / "x.nc";
    const auto refused = [&](const std::string& bytes) {
        storage::write_file(path, bytes);
        const auto thrown = support::thrown_by([&] { read_reduced_part(path); });
        EXPECT_EQ(thrown.kind, ErrorKind::input) << thrown.message;
        return thrown.message;
    };
    EXPECT_NE(refused("nothing of the kind").find("it is no reduced part"), std::string::npos);
    write_reduced_part(path, reduced_block(), "x");
    const std::string bytes = storage::read_file(path);
    refused(bytes.substr(0, bytes.size() / 2));
}

bool is_same(const reduction::Reduction& a, const reduction::Reduction& b) {
    return a.part.labels == b.part.labels && (a.part.stiffness - b.part.stiffness).norm() == 0.0 &&
           (a.part.mass - b.part.mass).norm() == 0.0 && (a.part.damping - b.part.damping).norm() == 0.0 &&
           a.part.positions == b.part.positions && a.mode_frequencies == b.mode_frequencies && a.inertia == b.inertia &&
           a.method == b.method && a.recovered == b.recovered && (a.recovery - b.recovery).norm() == 0.0;
}

// whatever bit is wrong, the end is the part that was written or an error
TEST(ReducedPart, IsWhatWasWrittenOrIsRefused) {
    const support::ScratchFolder folder;
    const std::string path = folder / "x.nc";
    const reduction::Reduction wrote = reduced_block();
    write_reduced_part(path, wrote, "x");
    const std::string bytes = storage::read_file(path);
    const std::size_t flips = std::getenv("STRIDOR_FULL") != nullptr ? 4000 : 100;
    int refused = 0;
    for (std::size_t k = 0; k < flips; ++k) {
        const std::size_t at = k * (bytes.size() / flips) + k % 7;
        std::string damaged = bytes;
        damaged[at] = static_cast<char>(damaged[at] ^ (1U << k % 8));
        storage::write_file(path, damaged);
        try {
            EXPECT_TRUE(is_same(read_reduced_part(path), wrote)) << "byte " << at;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::input) << error.what();
            ++refused;
        }
    }
    EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace stridor::io::structure
