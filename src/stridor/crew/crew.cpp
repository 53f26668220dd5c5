#include "stridor/crew/crew.hpp"

#include <iterator>
#include <utility>

namespace stridor::crew {

namespace {

// more than an eye follows, and a reaction to a key within that time
constexpr auto tick_time = std::chrono::milliseconds(100);
// results wait for one another, but not for long
constexpr std::size_t enough = 1024;

}  // namespace

void compute(Crew& crew, std::vector<Task> tasks, const std::function<void(Result)>& take,
             const std::function<void()>& tick) {
    auto next = tasks.begin();
    Crew::Clock::time_point due = Crew::Clock::now() + tick_time;
    for (bool is_over = false; !is_over;) {
        const auto left = static_cast<std::size_t>(std::distance(next, tasks.end()));
        if (const std::size_t wanted = crew.appetite(left); wanted > 0) {
            const auto last = next + static_cast<std::ptrdiff_t>(wanted);
            crew.give({std::make_move_iterator(std::exchange(next, last)), std::make_move_iterator(last)});
        }
        for (Result& result : crew.take(enough, due))
            take(std::move(result));
        is_over = crew.is_idle() && (next == tasks.end() || crew.has_stopped());
        if (!is_over && Crew::Clock::now() < due) continue;
        due = Crew::Clock::now() + tick_time;
        if (tick) tick();
    }
    crew.rethrow();
}

Error damaged_result() {
    return Error(ErrorKind::io, {"a result that another thread or process computed is damaged",
                                 "its bytes are none of this program's", "Is the same program started everywhere?"});
}

std::vector<Task> numbered_tasks(std::size_t count) {
    std::vector<Task> tasks(count);
    for (std::size_t number = 0; number < count; ++number)
        tasks[number].number = number;
    return tasks;
}

}  // namespace stridor::crew
