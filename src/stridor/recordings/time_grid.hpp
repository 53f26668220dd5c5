#pragma once

// The times of a table held against an even grid. Private to this folder.

#include "stridor/recordings/rate.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace stridor::recordings::time_grid {

/// Of how many times the rate is taken at first [1].
inline constexpr std::size_t looked_at = 1024;

/// How finely the times of a table are printed.
struct Precision {
    int decimals = -400;  // most digits behind the point
    int digits = 1;       // most significant digits
};

/// The precision of one numeral, with a decimal point.
Precision precision_of(std::string_view numeral);

/// The finer of two, in decimals and in digits: that of a table that has both.
Precision finer(Precision a, Precision b);

/// By how much a time printed so may be off, in the unit it is printed in.
double resolution(Precision precision, double time);

/// The times of the first rows and of the last one, in the unit of the file.
struct Times {
    std::vector<double> first{};
    double last = 0.0;
    double unit = 1.0;  // [s] of one
    Precision precision{};
};

/// The rate behind the times: from the first rows, refined over the whole table where they tell its number of rows.
///
/// Snapped to an exact one within what the printed digits leave open. Needs two increasing times.
SnappedRate rate_of(const Times& times);

/// The time a row is due at, counted from 0, where its own is off by more than 5 % of a step and what its digits leave
/// open; both in the unit of the file.
std::optional<double> missed(const Times& times, double rate, std::uint64_t row, double time);

}  // namespace stridor::recordings::time_grid
