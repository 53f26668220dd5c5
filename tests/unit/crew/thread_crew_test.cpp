#include "stridor/crew/thread_crew.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace stridor::crew
