#include "stridor/crew/crew.hpp"

#include "stridor/crew/thread_crew.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

namespace stridor::crew {
namespace {

using namespace std::chrono_literals;

Work squares(std::atomic<std::size_t>& begun) {
    return {"squares", [&] {
                return [&](const Task& task, const std::stop_token& stop) -> std::optional<std::string> {
                    if (stop.stop_requested()) return std::nullopt;
                    if (task.bytes == "fail") throw std::runtime_error("asked to fail");
                    ++begun;
                    if (task.bytes == "slow") std::this_thread::sleep_for(250ms);
                    return std::to_string(task.number * task.number);
                };
            }};
}

TEST(Compute, HandsOverTheResultOfEveryTaskOnce) {
    std::atomic<std::size_t> begun = 0;
    for (const int threads : {1, 3}) {
        ThreadCrew crew(squares(begun), threads, {});
        // a crew serves again and again
        for (const std::size_t count : {0U, 1U, 1000U}) {
            std::vector<std::string> results(count);
            compute(crew, numbered_tasks(count), [&](Result result) {
                EXPECT_TRUE(results.at(result.number).empty());
                results[result.number] = std::move(result.bytes);
            });
            for (std::size_t k = 0; k < count; ++k)
                EXPECT_EQ(results[k], std::to_string(k * k));
        }
    }
}

TEST(Compute, TicksWhileNothingComesAndAtTheEnd) {
    std::atomic<std::size_t> begun = 0;
    ThreadCrew crew(squares(begun), 1, {});
    std::size_t results = 0;
    std::vector<std::size_t> known;
    compute(
        crew, {{0, "slow"}}, [&](const Result&) { ++results; }, [&] { known.push_back(results); });
    ASSERT_GE(known.size(), 2U);
    EXPECT_EQ(known.front(), 0U);
    EXPECT_EQ(known.back(), 1U);
}

TEST(Compute, EndsSoonWhenItIsStopped) {
    std::atomic<std::size_t> begun = 0;
    std::stop_source stop;
    ThreadCrew crew(squares(begun), 2, stop.get_token());
    std::size_t results = 0;
    compute(crew, std::vector<Task>(1000, {0, "slow"}), [&](const Result&) {
        ++results;
        stop.request_stop();
    });
    EXPECT_LT(results, 10U);
    EXPECT_LT(begun, 10U);
}

TEST(Compute, ThrowsWhatATaskThrows) {
    std::atomic<std::size_t> begun = 0;
    ThreadCrew crew(squares(begun), 2, {});
    EXPECT_THROW(compute(crew, {{0, ""}, {1, "fail"}, {2, ""}}, [](const Result&) {}), std::runtime_error);
}

TEST(Compute, ThrowsWhatItsCallerThrows) {
    std::atomic<std::size_t> begun = 0;
    ThreadCrew crew(squares(begun), 2, {});
    EXPECT_THROW(compute(crew, numbered_tasks(100), [](const Result&) { throw damaged_result(); }), Error);
}

}  // namespace
}  // namespace stridor::crew
