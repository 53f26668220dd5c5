#pragma once

#include "stridor/explorer/server.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

// Boost takes long to compile: server.cpp alone includes this.
namespace stridor::explorer {

/// The parts of a streamed body on their way from the thread that makes them to the one that sends them.
class Parts {
public:
    /// Adds a part. Waits while two are under way, or until stopped, so that the maker never runs far ahead of the
    /// sender.
    void push(std::string part, const std::stop_token& stop) {
        if (part.empty()) return;  // an empty chunk would end the body
        std::unique_lock lock(mutex_);
        if (changed_.wait(lock, stop, [&] { return parts_.size() < 2; })) parts_.push_back(std::move(part));
    }

    /// Removes the first part; there must be one.
    void pop() {
        const std::lock_guard lock(mutex_);
        parts_.pop_front();
        changed_.notify_all();
    }

    /// Returns the first part, which stays until `pop`, or null if there is none.
    const std::string* front() {
        const std::lock_guard lock(mutex_);
        return parts_.empty() ? nullptr : &parts_.front();
    }

    /// Declares that no more parts will come; called by the sending thread.
    void end() { has_ended_ = true; }
    /// Says whether no more parts will come; called by the sending thread.
    bool has_ended() const { return has_ended_; }

private:
    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::deque<std::string> parts_;
    bool has_ended_ = false;
};

class Connection;

/// An answer being made. It is stopped with the server, by its deadline or when its client leaves.
struct Answering {
    /// Makes it so that `server` stops it.
    Answering(boost::asio::io_context& io, const std::stop_token& server)
        : deadline(io),
          look(io),
          patience(io),
          relay(server, [this] { source.request_stop(); }) {}

    /// Returns a token that is stopped when the answer is no longer wanted.
    std::stop_token token() const { return source.get_token(); }

    boost::asio::steady_timer deadline;  // when it is stopped
    boost::asio::steady_timer look;      // when its client is looked after
    boost::asio::steady_timer patience;  // when it is given up
    /// The progress of the answer.
    enum class State { waiting, making, given_up, done } state = State::waiting;
    std::stop_source source;
    std::stop_callback<std::function<void()>> relay;
};

/// The shared data of all connections. The threads that make answers own it, too: a thread that never ends keeps it
/// alive.
///
/// Only the thread that carries bytes touches it, except the counts of connections and threads.
struct Shared : std::enable_shared_from_this<Shared> {
    Shared(const Limits& given, const std::string& frame_origin)
        : limits(given),
          headers(security_headers(frame_origin)) {}

    using Task = std::function<void()>;

    /// Lets an answer be made as soon as there is a place for it.
    void add(const std::shared_ptr<Answering>& work, Task task) {
        ++requests;
        waiting.emplace_back(work, std::move(task));
        fill();
    }

    /// Ends an answer that is made, or was never begun.
    void finish(Answering& work) {
        for (boost::asio::steady_timer* timer : {&work.deadline, &work.look, &work.patience})
            timer->cancel();
        if (work.state == Answering::State::given_up)
            --given_up;
        else
            --requests;
        if (work.state == Answering::State::making) --making;
        work.state = Answering::State::done;
        fill();
    }

    /// Tells an answer to stop; calls `unanswered` if it does not stop, or was not begun.
    void stop_work(const std::shared_ptr<Answering>& work, const Task& unanswered) {
        const bool is_first = work->source.request_stop();
        if (work->state == Answering::State::waiting) {
            std::erase_if(waiting, [&](const auto& each) { return each.first == work; });
            finish(*work);
            unanswered();
        } else if (is_first && work->state == Answering::State::making) {
            await_end(work, unanswered);
        }
    }

    /// Waits until all threads have ended, but not for ever; returns how many have not.
    std::size_t join() {
        std::unique_lock lock(mutex_);
        ended_.wait_for(lock, limits.stopping, [this] { return threads_ == 0; });
        return threads_;
    }

    const Limits limits;
    const std::vector<std::pair<std::string, std::string>> headers;  // of every response
    Handler handler{};
    Admit admit{};
    std::stop_source stop{};  // of the whole server
    std::atomic<std::size_t> connections =
        0;                               // that are open; the last to hold one may be a thread that made its answer
    std::list<Connection*> strangers{};  // those of which no request was let through, the oldest first
    std::size_t requests = 0;            // waiting or being made, not given up
    std::size_t making = 0;              // of them
    std::size_t given_up = 0;
    boost::asio::io_context io{1};
    boost::asio::steady_timer pause{io};
    std::deque<std::pair<std::shared_ptr<Answering>, Task>> waiting{};

private:
    void fill() {
        while (making < limits.workers && !waiting.empty()) {
            auto& [work, task] = waiting.front();
            if (!start(task)) return try_again();
            work->state = Answering::State::making;
            ++making;
            waiting.pop_front();
        }
    }

    // false where the system starts no more threads
    bool start(const Task& asked) {
        {
            const std::lock_guard lock(mutex_);
            ++threads_;
        }
        try {
            std::thread([self = shared_from_this(), task = asked]() mutable {
                task();
                task = nullptr;  // what it holds stands on `self`
                const std::lock_guard lock(self->mutex_);
                --self->threads_;
                self->ended_.notify_all();
            }).detach();
            return true;
        } catch (const std::system_error&) {
            const std::lock_guard lock(mutex_);
            --threads_;
            return false;
        }
    }

    // an answer that waits for too long is given up by its deadline
    void try_again() {
        again_.expires_after(std::chrono::milliseconds(100));
        again_.async_wait([this](const boost::system::error_code& error) {
            if (!error) fill();
        });
    }

    void await_end(const std::shared_ptr<Answering>& work, const Task& unanswered) {
        work->patience.expires_after(limits.stopping);
        work->patience.async_wait([this, work, unanswered](const boost::system::error_code& error) {
            if (error || work->state != Answering::State::making) return;
            if (given_up >= limits.given_up) return await_end(work, unanswered);
            work->state = Answering::State::given_up;
            ++given_up;
            --making;
            --requests;
            unanswered();
            fill();
        });
    }

    boost::asio::steady_timer again_{io};  // when the next thread is tried
    std::mutex mutex_{};
    std::condition_variable ended_{};
    std::size_t threads_ = 0;  // that make answers, given up or not
};

}  // namespace stridor::explorer
