#include "stridor/sweep/agenda.hpp"

#include "stridor/base/check.hpp"

#include <algorithm>

namespace stridor::sweep {

void Agenda::add(std::size_t run) {
    STRIDOR_EXPECT(run < waiting_.size());
    if (was_added_[run]) return;
    was_added_[run] = true;
    waiting_[run] = true;
    ++left_;
    cursor_ = std::min(cursor_, run);
}

std::vector<std::size_t> Agenda::next(std::size_t most) {
    std::vector<std::size_t> runs;
    runs.reserve(std::min(most, left_));
    while (runs.size() < most && left_ > 0) {
        if (waiting_[cursor_]) {
            waiting_[cursor_] = false;
            --left_;
            runs.push_back(cursor_);
        }
        ++cursor_;
    }
    return runs;
}

}  // namespace stridor::sweep
