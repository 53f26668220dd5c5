#pragma once

#include "stridor/base/error.hpp"

#include <pybind11/pybind11.h>

#include <stop_token>

/// Work that takes time: other Python threads go on meanwhile, and Ctrl-C ends it.
///
/// The calling thread works itself, for handing over to another one would cost more than a short run. On the main
/// thread SIGINT then goes through a handler of ours, which notes it and passes it on to Python's. A thread that sleeps
/// as long as nobody works looks for the note 50 times a second and asks the work to stop. Python's handlers are called
/// where the work has ended. If they throw nothing, it begins anew: whoever has taken SIGINT over wants no end.
namespace stridor::binding {

/// Notes SIGINT while it lives, and asks for a stop then. It may be nested; it does nothing on other threads than main.
class Watch {
public:
    Watch();
    ~Watch();
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

    std::stop_token token() const { return source_.get_token(); }
    /// Lets the work end, whatever the reason.
    bool was_stopped() const { return source_.stop_requested(); }

private:
    std::stop_source source_;
    std::stop_source* outer_ = nullptr;
    bool is_watching_ = false;
};

/// Calls Python's signal handlers; what they throw comes out, KeyboardInterrupt as `Error` (interrupted) with the words
/// of `stopped`. Needs the GIL.
void call_signal_handlers(const Error& stopped);

/// Calls them while work goes on, from a callback of it; SIGINT is left to where the work ends. Needs the GIL.
void call_other_signal_handlers();

/// Calls back into Python from work that goes on, unless `progress` is None; what that throws ends the work.
template <typename Call>
void call_python(const pybind11::object& progress, Call call) {
    const pybind11::gil_scoped_acquire held;
    call_other_signal_handlers();
    if (!progress.is_none()) call();
}

/// What is said where a work ended by itself just as it was interrupted.
Error interrupted_at_end();

/// Does work(stop token), which ends in an `Error` (interrupted) when it is stopped, without the GIL.
template <typename Work>
auto unlocked(Work work) {
    for (;;) {
        const Watch watch;
        try {
            auto result = [&] {
                const pybind11::gil_scoped_release released;
                return work(watch.token());
            }();
            call_signal_handlers(interrupted_at_end());
            return result;
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::interrupted || !watch.was_stopped()) throw;
            call_signal_handlers(error);
        }
    }
}

}  // namespace stridor::binding
