#pragma once

#include <pthread.h>

#include <cstddef>
#include <exception>
#include <functional>
#include <stdexcept>

namespace stridor::support {

/// The stack of a small thread [bytes]: what calls itself for each byte of an input soon meets its end.
inline constexpr std::size_t small_stack = std::size_t{256} << 10U;

/// Runs something to its end on a small stack; what it throws is thrown here.
inline void on_small_stack(const std::function<void()>& work) {
    struct Task {
        const std::function<void()>* work;
        std::exception_ptr thrown{};
    } task{&work};
    const auto run = [](void* argument) -> void* {
        auto* given = static_cast<Task*>(argument);
        try {
            (*given->work)();
        } catch (...) {
            given->thrown = std::current_exception();
        }
        return nullptr;
    };
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, small_stack);
    pthread_t thread{};
    const int code = pthread_create(&thread, &attributes, run, &task);
    pthread_attr_destroy(&attributes);
    if (code != 0) throw std::runtime_error("no thread with a small stack");
    pthread_join(thread, nullptr);
    if (task.thrown) std::rethrow_exception(task.thrown);
}

}  // namespace stridor::support
