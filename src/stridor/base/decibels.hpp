#pragma once

#include <span>

namespace stridor::base {

/// Returns 10 log10(ratio), the level of a ratio of powers [dB], with the same bits on every machine; relative error
/// below 1e-15. The level of 0 is -infinity, that of a negative number none (NaN).
double decibels_of_power(double ratio);

/// Turns ratios of powers into levels [dB]: `decibels_of_power` of each, bit for bit, many at a time. Each ratio is
/// finite and 2.2e-308 or more.
void make_decibels(std::span<double> ratios);

/// Returns the ratio of powers of a level [dB], 10^(level/10), with the same bits on every machine; relative error
/// below 1e-15 times 1 + |level|/3. Beyond 3000 dB it is that of 3000 dB, below -3000 dB it is 0.
double power_of_decibels(double level);

/// Writes the logarithm to base 2 of each value: `logarithm_2`, bit for bit, many at a time. Each value is finite and
/// 2.2e-308 or more. `values` and `result` are of one size and do not overlap.
void find_logarithms_2(std::span<const double> values, std::span<double> result);

}  // namespace stridor::base
