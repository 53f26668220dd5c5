#include "stridor/io/chart/chart_exports.hpp"

#include "invented_chart.hpp"
#include "io_support.hpp"
#include "stridor/io/chart/chart_csv.hpp"

#include <gtest/gtest.h>

namespace stridor::io {
namespace {

using Names = std::vector<std::string>;

Names names_of(const std::vector<sweep::CellFigure>& figures) {
    Names names;
    for (const sweep::CellFigure& figure : figures)
        names.emplace_back(figure.name);
    return names;
}

TEST(ChartExports, AreAllTablesAndPicturesOfAUsualChart) {
    const sweep::Study study = invented_study(500, 1000);  // 1e6 cells
    const ChartExports exports = chart_exports(study, {});
    EXPECT_EQ(file_names(exports, study), (Names{"chart.png", "chart.svg", "chart.csv", "boundaries.csv", "chart.nc",
                                                 "chart.sqlite", "chart.toml"}));
    EXPECT_EQ(exports.figures.size(), sweep::cell_figures().size());
    EXPECT_EQ(exports.left_out, "");
}

TEST(ChartExports, OfALargeChartHaveNoCsvAndTheFiguresThatAreDrawn) {
    sweep::Study study = invented_study(501, 1000);
    study.quantities = {"category", "joint_level", "slip"};
    const ChartExports exports = chart_exports(study, {});
    EXPECT_EQ(file_names(exports, study),
              (Names{"chart.png", "chart.svg", "boundaries.csv", "chart.nc", "chart.sqlite", "chart.toml"}));
    EXPECT_EQ(names_of(exports.figures), (Names{"slip", "joint_level"}));
    EXPECT_EQ(exports.left_out,
              "the chart has 1002000 cells: chart.csv is left out, and the tables hold only category, status and the "
              "figures that are drawn; --files and --figures ask for more");
    EXPECT_EQ(chart_exports(study, {{"csv"}, {}}).left_out,
              "the chart has 1002000 cells: the tables hold only category, status and the figures that are drawn; "
              "--figures asks for more");
    EXPECT_EQ(chart_exports(study, {{}, {"all"}}).left_out,
              "the chart has 1002000 cells: chart.csv is left out; --files asks for more");
    EXPECT_EQ(chart_exports(study, {{"csv"}, {"all"}}).left_out, "");
}

TEST(ChartExports, AreWhatIsAskedForOnceAndInOrder) {
    const sweep::Study study = small_study();
    const ChartExports exports =
        chart_exports(study, {{"zarr", "png", "nc", "png", "pdf"}, {"category", "frequency", "slip", "frequency"}});
    EXPECT_EQ(file_names(exports, study),
              (Names{"chart.png", "chart.pdf", "chart.nc", "chart.zarr", "chart.sqlite", "chart.toml"}));
    EXPECT_EQ(picture_endings(exports), (Names{".png", ".pdf"}));
    EXPECT_EQ(names_of(exports.figures), (Names{"slip", "frequency"}));
    EXPECT_TRUE(chart_exports(study, {{}, {"status"}}).figures.empty());
    EXPECT_EQ(chart_exports(study, {{}, {"slip", "all"}}).figures.size(), sweep::cell_figures().size());
}

TEST(ChartExports, OfADiagramAreItsPointsToo) {
    sweep::Study study = small_study();
    study.y = sweep::resting_axis(study.base, study.x);
    EXPECT_EQ(file_names(chart_exports(study, {}), study).back(), "diagram.csv");
    EXPECT_EQ(file_names(chart_exports(study, {{"nc"}, {}}), study).back(), "chart.toml");
}

TEST(ChartExports, RefuseWhatIsNone) {
    expect_error(error_of([] {
                     chart_exports(small_study(), {{"ng"}, {}});
                 }),
                 "--files \"ng\" is no file of a chart", "");
    expect_error(error_of([] {
                     chart_exports(small_study(), {{}, {"frequenzy"}});
                 }),
                 "Did you mean \"frequency\"?", "");
}

TEST(ChartExports, ChooseTheColumnsOfTheTable) {
    std::string text;
    chart_csv(small_chart(), {"chart.toml", chart_exports(small_study(), {{}, {"frequency", "stick"}}).figures},
              [&](std::string_view piece) { text += piece; });
    text.erase(0, text.find('\n') + 1);
    EXPECT_EQ(text.substr(0, text.find('\n')),
              "x [N],y,direction,status,category,stick,frequency [Hz],quiet_because,source,message,reproduce");
}

}  // namespace
}  // namespace stridor::io
