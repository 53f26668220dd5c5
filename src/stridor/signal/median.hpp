#pragma once

#include <span>

namespace stridor::signal {

/// The median of values; of an even number of them the greater of the two in the middle. There is at least one.
double median_of(std::span<const double> values);

}  // namespace stridor::signal
