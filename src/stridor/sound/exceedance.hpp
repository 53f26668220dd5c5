#pragma once

#include <cstdint>
#include <vector>

namespace stridor::sound {

/// How often a positive quantity exceeds each value, counted in steps of 0.1 % from 1e-3 to 1e4 of its unit. What it
/// keeps does not grow.
class Exceedance {
public:
    /// Counts a value; what lies beyond the ends counts as the end.
    void count(double value);

    /// How many values were counted.
    std::uint64_t values() const { return values_; }

    /// Largest value; 0 of none.
    double greatest() const { return greatest_; }

    /// What is exceeded by this share of the values [1], within 0.1 %; 0 of none.
    double exceeded(double share) const;

private:
    double greatest_ = 0.0;
    std::uint64_t values_ = 0;
    std::vector<std::uint64_t> counts_ = std::vector<std::uint64_t>(16384);
};

}  // namespace stridor::sound
