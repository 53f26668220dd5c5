#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace stridor::console {

/// A few lines at the bottom of the terminal behind stderr that are drawn again and again. Elsewhere it draws nothing.
class RedrawnBlock {
public:
    RedrawnBlock() = default;
    ~RedrawnBlock() { clear(); }
    RedrawnBlock(const RedrawnBlock&) = delete;
    RedrawnBlock& operator=(const RedrawnBlock&) = delete;

    /// Says whether it is time for new lines: ten times a second.
    bool is_due() const;

    /// Draws lines, each with its end, over those before.
    void draw(const std::string& lines);

    /// Removes the lines, before anything else is written.
    void clear();

private:
    std::chrono::steady_clock::time_point drawn_{};
    std::size_t lines_ = 0;
};

}  // namespace stridor::console
