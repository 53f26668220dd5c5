#include "stridor/chart/process.hpp"

#include "support/error_text.hpp"

#include <gtest/gtest.h>

namespace stridor::chart {
namespace {

using support::thrown_by;

TEST(Process, PassesBytesBothWays) {
    // far more than any buffer between the two holds
    std::string bytes(5'000'000, 'x');
    for (std::size_t i = 0; i < bytes.size(); i += 7)
        bytes[i] = static_cast<char>(i % 256);
    const ProcessResult result = run_process({"cat"}, bytes);
    EXPECT_EQ(result.exit_status, 0);
    EXPECT_TRUE(result.output == bytes);
}

TEST(Process, SurvivesAProgramThatDoesNotRead) {
    const ProcessResult result = run_process({"true"}, std::string(5'000'000, 'x'));
    EXPECT_EQ(result.exit_status, 0);
}

TEST(Process, TellsHowTheProgramEnded) {
    EXPECT_EQ(run_process({"sh", "-c", "echo why >&2; exit 3"}, "").exit_status, 3);
    EXPECT_EQ(run_process({"sh", "-c", "echo why >&2; exit 3"}, "").messages, "why\n");
    EXPECT_EQ(run_process({"sh", "-c", "kill -9 $$"}, "").exit_status, 128 + 9);
}

TEST(Process, HasNumbersWithAPoint) {
    EXPECT_EQ(run_process({"sh", "-c", "printf %s \"$LC_ALL\""}, "").output, "C.UTF-8");
}

TEST(Process, PassesArgumentsWithoutAShell) {
    EXPECT_EQ(run_process({"printf", "%s", "$HOME `ls` 'x'"}, "").output, "$HOME `ls` 'x'");
}

TEST(Process, ThatDoesNotExistIsAnError) {
    const support::Thrown thrown = thrown_by([] { run_process({"no-such-program-of-ours"}, ""); });
    EXPECT_EQ(thrown.kind, ErrorKind::io);
    EXPECT_TRUE(thrown.says("no-such-program-of-ours could not be started"));
}

TEST(IsOnPath, KnowsTheShell) {
    EXPECT_TRUE(is_on_path("sh"));
    EXPECT_FALSE(is_on_path("no-such-program-of-ours"));
}

}  // namespace
}  // namespace stridor::chart
