#include "stridor/base/opened_library.hpp"

#include <gtest/gtest.h>

namespace stridor::base {
namespace {

TEST(OpenedLibrary, FindsFunctionsByTheirNames) {
    OpenedLibrary library("libm.so.6");
    double (*ldexp)(double, int) = library.function("ldexp");
    ASSERT_TRUE(library.is_whole());
    EXPECT_EQ(ldexp(3.0, 4), 48.0);
}

TEST(OpenedLibrary, IsNotWholeOnAMachineThatLacksIt) {
    OpenedLibrary library("libstridor-absent-1.0.so.7");
    void (*function)() = library.function("anything");
    EXPECT_EQ(function, nullptr);
    EXPECT_FALSE(library.is_whole());
}

TEST(OpenedLibrary, IsNotWholeWhereItLacksAFunction) {
    OpenedLibrary library("libm.so.6");
    void (*first)() = library.function("stridor_absent");
    double (*second)(double, int) = library.function("ldexp");
    EXPECT_EQ(first, nullptr);
    EXPECT_NE(second, nullptr);
    EXPECT_FALSE(library.is_whole());
}

}  // namespace
}  // namespace stridor::base
