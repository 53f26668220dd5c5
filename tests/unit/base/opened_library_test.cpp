#include "stridor/base/opened_library.hpp"

#include "stridor/base/error.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stridor::base {
namespace {

using support::Thrown;
using support::thrown_by;

TEST(OpenedLibrary, FindsFunctionsByTheirNames) {
    OpenedLibrary library("libm.so.6");
    double (*ldexp)(double, int) = library.function("ldexp");
    ASSERT_TRUE(library.is_whole());
    EXPECT_EQ(ldexp(3.0, 4), 48.0);
    EXPECT_NO_THROW(library.expect_whole("nothing can be computed"));
}

TEST(OpenedLibrary, SaysWhichPackageIsMissing) {
    OpenedLibrary library("libstridor-absent-1.0.so.7");
    void (*function)() = library.function("anything");
    EXPECT_EQ(function, nullptr);
    EXPECT_FALSE(library.is_whole());
    const Thrown thrown = thrown_by([&] { library.expect_whole("no sound can be drawn"); });
    EXPECT_EQ(thrown.kind, ErrorKind::io);
    EXPECT_TRUE(thrown.says("no sound can be drawn (libstridor-absent-1.0.so.7: cannot open")) << thrown.message;
    EXPECT_TRUE(thrown.says("apt install libstridor-absent-1.0-7")) << thrown.message;
}

TEST(OpenedLibrary, SaysWhichFunctionIsMissing) {
    OpenedLibrary library("libm.so.6");
    void (*first)() = library.function("stridor_absent");
    void (*second)() = library.function("stridor_absent_too");
    EXPECT_EQ(first, nullptr);
    EXPECT_EQ(second, nullptr);
    const Thrown thrown = thrown_by([&] { library.expect_whole("no sound can be drawn"); });
    EXPECT_EQ(thrown.kind, ErrorKind::io);
    EXPECT_TRUE(thrown.says("(libm.so.6 has no function stridor_absent)")) << thrown.message;
}

TEST(OpenedLibrary, KnowsDebiansNames) {
    EXPECT_EQ(debian_package("libnetcdf.so.19"), "libnetcdf19");
    EXPECT_EQ(debian_package("libpangocairo-1.0.so.0"), "libpangocairo-1.0-0");
}

}  // namespace
}  // namespace stridor::base
