#include "stridor/drawing/text.hpp"

#include <gtest/gtest.h>

namespace stridor::drawing {
namespace {

const std::vector<TextRun>& runs(const StyledText& text) {
    return text.runs;
}

TEST(StyledText, WhatAUserWroteStaysOnePlainRun) {
    EXPECT_EQ(runs("mu_d^2 {x}"), (std::vector<TextRun>{{"mu_d^2 {x}", TextStyle::plain}}));
    EXPECT_TRUE(is_empty(StyledText("")));
}

TEST(Symbol, SetsGreekLettersItalicAndIndicesLow) {
    EXPECT_EQ(runs(symbol("mu_d")), (std::vector<TextRun>{{"μ", TextStyle::italic}, {"d", TextStyle::subscript}}));
    EXPECT_EQ(runs(symbol("k1i")), (std::vector<TextRun>{{"k", TextStyle::italic}, {"1i", TextStyle::subscript}}));
    EXPECT_EQ(runs(symbol("A_exc")), (std::vector<TextRun>{{"A", TextStyle::italic}, {"exc", TextStyle::subscript}}));
    EXPECT_EQ(runs(symbol("alpha")), (std::vector<TextRun>{{"α", TextStyle::italic}}));
    EXPECT_EQ(runs(symbol("F")), (std::vector<TextRun>{{"F", TextStyle::italic}}));
}

TEST(UnitText, SetsPowersHighAndProductsDotted) {
    EXPECT_EQ(runs(unit_text("m/s^2")),
              (std::vector<TextRun>{{"m/s", TextStyle::plain}, {"2", TextStyle::superscript}}));
    EXPECT_EQ(plain_text(unit_text("N*s/m")), "N·s/m");
    EXPECT_EQ(plain_text(unit_text("deg")), "°");
    EXPECT_TRUE(is_empty(unit_text("1")));
    EXPECT_EQ(runs(unit_text("dB re 1e-6 N")),
              (std::vector<TextRun>{
                  {"dB re 10", TextStyle::plain}, {"−6", TextStyle::superscript}, {" N", TextStyle::plain}}));
}

TEST(UnitText, NamesTheReferenceOfVelocityLevelsAsPeopleDo) {
    EXPECT_EQ(plain_text(unit_text("dB re 1e-9 m/s")), "dB re 1 nm/s");
}

TEST(NumberText, WritesPowersOfTenAsPrinted) {
    EXPECT_EQ(plain_text(number_text(0.004)), "0.004");
    EXPECT_EQ(plain_text(number_text(-20.0)), "−20");
    EXPECT_EQ(runs(number_text(1e-6)),
              (std::vector<TextRun>{{"10", TextStyle::plain}, {"−6", TextStyle::superscript}}));
    EXPECT_EQ(plain_text(number_text(2e7)), "2·107");
}

}  // namespace
}  // namespace stridor::drawing
