#include "stridor/cluster/hand.hpp"

#include "stridor/cluster/messages.hpp"
#include "stridor/crew/crew.hpp"
#include "unit/cluster/invented_crew.hpp"

#include <gtest/gtest.h>

#include <deque>

namespace stridor::cluster {
namespace {

// rank 1 of two, whose rank 0 says what a test makes it say
class Helping : public testing::Test, public Post {
protected:
    int rank() const override { return 1; }
    int ranks() const override { return 2; }
    void send(int, std::string bytes) override { sent_.push_back(unpack(bytes)); }
    std::optional<Letter> poll() override {
        if (said_.empty()) return std::nullopt;
        Letter letter{0, pack(said_.front())};
        said_.pop_front();
        return letter;
    }

    Hand hand() {
        return Hand(*this, {[this] { return now_; }, [this](Timing::Clock::duration time) { now_ += time; }});
    }

    HandOptions options() {
        return {2, [this](const crew::Work& work, const std::stop_token& stop) {
                    return std::make_unique<OwnersCrew>(work, stop, random_, nullptr);
                }};
    }

    Study study_ = invented_study(9, 0);
    crew::Work work_ = invented_work(study_);
    std::mt19937_64 random_{1};
    Timing::Clock::time_point now_ = Timing::Clock::now();
    std::deque<Message> said_;
    std::vector<Message> sent_;
};

TEST_F(Helping, SaysNothingBeforeItsWorkIsBegun) {
    Hand helping = hand();
    helping.take_up(work_, options());
    EXPECT_TRUE(helping.step());
    EXPECT_TRUE(sent_.empty());
    said_.push_back(begin_of(work_));
    EXPECT_TRUE(helping.step());
    ASSERT_EQ(sent_.size(), 1U);
    EXPECT_EQ(std::get<Hello>(sent_[0]).threads, 2U);
}

TEST_F(Helping, GoesOnToTheWorkThatIsBegun) {
    Study other = study_;
    other.x.points += 1;
    const crew::Work next = invented_work(other);
    Hand helping = hand();
    helping.take_up(work_, options());
    said_.push_back(begin_of(next));
    said_.push_back(Batch{{{3, ""}}});
    EXPECT_FALSE(helping.step());
    helping.take_up(next, options());
    EXPECT_TRUE(helping.step());
    for (int steps = 0; steps < 100 && !std::holds_alternative<Delivery>(sent_.back()); ++steps)
        EXPECT_TRUE(helping.step());
    EXPECT_EQ(std::get<Delivery>(sent_.back()).results.front().number, 3U);
}

TEST_F(Helping, WithAnotherProgramComplains) {
    Hand helping = hand();
    Begin begin = begin_of(work_);
    begin.build = "stridor of last year";
    said_ = {begin, End{2}};
    helping.serve(work_, options());
    EXPECT_EQ(helping.wait_for_the_end(), 2);
    const auto& failure = std::get<Failure>(sent_.at(0));
    EXPECT_EQ(failure.kind, ErrorKind::input);
    EXPECT_NE(failure.problem.what.find("rank 1 on"), std::string::npos) << failure.problem.what;
    EXPECT_NE(failure.problem.why.find("stridor of last year here"), std::string::npos) << failure.problem.why;
}

TEST_F(Helping, WithoutTheWorkThatIsBegunComplains) {
    Study other = study_;
    other.x.points += 1;
    Hand helping = hand();
    said_ = {begin_of(invented_work(other)), End{2}};
    helping.serve(work_, options());
    EXPECT_EQ(helping.wait_for_the_end(), 2);
    const auto& failure = std::get<Failure>(sent_.at(0));
    EXPECT_NE(failure.problem.what.find("reads another case or chart"), std::string::npos) << failure.problem.what;
}

TEST_F(Helping, EndsWithTheJobWithoutAComplaint) {
    Hand helping = hand();
    said_.push_back(End{0});
    helping.serve(work_, options());
    helping.serve(work_, options());
    EXPECT_EQ(helping.wait_for_the_end(), 0);
    EXPECT_TRUE(sent_.empty());
}

TEST_F(Helping, HandsOverWhatIsFinishedWhenItIsStopped) {
    Hand helping = hand();
    helping.take_up(work_, options());
    said_ = {begin_of(work_), Batch{crew::numbered_tasks(3)}};
    while (sent_.size() < 2)
        EXPECT_TRUE(helping.step());
    said_.push_back(Stop{});
    while (!std::holds_alternative<Stopped>(sent_.back()))
        EXPECT_TRUE(helping.step());
    EXPECT_TRUE(helping.step()) << "it waits for another work, or the end";
}

}  // namespace
}  // namespace stridor::cluster
