#pragma once

#include "stridor/parameters/case.hpp"

#include <gtest/gtest.h>

#include <ostream>
#include <string>

namespace stridor::contract {

/// An engine as the contract suite sees it; every run goes through `integration::simulate`,
/// the one door to all engines.
struct EngineUnderTest {
    std::string name;
    void (*choose)(parameters::Case&);  // sets the engine and settings that make 20 ms of motion cheap
    double energy_tolerance = 0.0;      // [1] largest relative residual of the energy balance: rounding, derived
    double unstable_step = 0.0;         // [s] a time step no run may be made with; 0: no step is too long
};

inline void PrintTo(const EngineUnderTest& engine, std::ostream* out) {
    *out << engine.name;
}

/// What every engine promises. Instantiate it with INSTANTIATE_TEST_SUITE_P for each engine.
class EngineContract : public testing::TestWithParam<EngineUnderTest> {};

}  // namespace stridor::contract
