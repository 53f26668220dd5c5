#include "stridor/cluster/rank_crew.hpp"

#include "stridor/base/check.hpp"
#include "stridor/cluster/messages.hpp"
#include "stridor/crew/thread_crew.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace stridor::cluster {

namespace {

using namespace std::chrono_literals;

// long beside the time of a letter, short beside what anybody wants to lose
constexpr double seconds_per_batch = 0.1;
constexpr double most_tasks_per_batch = 4096.0;
// what is left is spread over so many batches a rank, so that all end together
constexpr std::size_t batches_at_the_end = 4;
// mpirun kills one second after it has passed on a signal, and the store is to be written before
constexpr auto patience = 400ms;
// between two looks for letters more is an absence of this rank: it writes to a slow disk, or was stopped
constexpr auto longest_look = 1s;

}  // namespace

RankCrew::RankCrew(Post& post, const crew::Work& work, const std::stop_token& stop, RankCrewOptions options)
    : post_(post),
      options_(std::move(options)),
      relay_(stop, [this] { halt_.request_stop(); }),
      own_(options_.crew(work, halt_.get_token())) {
    STRIDOR_EXPECT(post.rank() == 0);
    looked_ = options_.timing.now();
    const Begin begun = begin_of(work);
    for (int rank = 1; rank < post.ranks(); ++rank) {
        members_.push_back({});
        members_.back().rank = rank;
        post_.send(rank, pack(begun));
    }
}

std::size_t RankCrew::batch(const Member& member) {
    const auto threads = static_cast<double>(member.hello.threads);
    // before the first has ended nobody knows how long one takes
    if (!(member.seconds_per_task > 0.0)) return 2 * member.hello.threads;
    return static_cast<std::size_t>(
        std::clamp(seconds_per_batch * threads / member.seconds_per_task, 1.0, most_tasks_per_batch));
}

std::size_t RankCrew::appetite(std::size_t left) {
    for (Member& member : members_)
        member.wanted = 0;
    if (halt_.stop_requested()) return 0;
    const std::size_t most =
        std::max<std::size_t>(left / (batches_at_the_end * static_cast<std::size_t>(post_.ranks())), 1);
    std::size_t sum = 0;
    for (Member& member : members_) {
        const std::size_t size = batch(member);
        if (!member.has_said_hello || member.outstanding > size) continue;
        member.wanted = std::min({size, most, left - sum});
        sum += member.wanted;
    }
    return sum + std::min({own_->appetite(left), most, left - sum});
}

void RankCrew::give(std::vector<crew::Task> tasks) {
    // neighbours to one rank
    auto next = std::make_move_iterator(tasks.begin());
    const auto slice = [&](std::size_t size) {
        const auto left = static_cast<std::size_t>(std::distance(next, std::make_move_iterator(tasks.end())));
        const auto end = next + static_cast<std::ptrdiff_t>(std::min(size, left));
        return std::vector<crew::Task>(std::exchange(next, end), end);
    };
    for (Member& member : members_) {
        std::vector<crew::Task> part = slice(member.wanted);
        member.wanted = 0;
        if (part.empty()) continue;
        member.outstanding += part.size();
        post_.send(member.rank, pack(Batch{std::move(part)}));
    }
    own_->give(slice(tasks.size()));
    was_fed_ = true;
}

void RankCrew::fail(std::exception_ptr failure) {
    if (!failure_) failure_ = std::move(failure);
    halt_.request_stop();
}

void RankCrew::read(Member& member, Message message) {
    if (Hello* hello = std::get_if<Hello>(&message)) {
        member.hello = std::move(*hello);
        member.has_said_hello = true;
        was_fed_ = true;
    }
    if (const Failure* failure = std::get_if<Failure>(&message)) {
        member.has_stopped = true;
        throw Error(failure->kind, failure->problem);
    }
    // what it says before is of the work before
    if (!member.has_said_hello) return;
    if (Delivery* done = std::get_if<Delivery>(&message)) {
        member.outstanding -= std::min(member.outstanding, done->results.size());
        if (done->seconds_per_task > 0.0) member.seconds_per_task = done->seconds_per_task;
        std::move(done->results.begin(), done->results.end(), std::back_inserter(arrived_));
    }
    if (std::holds_alternative<Stopped>(message)) member.has_stopped = true;
}

void RankCrew::read_letters() {
    const Clock::time_point now = options_.timing.now();
    attention_ += std::min<Clock::duration>(now - std::exchange(looked_, now), longest_look);
    while (const std::optional<Letter> letter = post_.poll()) {
        STRIDOR_EXPECT(letter->from > 0 && letter->from < post_.ranks());
        Member& member = members_[static_cast<std::size_t>(letter->from - 1)];
        member.heard = attention_;
        try {
            read(member, unpack(letter->bytes));
        } catch (const Error&) {
            fail(std::current_exception());
        }
    }
}

void RankCrew::halt_all() {
    if (!halt_.stop_requested() || std::exchange(has_asked_to_stop_, true)) return;
    stop_asked_ = options_.timing.now();
    for (const Member& member : members_)
        post_.send(member.rank, pack(Stop{}));
}

void RankCrew::expect_signs_of_life() {
    for (const Member& member : members_) {
        const bool is_awaited = member.outstanding > 0 || !member.has_said_hello;
        if (!is_awaited || attention_ - member.heard <= options_.longest_silence || failure_) continue;
        const std::string where = member.has_said_hello ? " on " + member.hello.host : "";
        fail(std::make_exception_ptr(SilentRank(
            ErrorKind::io,
            {fmt::format("rank {}{} has been silent for {} s", member.rank, where, options_.longest_silence.count()),
             "its machine or its network has failed", "Run the same command again: it goes on from what is kept."})));
    }
}

bool RankCrew::is_satisfied(std::size_t enough) {
    // what there is to give is not known here; enough that nobody's appetite is cut short
    constexpr std::size_t plenty = 1U << 30U;
    return arrived_.size() >= enough || is_done() || (was_fed_ && appetite(plenty) > 0);
}

std::vector<crew::Result> RankCrew::take(std::size_t enough, Clock::time_point deadline) {
    for (bool is_late = false;; is_late = options_.timing.now() >= deadline) {
        halt_all();
        read_letters();
        expect_signs_of_life();
        if (is_late || is_satisfied(enough)) break;
        const Clock::time_point now = options_.timing.now();
        if (own_->is_idle()) options_.timing.pause(busy_pause);
        std::vector<crew::Result> results = own_->take(enough, std::min(deadline, now + busy_pause));
        std::move(results.begin(), results.end(), std::back_inserter(arrived_));
    }
    was_fed_ = false;
    return std::exchange(arrived_, {});
}

bool RankCrew::is_idle() {
    return arrived_.empty() && is_done();
}

bool RankCrew::is_done() {
    if (!own_->is_idle()) return false;
    if (!halt_.stop_requested())
        return std::all_of(members_.begin(), members_.end(),
                           [](const Member& member) { return member.outstanding == 0; });
    if (!has_asked_to_stop_) return false;
    if (options_.timing.now() - stop_asked_ > patience) return true;
    return std::all_of(members_.begin(), members_.end(),
                       [](const Member& member) { return member.has_stopped || !member.has_said_hello; });
}

bool RankCrew::has_stopped() {
    return halt_.stop_requested();
}

void RankCrew::rethrow() {
    own_->rethrow();
    if (failure_) std::rethrow_exception(failure_);
}

double RankCrew::seconds_per_task() {
    return own_->seconds_per_task();
}

crew::CrewMaker rank_crews(Post& post, int threads) {
    return [&post, threads](const crew::Work& work, const std::stop_token& stop) {
        RankCrewOptions options;
        options.threads = crew::thread_count(threads);
        options.crew = crew::thread_crews(threads);
        return std::make_unique<RankCrew>(post, work, stop, std::move(options));
    };
}

}  // namespace stridor::cluster
