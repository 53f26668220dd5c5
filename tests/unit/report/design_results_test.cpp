#include "stridor/report/design_results.hpp"

#include "stridor/io/case/ready_files.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/report/timed_parts.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace stridor::report {
namespace {

using support::thrown_by;

TEST(ChartToReport, IsOverPreloadAndFrictionAroundTheDesign) {
    const io::TomlSource source{io::ready_file("squeal"), "squeal.toml", {}};
    const parameters::Case c = io::read_case(source);
    const sweep::Study study = chart_to_report(source, c, {}, 24);
    EXPECT_EQ(study.x.parameter, "contact.preload");
    EXPECT_NEAR(study.x.from, 0.1 * c.contact().preload, 1e-12);
    EXPECT_EQ(study.y.parameter, "contact.kinetic_friction");
    EXPECT_EQ(study.y.to, c.contact().static_friction);
    EXPECT_EQ(study.x.points, 24);
    EXPECT_EQ(study.quantities, std::vector<std::string>{"category"});
}

TEST(ChartToReport, KeepsTheAxesOfItsFileWithFewerPoints) {
    const io::TomlSource source{io::ready_file("rate-map"), "map.toml", {}};
    const sweep::Study study = chart_to_report(source, io::read_case(source), {}, 10);
    EXPECT_EQ(study.x.parameter, "drive.velocity");
    EXPECT_EQ(study.x.points, 10);
}

TEST(ChartToReport, HasTwoAxes) {
    const io::TomlSource source{io::ready_file("squeal"), "squeal.toml", {}};
    EXPECT_TRUE(thrown_by([&] {
                    chart_to_report(source, io::read_case(source), {"preload=1:40", ""}, 24);
                }).says("--x was given without --y"));
}

TEST(TimedParts, SaysWhyThereIsNoneWhenTheTimeIsUp) {
    DesignResults results;
    results.design = io::read_case({io::ready_file("squeal"), "squeal.toml", {}});
    add_advice(results, {}, std::chrono::seconds(0));
    EXPECT_FALSE(results.advice.has_value());
    EXPECT_NE(results.without_advice.find("did not end within 0 s"), std::string::npos);
}

TEST(TimedParts, ChartsCoarselyWhatItHasTimeFor) {
    DesignResults results;
    const io::TomlSource source{io::ready_file("squeal"), "squeal.toml", {"run.duration=1000", "run.window=1000"}};
    results.design = io::read_case(source);
    const sweep::Study study = chart_to_report(source, results.design, {}, 8);
    add_chart(results, study, {}, PartTime(0.0));
    EXPECT_FALSE(results.chart.has_value());
    EXPECT_EQ(results.about_chart, "No chart, however coarse, ended within 0 s; `stridor chart` takes its time.");
    const sweep::Study quick = [&] {
        sweep::Study short_run = study;
        short_run.base.run.duration = short_run.base.run.window = 0.4;
        return short_run;
    }();
    add_chart(results, quick, {}, PartTime(1e6));
    ASSERT_TRUE(results.chart.has_value());
    EXPECT_EQ(results.chart->study.x.points, 8);
}

TEST(TimedParts, TellsAnEndOfTimeFromAStop) {
    const auto wait = [](const std::stop_token& stop) {
        while (!stop.stop_requested())
            std::this_thread::yield();
        throw Error(ErrorKind::interrupted, {"stopped", "", ""});
    };
    EXPECT_FALSE(ends_within(PartTime(0.0), {}, wait));
    EXPECT_TRUE(ends_within(PartTime(1e6), {}, [](const std::stop_token&) {}));
    std::stop_source source;
    source.request_stop();
    EXPECT_EQ(thrown_by([&] { ends_within(PartTime(1e6), source.get_token(), wait); }).kind, ErrorKind::interrupted);
}

TEST(TimedParts, EndsWithWhoAskedForIt) {
    DesignResults results;
    results.design = io::read_case({io::ready_file("squeal"), "squeal.toml", {}});
    std::stop_source source;
    source.request_stop();
    advice::AdviceOptions options;
    options.stop = source.get_token();
    EXPECT_EQ(thrown_by([&] { add_advice(results, options, std::chrono::seconds(60)); }).kind, ErrorKind::interrupted);
}

}  // namespace
}  // namespace stridor::report
