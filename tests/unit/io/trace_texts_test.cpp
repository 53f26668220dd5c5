#include "stridor/io/simulation/trace_texts.hpp"

#include "stridor/base/error.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

namespace stridor::io {
namespace {

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
