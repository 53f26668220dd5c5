#include "stridor/base/child_process.hpp"

#include "stridor/base/error.hpp"
#include "support/scratch_folder.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace stridor::base {
namespace {

using Channel = ChildProcess::Channel;

void say(const Channel& channel, int number) {
    channel.send(std::as_bytes(std::span(&number, 1)));
}

// what the work answers; nothing where it ends before
std::vector<int> answers_of(const Confines& confines, const std::function<void(const Channel&)>& work,
                            std::string& ending) {
    ChildProcess process(confines, work);
    std::vector<int> answers;
    int number = 0;
    while (process.receive(std::as_writable_bytes(std::span(&number, 1))))
        answers.push_back(number);
    ending = process.ending();
    return answers;
}

// what works on for nobody would keep memory and a processor
TEST(ConfinedProcess, EndsWithTheProcessThatBeganIt) {
    ASSERT_EQ(::prctl(PR_SET_CHILD_SUBREAPER, 1), 0);  // an orphan comes to this process
    const pid_t parent = ::fork();
    if (parent == 0) {
        ChildProcess process(Confines{}, [](const Channel& channel) {
            say(channel, 1);
            for (std::atomic<unsigned> turn{0};;)
                ++turn;
        });
        int number = 0;
        process.receive(std::as_writable_bytes(std::span(&number, 1)));
        ::_exit(number);  // no destructor ends it
    }
    int status = 0;
    ASSERT_EQ(::waitpid(parent, &status, 0), parent);
    EXPECT_EQ(WEXITSTATUS(status), 1);
    EXPECT_GT(::waitpid(-1, &status, 0), 0);
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), SIGKILL);
    ::prctl(PR_SET_CHILD_SUBREAPER, 0);
}

TEST(ConfinedProcess, AnswersWhatItIsAsked) {
    ChildProcess process(Confines{}, [](const Channel& channel) {
        int number = 0;
        while (channel.receive(std::as_writable_bytes(std::span(&number, 1))))
            say(channel, 2 * number);
    });
    for (const int number : {1, 21, -7}) {
        process.send(std::as_bytes(std::span(&number, 1)));
        int answer = 0;
        ASSERT_TRUE(process.receive(std::as_writable_bytes(std::span(&answer, 1)))) << process.ending();
        EXPECT_EQ(answer, 2 * number);
    }
}

TEST(ConfinedProcess, MayCrash) {
    std::string ending;
    const auto fault = [](const Channel& channel) {
        say(channel, 1);
        volatile int* volatile nowhere = nullptr;
        *nowhere = 1;
    };
    EXPECT_EQ(answers_of({}, fault, ending), std::vector<int>{1});
    EXPECT_NE(ending, "") << "how depends on the sanitizer";
    EXPECT_TRUE(answers_of(
                    {}, [](const Channel&) { std::abort(); }, ending)
                    .empty());
    EXPECT_NE(ending, "");
    EXPECT_TRUE(answers_of(
                    {}, [](const Channel&) { throw std::bad_alloc(); }, ending)
                    .empty());
    EXPECT_EQ(ending, "it ended too early");
}

TEST(ConfinedProcess, ComputesForSoLongAndNoLonger) {
    std::string ending;
    const auto work = [](const Channel&) {
        const std::atomic<bool> is_endless{true};
        while (is_endless)
            continue;
    };
    EXPECT_TRUE(answers_of({.processor_time = 1}, work, ending).empty());
    EXPECT_EQ(ending, "it computed for too long");
}

TEST(ConfinedProcess, MayNotKeepUsWaiting) {
    std::string ending;
    const auto work = [](const Channel& channel) {
        std::byte byte{};
        channel.receive(std::span(&byte, 1));
    };
    EXPECT_TRUE(answers_of({.patience = 1}, work, ending).empty());
    EXPECT_EQ(ending, "it did not answer within 1 s");
}

TEST(ConfinedProcess, GetsSoMuchMemoryAndNoMore) {
    std::string ending;
    const auto work = [](const Channel& channel) {
        for (const std::size_t size : {std::size_t{1} << 20U, std::size_t{1} << 28U}) {
            void* memory = std::malloc(size);
            say(channel, memory != nullptr ? 1 : 0);
            std::free(memory);
        }
    };
    const std::vector<int> answers = answers_of({.memory = std::uint64_t{1} << 26U}, work, ending);
    ASSERT_FALSE(answers.empty());
    EXPECT_EQ(answers.front(), 1);
    // the second time there is none: malloc says so, or the address sanitizer ends the process
    EXPECT_EQ(std::count(answers.begin(), answers.end(), 1), 1);
}

TEST(ConfinedProcess, ReachesNothingButItsFile) {
    const int file = ::open("/etc/passwd", O_RDONLY | O_CLOEXEC);
    ASSERT_GE(file, 0);
    std::string ending;
    const auto work = [file](const Channel& channel) {
        char byte = 0;
        say(channel, ::open("/etc/passwd", O_RDWR) >= 0);                   // writing
        say(channel, ::open("/tmp/stridor-confined", O_CREAT, 0600) >= 0);  // making
        say(channel, ::socket(AF_INET, SOCK_STREAM, 0) >= 0);
        say(channel, ::fork() >= 0);
        say(channel, ::kill(::getppid(), 0) == 0);
        say(channel, ::write(STDOUT_FILENO, "", 0) < 0);  // leads nowhere, but is there
        say(channel, file > 4 && ::read(file, &byte, 1) >= 0);
        // the file of its own, as often as was agreed on
        const int first = ::open(ChildProcess::file_path, O_RDONLY);
        say(channel, first >= 0 && ::read(first, &byte, 1) == 1 && byte != 0 ? 7 : 0);
        ::close(first);
        say(channel, ::open(ChildProcess::file_path, O_RDONLY) >= 0);
        say(channel, ::open("/etc/passwd", O_RDONLY) >= 0);
    };
    const std::vector<int> answers = answers_of({.openings = 1, .file = file}, work, ending);
    ::close(file);
    EXPECT_EQ(answers, (std::vector<int>{0, 0, 0, 0, 0, 0, 0, 7, 0, 0})) << ending;
}

std::span<const std::byte> bytes_of(const std::string& text) {
    return std::as_bytes(std::span(text));
}

TEST(ChildProcess, GetsWhatIsSentAndSaysThatItIsDone) {
    const support::ScratchFolder folder;
    const std::string file = (folder / "received").string();
    ChildProcess process({}, [&](const Channel& channel) {
        std::ofstream stream(file);
        for (std::array<char, 4> word{}; channel.receive(std::as_writable_bytes(std::span(word)));)
            stream << std::string(word.data(), word.size()) << ' ';
    });
    process.send(bytes_of("onetwo"));
    process.send(bytes_of("_six"));
    process.send(bytes_of("ty"));
    EXPECT_EQ(process.finish(), "");
    std::string text;
    std::getline(std::ifstream(file), text);
    EXPECT_EQ(text, "onet wo_s ixty ");
}

TEST(ChildProcess, SaysWhatWasThrownInIt) {
    ChildProcess process({}, [](const Channel&) {
        throw Error(ErrorKind::io, {"the netCDF library has failed", "the disk is full", ""});
    });
    EXPECT_EQ(process.finish(), "the disk is full");
}

TEST(ChildProcess, SaysBySendingThatItFailedLongAgo) {
    ChildProcess process({}, [](const Channel&) { throw std::runtime_error("no pen"); });
    const std::vector<std::byte> much(std::size_t{1} << 20U);
    // more than fits between the two
    int sent = 0;
    while (sent < 64 && process.send(much))
        ++sent;
    EXPECT_LT(sent, 64);
    EXPECT_EQ(process.finish(), "no pen");
}

TEST(ChildProcess, MayCrash) {
    for (const int signal : {SIGSEGV, SIGABRT, SIGKILL}) {
        ChildProcess process({}, [signal](const Channel&) {
            // as the system leaves it, whoever looks at it here
            std::signal(signal, SIG_DFL);
            std::raise(signal);
        });
        const std::string reason = process.finish();
        EXPECT_NE(reason.find("ended by signal " + std::to_string(signal)), std::string::npos) << reason;
    }
}

// a library that ends the process says nothing, and its work is not done
TEST(ChildProcess, IsNotDoneWhereItEndsByItself) {
    for (int status = 1; status < 5; ++status) {
        ChildProcess process({}, [status](const Channel&) { ::_exit(status); });
        EXPECT_EQ(process.finish(), "the process that writes it ended too early") << status;
    }
}

TEST(ChildProcess, NoticesThatTheMessageIsCutShort) {
    ChildProcess process({}, [](const Channel& channel) {
        std::array<std::byte, 8> word{};
        channel.receive(word);
    });
    process.send(bytes_of("half"));
    EXPECT_EQ(process.finish(), "the process that sent it died");
}

TEST(ChildProcess, EndsWithItsOwner) {
    const ChildProcess process({}, [](const Channel& channel) {
        std::array<std::byte, 8> word{};
        channel.receive(word);
    });
}

}  // namespace
}  // namespace stridor::base
