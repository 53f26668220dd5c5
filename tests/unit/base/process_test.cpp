#include "stridor/base/process.hpp"

#include "support/error_text.hpp"

#include <gtest/gtest.h>

namespace stridor::base {
namespace {

using support::thrown_by;

std::string messages_of(const std::string& script) {
    return run_process({"sh", "-c", script}).messages;
}

TEST(Process, TellsHowTheProgramEnded) {
    EXPECT_EQ(run_process({"sh", "-c", "echo why >&2; exit 3"}).exit_status, 3);
    EXPECT_EQ(messages_of("echo why >&2; exit 3"), "why\n");
    EXPECT_EQ(run_process({"sh", "-c", "kill -9 $$"}).exit_status, 128 + 9);
}

TEST(Process, ReadsMessagesLongerThanAnyBuffer) {
    EXPECT_EQ(messages_of("head -c 1000000 /dev/zero >&2").size(), 1000000U);
}

TEST(Process, HasNothingToReadAndSaysNothingItself) {
    testing::internal::CaptureStdout();
    EXPECT_EQ(messages_of("echo loud; cat; echo read >&2"), "read\n");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST(Process, HasNumbersWithAPoint) {
    EXPECT_EQ(messages_of("printf %s \"$LC_ALL\" >&2"), "C.UTF-8");
}

TEST(Process, PassesArgumentsWithoutAShell) {
    EXPECT_EQ(run_process({"sh", "-c", "printf %s \"$1\" >&2", "sh", "$HOME `ls` 'x'"}).messages, "$HOME `ls` 'x'");
}

TEST(Process, ThatDoesNotExistIsAnError) {
    const support::Thrown thrown = thrown_by([] { run_process({"no-such-program-of-ours"}); });
    EXPECT_EQ(thrown.kind, ErrorKind::io);
    EXPECT_TRUE(thrown.says("no-such-program-of-ours could not be started"));
}

TEST(Process, ThatDoesNotEndInTimeIsEnded) {
    const support::Thrown thrown = thrown_by([] {
        run_process({"sh", "-c", "exec sleep 1000"}, std::chrono::seconds(0));
    });
    EXPECT_EQ(thrown.kind, ErrorKind::io);
    EXPECT_TRUE(thrown.says("sh did not end within 0 s"));
}

TEST(IsOnPath, KnowsTheShell) {
    EXPECT_TRUE(is_on_path("sh"));
    EXPECT_FALSE(is_on_path("no-such-program-of-ours"));
}

}  // namespace
}  // namespace stridor::base
