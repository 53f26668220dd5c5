#pragma once

#include "support/effort.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdint>
#include <cstdlib>

/// Properties on random input (RapidCheck) with a fixed seed: the same cases on every run and machine.
///
/// RC_PARAMS set in the environment wins: RC_PARAMS="max_success=10000 seed=1" looks further. Checked builds look at
/// the first quarter of the usual hundred.
namespace stridor::support {

/// Runs before main in every test program that includes this file; RapidCheck reads RC_PARAMS at its first property.
inline const bool is_seeded = setenv("RC_PARAMS", effort("seed=20120401", "seed=20120401 max_success=25"), 0) == 0;

/// A whole number in [low, high], evenly spread; shrinks towards `low`. (RapidCheck's own range grows with its size.)
inline rc::Gen<int> whole_between(int low, int high) {
    return rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high + 1));
}

/// A number in [low, high] on a grid of a thousand intervals: short decimals, ends included; shrinks towards `low`.
inline rc::Gen<double> number_between(double low, double high) {
    return rc::gen::map(whole_between(0, 1000), [=](int k) { return low + (high - low) * (k / 1000.0); });
}

/// A number in [-1, 1) with 53 random bits, evenly spread.
inline rc::Gen<double> signed_fraction() {
    return rc::gen::map(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::int64_t>()),
                        [](std::int64_t random) { return static_cast<double>(random >> 11) * 0x1p-52; });
}

}  // namespace stridor::support
