#include "stridor/recordings/line_reader.hpp"

#include <gtest/gtest.h>

namespace stridor::recordings {
namespace {

TEST(FortranText, ReadsNumbersAsFortranPrintsThem) {
    EXPECT_EQ(fortran_number("1.5D-05"), 1.5e-5);
    EXPECT_EQ(fortran_number(" -.5E+3 "), -500.0);
    EXPECT_EQ(fortran_number("+1.d2"), 100.0);
    EXPECT_EQ(fortran_number("1.0-105"), 1e-105);
    EXPECT_EQ(fortran_number("-1.0+105"), -1e105);
    for (const char* text : {"", "-", "1.0E", "****", "1.0 2.0", "1.0E+00-1.0E+00", "0x10", "++1"})
        EXPECT_FALSE(fortran_number(text)) << text;
}

TEST(FortranText, IsSplitAtBlanks) {
    EXPECT_EQ(words(" 12  -1.0D+00\t3\r"), (std::vector<std::string_view>{"12", "-1.0D+00", "3"}));
    EXPECT_TRUE(words(" \t ").empty());
}

}  // namespace
}  // namespace stridor::recordings
