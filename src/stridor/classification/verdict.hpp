#pragma once

#include "stridor/analysis/evidence.hpp"
#include "stridor/classification/category.hpp"
#include "stridor/parameters/case.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::classification {

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

}  // namespace stridor::classification
