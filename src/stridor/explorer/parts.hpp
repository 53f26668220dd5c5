#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <stop_token>
#include <string>
#include <utility>

namespace stridor::explorer {

/// The parts of a streamed body on their way from the thread that makes them to the one that sends them.
class Parts {
public:
    /// Waits while two are under way, or until stopped: whoever makes parts never runs far ahead of whoever takes them.
    void push(std::string part, const std::stop_token& stop) {
        if (part.empty()) return;  // an empty chunk would end the body
        std::unique_lock lock(mutex_);
        if (changed_.wait(lock, stop, [&] { return parts_.size() < 2; })) parts_.push_back(std::move(part));
    }

    /// Takes the front part away; there must be one.
    void pop() {
        const std::lock_guard lock(mutex_);
        parts_.pop_front();
        changed_.notify_all();
    }

    /// The next one, which stays where it is until `pop`; null where there is none.
    const std::string* front() {
        const std::lock_guard lock(mutex_);
        return parts_.empty() ? nullptr : &parts_.front();
    }

    /// No more will come; told and asked by the sending thread.
    void end() { has_ended_ = true; }
    /// Likewise: will no more come?
    bool has_ended() const { return has_ended_; }

private:
    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::deque<std::string> parts_;
    bool has_ended_ = false;
};

}  // namespace stridor::explorer
