#pragma once

#include "stridor/base/error.hpp"

#include <pybind11/pybind11.h>

#include <stop_token>

/// Long work: other Python threads go on meanwhile, and Ctrl-C ends it.
///
/// The calling thread works itself, since another thread would cost more than a short run. On the main thread our own
/// handler of SIGINT notes the signal and passes it on to Python's. A helper thread, which sleeps while nobody works,
/// looks for the note 50 times a second and asks the work to stop. Python's handlers are called where the work has
/// ended. If they throw nothing, the work begins anew: the owner of the SIGINT handler does not want it to end.
namespace stridor::binding {

/// Notes SIGINT while it lives, and then asks for a stop. It may be nested; it does nothing on other threads than main.
class Watch {
public:
    Watch();
    ~Watch();
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

    std::stop_token token() const { return source_.get_token(); }
    /// Says whether the work was asked to stop, for any reason.
    bool was_stopped() const { return source_.stop_requested(); }

private:
    std::stop_source source_;
    std::stop_source* outer_ = nullptr;
    bool is_watching_ = false;
};

/// Calls Python's signal handlers. Throws their exceptions, KeyboardInterrupt as `Error` (interrupted) with the words
/// of `stopped`. Needs the GIL.
void call_signal_handlers(const Error& stopped);

/// Calls these handlers, except SIGINT's, from a callback of running work; SIGINT is handled where the work ends. Needs
/// the GIL.
void call_other_signal_handlers();

/// Calls back into Python from running work, unless `progress` is None; an exception ends the work.
template <typename Call>
void call_python(const pybind11::object& progress, Call call) {
    const pybind11::gil_scoped_acquire held;
    call_other_signal_handlers();
    if (!progress.is_none()) call();
}

/// Returns the error (interrupted) of work that ended by itself just as it was interrupted.
Error interrupted_at_end();

/// Does work(stop token) without the GIL and returns its result. Throws `Error` (interrupted) when it is stopped.
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
