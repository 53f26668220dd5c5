#pragma once

#include "stridor/sweep/cell.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

/// Multistability: one cell run from several starts.
///
/// A contact may have several motions, and its beginning decides in which one it ends. A cell shows the motion of its
/// worst start: slides, then sticks, locks, no result, undecided, creak, squeak, squeal; of equals the first start. So
/// a cell is quiet only if every start is. All summaries of starts or directions use this order. The order of the
/// noises is one of evidence, from the motion whose pattern is least established to the most regular one; it is not one
/// of sound pressure.
namespace stridor::sweep {

/// Returns the names of starts, by parameters::Initial: the choices of run.initial.
std::span<const std::string_view> start_names();

/// The words of all verdicts: the categories, the statuses of cells without one, and `locks`, which is no quiet `none`.
inline constexpr auto verdict_words = [] {
    using classification::category_names;
    std::array<std::string_view, category_names.size() + status_names.size()> words{};
    std::copy(category_names.begin(), category_names.end(), words.begin());
    std::copy(status_names.begin() + 1, status_names.end(), words.begin() + category_names.size());
    words.back() = classification::name(classification::Quiet::locks);
    return words;
}();

/// Returns the number of a verdict's word in `verdict_words`.
std::size_t number_of(const StartVerdict& verdict);

/// Returns the verdict with this word; a `none` slides.
StartVerdict verdict_of(std::size_t number);

/// Returns "squeal", "locks", or the status if there is no category: "failed".
std::string_view word(const StartVerdict& verdict);

/// Returns the same of a cell's run.
std::string_view word(const Cell& cell);

/// Says whether the runs of two cells have the same verdict.
bool has_same_verdict(const Cell& a, const Cell& b);

/// Returns the place of the first of the worst verdicts.
std::size_t worst(std::span<const StartVerdict> verdicts);

/// Returns how the verdicts of one cell, at least one, agree.
Agreement agreement(std::span<const StartVerdict> verdicts);

/// Returns the start from which a cell has its figures: an index into study.starts, 0 if it has none.
std::size_t shown_start(const Cell& cell);

/// Returns one cell from the same cell run from each start (at least one): the worst one's figures, and the verdicts of
/// all.
Cell joined(std::vector<Cell> by_start);

}  // namespace stridor::sweep
