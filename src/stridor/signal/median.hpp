#pragma once

#include <span>

namespace stridor::signal {

/// Returns the median of at least one value; of an even number of values the greater of the two in the middle.
double median_of(std::span<const double> values);

}  // namespace stridor::signal
