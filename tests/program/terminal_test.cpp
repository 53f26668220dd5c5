// What others wrote must not steer the terminal of who reads it.

#include "stridor/base/escapes.hpp"
#include "support/process.hpp"

#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <vector>

namespace stridor {
namespace {

using support::Finished;
using support::run;

// sets a window's title, moves the cursor, turns text around
constexpr const char* hostile =
    "\x1b]0;owned\x07\x1b[2J\r\xc2\x9b"
    "31m\xe2\x80\xae\x7f";

// line ends, tabs and the program's own styles aside
bool is_harmless(std::string text) {
    for (const std::string style : {"\x1b[0m", "\x1b[1m", "\x1b[2m", "\x1b[31;1m"})
        for (std::size_t at = text.find(style); at != std::string::npos; at = text.find(style))
            text.erase(at, style.size());
    std::erase_if(text, [](char c) { return c == '\n' || c == '\t'; });
    return base::is_utf8(text) && !base::has_control(text);
}

class TerminalTest : public testing::Test {
protected:
    TerminalTest() {
        std::string text = run({"init", "squeal"}).out;
        const std::size_t from = text.find("title = ");
        text.replace(from, text.find('\n', from) - from,
                     "title = \"seal \\u001b]0;owned\\u0007\\u001b[2J\\r\\u009b31m\\u202e\\u007f end\"");
        support::write_text(file(), text);
    }
    std::string file() const { return (folder_ / "case.toml").string(); }

    // its output where stdout and stderr are a terminal
    static std::string run_in_terminal(const std::vector<std::string>& arguments) {
        int terminal = -1;
        const pid_t child = ::forkpty(&terminal, nullptr, nullptr, nullptr);
        if (child == 0) {
            std::string name = support::program();
            std::vector<char*> words{name.data()};
            for (const std::string& argument : arguments)
                words.push_back(const_cast<char*>(argument.c_str()));
            words.push_back(nullptr);
            ::execv(name.c_str(), words.data());
            ::_exit(127);
        }
        std::string text;
        char buffer[4096];
        for (ssize_t count = ::read(terminal, buffer, sizeof buffer); count > 0;
             count = ::read(terminal, buffer, sizeof buffer))
            text.append(buffer, static_cast<std::size_t>(count));
        ::close(terminal);
        ::waitpid(child, nullptr, 0);
        std::erase(text, '\r');  // the terminal's own line ends
        return text;
    }

    support::ScratchFolder folder_;
};

TEST_F(TerminalTest, TitlesAreShownNotObeyed) {
    for (const Finished& finished :
         {run({"check", file()}), run({"simulate", file(), "--set", "run.duration=0.3", "--set", "run.window=0.3"})}) {
        EXPECT_EQ(finished.exit_code, 0) << finished.err;
        EXPECT_NE(finished.out.find("seal \\u001b]0;owned\\u0007\\u001b[2J\\u000d\\u009b31m\\u202e\\u007f end"),
                  std::string::npos)
            << finished.out;
        EXPECT_TRUE(is_harmless(finished.out)) << finished.out;
    }
}

TEST_F(TerminalTest, DocumentsKeepTheirBytesInAPipeAndAreShownInATerminal) {
    const Finished document = run({"check", file(), "--json"});
    EXPECT_NE(document.out.find("seal \\u001b]0;owned\\u0007\\u001b[2J\\r"), std::string::npos) << document.out;
    const std::string seen = run_in_terminal({"check", file(), "--json"});
    EXPECT_NE(seen.find("owned"), std::string::npos) << seen;
    EXPECT_TRUE(is_harmless(seen)) << seen;
}

TEST_F(TerminalTest, ErrorsShowWhatTheySpeakOf) {
    const std::string name = (folder_ / ("no such " + std::string(hostile))).string();
    support::write_text(file(), "[joint]\nmass = 1\n# " + std::string(hostile) + "\nmass = \"" + hostile + "\"\n");
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"check", name},
                                               {"simulate", file()},
                                               {"check", file(), "--set", std::string("contact.preload=") + hostile},
                                               {"check", file(), "--set", hostile},
                                               {"check", file(), std::string("--no-") + hostile},
                                               {hostile},
                                               {"analyse", name},
                                               {"library", "list", "--library", name},
                                               {"chart", file(), "--out", name}}) {
        const Finished finished = run(arguments);
        EXPECT_NE(finished.exit_code, 0);
        EXPECT_FALSE(finished.err.empty());
        EXPECT_TRUE(is_harmless(finished.err)) << finished.err;
        EXPECT_TRUE(is_harmless(finished.out)) << finished.out;
        EXPECT_TRUE(is_harmless(run_in_terminal(arguments)));
    }
}

TEST_F(TerminalTest, TheCaretStandsUnderWhatIsShown) {
    support::write_text(file(), "x\x1b = 1\n");
    const Finished finished = run({"check", file()});
    const std::size_t line = finished.err.find("    1 | ");
    ASSERT_NE(line, std::string::npos) << finished.err;
    const std::size_t end = finished.err.find('\n', line);
    EXPECT_EQ(finished.err.substr(line, end - line), "    1 | x\\u001b = 1");
}

}  // namespace
}  // namespace stridor
