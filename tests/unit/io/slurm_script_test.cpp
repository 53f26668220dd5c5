#include "stridor/io/chart/slurm_script.hpp"

#include "support/error_text.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace stridor::io
