#pragma once

#include "support/scratch_folder.hpp"
#include "support/wait.hpp"

#include <fcntl.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <fstream>
#include <stop_token>
#include <string>
#include <thread>

namespace stridor::support {

/// A file, and a pipe that would keep whoever opens it for ever: both tell whether anybody has opened them.
class Canary {
public:
    static constexpr const char* mark = "canary-7d1f";  // what the file says

    Canary() : watch_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
        std::ofstream(file()) << mark << "\n1,2\n";
        ::mkfifo(pipe().c_str(), 0600);
        is_watching_ = ::inotify_add_watch(watch_, file().c_str(), IN_OPEN) >= 0;
        keeper_ = std::jthread([this](const std::stop_token& stop) { keep(stop); });
    }
    ~Canary() {
        keeper_.request_stop();
        keeper_.join();
        ::close(watch_);
    }
    Canary(const Canary&) = delete;
    Canary& operator=(const Canary&) = delete;

    std::string file() const { return (folder_ / "drive.csv").string(); }
    std::string pipe() const { return (folder_ / "pipe.csv").string(); }
    bool is_watching() const { return is_watching_; }

    /// Has either been opened since it was asked last?
    bool was_opened() {
        std::array<char, 4096> events{};
        const bool was_read = ::read(watch_, events.data(), events.size()) > 0;
        return pipe_opened_.exchange(false) || was_read;
    }

private:
    // a pipe can be opened for writing without waiting only while somebody reads it; closing it lets them go
    void keep(const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            const int writer = ::open(pipe().c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
            if (writer >= 0) {
                pipe_opened_ = true;
                ::close(writer);
            }
            wait_for_stop(stop, std::chrono::milliseconds(1));
        }
    }

    ScratchFolder folder_;
    int watch_;
    bool is_watching_ = false;
    std::atomic<bool> pipe_opened_ = false;
    std::jthread keeper_;
};

}  // namespace stridor::support
