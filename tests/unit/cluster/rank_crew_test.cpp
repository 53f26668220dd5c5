#include "stridor/cluster/rank_crew.hpp"

#include "stridor/cluster/messages.hpp"
#include "stridor/crew/crew.hpp"
#include "support/error_text.hpp"
#include "unit/cluster/network.hpp"

#include <gtest/gtest.h>

namespace stridor::cluster {
namespace {

using support::Thrown;
using support::thrown_by;

// rank 0 of two, whose other rank says what a test makes it say
class Led : public testing::Test, public Post {
protected:
    int rank() const override { return 0; }
    int ranks() const override { return 2; }
    void send(int, std::string bytes) override { sent_.push_back(unpack(bytes)); }
    std::optional<Letter> poll() override {
        if (said_.empty()) return std::nullopt;
        Letter letter{1, pack(said_.front())};
        said_.pop_front();
        return letter;
    }

    RankCrew crew() {
        RankCrewOptions options;
        options.crew = [this](const crew::Work& work, const std::stop_token& stop) {
            return std::make_unique<OwnersCrew>(work, stop, random_, nullptr);
        };
        options.timing = {[this] { return now_; }, [this](Timing::Clock::duration time) { now_ += time; }};
        return {*this, work_, stop_.get_token(), std::move(options)};
    }

    template <typename Kind>
    std::vector<Kind> sent() const {
        std::vector<Kind> found;
        for (const Message& message : sent_)
            if (const Kind* kind = std::get_if<Kind>(&message)) found.push_back(*kind);
        return found;
    }

    // all that comes while the clock runs for so long
    std::vector<crew::Result> taken(RankCrew& crew, std::chrono::milliseconds time) {
        return crew.take(1U << 20U, now_ += time);
    }

    Study study_ = invented_study(9, 0);
    crew::Work work_ = invented_work(study_);
    std::mt19937_64 random_{1};
    Timing::Clock::time_point now_ = Timing::Clock::now();
    std::stop_source stop_;
    std::deque<Message> said_;
    std::vector<Message> sent_;
};

TEST_F(Led, SaysWhatItBegins) {
    const RankCrew led = crew();
    ASSERT_EQ(sent<Begin>().size(), 1U);
    EXPECT_EQ(sent<Begin>()[0].work, begin_of(work_).work);
}

TEST_F(Led, DoesNotListenToWhatIsOfTheWorkBefore) {
    RankCrew led = crew();
    said_.push_back(Delivery{{{3, "of the work before"}}, 0.01});
    said_.push_back(Stopped{});
    said_.push_back(Hello{"n1", 1});
    EXPECT_TRUE(taken(led, std::chrono::milliseconds(1)).empty());
    EXPECT_GT(led.appetite(1000), 8U) << "the rank has not stopped";
}

TEST_F(Led, GivesNothingToWhoHasNotSaidHello) {
    RankCrew led = crew();
    led.give(crew::numbered_tasks(8));
    EXPECT_TRUE(sent<Batch>().empty());
    said_.push_back(Hello{"n1", 3});
    taken(led, std::chrono::milliseconds(1));
    EXPECT_GE(led.appetite(1000), 6U);
}

TEST_F(Led, GivesNeighboursInBatchesOfATenthOfASecond) {
    RankCrew led = crew();
    said_.push_back(Hello{"n1", 2});
    said_.push_back(Delivery{{}, 0.01});
    taken(led, std::chrono::milliseconds(1));
    led.give(crew::numbered_tasks(led.appetite(10000)));
    ASSERT_EQ(sent<Batch>().size(), 1U);
    // two threads at 10 ms a task
    ASSERT_EQ(sent<Batch>()[0].tasks.size(), 20U);
    for (std::size_t k = 0; k < 20; ++k)
        EXPECT_EQ(sent<Batch>()[0].tasks[k].number, k);
    // a second batch ahead, and then none
    led.give(crew::numbered_tasks(led.appetite(10000)));
    EXPECT_EQ(sent<Batch>().size(), 2U);
    led.give(crew::numbered_tasks(led.appetite(10000)));
    EXPECT_EQ(sent<Batch>().size(), 2U);
}

TEST_F(Led, GivesSmallerBatchesTowardsTheEnd) {
    RankCrew led = crew();
    said_.push_back(Hello{"n1", 8});
    said_.push_back(Delivery{{}, 0.001});
    taken(led, std::chrono::milliseconds(1));
    // two ranks, four batches for each
    led.give(crew::numbered_tasks(led.appetite(80)));
    EXPECT_EQ(sent<Batch>()[0].tasks.size(), 10U);
}

TEST_F(Led, WhatARankFailsWithComesOut) {
    RankCrew led = crew();
    said_.push_back(Hello{"n1", 1});
    said_.push_back(Failure{ErrorKind::numerical, {"no roots", "the matrix is empty", ""}});
    taken(led, std::chrono::milliseconds(1));
    EXPECT_EQ(thrown_by([&] { led.rethrow(); }).kind, ErrorKind::numerical);
    taken(led, std::chrono::milliseconds(1));
    EXPECT_EQ(sent<Stop>().size(), 1U) << "the others need not finish what will not be used";
}

TEST_F(Led, KeepsWhatARankHandsOverAfterAStop) {
    RankCrew led = crew();
    said_.push_back(Hello{"n1", 1});
    taken(led, std::chrono::milliseconds(1));
    led.give(crew::numbered_tasks(led.appetite(100)));
    stop_.request_stop();
    taken(led, std::chrono::milliseconds(1));
    EXPECT_EQ(sent<Stop>().size(), 1U);
    EXPECT_FALSE(led.is_idle()) << "it may have finished some";
    said_.push_back(Delivery{{{3, "result"}}, 0.01});
    said_.push_back(Stopped{});
    EXPECT_EQ(taken(led, std::chrono::milliseconds(1)).size(), 1U);
    EXPECT_TRUE(led.is_idle());
}

TEST_F(Led, DoesNotWaitForEverForWhoDoesNotStop) {
    RankCrew led = crew();
    said_.push_back(Hello{"n1", 1});
    taken(led, std::chrono::milliseconds(1));
    led.give(crew::numbered_tasks(led.appetite(100)));
    stop_.request_stop();
    taken(led, std::chrono::milliseconds(1));
    now_ += std::chrono::milliseconds(500);
    EXPECT_TRUE(led.is_idle());
}

TEST_F(Led, SaysWhichRankIsSilent) {
    RankCrew led = crew();
    // it looks for letters all the time
    const auto pass = [&](int seconds) {
        for (int second = 0; second < seconds; ++second) {
            now_ += std::chrono::seconds(1);
            taken(led, std::chrono::milliseconds(1));
        }
    };
    said_.push_back(Hello{"n1", 1});
    taken(led, std::chrono::milliseconds(1));
    led.give(crew::numbered_tasks(led.appetite(100)));
    pass(59);
    said_.push_back(Alive{});
    pass(60);
    EXPECT_FALSE(led.has_stopped());
    pass(2);
    EXPECT_TRUE(led.has_stopped());
    EXPECT_THROW(led.rethrow(), SilentRank);
    EXPECT_TRUE(thrown_by([&] { led.rethrow(); }).says("silent for 60 s"));
}

TEST_F(Led, BlamesNobodyForTheTimeInWhichItStoodStillItself) {
    RankCrew led = crew();
    said_.push_back(Hello{"n1", 1});
    taken(led, std::chrono::milliseconds(1));
    led.give(crew::numbered_tasks(led.appetite(100)));
    // stopped for an hour: what the others said meanwhile is not here yet when it wakes
    now_ += std::chrono::hours(1);
    taken(led, std::chrono::milliseconds(1));
    EXPECT_FALSE(led.has_stopped());
    EXPECT_NO_THROW(led.rethrow());
}

}  // namespace
}  // namespace stridor::cluster
