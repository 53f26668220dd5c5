#include "stridor/report/timed_advice.hpp"

#include "stridor/base/error.hpp"

#include <fmt/format.h>

#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

namespace stridor::report {

namespace {

// asks for a stop when somebody else does, or when the time is up
class Deadline {
public:
    Deadline(const std::stop_token& asked, std::chrono::seconds time)
        : relay_(asked, [this] { source_.request_stop(); }),
          watch_([this, time](const std::stop_token& end) {
              std::unique_lock lock(mutex_);
              std::condition_variable_any().wait_for(lock, end, time, [] { return false; });
              if (!end.stop_requested()) source_.request_stop();
          }) {}

    std::stop_token token() const { return source_.get_token(); }

private:
    std::stop_source source_;
    std::stop_callback<std::function<void()>> relay_;
    std::mutex mutex_;
    std::jthread watch_;  // last: ends before what it uses
};

}  // namespace

void add_advice(DesignResults& results, advice::AdviceOptions options, std::chrono::seconds longest) {
    const std::stop_token asked = options.stop;
    const Deadline deadline(asked, longest);
    options.stop = deadline.token();
    try {
        results.advice = advice::advise(results.design, options);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::interrupted || asked.stop_requested()) throw;
        results.without_advice = fmt::format(
            "The search for a quieting change did not end within {} s and was left out; `stridor advise` takes its "
            "time.",
            longest.count());
    }
}

}  // namespace stridor::report
