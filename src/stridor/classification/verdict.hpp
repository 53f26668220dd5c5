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

/// The categories of the paper, and `undecided` if the evidence is too thin. A cell that could not be computed has no
/// category: it has a status.
enum class Category : std::uint8_t { none, squeal, squeak, creak, undecided };

inline constexpr std::array<std::string_view, 5> category_names{"none", "squeal", "squeak", "creak", "undecided"};

/// Returns the word of a category in files and messages: "squeal".
constexpr std::string_view name(Category category) {
    return category_names[static_cast<std::size_t>(category)];
}

/// Returns how much a category speaks for noise, from 0: none, undecided, creak, squeak, squeal.
constexpr int loudness(Category category) {
    constexpr std::array<int, 5> ranks{0, 4, 3, 2, 1};  // in the order of the categories
    return ranks[static_cast<std::size_t>(category)];
}

/// Why a contact makes no noise. It slides, or it sticks and the joint is carried along, or it locks: it sticks, and
/// the way it is dragged presses it harder and harder (sprag-slip). A locking contact is not a quiet design: it flips
/// over, wears or breaks.
enum class Quiet : std::uint8_t { no, slides, sticks, locks };

inline constexpr std::array<std::string_view, 4> quiet_names{"no", "slides", "sticks", "locks"};

/// Returns the word of a reason: "slides"; "no" for a contact that is not quiet.
constexpr std::string_view name(Quiet quiet) {
    return quiet_names[static_cast<std::size_t>(quiet)];
}

/// A figure beside the threshold it was compared with. `distance` = figure - threshold: its sign says on which side the
/// figure lies, if it is larger than the figure's error.
struct Margin {
    std::string_view threshold_name;  // "quiet_slip", the key in [verdict]
    std::string_view figure_name;     // "judged slip rate"
    double figure = 0.0;              // in the threshold's unit
    double threshold = 0.0;           // in its unit
    double distance = 0.0;            // in its unit
    std::optional<double> error{};    // of the figure, in its unit, if it is known
};

/// A category with its figures, the distance of each from its threshold, and the reasons.
struct Verdict {
    Category category = Category::undecided;
    Quiet quiet = Quiet::no;  // why, if the category is none
    analysis::Evidence evidence;
    std::vector<Margin> margins;        // in the order of the rules; those never reached are listed too
    std::vector<std::string> reasons;   // sentences, in the order of the rules
    std::vector<std::string> warnings;  // further things that a reader should know
};

/// The names of contacts in reasons and warnings, shape [contact]; empty: "contact 2".
using ContactNames = std::vector<std::string>;

/// Returns the names of a case's contacts.
ContactNames contact_names(const parameters::Case& c);

/// Returns the word for people: the category, or "locks", which is not a category in files.
inline std::string_view word(const Verdict& verdict) {
    return verdict.quiet == Quiet::locks ? name(verdict.quiet) : name(verdict.category);
}

/// How often two verdicts agree.
struct Confusion {
    using Row = std::array<std::size_t, category_names.size()>;
    std::array<Row, category_names.size()> counts{};  // shape [truth][heard], in the order of `category_names`
};

/// Returns the table with one more pair.
Confusion counted(Confusion table, Category truth, Category heard);

/// Returns the number of pairs in the table.
std::size_t total(const Confusion& table);

/// Returns the share of pairs that agree [1]; NaN for an empty table.
double agreement(const Confusion& table);

/// Returns the share of a truth's pairs that agree [1]; NaN if it has none.
double agreement_on(const Confusion& table, Category truth);

/// Returns the table without the pairs whose truth is undecided: nothing can agree with them.
Confusion decided(Confusion table);

/// Returns the mean, over the decided truths that occur, of the share of their pairs that agree [1]. Each category has
/// the same weight, however often it occurs. NaN for an empty table.
double mean_agreement(const Confusion& table);

/// Returns the sum of both tables.
Confusion sum(Confusion a, const Confusion& b);

}  // namespace stridor::classification
