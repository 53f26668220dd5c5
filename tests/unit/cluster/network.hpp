#pragma once

#include "stridor/cluster/hand.hpp"
#include "stridor/cluster/post.hpp"
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

    /// The works are those of the command that all ranks run.
    Network(std::vector<crew::Work> works, int ranks, std::uint64_t seed) : works_(std::move(works)), random_(seed) {
        for (int rank = 0; rank < ranks; ++rank)
            posts_.push_back(std::make_unique<MemoryPost>(*this, rank, ranks));
        for (int rank = 1; rank < ranks; ++rank) {
            others_.push_back({std::make_unique<Hand>(post(rank), timing(nullptr))});
            go_on(others_.back());
        }
    }

    Post& post(int rank) { return *posts_[static_cast<std::size_t>(rank)]; }
    std::mt19937_64& random() { return random_; }
    Clock::time_point now() const { return now_; }
    std::size_t hands() const { return others_.size(); }

    /// Rank 0 has waited a moment: time goes on, and so do some of the others, in any order.
    void turn() {
        now_ += std::chrono::microseconds(random_() % 20000);
        for (std::size_t left = random_() % (2 * others_.size() + 1); left > 0; --left) {
            const std::size_t chosen = random_() % others_.size();
            Other& other = others_[chosen];
            if (!dead_.contains(chosen) && other.works <= works_.size() && !other.hand->step()) go_on(other);
        }
    }

    /// How many results others than rank 0 have handed over.
    std::size_t results_of_others() const { return results_of_others_; }

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

    // another rank, and how many works it has come upon
    struct Other {
        std::unique_ptr<Hand> hand;
        std::size_t works = 0;
    };

    void go_on(Other& other) {
        const auto crew = [this](const crew::Work& work, const std::stop_token& stop) {
            return std::make_unique<OwnersCrew>(work, stop, random_, nullptr);
        };
        if (++other.works <= works_.size()) other.hand->take_up(works_[other.works - 1], {1, crew});
    }

    void send(int from, int to, std::string bytes) {
        if (const Message message = unpack(bytes); const Delivery* results = std::get_if<Delivery>(&message))
            results_of_others_ += results->results.size();
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

    std::vector<crew::Work> works_;
    std::mt19937_64 random_;
    Clock::time_point now_ = Clock::now();
    std::map<std::pair<int, int>, std::deque<Sent>> wires_;
    std::vector<std::unique_ptr<MemoryPost>> posts_;
    std::vector<Other> others_;
    std::set<std::size_t> dead_;
    std::size_t results_of_others_ = 0;
};

}  // namespace stridor::cluster
