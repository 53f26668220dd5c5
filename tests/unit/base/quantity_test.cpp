#include "stridor/base/quantity.hpp"

#include "support/error_text.hpp"
#include "support/property.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <string>
#include <utility>

namespace stridor::base {
namespace {

using support::Thrown;
using support::thrown_by;

Thrown refusal(const char* text, const char* unit) {
    const Thrown thrown = thrown_by([&] { parse_quantity(text, unit); });
    EXPECT_EQ(thrown.kind, ErrorKind::input) << text;
    return thrown;
}

TEST(Quantity, WithoutAUnitIsInTheFieldsOwn) {
    EXPECT_EQ(parse_quantity("20", "N"), 20.0);
    EXPECT_EQ(parse_quantity("70", "deg"), 70.0);
    EXPECT_EQ(parse_quantity(" -3.5e2 ", "m/s"), -350.0);
    EXPECT_EQ(parse_quantity("+0.6", "1"), 0.6);
}

TEST(Quantity, WithAUnitIsConvertedToSiAndDegrees) {
    EXPECT_EQ(parse_quantity("20 N", "N"), 20.0);
    EXPECT_EQ(parse_quantity("20N", "N"), 20.0);
    EXPECT_EQ(parse_quantity("4 mm", "m"), 0.004);
    EXPECT_EQ(parse_quantity("70 deg", "deg"), 70.0);
    EXPECT_EQ(parse_quantity("70°", "deg"), 70.0);
    EXPECT_EQ(parse_quantity("45 %", "1"), 0.45);
    EXPECT_EQ(parse_quantity("-10 degC", "degC"), -10.0);
    EXPECT_EQ(parse_quantity("23°C", "degC"), 23.0);
    EXPECT_EQ(parse_quantity("2 min", "s"), 120.0);
    EXPECT_EQ(parse_quantity("100 g", "kg"), 0.1);
    EXPECT_EQ(parse_quantity("0.4 kg", "kg"), 0.4);
    EXPECT_EQ(parse_quantity("5 µm", "m"), 5e-6);
    EXPECT_DOUBLE_EQ(parse_quantity("1 rad", "deg"), 57.29577951308232);
    EXPECT_DOUBLE_EQ(parse_quantity("1 mrad", "deg"), 0.05729577951308232);
}

TEST(Quantity, MayBeInUnitsOfTheWorkshop) {
    EXPECT_EQ(parse_quantity("60 rpm", "Hz"), 1.0);
    EXPECT_EQ(parse_quantity("720 rpm", "Hz"), 12.0);
    EXPECT_EQ(parse_quantity("60 1/min", "Hz"), 1.0);
    EXPECT_EQ(parse_quantity("2 daN", "N"), 20.0);
    EXPECT_EQ(parse_quantity("0.4 daN/mm", "N/m"), 4000.0);
    EXPECT_EQ(parse_quantity("1.5 t", "kg"), 1500.0);
    EXPECT_EQ(parse_quantity("1 h", "s"), 3600.0);
    EXPECT_EQ(parse_quantity("36 km/h", "m/s"), 10.0);
    EXPECT_EQ(parse_quantity("3 Ns/m", "N*s/m"), 3.0);
    EXPECT_EQ(parse_quantity("3 Ns/mm", "N*s/m"), 3000.0);
    EXPECT_EQ(parse_quantity("2 kNm", "J"), 2000.0);
}

// n whole parts of a unit that has no exact double read as the nearest one
RC_GTEST_PROP(Quantity, TurnsPerMinuteAreDividedExactly, ()) {
    const int turns = *support::whole_between(1, 100000);
    RC_ASSERT(parse_quantity(std::to_string(turns) + " rpm", "Hz") == static_cast<double>(turns) / 60.0);
}

TEST(Quantity, MayBeElectric) {
    EXPECT_EQ(parse_quantity("250 mV", "V"), 0.25);
    EXPECT_EQ(parse_unit("V*A*s").dimension, parse_unit("J").dimension);
    EXPECT_EQ(describe(parse_unit("mV").dimension), "a voltage (V)");
    EXPECT_EQ(describe(parse_unit("V/m").dimension), "a quantity in kg m s^-3 A^-1");
}

TEST(Quantity, FindsAUnitWithoutAnError) {
    EXPECT_EQ(find_unit("kN")->factor, 1000.0);
    for (const char* text : {"", "Pas", "m/", "s^99", "counts"})
        EXPECT_FALSE(find_unit(text)) << text;
}

TEST(Quantity, TenthOfAMicrosecondIsExactlyWhatAUserWrites) {
    EXPECT_EQ(parse_quantity("0.1 us", "s"), 1e-7);
    EXPECT_EQ(parse_quantity("100 ns", "s"), 1e-7);
    EXPECT_EQ(parse_quantity("1e-4 ms", "s"), 1e-7);
}

// "k e-d prefix" and "k e(exponent - d)" name one decimal number: both must read as the double nearest to it
RC_GTEST_PROP(Quantity, DecimalPrefixesReadAsTheNearestDouble, ()) {
    struct Prefixed {
        const char* unit;
        const char* si;
        int exponent;
    };
    const auto prefixed = *rc::gen::element(
        Prefixed{"us", "s", -6}, Prefixed{"ns", "s", -9}, Prefixed{"mm", "m", -3}, Prefixed{"cm", "m", -2},
        Prefixed{"%", "1", -2}, Prefixed{"kN", "N", 3}, Prefixed{"MN", "N", 6}, Prefixed{"kN/mm", "N/m", 6},
        Prefixed{"N*s/mm", "N*s/m", 3}, Prefixed{"mm/s", "m/s", -3}, Prefixed{"g", "kg", -3}, Prefixed{"kHz", "Hz", 3});
    const std::string digits = std::to_string(*support::whole_between(-99999, 99999));
    const int shift = *support::whole_between(-6, 6);
    const std::string text = digits + "e" + std::to_string(shift) + " " + prefixed.unit;
    const std::string plain = digits + "e" + std::to_string(shift + prefixed.exponent);
    RC_ASSERT(parse_quantity(text, prefixed.si) == std::strtod(plain.c_str(), nullptr));
}

TEST(Unit, ReadsProductsQuotientsAndPowers) {
    const Unit damping = parse_unit("N*s/m");
    EXPECT_EQ(damping.dimension, (Dimension{1, 0, -1, 0}));
    EXPECT_EQ(damping.factor, 1.0);
    for (const char* same : {"N s/m", "N·s/m", "N s / m", "kg/s", "kg*s^-1", " N*s/m "})
        EXPECT_EQ(parse_unit(same).dimension, damping.dimension) << same;

    EXPECT_EQ(parse_unit("kN/mm").dimension, (Dimension{1, 0, -2, 0}));
    EXPECT_DOUBLE_EQ(parse_unit("kN/mm").factor, 1e6);
    EXPECT_EQ(parse_unit("m/s^2").dimension, (Dimension{0, 1, -2, 0}));
    EXPECT_EQ(parse_unit("m/s²").dimension, parse_unit("m/s^2").dimension);
    EXPECT_DOUBLE_EQ(parse_unit("mm^3").factor, 1e-9);
    EXPECT_DOUBLE_EQ(parse_unit("ms^-2").factor, 1e6);
    EXPECT_EQ(parse_unit("N").dimension, parse_unit("kg*m/s^2").dimension);
    EXPECT_EQ(parse_unit("J").dimension, parse_unit("N*m").dimension);
    EXPECT_EQ(parse_unit("Pa").dimension, parse_unit("N/m^2").dimension);
    EXPECT_EQ(parse_unit("kg").factor, 1.0);
    // a quotient of quotients reads from left to right, as in every text book
    EXPECT_EQ(parse_unit("m/s/s").dimension, parse_unit("m/s^2").dimension);
}

TEST(Unit, HasAWordForEveryKindOfField) {
    constexpr std::array words{
        std::pair{"1", "a plain number"},      std::pair{"kg", "a mass (kg)"},
        std::pair{"m", "a length (m)"},        std::pair{"s", "a time (s)"},
        std::pair{"deg", "an angle (deg)"},    std::pair{"N", "a force (N)"},
        std::pair{"N/m", "a stiffness (N/m)"}, std::pair{"N*s/m", "a damping (N*s/m)"},
        std::pair{"m/s", "a velocity (m/s)"},  std::pair{"Hz", "a frequency (Hz)"},
    };
    for (const auto& [unit, word] : words)
        EXPECT_EQ(describe(parse_unit(unit).dimension), word);
    EXPECT_EQ(describe(parse_unit("kg*m^3/s").dimension), "a quantity in kg m^3 s^-1");
}

TEST(QuantityError, NamesBothDimensionsWhenTheyDiffer) {
    const Thrown thrown = refusal("20 mm", "N");
    EXPECT_TRUE(thrown.says("a length (m)")) << thrown.message;
    EXPECT_TRUE(thrown.says("expected a force (N)")) << thrown.message;
    EXPECT_TRUE(thrown.says("\"20 mm\"")) << thrown.message;
    // an angle is no plain number, and the other way round
    EXPECT_TRUE(refusal("0.6 deg", "1").says("an angle (deg)"));
    EXPECT_TRUE(refusal("70 %", "deg").says("a plain number"));
}

TEST(QuantityError, SuggestsTheNearestUnit) {
    EXPECT_TRUE(refusal("20 degg", "deg").says("Did you mean \"deg\"?"));
    EXPECT_TRUE(refusal("20 furlongs", "m").says("Give it in m. Known: m, g"));
    for (const char* unit : {"lbf", "kgf", "psi", "bar", "in", "ft"})
        EXPECT_TRUE(refusal("20 furlongs", "m").says(std::string(", ") + unit + ",")) << unit;
    EXPECT_TRUE(refusal("20 N*s/mmm", "N*s/m").says("Did you mean \"N*s/mm\"?"));
}

TEST(QuantityError, SuggestsTheSameInOtherLettersFirst) {
    EXPECT_TRUE(refusal("8 n", "N").says("Did you mean \"N\"?"));
    EXPECT_TRUE(refusal("8 KN", "N").says("Did you mean \"kN\"?"));
    EXPECT_TRUE(refusal("8 MM", "m").says("Did you mean \"mm\"?"));
    EXPECT_TRUE(refusal("8 n s/m", "N*s/m").says("Did you mean \"N s/m\"?"));
    EXPECT_TRUE(refusal("8 hz", "Hz").says("Did you mean \"Hz\"?"));
    EXPECT_TRUE(refusal("8 Newton", "N").says("Did you mean \"N\"?"));
    EXPECT_TRUE(refusal("8 Seconds", "s").says("Did you mean \"s\"?"));
}

TEST(QuantityError, SuggestsNothingOfAnotherDimension) {
    for (const auto& [text, unit] : {std::pair{"8 n", "s"}, {"8 x", "N"}, {"8 rpn", "deg"}, {"8 radd", "Hz"}})
        EXPECT_FALSE(refusal(text, unit).says("Did you mean")) << text;
    EXPECT_TRUE(refusal("720 rpm", "deg").says("a frequency (Hz)"));
}

TEST(QuantityError, RefusesWhatIsNoNumber) {
    for (const char* text : {"", "  ", "fast", "inf", "nan", "infinity N", "--5", "+-5", "+", "."})
        EXPECT_TRUE(refusal(text, "N").says("is not a number")) << text;
}

TEST(QuantityError, RefusesWhatIsNotFinite) {
    for (const char* text : {"1e999", "-1e999 N", "-inf", "1e306 kN", "1e305 MN"})
        refusal(text, "N");
    EXPECT_TRUE(refusal("1e306 kN", "N").says("is not a finite number"));
}

TEST(QuantityError, ExplainsADecimalComma) {
    EXPECT_TRUE(refusal("0,5", "1").says("Write \"0.5\"."));
    EXPECT_TRUE(refusal("-12,25 mm", "m").says("Write \"-12.25 mm\"."));
    for (const char* text : {"1,234.5 N", "1,234,567 N", "0, 5 N", "1.5,3 N", "3,N"})
        EXPECT_TRUE(refusal(text, "N").says("Write 1234.5, not 1,234.5.")) << text;
}

TEST(QuantityError, RefusesBrokenUnits) {
    for (const char* text : {"1 N/", "1 N//m", "1 *N", "1 m^", "1 m^x", "1 m^2.5", "1 m^10", "1 kkg", "1 kmin", "1 /s"})
        refusal(text, "N");
    EXPECT_EQ(thrown_by([] { parse_unit(""); }).kind, ErrorKind::input);
}

}  // namespace
}  // namespace stridor::base
