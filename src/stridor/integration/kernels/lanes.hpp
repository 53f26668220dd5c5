#pragma once

#include <cstddef>

namespace stridor::integration {

/// Numbers that stand side by side: one register of AVX-512, two of AVX2, four of the baseline.
inline constexpr int lanes = 8;

/// Eight numbers side by side: a state, or a row, or a part of one. A built-in array: checks of std::array would hide
/// its loops from compilers.
struct alignas(64) Lanes {
    double at[lanes];
};

/// Returns how many of them hold so many numbers.
constexpr std::size_t registers_for(std::size_t count) {
    return (count + lanes - 1) / lanes;
}

/// Returns one of the numbers in a row of registers.
inline double& number_in(Lanes* row, std::size_t index) {
    return row[index / lanes].at[index % lanes];
}
inline double number_in(const Lanes* row, std::size_t index) {
    return row[index / lanes].at[index % lanes];
}

}  // namespace stridor::integration
