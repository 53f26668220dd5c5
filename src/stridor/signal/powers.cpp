#include "stridor/signal/powers.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/clones.hpp"

#include <cstddef>

namespace stridor::signal {

STRIDOR_CLONES void powers_of(std::span<const std::complex<double>> lines, std::span<double> powers) {
    STRIDOR_EXPECT(powers.size() == lines.size());
    const double* __restrict parts = reinterpret_cast<const double*>(lines.data());
    double* __restrict result = powers.data();
    for (std::size_t k = 0; k < powers.size(); ++k)
        result[k] = parts[2 * k] * parts[2 * k] + parts[2 * k + 1] * parts[2 * k + 1];
}

}  // namespace stridor::signal
