#pragma once

#include "stridor/model/laws/friction.hpp"

#include <gtest/gtest.h>

#include <ostream>
#include <string>

namespace stridor::contract {

/// A law of friction as the contract suite sees it.
struct FrictionUnderTest {
    std::string name;
    model::FrictionLaw law;
    double rise = 0.0;  // [s/m] of a slip, by viscosity: the only way above the limit of the stick
};

inline void PrintTo(const FrictionUnderTest& friction, std::ostream* out) {
    *out << friction.name;
}

/// What every law of friction promises the engines. Instantiate it with INSTANTIATE_TEST_SUITE_P for each law.
class FrictionContract : public testing::TestWithParam<FrictionUnderTest> {
protected:
    const model::FrictionLaw& law() const { return GetParam().law; }
};

}  // namespace stridor::contract
