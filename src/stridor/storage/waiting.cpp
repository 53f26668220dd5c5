#include "stridor/storage/waiting.hpp"

#include "stridor/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <utility>

namespace stridor::storage {

namespace {

constexpr std::chrono::milliseconds longest_moment{250};
constexpr std::chrono::seconds until_told{1};

}  // namespace

bool Waiting::goes_on(const std::string& whom) {
    const auto waited = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - begun_);
    if (waited >= longest_) return false;
    if (options_.note && waited >= until_told && !std::exchange(has_told_, true)) {
        const auto bound = std::chrono::duration_cast<std::chrono::seconds>(longest_);
        options_.note(fmt::format("waits for {}, {} s at most", whom, bound.count()));
    }
    std::mutex mutex;
    std::condition_variable_any never;
    std::unique_lock lock(mutex);
    never.wait_for(lock, options_.stop, std::min(moment_, longest_ - waited), [] { return false; });
    moment_ = std::min(2 * moment_, longest_moment);
    if (options_.stop.stop_requested())
        throw Error(ErrorKind::interrupted,
                    {"stopped while it waited for " + whom, "nothing has been changed", "Run the same command again."});
    return true;
}

std::optional<std::chrono::steady_clock::duration> Unchanged::look(const std::string& state) {
    const auto now = std::chrono::steady_clock::now();
    const bool is_first = state_.empty();
    const bool is_same = state == state_;
    if (!is_same) {
        state_ = state;
        since_ = now;
    }
    if (!is_first && !is_same) return std::nullopt;
    return now - since_;
}

}  // namespace stridor::storage
