#pragma once

#include "stridor/model/laws/impact.hpp"

#include <gtest/gtest.h>

#include <ostream>
#include <string>

namespace stridor::contract {

/// A law of impacts as the contract suite sees it.
struct ImpactUnderTest {
    std::string name;
    model::ImpactLaw law;
};

inline void PrintTo(const ImpactUnderTest& impact, std::ostream* out) {
    *out << impact.name;
}

/// What every law of impacts promises the engines. Instantiate it with INSTANTIATE_TEST_SUITE_P for each law.
class ImpactContract : public testing::TestWithParam<ImpactUnderTest> {};

}  // namespace stridor::contract
