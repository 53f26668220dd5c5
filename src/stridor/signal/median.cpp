#include "stridor/signal/median.hpp"

#include "stridor/base/check.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace stridor::signal {

double median_of(std::span<const double> values) {
    STRIDOR_EXPECT(!values.empty());
    std::vector<double> sorted(values.begin(), values.end());
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    return *middle;
}

}  // namespace stridor::signal
