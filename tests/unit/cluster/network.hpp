#pragma once

#include "stridor/cluster/hand.hpp"
#include "stridor/cluster/hello.hpp"
#include "stridor/cluster/post.hpp"
#include "stridor/cluster/timing.hpp"
#include "unit/cluster/invented_crew.hpp"

#include <deque>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace stridor::cluster {

/// Ranks in one process and one thread, on a network that delays letters and mixes those of different senders, with a
/// clock of its own: all of it follows from the seed.
class Network {
public:
    using Clock = Timing::Clock;

    Network(const Study& study, int ranks, std::uint64_t seed) : study_(study), random_(seed) {
        for (int rank = 0; rank < ranks; ++rank)
            posts_.push_back(std::make_unique<MemoryPost>(*this, rank, ranks));
        for (int rank = 1; rank < ranks; ++rank)
            hands_.push_back(std::make_unique<Hand>(post(rank), study, hand_options()));
    }

    Post& post(int rank) { return *posts_[static_cast<std::size_t>(rank)]; }
    std::mt19937_64& random() { return random_; }
    Clock::time_point now() const { return now_; }
    std::size_t hands() const { return hands_.size(); }

    /// Rank 0 has waited a moment: time goes on, and so do some of the others, in any order.
    void turn() {
        now_ += std::chrono::microseconds(random_() % 20000);
        for (std::size_t left = random_() % (2 * hands_.size() + 1); left > 0; --left) {
            const std::size_t chosen = random_() % hands_.size();
            if (!dead_.contains(chosen)) hands_[chosen]->step();
        }
    }

    /// A rank does nothing any more.
    void kill(std::size_t hand) { dead_.insert(hand); }

    /// The clock of a rank whose waiting is another's turn.
    Timing timing(std::function<void()> while_waiting) {
        return {[this] { return now_; },
                [=](Clock::duration) {
                    if (while_waiting) while_waiting();
                }};
    }

private:
    struct Sent {
        Clock::time_point arrives;
        std::string bytes;
    };

    class MemoryPost final : public Post {
    public:
        MemoryPost(Network& network, int rank, int ranks) : network_(network), rank_(rank), ranks_(ranks) {}
        int rank() const override { return rank_; }
        int ranks() const override { return ranks_; }
        void send(int to, std::string bytes) override { network_.send(rank_, to, std::move(bytes)); }
        std::optional<Letter> poll() override { return network_.poll(rank_); }

    private:
        Network& network_;
        int rank_;
        int ranks_;
    };

    HandOptions hand_options() {
        HandOptions options;
        options.crew = [this](const Study& study, const std::stop_token& stop) {
            return std::make_unique<InventedCrew>(study, stop, random_, nullptr);
        };
        options.timing = timing(nullptr);
        return options;
    }

    void send(int from, int to, std::string bytes) {
        std::deque<Sent>& wire = wires_[{from, to}];
        Clock::time_point arrives = now_ + std::chrono::microseconds(random_() % 20000);
        // none overtakes another of its sender
        if (!wire.empty()) arrives = std::max(arrives, wire.back().arrives);
        wire.push_back({arrives, std::move(bytes)});
    }

    std::optional<Letter> poll(int to) {
        std::vector<int> senders;
        for (const auto& [ends, wire] : wires_)
            if (ends.second == to && !wire.empty() && wire.front().arrives <= now_) senders.push_back(ends.first);
        if (senders.empty()) return std::nullopt;
        const int from = senders[random_() % senders.size()];
        std::deque<Sent>& wire = wires_[{from, to}];
        Letter letter{from, std::move(wire.front().bytes)};
        wire.pop_front();
        return letter;
    }

    const Study& study_;
    std::mt19937_64 random_;
    Clock::time_point now_ = Clock::now();
    std::map<std::pair<int, int>, std::deque<Sent>> wires_;
    std::vector<std::unique_ptr<MemoryPost>> posts_;
    std::vector<std::unique_ptr<Hand>> hands_;
    std::set<std::size_t> dead_;
};

}  // namespace stridor::cluster
