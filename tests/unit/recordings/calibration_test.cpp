#include "stridor/recordings/calibration.hpp"

#include "stridor/recordings/sidecar.hpp"
#include "stridor/recordings/time_grid.hpp"
#include "support/expected_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stridor::recordings {

using support::error_of;
using support::expect_error;
namespace {

TEST(FullScale, IsAQuantityOfAnyUnitASensorHas) {
    EXPECT_EQ(parse_full_scale("2 Pa"), (FullScale{2.0, "Pa"}));
    EXPECT_EQ(parse_full_scale("2.5kPa"), (FullScale{2500.0, "Pa"}));
    EXPECT_EQ(parse_full_scale("50 m/s^2"), (FullScale{50.0, "m/s^2"}));
    EXPECT_EQ(parse_full_scale("10 mm/s"), (FullScale{0.01, "m/s"}));
    EXPECT_EQ(parse_full_scale("300 mN"), (FullScale{0.3, "N"}));
    EXPECT_EQ(parse_full_scale("1 mV"), (FullScale{0.001, "V"}));
    EXPECT_EQ(parse_full_scale("0.5 FS"), (FullScale{0.5, "FS"}));
    EXPECT_EQ(parse_full_scale("1e2 Pa"), (FullScale{100.0, "Pa"}));
}

TEST(FullScale, InGIsGravityAndNoMass) {
    EXPECT_EQ(parse_full_scale("10 g"), (FullScale{10.0 * 9.80665, "m/s^2"}));
}

TEST(FullScale, IsRefusedWithoutAUnitOrSense) {
    for (const char* text : {"", "2", "Pa", "0 Pa", "-1 Pa", "nan Pa", "2 2 Pa", "1e400 Pa"})
        EXPECT_TRUE(error_of([&] { parse_full_scale(text); })) << text;
    expect_error(error_of([] { parse_full_scale("2"); }), "it has no unit", "");
    expect_error(error_of([] { parse_full_scale("2 Pas"); }), "unknown unit \"Pas\"", "");
}

TEST(UnitLabel, IsUnderstoodAsLabsWriteIt) {
    EXPECT_EQ(unit_of_label("m/s**2"), (FullScale{1.0, "m/s^2"}));
    EXPECT_EQ(unit_of_label(" m/s² "), (FullScale{1.0, "m/s^2"}));
    EXPECT_EQ(unit_of_label("g"), (FullScale{9.80665, "m/s^2"}));
    for (const char* label : {"m/s2", "m/sec^2", "(m/s^2)", "[m/s\xB2]", "m/sec2", "m/s/s", "m*s^-2", "m.s-2"})
        EXPECT_EQ(unit_of_label(label), (FullScale{1.0, "m/s^2"})) << label;
    EXPECT_EQ(unit_of_label("mm/s2"), (FullScale{1e-3, "m/s^2"}));
    for (const char* label : {"G", "gn", "g's"})
        EXPECT_EQ(unit_of_label(label), (FullScale{9.80665, "m/s^2"})) << label;
    EXPECT_NEAR(unit_of_label("mg").value, 9.80665e-3, 1e-15);
    EXPECT_EQ(unit_of_label("Newtons"), (FullScale{1.0, "N"}));
    EXPECT_EQ(unit_of_label("Volts"), (FullScale{1.0, "V"}));
    EXPECT_EQ(unit_of_label("N.m"), (FullScale{1.0, "J"}));
    EXPECT_EQ(unit_of_label("lbf"), (FullScale{4.4482216152605, "N"}));
    EXPECT_EQ(unit_of_label("in/sec"), (FullScale{0.0254, "m/s"}));
    EXPECT_EQ(unit_of_label("\xB5s"), (FullScale{1e-6, "s"}));
    EXPECT_EQ(unit_of_label("Deg C").unit, "Deg C") << "what is not known stays what it is";
    EXPECT_EQ(unit_of_label("kN"), (FullScale{1000.0, "N"}));
    EXPECT_EQ(unit_of_label(""), FullScale{});
    EXPECT_EQ(unit_of_label("-"), FullScale{});
    EXPECT_EQ(unit_of_label("counts"), (FullScale{1.0, "counts"}));
    EXPECT_FALSE(is_known_unit("counts"));
}

// 94 dB SPL is an rms of 1.0024 Pa; the number 1 is the peak of a sine whose peaks reach full scale
TEST(Description, GivesThePressureOfFullScale) {
    for (const char* text : {"0dBFS = 94 dBSPL", "rig 7; 0 dBFS: 94 dB SPL, gain 2", "-20 dBFS = 74 dB (SPL)",
                             "0dBFS=94,0 dBSPL", "0 DBFS is 94.00 dbspl"}) {
        const auto scale = calibration_in(text);
        ASSERT_TRUE(scale) << text;
        EXPECT_EQ(scale->unit, "Pa");
        EXPECT_NEAR(scale->value, std::sqrt(2.0) * 20e-6 * std::pow(10.0, 94.0 / 20.0), 1e-12) << text;
    }
}

TEST(Description, MayGiveAnyFullScaleExactly) {
    EXPECT_EQ(calibration_in("0dBFS = 94 dBSPL; full scale = 2 Pa"), (FullScale{2.0, "Pa"}));
    EXPECT_EQ(calibration_in("Full Scale: 1 g"), (FullScale{9.80665, "m/s^2"}));
}

TEST(Description, OfOtherThingsIsNoCalibration) {
    for (const char* text : {"", "peak -3 dBFS", "dBFS = 94 dBSPL", "0dBFS = 94 dB", "0dBFS = loud dBSPL",
                             "0dBFS = 9999 dBSPL", "at full scale the needle bends", "full scale = very"})
        EXPECT_FALSE(calibration_in(text)) << text;
}

TEST(Description, ReadsBackAsItWasWritten) {
    for (const FullScale& scale : {FullScale{2.0, "Pa"}, FullScale{1.0 / 3.0, "Pa"}, FullScale{98.0665, "m/s^2"}})
        EXPECT_EQ(calibration_in(calibration_text(scale)), scale);
    EXPECT_EQ(calibration_text(FullScale{}), "");
    EXPECT_EQ(calibration_text({2.0, "Pa"}), "0dBFS = 96.99 dBSPL; full scale = 2 Pa");
}

TEST(Sidecar, ReadsBackAsItWasWritten) {
    const Sidecar sidecar{
        {{"left", FullScale{2.0, "Pa"}}, {std::nullopt, std::nullopt}}, 48000.5, {{"preload", "20 N"}}};
    const Sidecar back = parse_sidecar(sidecar_json(sidecar), "s");
    ASSERT_EQ(back.channels.size(), 2U);
    EXPECT_EQ(back.channels[0].name, "left");
    EXPECT_EQ(back.channels[0].full_scale, (FullScale{2.0, "Pa"}));
    EXPECT_FALSE(back.channels[1].name || back.channels[1].full_scale);
    EXPECT_EQ(back.rate, 48000.5);
    EXPECT_EQ(back.metadata, sidecar.metadata);
}

TEST(Sidecar, IsRefusedWithItsReason) {
    const auto refusal = [](const std::string& rest) {
        return error_of([&] { parse_sidecar("{\"schema\": \"stridor.sidecar/1\", " + rest + "}", "s.json"); });
    };
    expect_error(error_of([] { parse_sidecar("{", "s.json"); }),
                 "the sidecar is no JSON (it cannot be read on from here). Correct it, or remove it", "s.json:1:2");
    expect_error(error_of([] { parse_sidecar("{\n \"rate\": 8000,\n \"unit\": Pa\n}", "s.json"); }), "no JSON",
                 "s.json:3:10");
    expect_error(refusal("\"rate\": 1e999"), "a number in it is too large", "s.json");
    expect_error(error_of([] { parse_sidecar("{}", "s.json"); }), "is no sidecar", "s.json");
    expect_error(refusal("\"chanels\": []"), "Did you mean \"channels\"?", "s.json");
    expect_error(refusal("\"channels\": 1"), "is no list", "s.json");
    expect_error(refusal("\"channels\": [{\"full_scale\": 2}]"), "without a \"unit\"", "s.json");
    expect_error(refusal("\"channels\": [{\"unit\": \"loud\"}]"), "unknown unit", "s.json");
    expect_error(refusal("\"channels\": [{\"unit\": \"Pa\", \"full_scale\": -1}]"), "no positive number", "s.json");
    expect_error(refusal("\"rate\": \"fast\""), "\"rate\" is no positive number", "s.json");
}

TEST(Rate, IsSnappedToTheOneBehindTheDigits) {
    EXPECT_EQ(snapped_rate(2.08333e-5, step_tolerance("2.08333E-05")).rate, 48000.0);
    EXPECT_EQ(snapped_rate(2.26757e-5, step_tolerance("2.26757E-05")).rate, 44100.0);
    EXPECT_EQ(snapped_rate(1.95312e-5, step_tolerance("1.95312E-05")).rate, 51200.0);  // cut, not rounded
    EXPECT_EQ(snapped_rate(1.52588e-5, step_tolerance("1.52588E-05")).rate, 65536.0);
    EXPECT_EQ(snapped_rate(0.3, step_tolerance("3.00000E-01")).rate, 1.0 / 0.3);
    EXPECT_EQ(snapped_rate(1.0 / 48000.0, 1e-12).rate, 48000.0);
}

TEST(Rate, IsLeftAloneWhereTheDigitsTell) {
    // twelve digits of 1/48000.1 are no 48000
    EXPECT_NEAR(snapped_rate(2.08332899307e-5, step_tolerance("2.08332899307E-05")).rate, 48000.1, 1e-5);
    EXPECT_EQ(snapped_rate(1e-3, 1e-9).note, "");
    EXPECT_EQ(snapped_rate(2.08333e-5, 5e-6).note, "the step 2.08333e-05 s was taken for 48000 Hz");
}

}  // namespace
}  // namespace stridor::recordings
