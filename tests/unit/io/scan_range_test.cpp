#include "stridor/io/chart/scan_range.hpp"

#include "stridor/base/error.hpp"

#include <gtest/gtest.h>

namespace stridor::io {
namespace {

TEST(ScanRange, IsReadWithUnitsAndAnyNameOfItsKey) {
    const analysis::ScanRange range = read_scan_range("incidence_angle=0 deg:180 deg:181");
    EXPECT_EQ(range.key, "joint.incidence_angle");
    EXPECT_EQ(range.from, 0.0);
    EXPECT_EQ(range.to, 180.0);
    EXPECT_EQ(range.points, 181);
}

TEST(ScanRange, RefusesAnythingElse) {
    for (const char* text : {"mu_d", "mu_d=0", "mu_d=0:1:2:3", "mu_d=0:1:1", "mu_d=0:1:x", "nokey=0:1"})
        EXPECT_THROW(read_scan_range(text), Error) << text;
}

}  // namespace
}  // namespace stridor::io
