#pragma once

#include "stridor/storage/waiting.hpp"

#include <stop_token>
#include <thread>

namespace stridor::app {

/// Notes the signals from now on, for the first `Interrupt`, in a program that takes long to begin.
void note_signals();

/// Turns SIGINT (Ctrl-C), SIGTERM and SIGUSR1 into a stop request; a second one ends the program at once with exit code
/// 4.
///
/// Only one may live at a time. Its signal handlers only set a flag; a thread looks at it 20 times a second.
class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    std::stop_token token() const { return source_.get_token(); }
    bool is_requested() const { return source_.stop_requested(); }

private:
    std::stop_source source_;
    std::jthread watcher_;
};

/// Returns how to wait for another process: the wait is said on stderr, and ended by a stop request.
storage::WaitOptions waiting(const std::stop_token& stop = {});

}  // namespace stridor::app
