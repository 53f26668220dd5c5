#include "stridor/cluster/hand.hpp"

#include "stridor/cluster/hello.hpp"
#include "stridor/sweep/thread_crew.hpp"

#include <chrono>
#include <cstdint>
#include <iterator>
#include <utility>

namespace stridor::cluster {

namespace {

using namespace std::chrono_literals;

// finished cells wait so long for others: what a kill may cost
constexpr auto longest_delay = 50ms;
constexpr std::size_t most_cells_a_letter = 1024;
// who is silent for a minute is taken for dead
constexpr auto sign_of_life = 1s;
constexpr auto soon_idle = 100ms;

}  // namespace

Hand::Hand(Post& post, const sweep::Study& study, HandOptions options)
    : post_(post),
      options_(std::move(options)),
      crew_(options_.crew(study, halt_.get_token())),
      worked_(options_.timing.now()) {
    tell(hello_of(study, options_.threads));
}

void Hand::tell(const Message& message) {
    post_.send(0, pack(message));
    told_ = options_.timing.now();
}

void Hand::read_letters() {
    while (const std::optional<Letter> letter = post_.poll()) {
        Message message = unpack(letter->bytes);
        if (Batch* batch = std::get_if<Batch>(&message)) crew_->give(std::move(batch->runs));
        if (std::holds_alternative<Stop>(message)) halt_.request_stop();
        if (const End* end = std::get_if<End>(&message)) {
            has_ended_ = true;
            exit_code_ = end->exit_code;
            halt_.request_stop();
        }
    }
}

void Hand::hand_over(Clock::time_point now) {
    const bool is_idle = crew_->is_idle();
    if (!is_idle || !finished_.empty()) worked_ = now;
    const bool is_due = is_idle || finished_.size() >= most_cells_a_letter || now - told_ >= longest_delay;
    if (!finished_.empty() && is_due) tell(Cells{std::exchange(finished_, {}), crew_->seconds_per_run()});
    if (is_idle && crew_->has_stopped() && !std::exchange(has_told_its_end_, true)) {
        try {
            crew_->rethrow();
            tell(Stopped{});
        } catch (const Error& error) {
            tell(Failure{error.kind(), error.problem()});
        } catch (const std::exception& error) {
            tell(Failure{ErrorKind::io, {error.what(), "", ""}});
        }
    }
    if (now - told_ >= sign_of_life) tell(Alive{});
}

bool Hand::step() {
    read_letters();
    if (has_ended_) return false;
    const Clock::time_point now = options_.timing.now();
    if (crew_->is_idle()) options_.timing.pause(now - worked_ < soon_idle ? busy_pause : idle_pause);
    std::vector<sweep::IndexedCell> cells = crew_->take(most_cells_a_letter, now + busy_pause);
    std::move(cells.begin(), cells.end(), std::back_inserter(finished_));
    hand_over(options_.timing.now());
    return true;
}

int serve(Post& post, const sweep::Study& study, int threads) {
    HandOptions options;
    options.threads = sweep::thread_count(threads);
    options.crew = sweep::thread_crews(threads);
    Hand hand(post, study, std::move(options));
    while (hand.step())
        ;
    return hand.exit_code();
}

}  // namespace stridor::cluster
