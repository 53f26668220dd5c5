#include "stridor/recordings/table/sampled_csv.hpp"

#include "support/expected_error.hpp"

#include <gtest/gtest.h>

namespace stridor::recordings {

using support::error_of;
using support::expect_error;
namespace {

std::optional<Error> refusal(const std::string& text) {
    const auto error = error_of([&] { read_sampled_csv(text, "d.csv"); });
    EXPECT_TRUE(!error || error->kind() == ErrorKind::input) << error->what();
    return error;
}

void expect_two_samples(const std::string& text) {
    const SampledMotion motion = read_sampled_csv(text, "d.csv");
    EXPECT_EQ(motion.times, (std::vector<double>{0.0, 0.5})) << text;
    EXPECT_EQ(motion.velocities, (std::vector<double>{0.1, -0.25})) << text;
}

TEST(SampledCsv, SniffsTheDelimiterAndTheDecimalMark) {
    expect_two_samples("time,velocity\n0,0.1\n0.5,-0.25\n");
    expect_two_samples("time;velocity\n0;0.1\n0.5;-0.25\n");
    expect_two_samples("time\tvelocity\n0\t0.1\n0.5\t-0.25\n");
    expect_two_samples("time;velocity\n0;0,1\n0,5;-0,25\n");
    expect_two_samples("time\tvelocity\n0\t0,1\n5,e-1\t-2,5E-1\n");
}

TEST(SampledCsv, FindsColumnsByNameInAnyOrderAndCase) {
    expect_two_samples("t,v\n0,0.1\n0.5,-0.25\n");
    expect_two_samples("V,force,Time\n0.1,9,0\n-0.25,9,0.5\n");
    expect_two_samples("note,\"velocity\",\"time\"\n\"a, b\",0.1,0\nx,-0.25,0.5\n");
}

TEST(SampledCsv, ReadsUnitsFromTitlesOrTheirOwnRow) {
    expect_two_samples("time [ms],velocity [mm/s]\n0,100\n500,-250\n");
    expect_two_samples("time (ms);velocity (cm/s)\n0;10\n500;-25\n");
    expect_two_samples("time,velocity\nms,mm/s\n0,100\n500,-250\n");
    expect_two_samples("time,velocity\n[s],[m/s]\n0,0.1\n0.5,-0.25\n");
    expect_two_samples("time,velocity\n,\n0,0.1\n0.5,-0.25\n");
}

TEST(SampledCsv, NeedsNoHeaderForTwoColumns) {
    expect_two_samples("0,0.1\n0.5,-0.25\n");
    expect_two_samples("+0;+0,1\n0,5;-0,25");
}

TEST(SampledCsv, SkipsMarksCommentsBlankLinesAndTrailingDelimiters) {
    expect_two_samples("\xEF\xBB\xBFtime,velocity\r\n0,0.1\r\n0.5,-0.25\r\n");
    expect_two_samples("# measured\n\ntime,velocity\n  # in the lab\n0,0.1\n\n0.5,-0.25\n\n");
    expect_two_samples("time;velocity;\n0;0.1;\n0.5;-0.25;\n");
    expect_two_samples("time,velocity\r0,0.1\r0.5,-0.25\r");
}

TEST(SampledCsv, PointsAtTheFieldThatIsNoNumber) {
    expect_error(refusal("t,v\n0,1\n1,fast\n"), "velocity = \"fast\" is not a number", "d.csv:3:3");
    expect_error(refusal("t;v\n0;1\n1,5x;2\n"), "time = \"1,5x\" is not a number", "d.csv:3:1");
    expect_error(refusal("t;v\n0;1\n1;1.2345,5\n"), "Write the decimal mark as a point", "d.csv:3:3");
    expect_error(refusal("t,v\n0,1\n1,\n"), "velocity = \"\" is not a number (the field is empty)", "d.csv:3:3");
    expect_error(refusal("t,v\n0,1\n1,nan\n"), "velocity = \"nan\" is not a finite number", "d.csv:3:3");
    expect_error(refusal("t,v\n0,1\n1,1e999\n"), "is not a finite number", "d.csv:3:3");
    expect_error(refusal("t [s],v [km/s]\n0,1\n1,1e308\n"), "is not a finite number", "d.csv:3:3");
    EXPECT_EQ(refusal("t,v\n0,1\n1,fast\n")->place()->source_line, "1,fast");
}

TEST(SampledCsv, PointsAtShortAndLongRows) {
    expect_error(refusal("t,v\n0,1\n1"), "the row has 1 columns (the first row has 2)", "d.csv:3:1");
    expect_error(refusal("t,v\n0,1\n1,2,3\n"), "the row has 3 columns (the first row has 2)", "d.csv:3:5");
}

TEST(SampledCsv, RefusesTimesThatDoNotIncrease) {
    expect_error(refusal("v,t\n1,0\n2,1\n3,1\n"), "1 s follows 1 s", "d.csv:4:3");
    expect_error(refusal("t,v\n0,1\n-1,2\n"), "the times do not increase", "d.csv:3:1");
}

TEST(SampledCsv, NamesTheColumnsWhenOneIsMissing) {
    expect_error(refusal("time,speed\n0,1\n"), "there is no column velocity (the columns are: time, speed)",
                 "d.csv:1:1");
    expect_error(refusal("0,1,2\n"), "3 columns without a header", "d.csv:1:1");
}

TEST(SampledCsv, RefusesUnitsOfTheWrongDimension) {
    expect_error(refusal("time [s],velocity [mm]\n0,1\n"), "the column velocity is in mm, a length (m)", "d.csv:1:10");
    expect_error(refusal("time,velocity\nN,m/s\n0,1\n"), "the column time is in N, a force (N)", "d.csv:2:1");
    expect_error(refusal("time [ticks],velocity\n0,1\n"), "unknown unit \"ticks\"", "d.csv:1:1");
}

TEST(SampledCsv, RefusesEmptyFilesAndOtherEncodings) {
    expect_error(refusal(""), "the file holds no table", "d.csv");
    expect_error(refusal("# only this\n\n"), "the file holds no table", "d.csv");
    expect_error(refusal("\xFF\xFEt\0,\0"), "Save it as UTF-8", "d.csv:1:1");
}

// friction over the speed of slip is read in the same way
TEST(FrictionCsv, FindsItsColumnsAndUnits) {
    const SampledFriction table = read_friction_csv("friction;speed [mm/s]\n0,8;0\n0,6;50\n", "f.csv");
    EXPECT_EQ(table.speeds, (std::vector<double>{0.0, 0.05}));
    EXPECT_EQ(table.coefficients, (std::vector<double>{0.8, 0.6}));
    EXPECT_EQ(read_friction_csv("0,0.8\n1,0.5\n", "f.csv").coefficients, (std::vector<double>{0.8, 0.5}));
}

TEST(FrictionCsv, OfWhatIsNoFunctionIsRefusedWithItsPlace) {
    const auto refusal_of = [](std::string_view text) { return error_of([&] { read_friction_csv(text, "f.csv"); }); };
    expect_error(refusal_of("speed,friction\n0,0.8\n0.1,0.6\n0.1,0.5\n"), "the speeds do not increase", "f.csv:4:1");
    expect_error(refusal_of("speed,mu\n0,0.8\n"), "there is no column friction", "f.csv:1:1");
    expect_error(refusal_of("speed,friction\n0,wet\n"), "is not a number", "f.csv:2:3");
}

}  // namespace
}  // namespace stridor::recordings
