#include "stridor/base/separate_process.hpp"

#include "stridor/base/error.hpp"
#include "support/error_text.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <array>
#include <csignal>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace stridor::base {
namespace {

using support::Thrown;
using support::thrown_by;

std::span<const std::byte> bytes_of(const std::string& text) {
    return std::as_bytes(std::span(text));
}

TEST(SeparateProcess, GetsWhatIsSentAndSaysThatItIsDone) {
    const support::ScratchFolder folder;
    const std::string file = (folder / "received").string();
    SeparateProcess process("cannot count", [&](const Receive& receive) {
        std::ofstream stream(file);
        for (std::array<char, 4> word{}; receive(std::as_writable_bytes(std::span(word)));)
            stream << std::string(word.data(), word.size()) << ' ';
    });
    process.send(bytes_of("onetwo"));
    process.send(bytes_of("_six"));
    process.send(bytes_of("ty"));
    process.finish();
    std::string text;
    std::getline(std::ifstream(file), text);
    EXPECT_EQ(text, "onet wo_s ixty ");
}

TEST(SeparateProcess, SaysWhatWasThrownInIt) {
    SeparateProcess process("cannot draw \"x\"", [](const Receive&) {
        throw Error(ErrorKind::io, {"the netCDF library has failed", "the disk is full", ""});
    });
    const Thrown thrown = thrown_by([&] { process.finish(); });
    EXPECT_EQ(thrown.kind, ErrorKind::io);
    EXPECT_TRUE(thrown.says("cannot draw \"x\" (the disk is full)")) << thrown.message;
}

TEST(SeparateProcess, SaysBySendingThatItFailedLongAgo) {
    SeparateProcess process("cannot draw", [](const Receive&) { throw std::runtime_error("no pen"); });
    const std::vector<std::byte> much(std::size_t{1} << 20U);
    const Thrown thrown = thrown_by([&] {
        // more than fits between the two
        for (int k = 0; k < 64; ++k)
            process.send(much);
    });
    EXPECT_TRUE(thrown.says("cannot draw (no pen)")) << thrown.message;
}

TEST(SeparateProcess, MayCrash) {
    for (const int signal : {SIGSEGV, SIGABRT, SIGKILL}) {
        SeparateProcess process("cannot draw", [signal](const Receive&) {
            // as the system leaves it, whoever looks at it here
            std::signal(signal, SIG_DFL);
            std::raise(signal);
        });
        const Thrown thrown = thrown_by([&] { process.finish(); });
        EXPECT_EQ(thrown.kind, ErrorKind::io);
        EXPECT_TRUE(thrown.says("ended by signal " + std::to_string(signal))) << thrown.message;
    }
}

TEST(SeparateProcess, NoticesThatTheMessageIsCutShort) {
    SeparateProcess process("cannot draw", [](const Receive& receive) {
        std::array<std::byte, 8> word{};
        receive(word);
    });
    process.send(bytes_of("half"));
    EXPECT_TRUE(thrown_by([&] { process.finish(); }).says("the process that sent it died"));
}

TEST(SeparateProcess, EndsWithItsOwner) {
    const SeparateProcess process("cannot wait", [](const Receive& receive) {
        std::array<std::byte, 8> word{};
        receive(word);
    });
}

}  // namespace
}  // namespace stridor::base
