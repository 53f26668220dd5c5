#include "stridor/io/chart/share_texts.hpp"

#include "support/error_text.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace stridor::io {
namespace {

using support::thrown_by;

SlurmJob small_job() {
    return {"/usr/bin/stridor", "/home/ann/pair", 16, 4, "2:00:00"};
}

TEST(SlurmScript, HasEachTaskComputeItsShareAndTheMergeFollow) {
    const std::string script = slurm_script(small_job());
    EXPECT_TRUE(script.starts_with("#!/bin/bash\n#SBATCH --job-name=stridor-pair\n"));
    for (const char* part : {"shares=16\n", "threads=4\n", "limits=(--time=2:00:00)\n", "folder='/home/ann/pair'\n",
                             "--array=\"${tasks:-0-$((shares - 1))}\" --requeue --signal=B:TERM@30",
                             "chart-status \"$folder\" --lacking \"$shares\"", "exec \"$program\" chart",
                             "--dependency=\"afterany:$array\"", "--shard \"$SLURM_ARRAY_TASK_ID/$shares\""})
        EXPECT_NE(script.find(part), std::string::npos) << part << " in " << script;
}

TEST(SlurmScript, LeavesTheTimeToThePartition) {
    SlurmJob job = small_job();
    job.time.clear();
    EXPECT_NE(slurm_script(job).find("limits=()\n"), std::string::npos);
}

TEST(SlurmScript, LetsNoPathOutOfItsQuotes) {
    SlurmJob job = small_job();
    job.folder = "/home/ann/it's; rm -rf $HOME";
    const std::string script = slurm_script(job);
    EXPECT_NE(script.find("folder='/home/ann/it'\\''s; rm -rf $HOME'\n"), std::string::npos) << script;
    EXPECT_NE(script.find("#SBATCH --job-name=stridor-it-s--rm--rf--HOME\n"), std::string::npos) << script;
    job.folder = "/home/ann/a\nb";
    EXPECT_TRUE(thrown_by([&] { slurm_script(job); }).says("has a line end"));
}

TEST(SlurmScript, RefusesATimeThatSlurmDoesNotRead) {
    for (const char* time : {"2h", "-1", "1:", "$(reboot)", "two hours", "1 2"}) {
        SlurmJob job = small_job();
        job.time = time;
        EXPECT_TRUE(thrown_by([&] { slurm_script(job); }).says("is no time limit")) << time;
    }
    for (const char* time : {"30", "2:00:00", "1-12", "1-12:30:00"}) {
        SlurmJob job = small_job();
        job.time = time;
        EXPECT_NO_THROW(slurm_script(job)) << time;
    }
}

// the chart in so many shares, those of these numbers lacking cells
sweep::ChartState state_of(std::size_t count, const std::vector<std::size_t>& lacking) {
    sweep::ChartState state;
    for (std::size_t index = 0; index < count; ++index) {
        sweep::StoreState share;
        share.share = sweep::Share{index, count};
        share.standing = sweep::StoreStanding::complete;
        state.shares.push_back(share);
    }
    for (const std::size_t index : lacking)
        state.shares[index].missing = 7;
    return state;
}

TEST(LackingText, NamesTheSharesAsAnArray) {
    EXPECT_EQ(lacking_text(state_of(16, {0, 3, 7, 8, 9}), 16), "0,3,7-9");
    EXPECT_EQ(lacking_text(state_of(3, {2}), 3), "2");
    EXPECT_EQ(lacking_text(state_of(3, {}), 3), "");
}

TEST(LackingText, NamesAllWhereNoneOfThatNumberWasBegun) {
    EXPECT_EQ(lacking_text({}, 16), "0-15");
    EXPECT_EQ(lacking_text(state_of(3, {2}), 16), "0-15");
    sweep::ChartState merged;
    merged.is_merged = true;
    EXPECT_EQ(lacking_text(merged, 16), "");
}

TEST(LackingText, NamesAShareThatCannotBeRead) {
    sweep::ChartState state = state_of(3, {});
    state.shares[1].standing = sweep::StoreStanding::unreadable;
    EXPECT_EQ(lacking_text(state, 3), "1");
}

}  // namespace
}  // namespace stridor::io
