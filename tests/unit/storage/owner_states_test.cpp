// Whatever stands where an owner's file or its lock may be: who comes claims the file, is refused with a word, or
// leaves it to the lock, and waits for nobody beyond a bound.

#include "stridor/base/error.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "stridor/storage/owner_draft.hpp"
#include "stridor/storage/owner_file.hpp"
#include "support/scratch_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstring>
#include <ctime>
#include <thread>
#include <vector>

namespace stridor::storage {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds patience{2000};

// an hour, in which no test waits for its end
constexpr std::time_t long_time = 3600;  // [s]

enum class Kind { text, garbage, empty, unreadable, folder, pipe, socket, link, dangling_link };
enum class Age { now, long_ago, soon, far_in_the_future };
enum class Outcome { claimed, refused, left_to_the_lock };

constexpr bool says_nothing(Kind kind) {
    return kind >= Kind::folder;
}

/// What stands there before somebody comes.
struct State {
    Kind kind = Kind::text;
    Age age = Age::now;
    std::string host = "n2";
    bool is_alive = false;       // the process that is named
    bool owner_has_lock = true;  // as he says
    bool has_lock = true;        // of who comes
    bool is_at_lock = false;     // what stands there is the lock of somebody who takes over from a dead owner
};

std::string text_of(const State& state) {
    constexpr const char* kinds[] = {"text", "garbage", "empty", "unreadable",   "folder",
                                     "pipe", "socket",  "link",  "dangling link"};
    constexpr const char* ages[] = {"now", "long ago", "soon", "far in the future"};
    return fmt::format("{} {} {} {} {} {} {}", kinds[static_cast<int>(state.kind)], ages[static_cast<int>(state.age)],
                       state.host, state.is_alive ? "alive" : "dead",
                       state.owner_has_lock ? "with lock" : "without lock",
                       state.has_lock ? "met with lock" : "met without lock", state.is_at_lock ? "as lock" : "");
}

// by the rules of owner_file.hpp
Outcome expected(const State& state) {
    if (says_nothing(state.kind)) return Outcome::refused;
    if (state.is_at_lock) return Outcome::claimed;
    const bool is_neighbour = state.kind == Kind::text && state.host == "n1";
    if (is_neighbour && state.has_lock && state.owner_has_lock) return Outcome::left_to_the_lock;
    if (is_neighbour && !state.is_alive) return Outcome::claimed;
    return state.age == Age::long_ago || state.age == Age::far_in_the_future ? Outcome::claimed : Outcome::refused;
}

std::vector<State> all_states() {
    constexpr Age ages[] = {Age::now, Age::long_ago, Age::soon, Age::far_in_the_future};
    std::vector<State> states;
    for (const bool is_at_lock : {false, true})
        for (const bool has_lock : {true, false})
            for (const Age age : ages) {
                for (const char* host : {"n1", "n2"})
                    for (const bool is_alive : {true, false})
                        for (const bool owner_has_lock : {true, false})
                            states.push_back({Kind::text, age, host, is_alive, owner_has_lock, has_lock, is_at_lock});
                for (const Kind kind : {Kind::garbage, Kind::empty, Kind::unreadable, Kind::folder, Kind::pipe,
                                        Kind::socket, Kind::link, Kind::dangling_link})
                    states.push_back({kind, age, "n2", false, true, has_lock, is_at_lock});
            }
    return states;
}

void set_time(const fs::path& name, std::time_t ahead) {
    const std::time_t then = std::time(nullptr) + ahead;
    const timespec times[2] = {{then, 0}, {then, 0}};
    ASSERT_EQ(::utimensat(AT_FDCWD, name.c_str(), times, AT_SYMLINK_NOFOLLOW), 0) << name << std::strerror(errno);
}

void make_socket(const fs::path& name) {
    const int made = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::snprintf(address.sun_path, sizeof address.sun_path, "%s", name.c_str());
    ASSERT_EQ(::bind(made, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    ::close(made);
}

void put(const State& state, const fs::path& name, long dead) {
    const std::string text = owner_text(
        {state.host, state.is_alive ? ::getpid() : dead, "17", "0123456789abcdef", 5, 2, state.owner_has_lock});
    const fs::path beside = name.parent_path() / "beside";
    switch (state.kind) {
        case Kind::text:
        case Kind::unreadable:
            write_file(name.string(), text);
            break;
        case Kind::garbage:
            write_file(name.string(), "\x01\xff = \n = host\nprocess = \nhost\n" + std::string(3000, 'x'));
            break;
        case Kind::empty:
            write_file(name.string(), "");
            break;
        case Kind::folder:
            fs::create_directory(name);
            break;
        case Kind::pipe:
            ASSERT_EQ(::mkfifo(name.c_str(), 0600), 0);
            break;
        case Kind::socket:
            make_socket(name);
            break;
        case Kind::link:
            write_file(beside.string(), text);
            fs::create_symlink(beside, name);
            break;
        case Kind::dangling_link:
            fs::create_symlink(beside, name);
            break;
    }
    if (state.age == Age::long_ago) set_time(name, -long_time);
    if (state.age == Age::soon) set_time(name, 1);
    if (state.age == Age::far_in_the_future) set_time(name, long_time);
    if (state.kind == Kind::unreadable) {
        ASSERT_EQ(::chmod(name.c_str(), 0), 0);
    }
}

double processor_time() {
    rusage usage{};
    ::getrusage(RUSAGE_THREAD, &usage);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

void meet(const State& state, long dead) {
    const support::ScratchFolder folder;
    const fs::path file = folder / "chart.sqlite";
    const fs::path name = owner_file_of(file);
    if (state.is_at_lock) put({Kind::text, Age::long_ago, "n2"}, name, dead);
    put(state, state.is_at_lock ? fs::path(name.string() + ".lock") : name, dead);
    OwnerOptions options;
    options.shown = "the store chart.sqlite";
    options.host = "n1";
    options.has_lock = state.has_lock;
    options.patience = patience;
    const double worked = processor_time();
    const Clock::time_point begin = Clock::now();
    Outcome outcome = Outcome::refused;
    std::string words;
    try {
        const OwnerFile owner(file, options);
        outcome = owner.is_claimed() ? Outcome::claimed : Outcome::left_to_the_lock;
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::io) << text_of(state);
        words = error.what();
    }
    EXPECT_EQ(outcome, expected(state)) << text_of(state) << ": " << words;
    EXPECT_LT(Clock::now() - begin, 2 * patience + std::chrono::seconds(5)) << text_of(state);
    EXPECT_LT(processor_time() - worked, 0.5) << text_of(state);
    if (outcome == Outcome::refused) {
        EXPECT_NE(words.find(says_nothing(state.kind) ? "Remove that." : "is in use"), std::string::npos) << words;
    }
    if (outcome == Outcome::claimed) {
        EXPECT_FALSE(fs::exists(name)) << text_of(state) << ": it is given back";
    }
    // who only reads waits for nobody
    const Clock::time_point look = Clock::now();
    try {
        expect_not_filled(file, options);
        owner_of(file);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::io);
    }
    EXPECT_LT(Clock::now() - look, std::chrono::seconds(5)) << text_of(state);
}

/// While it lives this process may no more than anybody: root reads what forbids it.
class AsAnybody {
public:
    AsAnybody() {
        if (before_ == 0) {
            EXPECT_EQ(::seteuid(65534), 0);
        }
    }
    ~AsAnybody() { EXPECT_EQ(::seteuid(before_), 0); }
    AsAnybody(const AsAnybody&) = delete;
    AsAnybody& operator=(const AsAnybody&) = delete;

private:
    uid_t before_ = ::geteuid();
};

TEST(OwnerStates, AreAllMetWithinABound) {
    const AsAnybody anybody;
    const pid_t dead = ::fork();
    if (dead == 0) ::_exit(0);
    ::waitpid(dead, nullptr, 0);
    const std::vector<State> states = all_states();
    EXPECT_GE(states.size(), 200U);
    // most of the time they wait
    std::atomic<std::size_t> next{0};
    std::vector<std::jthread> threads;
    for (int k = 0; k < 32; ++k)
        threads.emplace_back([&] {
            for (std::size_t index = next++; index < states.size(); index = next++)
                meet(states[index], dead);
        });
}

TEST(OwnerStates, ThatAreWaitedForAreToldAfterASecondAndEndWithTheFirstStop) {
    const support::ScratchFolder folder;
    const fs::path file = folder / "chart.sqlite";
    put({Kind::text, Age::far_in_the_future, "n2"}, owner_file_of(file), 17);
    std::stop_source stop;
    std::vector<std::string> told;
    OwnerOptions options;
    options.shown = "the store chart.sqlite";
    options.host = "n1";
    options.wait = {stop.get_token(), [&](const std::string& words) {
                        told.push_back(words);
                        stop.request_stop();
                    }};
    const Clock::time_point begin = Clock::now();
    try {
        const OwnerFile owner(file, options);
        FAIL() << "it was not waited for";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::interrupted);
    }
    EXPECT_LT(Clock::now() - begin, std::chrono::seconds(20));
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(
        told.front(),
        "waits for a sign of life of process 17 of host n2, job 17, last heard of 60 min from now by the clock of "
        "the file system, 120 s at most");
    EXPECT_TRUE(owner_of(file)) << "it is not touched";
}

TEST(OwnerStates, OfOneWhoLivesInTheFutureAreNoticed) {
    const support::ScratchFolder folder;
    const fs::path file = folder / "chart.sqlite";
    const fs::path name = owner_file_of(file);
    put({Kind::text, Age::far_in_the_future, "n2"}, name, 17);
    OwnerOptions options;
    options.shown = "the store chart.sqlite";
    options.host = "n1";
    // by his clock, which is an hour ahead
    const std::jthread beats([&](const std::stop_token& stop) {
        for (int beat = 0; !stop.stop_requested(); ++beat) {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            set_time(name, long_time + beat);
        }
    });
    EXPECT_THROW(OwnerFile(file, options), Error);
}

}  // namespace
}  // namespace stridor::storage
