#include "interrupt.hpp"

#include "stridor/base/error.hpp"
#include "stridor/console/terminal.hpp"

#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <csignal>
#include <mutex>
#include <string>

namespace stridor::app {

namespace {

// the only state a signal handler may touch
volatile std::sig_atomic_t signals_seen = 0;

void on_signal(int) {
    signals_seen = signals_seen + 1;
    if (signals_seen > 1) _exit(base::exit_code(ErrorKind::interrupted));
}

// while the program begins there may be several: mpirun passes on what each process gets from a batch system, too
void on_early_signal(int) {
    signals_seen = 1;
}

void handle_signals(void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    // what a batch system sends some time before it ends a job
    sigaction(SIGUSR1, &action, nullptr);
}

}  // namespace

void note_signals() {
    handle_signals(on_early_signal);
}

Interrupt::Interrupt()
    : watcher_([this](const std::stop_token& done) {
          std::mutex mutex;
          std::condition_variable_any never;
          std::unique_lock lock(mutex);
          while (!done.stop_requested()) {
              if (signals_seen > 0) source_.request_stop();
              // nobody notifies: it wakes after its time, or at once when this object ends
              never.wait_for(lock, done, std::chrono::milliseconds(50), [] { return false; });
          }
      }) {
    handle_signals(on_signal);
}

Interrupt::~Interrupt() {
    handle_signals(SIG_DFL);
    signals_seen = 0;
}

storage::WaitOptions waiting(const std::stop_token& stop) {
    return {stop, [](const std::string& words) { console::say_note(words); }};
}

}  // namespace stridor::app
