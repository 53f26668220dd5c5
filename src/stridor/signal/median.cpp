#include "stridor/signal/median.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/clones.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace stridor::signal {

namespace {

constexpr std::size_t few = 96;  // values among which counting is quicker than sorting, which guesses what comes next

// the value of a rank: no more than so many are smaller, and more are not greater
STRIDOR_CLONES double ranked(const double* values, std::size_t count, std::int64_t rank) {
    for (std::size_t k = 0; k < count; ++k) {
        const double value = values[k];
        std::int64_t smaller = 0;
        std::int64_t not_greater = 0;
        for (std::size_t other = 0; other < count; ++other) {
            smaller += values[other] < value ? 1 : 0;
            not_greater += values[other] <= value ? 1 : 0;
        }
        if (smaller <= rank && rank < not_greater) return value;
    }
    return values[0];  // some are no numbers
}

}  // namespace

double median_of(std::span<const double> values) {
    STRIDOR_EXPECT(!values.empty());
    if (values.size() <= few) return ranked(values.data(), values.size(), static_cast<std::int64_t>(values.size() / 2));
    std::vector<double> sorted(values.begin(), values.end());
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    return *middle;
}

}  // namespace stridor::signal
