#include "stridor/console/redrawn_block.hpp"

#include "stridor/console/terminal.hpp"

#include <algorithm>
#include <cstdio>

namespace stridor::console {

bool RedrawnBlock::is_due() const {
    return has_terminal() && std::chrono::steady_clock::now() - drawn_ >= std::chrono::milliseconds(100);
}

void RedrawnBlock::draw(const std::string& lines) {
    if (!has_terminal()) return;
    clear();
    const std::string text = shown(lines);
    std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
    lines_ = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    drawn_ = std::chrono::steady_clock::now();
}

void RedrawnBlock::clear() {
    if (lines_ == 0) return;
    // up to its first line, and away with all below
    std::fprintf(stderr, "\033[%zuA\r\033[J", lines_);
    std::fflush(stderr);
    lines_ = 0;
}

}  // namespace stridor::console
