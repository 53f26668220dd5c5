#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace stridor::classification {

/// The categories of the paper, and `undecided` where the evidence is too thin. A cell that could not be computed has
/// no category at all: it carries a status.
enum class Category : std::uint8_t { none, squeal, squeak, creak, undecided };

inline constexpr std::array<std::string_view, 5> category_names{"none", "squeal", "squeak", "creak", "undecided"};

/// The word of a category in files and messages: "squeal".
constexpr std::string_view name(Category category) {
    return category_names[static_cast<std::size_t>(category)];
}

/// How much a category speaks for noise, from 0: none, undecided, creak, squeak, squeal.
constexpr int loudness(Category category) {
    constexpr std::array<int, 5> ranks{0, 4, 3, 2, 1};  // in the order of the categories
    return ranks[static_cast<std::size_t>(category)];
}

/// Why a contact makes no noise: it slides, it sticks and the joint is carried along, or it locks: it sticks and is
/// pressed harder and harder by the way it is dragged (sprag-slip). What locks is no quiet design: it flips over,
/// wears or breaks.
enum class Quiet : std::uint8_t { no, slides, sticks, locks };

inline constexpr std::array<std::string_view, 4> quiet_names{"no", "slides", "sticks", "locks"};

/// The word of it: "slides"; "no" for a contact that is not quiet.
constexpr std::string_view name(Quiet quiet) {
    return quiet_names[static_cast<std::size_t>(quiet)];
}

}  // namespace stridor::classification
