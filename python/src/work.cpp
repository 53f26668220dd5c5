#include "work.hpp"

#include "stridor/base/process.hpp"

#include <sys/syscall.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <csignal>
#include <memory>
#include <mutex>
#include <system_error>
#include <thread>

namespace stridor::binding {

namespace py = pybind11;

namespace {

constexpr auto patience = std::chrono::milliseconds(20);  // between two looks: Ctrl-C ends work within 0.1 s
constexpr int looks_until_sleep = 100;                    // without work between them

// the only state that the signal handler touches
volatile std::sig_atomic_t interrupts_seen = 0;
struct sigaction passed_on {};  // the handler that was there: Python's

void on_interrupt(int number) {
    interrupts_seen = 1;
    passed_on.sa_handler(number);
}

bool is_main_thread() {
    return ::syscall(SYS_gettid) == ::getpid();
}

/// The thread that looks for interrupts. It is never ended: nobody could wait for it while the process ends.
class Watcher {
public:
    // what is to be stopped from now on, or nothing; returns what was before
    std::stop_source* watch(std::stop_source* source) {
        const std::lock_guard lock(mutex_);
        std::swap(current_, source);
        if (current_ != nullptr && sleeps_) changed_.notify_one();
        return source;
    }

    void look() {
        std::unique_lock lock(mutex_);
        for (int idle = 0;;) {
            sleeps_ = idle > looks_until_sleep;
            if (sleeps_) changed_.wait(lock, [&] { return current_ != nullptr; });
            sleeps_ = false;
            idle = current_ != nullptr ? 0 : idle + 1;
            if (current_ != nullptr && interrupts_seen != 0) current_->request_stop();
            changed_.wait_for(lock, patience, [] { return false; });
        }
    }

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    std::stop_source* current_ = nullptr;
    bool sleeps_ = false;
};

// a copy of the process (fork) has the watcher's memory and not its thread: it gets one of its own
Watcher& watcher() {
    static Watcher* here = nullptr;
    static pid_t process = 0;
    if (process != ::getpid()) {
        auto made = std::make_unique<Watcher>();
        try {
            std::thread([of = made.get()] { of->look(); }).detach();
        } catch (const std::system_error& failure) {
            throw base::no_thread(failure);
        }
        here = made.release();
        process = ::getpid();
    }
    return *here;
}

}  // namespace

Watch::Watch() {
    struct sigaction found {};
    if (!is_main_thread() || sigaction(SIGINT, nullptr, &found) != 0) return;
    const bool is_nested = found.sa_handler == on_interrupt;
    const bool is_handled = found.sa_handler != SIG_DFL && found.sa_handler != SIG_IGN;
    if (!is_handled || (found.sa_flags & SA_SIGINFO) != 0) return;
    Watcher& here = watcher();
    is_watching_ = true;
    if (!is_nested) {
        interrupts_seen = 0;
        passed_on = found;
        found.sa_handler = on_interrupt;
        sigaction(SIGINT, &found, nullptr);
    }
    outer_ = here.watch(&source_);
}

Watch::~Watch() {
    if (!is_watching_) return;
    watcher().watch(outer_);
    struct sigaction found {};
    const bool is_ours = sigaction(SIGINT, nullptr, &found) == 0 && found.sa_handler == on_interrupt;
    // whoever has put another one there in the meantime keeps it
    if (outer_ == nullptr && is_ours) sigaction(SIGINT, &passed_on, nullptr);
}

void call_signal_handlers(const Error& stopped) {
    interrupts_seen = 0;
    if (PyErr_CheckSignals() == 0) return;
    if (PyErr_ExceptionMatches(PyExc_KeyboardInterrupt) == 0) throw py::error_already_set();
    PyErr_Clear();
    throw Error(stopped);
}

void call_other_signal_handlers() {
    if (interrupts_seen != 0 || PyErr_CheckSignals() == 0) return;
    if (PyErr_ExceptionMatches(PyExc_KeyboardInterrupt) == 0) throw py::error_already_set();
    // it came just now: the watcher stops the work, which says how far it was
    PyErr_Clear();
    PyErr_SetInterrupt();
    interrupts_seen = 1;
}

Error interrupted_at_end() {
    return {ErrorKind::interrupted, {"stopped", "the result that had just come is lost", "Run it again."}};
}

}  // namespace stridor::binding
