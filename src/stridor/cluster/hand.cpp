#include "stridor/cluster/hand.hpp"

#include "stridor/cluster/messages.hpp"

#include <chrono>
#include <cstdint>
#include <iterator>
#include <stop_token>
#include <utility>
#include <vector>

namespace stridor::cluster {

namespace {

using namespace std::chrono_literals;

// results wait so long for others: what a kill may cost
constexpr auto longest_delay = 50ms;
constexpr std::size_t most_results_a_letter = 1024;
// who is silent for a minute is taken for dead
constexpr auto sign_of_life = 1s;
constexpr auto soon_idle = 100ms;

}  // namespace

struct Hand::Labour {
    std::stop_source halt;
    std::unique_ptr<crew::Crew> crew;
    std::vector<crew::Result> finished;
    Clock::time_point worked;  // when there was last something to do
    bool has_told_its_end = false;
};

Hand::Hand(Post& post, Timing timing) : post_(post), timing_(std::move(timing)) {}

Hand::~Hand() = default;

void Hand::tell(const Message& message) {
    post_.send(0, pack(message));
    told_ = timing_.now();
}

void Hand::fail(const Failure& failure) {
    tell(failure);
}

void Hand::take_up(const crew::Work& work, HandOptions options) {
    work_ = &work;
    options_ = std::move(options);
    labour_.reset();
}

void Hand::read(Message message) {
    if (Batch* batch = std::get_if<Batch>(&message); batch != nullptr && labour_)
        labour_->crew->give(std::move(batch->tasks));
    if (std::holds_alternative<Stop>(message) && labour_) labour_->halt.request_stop();
    if (Begin* begin = std::get_if<Begin>(&message)) begun_ = std::move(*begin);
    if (const End* end = std::get_if<End>(&message)) exit_code_ = end->exit_code;
}

// no further than to what begins or ends: what comes after it is of another work
void Hand::read_letters() {
    while (!begun_ && !exit_code_)
        if (const std::optional<Letter> letter = post_.poll())
            read(unpack(letter->bytes));
        else
            break;
}

void Hand::begin() {
    begun_.reset();
    labour_ = std::make_unique<Labour>();
    labour_->crew = options_.crew(*work_, labour_->halt.get_token());
    labour_->worked = timing_.now();
    tell(Hello{host_name(), static_cast<std::uint32_t>(options_.threads)});
}

void Hand::hand_over(Clock::time_point now) {
    Labour& labour = *labour_;
    const bool is_idle = labour.crew->is_idle();
    if (!is_idle || !labour.finished.empty()) labour.worked = now;
    const bool is_due = is_idle || labour.finished.size() >= most_results_a_letter || now - told_ >= longest_delay;
    if (!labour.finished.empty() && is_due)
        tell(Delivery{std::exchange(labour.finished, {}), labour.crew->seconds_per_task()});
    if (is_idle && labour.crew->has_stopped() && !std::exchange(labour.has_told_its_end, true)) {
        try {
            labour.crew->rethrow();
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
    if (begun_ && !labour_ && begun_->build == begin_of(*work_).build && begun_->work == begin_of(*work_).work) {
        begin();
        read_letters();
    }
    if (begun_ || exit_code_) {
        labour_.reset();
        return false;
    }
    if (!labour_) {
        timing_.pause(idle_pause);
        return true;
    }
    const Clock::time_point now = timing_.now();
    if (labour_->crew->is_idle()) timing_.pause(now - labour_->worked < soon_idle ? busy_pause : idle_pause);
    std::vector<crew::Result> results = labour_->crew->take(most_results_a_letter, now + busy_pause);
    std::move(results.begin(), results.end(), std::back_inserter(labour_->finished));
    hand_over(timing_.now());
    return true;
}

void Hand::serve(const crew::Work& work, HandOptions options) {
    take_up(work, std::move(options));
    while (step())
        ;
}

int Hand::wait_for_the_end() {
    for (bool has_complained = false; !exit_code_;) {
        read_letters();
        if (begun_ && !std::exchange(has_complained, true)) tell(mismatch(*begun_, post_.rank()));
        begun_.reset();
        if (!exit_code_) timing_.pause(idle_pause);
    }
    return *exit_code_;
}

}  // namespace stridor::cluster
