#include "stridor/io/chart/range_text.hpp"

#include "stridor/base/error.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

namespace stridor::io {
namespace {

TEST(RangeText, IsAKeyAndWhatStandsBetweenColons) {
    const auto text = split_range(" mu_d = 0.2 : 0.8 : 30 ");
    ASSERT_TRUE(text.has_value());
    EXPECT_EQ(text->key, "mu_d");
    EXPECT_EQ(text->parts, (std::vector<std::string_view>{"0.2", "0.8", "30"}));
}

TEST(RangeText, KeepsEmptyParts) {
    EXPECT_EQ(split_range("mu_d=")->parts, std::vector<std::string_view>{""});
    EXPECT_EQ(split_range("mu_d=:1:")->parts, (std::vector<std::string_view>{"", "1", ""}));
}

TEST(RangeText, IsNoneWithoutAnEqualsSign) {
    EXPECT_FALSE(split_range("mu_d").has_value());
    EXPECT_FALSE(split_range("").has_value());
}

TEST(RangeEnds, TakeTheUnitOfTheLastEnd) {
    const RangeEnds ends = read_range_ends("1", "40 kN", "N");
    EXPECT_EQ(ends.from, 1000.0);
    EXPECT_EQ(ends.to, 40000.0);
}

TEST(RangeEnds, MayEachHaveTheirOwn) {
    const RangeEnds ends = read_range_ends("+500 mN", "2 N", "N");
    EXPECT_EQ(ends.from, 0.5);
    EXPECT_EQ(ends.to, 2.0);
}

TEST(RangeEnds, WithoutUnitsAreInTheOneAskedFor) {
    const RangeEnds ends = read_range_ends("-30", "80", "degC");
    EXPECT_EQ(ends.from, -30.0);
    EXPECT_EQ(ends.to, 80.0);
}

TEST(RangeEnds, RefuseWhatIsNoQuantity) {
    EXPECT_THROW(read_range_ends("", "40 N", "N"), Error);
    EXPECT_THROW(read_range_ends("1", "", "N"), Error);
    EXPECT_THROW(read_range_ends("1", "40 mm", "N"), Error);
}

TEST(RangePoints, AreWholeAndWithinBounds) {
    EXPECT_EQ(read_points("2", 100), 2);
    EXPECT_EQ(read_points("100", 100), 100);
    for (const char* text : {"1", "101", "-3", "3.5", "3 ", "", "many", "99999999999"})
        EXPECT_FALSE(read_points(text, 100).has_value()) << text;
}

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

TEST(TraceTexts, AreTheWholeRunWithoutTimes) {
    parameters::Case c;
    c.run.duration = 0.3;
    const record::TraceRequest trace = trace_request({}, c);
    EXPECT_EQ(trace.from, 0.0);
    EXPECT_EQ(trace.to, 0.3);
    EXPECT_EQ(trace.interval, 20e-6);
}

TEST(TraceTexts, CarryUnits) {
    const record::TraceRequest trace = trace_request({"10 ms", "20 ms", "0.5 ms"}, {});
    EXPECT_DOUBLE_EQ(trace.from, 0.01);
    EXPECT_DOUBLE_EQ(trace.to, 0.02);
    EXPECT_DOUBLE_EQ(trace.interval, 5e-4);
}

TEST(TraceTexts, RefuseTracesWithoutSamplesAndThoseThatNoMemoryHolds) {
    const auto refusal = [](const TraceTexts& texts) { return support::thrown_by([&] { trace_request(texts, {}); }); };
    EXPECT_TRUE(refusal({"20 ms", "10 ms", "1 ms"}).says("the trace has no samples"));
    EXPECT_TRUE(refusal({"", "", "0 s"}).says("the trace has no samples"));
    EXPECT_TRUE(refusal({"0 s", "1 s", "0.1 us"}).says("the trace has 1e+07 samples"));
    EXPECT_TRUE(refusal({"1e300 s", "1e300 s", "1 us"}).says("the trace has 0 samples"));
    EXPECT_EQ(refusal({"noon", "", "1 ms"}).kind, ErrorKind::input);
}

}  // namespace
}  // namespace stridor::io
