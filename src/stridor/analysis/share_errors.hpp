#pragma once

#include "stridor/analysis/rates.hpp"
#include "stridor/record/tally.hpp"

namespace stridor::analysis {

/// Standard errors of the judged shares of a contact [1]: by how much they scatter because the judged time is a piece
/// of the motion and not all of it.
///
/// The judged stretches are cut into groups of their parts, 6 to 16 in all. Groups at the same place of several
/// stretches are held against each other, so that what changes with the velocity of the drive within each of them is no
/// error; those of a single stretch against their mean. Standard error of a mean of independent groups: a motion whose
/// memory is longer than a group has a larger one.
///
/// Zero for a proven limit cycle, and where the shares never change. NaN without a complete stretch.
Rates share_errors(const record::ContactTally& tally);

}  // namespace stridor::analysis
