#pragma once

#include <cstddef>
#include <vector>

namespace stridor::sweep {

/// The runs that nobody was given yet, in index order: a store is filled ten times as fast in that order as in any.
///
/// It needs two bits for each run that could be on it.
class Agenda {
public:
    /// For runs whose index is below `bound`, none of them on it.
    explicit Agenda(std::size_t bound) : waiting_(bound), was_added_(bound) {}

    /// Puts a run on it, unless it was on it before.
    void add(std::size_t run);

    /// Takes so many runs off it, or all that are left, those with the lowest indices.
    std::vector<std::size_t> next(std::size_t most);

    /// Number of runs that are on it.
    std::size_t left() const { return left_; }

private:
    std::vector<bool> waiting_;
    std::vector<bool> was_added_;
    std::size_t left_ = 0;
    std::size_t cursor_ = 0;  // none below it waits
};

}  // namespace stridor::sweep
