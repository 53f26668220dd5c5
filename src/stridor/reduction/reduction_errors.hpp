#pragma once

#include "stridor/reduction/condensed_part.hpp"
#include "stridor/reduction/reduction.hpp"

#include <optional>
#include <string>
#include <vector>

namespace stridor::reduction {

/// A state of all contacts at once, in which some rows of the boundary do not move.
struct HeldRows {
    std::string name;                // "open", "sliding"
    std::vector<Eigen::Index> held;  // rows of the reduced part, within its boundary
};

/// A frequency of the full part and the same one of the reduced part [Hz].
struct FrequencyPair {
    double full = 0.0;
    double reduced = 0.0;
};

/// Returns the relative error of a frequency of the reduced part [1].
double relative_error(const FrequencyPair& pair);

/// Frequencies of both parts with some rows held.
struct StateErrors {
    std::string name;
    std::vector<FrequencyPair> frequencies;  // rising; rigid-body modes left out
};

struct ReductionErrors {
    std::vector<StateErrors> states;
    // [1] largest error of (K^-1)_bb over its largest entry; `std::nullopt` for a free part, or without the state
    // "open"
    std::optional<double> flexibility;
    double coupling = 0.0;  // [1] largest |S_jk| / sqrt(S_jj S_kk) of the contact inertia, j != k
};

/// Returns the common states of all contacts: "open", nothing held, and "sliding", their component `normal` held (0:
/// left out). With all of the boundary held the reduced part has the full part's modes by construction.
std::vector<HeldRows> contact_states(const Reduction& reduction, int normal);

/// Returns the errors of a reduced part against the full one: `count` frequencies of each state, and in the state
/// without held rows the static flexibility. The full part is solved by its condensed stiffness, whose own rounding is
/// counted in.
ReductionErrors reduction_errors(const CondensedPart& full, const Reduction& reduction,
                                 const std::vector<HeldRows>& states, Eigen::Index count);

/// Returns the reason to doubt the reduced part: how many frequencies are off by more than 1 %, in words, with a
/// remedy; empty if none is.
std::string errors_doubt(const Reduction& reduction, const ReductionErrors& errors);

}  // namespace stridor::reduction
