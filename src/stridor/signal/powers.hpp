#pragma once

#include <complex>
#include <span>

namespace stridor::signal {

/// Writes the squared magnitudes of lines; both of one shape.
void powers_of(std::span<const std::complex<double>> lines, std::span<double> powers);

}  // namespace stridor::signal
