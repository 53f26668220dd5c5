#include "stridor/crew/thread_crew.hpp"

#include "support/error_text.hpp"

#include <gtest/gtest.h>
#include <pthread.h>

#include <map>
#include <stdexcept>
#include <string>

namespace stridor::crew {
namespace {

using namespace std::chrono_literals;

// its results are what the tasks say, twice; "fail" fails
Work echo() {
    return {"echo", [] {
                return [](const Task& task, const std::stop_token&) -> std::optional<std::string> {
                    if (task.bytes == "fail") throw std::runtime_error("asked to fail");
                    return task.bytes + task.bytes;
                };
            }};
}

// its tasks end when they are stopped, and not before
Work endless() {
    return {"endless", [] {
                return [](const Task&, const std::stop_token& stop) -> std::optional<std::string> {
                    while (!stop.stop_requested())
                        std::this_thread::sleep_for(1ms);
                    return std::nullopt;
                };
            }};
}

std::vector<Task> tasks(std::size_t count) {
    std::vector<Task> all;
    for (std::size_t number = 0; number < count; ++number)
        all.push_back({number, std::to_string(number)});
    return all;
}

TEST(ThreadCrew, ComputesWhatItIsGivenAndIsIdleThen) {
    ThreadCrew crew(echo(), 3, {});
    EXPECT_TRUE(crew.is_idle());
    EXPECT_EQ(crew.seconds_per_task(), 0.0);
    crew.give(tasks(100));
    std::map<std::size_t, std::string> results;
    while (!crew.is_idle())
        for (Result& result : crew.take(4, Crew::Clock::now() + 1s))
            EXPECT_TRUE(results.emplace(result.number, std::move(result.bytes)).second) << result.number;
    EXPECT_EQ(results.size(), 100U);
    EXPECT_EQ(results.at(57), "5757");
    EXPECT_GT(crew.seconds_per_task(), 0.0);
    EXPECT_FALSE(crew.has_stopped());
    EXPECT_NO_THROW(crew.rethrow());
}

TEST(ThreadCrew, WantsTwoTasksForEachThreadUntilItKnowsHowLongOneTakes) {
    ThreadCrew crew(endless(), 3, {});
    EXPECT_EQ(crew.appetite(100), 6U);
    EXPECT_EQ(crew.appetite(5), 5U);
    crew.give(tasks(6));
    EXPECT_LE(crew.appetite(100), 6U);
}

TEST(ThreadCrew, ComesBackAtTheDeadlineWithNothing) {
    std::stop_source stop;
    ThreadCrew crew(endless(), 1, stop.get_token());
    crew.give(tasks(4));
    EXPECT_TRUE(crew.take(1, Crew::Clock::now() + 10ms).empty());
    EXPECT_FALSE(crew.is_idle());
    stop.request_stop();
    while (!crew.is_idle())
        EXPECT_TRUE(crew.take(1, Crew::Clock::now() + 1s).empty());
    EXPECT_TRUE(crew.has_stopped());
    EXPECT_EQ(crew.appetite(100), 0U);
}

TEST(ThreadCrew, StopsAllWhereOneFails) {
    ThreadCrew crew(echo(), 2, {});
    crew.give({{0, "fail"}});
    while (!crew.is_idle())
        crew.take(1, Crew::Clock::now() + 1s);
    EXPECT_TRUE(crew.has_stopped());
    EXPECT_THROW(crew.rethrow(), std::runtime_error);
}

// from the n-th on no thread gets memory for its stack
class NoMoreThreads {
public:
    NoMoreThreads() {
        pthread_getattr_default_np(&before_);
        pthread_attr_init(&huge_);
        pthread_attr_setstacksize(&huge_, std::size_t{1} << 46U);
    }
    ~NoMoreThreads() {
        pthread_setattr_default_np(&before_);
        pthread_attr_destroy(&huge_);
        pthread_attr_destroy(&before_);
    }
    NoMoreThreads(const NoMoreThreads&) = delete;
    NoMoreThreads& operator=(const NoMoreThreads&) = delete;

    void begin() { pthread_setattr_default_np(&huge_); }

private:
    pthread_attr_t before_{};
    pthread_attr_t huge_{};
};

TEST(ThreadCrew, EndsWithAWordWhereNotAllThreadsCanBeStarted) {
    NoMoreThreads limit;
    int made = 0;
    Work work = echo();
    work.worker = [&, worker = work.worker] {
        if (++made == 3) limit.begin();
        return worker();
    };
    const support::Thrown thrown = support::thrown_by([&] { ThreadCrew(work, 8, {}); });
    EXPECT_EQ(thrown.kind, ErrorKind::io);
    EXPECT_TRUE(thrown.says("the system starts no more threads (Resource temporarily unavailable)")) << thrown.message;
    EXPECT_EQ(made, 3) << "two were started, and have ended";
}

TEST(ThreadCrew, EndsWithWhatAWorkerFailsToBegin) {
    int made = 0;
    Work work = echo();
    work.worker = [&, worker = work.worker] {
        if (++made == 3) throw std::runtime_error("no worker");
        return worker();
    };
    EXPECT_THROW(ThreadCrew(work, 8, {}), std::runtime_error);
}

TEST(ThreadCrew, IsNotAskedForMoreThreadsThanAnyMachineHas) {
    EXPECT_EQ(support::thrown_by([] { thread_count(1'000'000'000); }).kind, ErrorKind::input);
    EXPECT_EQ(thread_count(4096), 4096U);
}

}  // namespace
}  // namespace stridor::crew
