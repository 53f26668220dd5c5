#pragma once

#include "stridor/analysis/evidence.hpp"
#include "stridor/parameters/case.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

/// A figure beside the threshold it was held against. `distance` = figure - threshold: its sign says which side, if
/// it is larger than the figure's error.
struct Margin {
    std::string_view threshold_name;  // "quiet_slip", the key in [verdict]
    std::string_view figure_name;     // "judged slip rate"
    double figure = 0.0;              // in the threshold's unit
    double threshold = 0.0;           // in its unit
    double distance = 0.0;            // in its unit
    std::optional<double> error{};    // of the figure, in its unit, where it is known
};

/// A category with the figures it was made from, how far each lies from its threshold, and why.
struct Verdict {
    Category category = Category::undecided;
    Quiet quiet = Quiet::no;  // why, if the category is none
    analysis::Evidence evidence;
    std::vector<Margin> margins;        // in the order the rules look at them; those never reached are listed too
    std::vector<std::string> reasons;   // sentences, in the order of the rules
    std::vector<std::string> warnings;  // what a reader should know beside the category
};

/// What contacts are called in reasons and warnings, shape [contact]; empty: "contact 2".
using ContactNames = std::vector<std::string>;

/// The names of a case's contacts.
ContactNames contact_names(const parameters::Case& c);

/// What people read: the category, or that it locks, which is no category in files.
inline std::string_view word(const Verdict& verdict) {
    return verdict.quiet == Quiet::locks ? name(verdict.quiet) : name(verdict.category);
}

/// How often one verdict says what another says.
struct Confusion {
    using Row = std::array<std::size_t, category_names.size()>;
    std::array<Row, category_names.size()> counts{};  // shape [truth][heard], in the order of `category_names`
};

/// The table with one more pair.
Confusion counted(Confusion table, Category truth, Category heard);

/// Pairs in the table.
std::size_t total(const Confusion& table);

/// Share of pairs that agree [1]; NaN for an empty table.
double agreement(const Confusion& table);

/// Share of a truth's pairs that agree [1]; NaN where there are none.
double agreement_on(const Confusion& table, Category truth);

/// The table without the pairs whose truth is undecided: there is nothing to agree with.
Confusion decided(Confusion table);

/// Mean over the decided truths that occur of the share of their pairs that agree [1]: each category weighs the same,
/// however often it occurs. NaN for an empty table.
double mean_agreement(const Confusion& table);

/// Both tables in one.
Confusion sum(Confusion a, const Confusion& b);

}  // namespace stridor::classification
