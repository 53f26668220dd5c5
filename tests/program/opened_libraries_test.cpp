// Libraries that few commands need, netCDF, cairo and pango, on a machine where they are damaged: files of their names
// that the loader meets first hold nothing.

#include "support/process.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace stridor {
namespace {

using support::Finished;

class OpenedLibraries : public testing::Test {
protected:
    OpenedLibraries() {
        for (const std::string name : {STRIDOR_NETCDF_LIBRARY, STRIDOR_CAIRO_LIBRARY, STRIDOR_PANGOCAIRO_LIBRARY})
            support::write_text(folder_ / name, "");
        support::write_text(folder_ / "case.toml", support::read_text(STRIDOR_SOURCE_DIR "/cases/squeal.toml"));
    }

    Finished run(const std::vector<std::string>& arguments) const {
        return support::run({arguments, folder_.path(), {}, {}, {{"LD_LIBRARY_PATH", folder_.path().string()}}});
    }

    // says what cannot be done, and what to install for it; leaves nothing behind
    void expect_missing(const std::string& file, const std::string& problem, const std::string& package,
                        const Finished& finished) const {
        EXPECT_EQ(finished.exit_code, 5);
        EXPECT_NE(finished.err.find(problem), std::string::npos) << finished.err;
        EXPECT_NE(finished.err.find("apt install " + package), std::string::npos) << finished.err;
        EXPECT_FALSE(exists(folder_ / file));
    }

    support::ScratchFolder folder_;
};

TEST_F(OpenedLibraries, AreNotNeededToSimulate) {
    EXPECT_EQ(run({"--version"}).exit_code, 0);
    EXPECT_EQ(run({"simulate", "case.toml", "--trace", "motion.csv"}).exit_code, 0);
}

TEST_F(OpenedLibraries, AreAskedForByName) {
    expect_missing("motion.nc", "netCDF files cannot be made (", "libnetcdf",
                   run({"simulate", "case.toml", "--trace", "motion.nc"}));
    expect_missing("motion.png", "cannot be drawn (", "lib", run({"simulate", "case.toml", "--figure", "motion.png"}));
}

}  // namespace
}  // namespace stridor
