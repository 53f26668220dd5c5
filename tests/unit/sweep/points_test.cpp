#include "stridor/sweep/points.hpp"

#include "stridor/parameters/paper_cases.hpp"
#include "stridor/sweep/evaluate.hpp"
#include "stridor/sweep/ready_charts.hpp"
#include "support/expected_error.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace stridor::sweep {
namespace {

using parameters::Direction;
using support::error_of;

// a chart of 3 by 2 cells, and the same cells as points
Study small_chart() {
    Study study = figure_8();
    study.base.run.duration = study.base.run.window = 0.05;
    study.x.points = 3;
    study.y.points = 2;
    return study;
}

DesignPoints points_of(const Study& study) {
    DesignPoints points{{study.base}, {study.x.parameter, study.y.parameter}, {}};
    for (int iy = 0; iy < study.y.points; ++iy)
        for (int ix = 0; ix < study.x.points; ++ix) {
            points.values.push_back(value_at(study.x, ix));
            points.values.push_back(value_at(study.y, iy));
        }
    return points;
}

DesignPoints two_points(double second) {
    return {{parameters::paper_case(parameters::PaperCase::squeal)}, {"contact.preload"}, {20.0, second}};
}

void expect_same_cells(const std::vector<Cell>& a, const std::vector<Cell>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
        EXPECT_EQ(a[k].status, b[k].status);
        EXPECT_EQ(a[k].category, b[k].category);
        EXPECT_EQ(a[k].agreement, b[k].agreement);
        EXPECT_EQ(a[k].starts, b[k].starts);
        ASSERT_EQ(a[k].figures.size(), b[k].figures.size());
        for (std::size_t figure = 0; figure < a[k].figures.size(); ++figure)
            EXPECT_EQ(std::bit_cast<std::uint64_t>(a[k].figures[figure]),
                      std::bit_cast<std::uint64_t>(b[k].figures[figure]));
    }
}

std::vector<Cell> cells_of(const Study& study) {
    std::vector<Cell> cells(cell_count(study));
    for (int iy = 0; iy < study.y.points; ++iy)
        for (int ix = 0; ix < study.x.points; ++ix) {
            const std::vector<Cell> here = evaluate(study, ix, iy);
            for (std::size_t direction = 0; direction < here.size(); ++direction)
                cells[index_of(study, {direction, iy, ix})] = here[direction];
        }
    return cells;
}

TEST(DesignPoints, HaveWhatTheCellsOfAChartHave) {
    for (const bool is_constant : {true, false}) {
        Study study = small_chart();
        if (!is_constant) study.base.drive = parameters::paper_case(parameters::PaperCase::squeal).drive;
        const std::vector<Cell> cells = cells_of(study);
        for (const int threads : {1, 2, 3})
            expect_same_cells(evaluate(points_of(study), {.crew = crew::thread_crews(threads)}), cells);
    }
}

TEST(DesignPoints, HaveWhatTheCellsOfAChartWithTheSameStartsHave) {
    using parameters::Initial;
    for (const bool is_constant : {true, false})
        for (const std::vector<Initial>& starts :
             {std::vector{Initial::sliding}, {Initial::stuck, Initial::sliding}, {Initial::sliding, Initial::rest}}) {
            Study study = small_chart();
            if (!is_constant) study.base.drive = parameters::paper_case(parameters::PaperCase::squeal).drive;
            study.starts = starts;
            const std::vector<Cell> cells = cells_of(study);
            DesignPoints points = points_of(study);
            points.starts = starts;
            for (const int threads : {1, 3})
                expect_same_cells(evaluate(points, {.crew = crew::thread_crews(threads)}), cells);
            ASSERT_EQ(cells.front().starts.size(), starts.size());
        }
}

// the bases differ in what drives them: one is run once for each direction, the other gives both in one run
TEST(DesignPoints, OfSeveralBasesAreThoseOfEachAlone) {
    const Study constant = small_chart();
    Study sinusoidal = small_chart();
    sinusoidal.base.drive = parameters::paper_case(parameters::PaperCase::squeal).drive;
    DesignPoints points = points_of(constant);
    points.bases = {constant.base, sinusoidal.base};
    points.base_of = {0, 1, 1, 0, 1, 0};
    const std::vector<Cell> cells = evaluate(points, {.crew = crew::thread_crews(2)});
    const std::vector<Cell> alone[] = {cells_of(constant), cells_of(sinusoidal)};
    std::vector<Cell> wanted;
    for (std::size_t index = 0; index < 12; ++index)
        wanted.push_back(alone[points.base_of[index % 6]][index]);
    expect_same_cells(cells, wanted);
    EXPECT_EQ(run_count(points), 9U);  // 3 points with 2 runs, 3 with 1

    // what means something for one of them alone changes its points alone
    points.keys = {"drive.velocity"};
    points.values.assign(6, 0.05);
    const std::vector<Cell> driven = evaluate(points);
    EXPECT_EQ(driven[1].figures, driven[2].figures);
    EXPECT_NE(driven[0].figures, driven[1].figures);

    // a base may be all that changes
    points.keys.clear();
    points.values.clear();
    EXPECT_EQ(evaluate(points)[4].figures, driven[1].figures);
}

TEST(DesignPoints, ThatContradictThemselvesAreInvalidAndTheOthersAreNot) {
    DesignPoints points = two_points(30.0);
    points.keys = {"kinetic_friction"};
    points.values = {0.9, 0.1};
    const std::vector<Cell> cells = evaluate(points);
    EXPECT_EQ(cells[0].status, Status::invalid);
    EXPECT_NE(cells[0].message.find("exceeds"), std::string::npos);
    EXPECT_EQ(cells[1].status, Status::done);
}

TEST(DesignPoints, OutOfRangeAreRefusedByNumber) {
    for (const double wrong : {-1.0, std::nan(""), HUGE_VAL}) {
        support::expect_error(error_of([&] { evaluate(two_points(wrong)); }), "point 1: contact.preload", "");
    }
}

TEST(DesignPoints, AreRefusedWithWrongKeysOrDirections) {
    const auto refusal = [](auto change) {
        DesignPoints points = two_points(30.0);
        change(points);
        const std::optional<Error> error = error_of([&] { check(points); });
        return std::string(error ? error->what() : "");
    };
    const auto has = [](const std::string& text, const char* words) { return text.find(words) != std::string::npos; };
    EXPECT_TRUE(has(refusal([](DesignPoints& p) { p.keys = {"preloda"}; }), "preload"));
    EXPECT_TRUE(has(refusal([](DesignPoints& p) { p.keys = {"run.engine"}; }), "no quantity"));
    EXPECT_TRUE(has(refusal([](DesignPoints& p) { p.keys = {"drive.velocity"}; }), "means nothing"));
    EXPECT_TRUE(has(refusal([](DesignPoints& p) { p.keys = {"F", "preload"}; }), "same quantity"));
    EXPECT_TRUE(has(refusal([](DesignPoints& p) { p.keys = {"F", "mu_d", "mu_s"}; }), "not complete"));
    EXPECT_TRUE(has(refusal([](DesignPoints& p) { p.keys.clear(); }), "no points"));
    EXPECT_TRUE(has(refusal([](DesignPoints& p) { p.keys = {"joint.lip9.contact.preload"}; }), "no joint"));
    EXPECT_TRUE(has(refusal([](DesignPoints& p) { p.directions.clear(); }), "directions"));
    EXPECT_TRUE(has(refusal([](DesignPoints& p) { p.base_of = {0}; }), "not complete"));
    EXPECT_TRUE(has(refusal([](DesignPoints& p) { p.keys = {"run.perturbation"}; }), "means nothing"));
    EXPECT_TRUE(has(refusal([](DesignPoints& p) {
                        p.starts = {parameters::Initial::rest, parameters::Initial::rest};
                    }),
                    "\"rest\" twice"));
    EXPECT_TRUE(has(refusal([](DesignPoints& p) {
                        p.directions = {Direction::going, Direction::going};
                    }),
                    "directions"));
}

TEST(DesignPoints, EndWhenTheyAreStopped) {
    std::stop_source source;
    source.request_stop();
    EXPECT_EQ(error_of([&] {
                  evaluate(two_points(30.0), {.crew = crew::thread_crews(1), .stop = source.get_token()});
              })->kind(),
              ErrorKind::interrupted);
}

TEST(DesignPoints, HandOnWhatTheCallbackThrows) {
    PointOptions options;
    options.progress = [](std::size_t) { throw Error(ErrorKind::io, {"mine", "", ""}); };
    EXPECT_EQ(error_of([&] { evaluate(two_points(30.0), options); })->problem().what, "mine");
}

TEST(DesignPoints, NoneGiveNoCells) {
    DesignPoints none = two_points(1.0);
    none.values.clear();
    EXPECT_TRUE(evaluate(none).empty());
}

}  // namespace
}  // namespace stridor::sweep
