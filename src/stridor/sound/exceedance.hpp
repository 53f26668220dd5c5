#pragma once

#include <cstdint>
#include <vector>

namespace stridor::sound {

/// Counts how often a positive quantity exceeds each value, in steps of 0.1 % from 1e-3 to 1e4 of its unit. Its memory
/// does not grow.
class Exceedance {
public:
    /// Counts a value; a value beyond the ends counts as the end.
    void count(double value);

    /// Returns the number of values counted.
    std::uint64_t values() const { return values_; }

    /// Returns the largest value; 0 without values.
    double greatest() const { return greatest_; }

    /// Returns the value that this share of the values [1] exceeds, within 0.1 %; 0 without values.
    double exceeded(double share) const;

private:
    double greatest_ = 0.0;
    std::uint64_t values_ = 0;
    std::vector<std::uint64_t> counts_ = std::vector<std::uint64_t>(16384);
};

}  // namespace stridor::sound
