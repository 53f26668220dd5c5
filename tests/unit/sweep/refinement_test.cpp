#include "stridor/sweep/refinement.hpp"

#include "support/property.hpp"
#include "support/small_study.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <string>

namespace stridor::sweep {
namespace {

using support::whole_between;

// the mark at a place of the unit square
using Picture = std::function<int(double x, double y)>;

Study square(int points, int levels) {
    Study study = small_study();
    study.x.points = points;
    study.y.points = points;
    study.directions = {parameters::Direction::going};
    study.refine = levels;
    return study;
}

int mark_at(const Study& study, const Picture& picture, std::size_t point) {
    const CellPlace place = place_of(study, point);
    return picture(static_cast<double>(place.ix) / (study.x.points - 1),
                   static_cast<double>(place.iy) / (study.y.points - 1));
}

struct Outcome {
    std::vector<int> marks;  // of the computed cells
    std::vector<CellIndex> sources;
    int rounds = 0;

    std::size_t computed() const {
        return marks.size() - static_cast<std::size_t>(std::count(marks.begin(), marks.end(), unknown_mark));
    }
};

// what is computed when at most `appetite` of the missing points are done before the next look
Outcome refined(const Study& study, const Picture& picture, std::size_t appetite) {
    Outcome outcome;
    outcome.marks.assign(cell_count(study), unknown_mark);
    for (;; ++outcome.rounds) {
        Refinement refinement = refine(study, outcome.marks);
        if (refinement.missing.empty()) {
            outcome.sources = std::move(refinement.sources);
            return outcome;
        }
        // from the end: another order than the one they are given in
        for (std::size_t k = 0; k < std::min(appetite, refinement.missing.size()); ++k) {
            const std::size_t point = refinement.missing[refinement.missing.size() - 1 - k];
            outcome.marks[point] = mark_at(study, picture, point);
        }
    }
}

Outcome refined(const Study& study, const Picture& picture) {
    return refined(study, picture, cell_count(study));
}

// share of cells that are as in the complete chart
double share_alike(const Study& study, const Picture& picture, const Outcome& outcome) {
    std::size_t right = 0;
    for (std::size_t point = 0; point < outcome.marks.size(); ++point)
        right += outcome.marks[outcome.sources[point]] == mark_at(study, picture, point) ? 1 : 0;
    return static_cast<double>(right) / static_cast<double>(outcome.marks.size());
}

double share(const Outcome& outcome) {
    return static_cast<double>(outcome.computed()) / static_cast<double>(outcome.marks.size());
}

int uniform(double, double) {
    return 7;
}

int diagonal(double x, double y) {
    return y > 0.13 + 0.71 * x ? 1 : 0;
}

// five islands, the smallest seven cells of a 200 by 200 chart across
int islands(double x, double y) {
    struct Disc {
        double x, y, radius;
    };
    constexpr Disc discs[] = {
        {0.2, 0.3, 0.1}, {0.71, 0.22, 0.03}, {0.5, 0.61, 0.018}, {0.83, 0.77, 0.05}, {0.15, 0.85, 0.02}};
    for (const Disc& disc : discs)
        if (std::hypot(x - disc.x, y - disc.y) < disc.radius) return 1;
    return 0;
}

// a wavy strip two cells of a 200 by 200 chart wide, that ends on the chart's edges
int strip(double x, double y) {
    const double middle = 0.5 + 0.3 * std::sin(7.0 * x);
    return std::abs(y - middle) < 0.005 ? 1 : 0;
}

// areas that meet, as in the paper's Figure 8
int areas(double x, double y) {
    if (y < 0.45 + 0.1 * std::sin(4.0 * x)) return 0;
    if (x > 0.7) return 3;
    return x > 0.4 + 0.2 * y ? 2 : 1;
}

struct Drawn {
    std::string name;
    Picture picture;
    double most;     // [1] share of the cells that may be computed
    int levels = 4;  // [1] the coarsest refinement that misses nothing
};

class Pictures : public testing::TestWithParam<Drawn> {};

TEST_P(Pictures, AreFoundFromASmallShareOfTheCells) {
    for (int levels = 2; levels <= GetParam().levels; ++levels) {
        const Study study = square(200, levels);
        const Outcome outcome = refined(study, GetParam().picture);
        EXPECT_GE(share_alike(study, GetParam().picture, outcome), 0.999) << levels;
        if (levels > 2) {
            EXPECT_LT(share(outcome), GetParam().most) << levels;
        }
    }
}

TEST_P(Pictures, AreFoundAlikeHoweverTheWorkIsCut) {
    const Study study = square(75, 4);
    const Outcome whole = refined(study, GetParam().picture);
    for (const std::size_t appetite : {1U, 7U, 100U}) {
        const Outcome pieces = refined(study, GetParam().picture, appetite);
        EXPECT_EQ(pieces.marks, whole.marks) << appetite;
        EXPECT_EQ(pieces.sources, whole.sources) << appetite;
    }
}

TEST_P(Pictures, AreInferredFromComputedCells) {
    const Study study = square(75, 4);
    const Outcome outcome = refined(study, GetParam().picture);
    for (std::size_t point = 0; point < outcome.sources.size(); ++point) {
        const std::size_t source = outcome.sources[point];
        EXPECT_NE(outcome.marks[source], unknown_mark);
        EXPECT_EQ(source == point, outcome.marks[point] != unknown_mark);
    }
}

TEST_P(Pictures, HaveTheirBoundariesBetweenComputedCells) {
    const Study study = square(75, 4);
    const Outcome outcome = refined(study, GetParam().picture);
    const auto shown = [&](std::size_t point) { return outcome.marks[outcome.sources[point]]; };
    const auto columns = static_cast<std::size_t>(study.x.points);
    for (std::size_t point = 0; point < outcome.marks.size(); ++point)
        for (const std::size_t next : {point + 1, point + columns}) {
            const bool is_neighbour = next < outcome.marks.size() && (next != point + 1 || next % columns != 0);
            if (!is_neighbour || shown(point) == shown(next)) continue;
            EXPECT_NE(outcome.marks[point], unknown_mark);
            EXPECT_NE(outcome.marks[next], unknown_mark);
        }
}

const Drawn drawn_pictures[] = {{"Uniform", uniform, 0.04},
                                {"Diagonal", diagonal, 0.07},
                                {"Islands", islands, 0.08, 3},
                                {"Strip", strip, 0.10},
                                {"Areas", areas, 0.08}};

INSTANTIATE_TEST_SUITE_P(Refinement, Pictures, testing::ValuesIn(drawn_pictures),
                         [](const testing::TestParamInfo<Drawn>& each) { return each.param.name; });

// The closed-set property: who asks while a part of what was asked for is still being computed, and computes in any
// order, ends with the cells of one who goes round by round.
TEST(Refinement, AsksForTheSameCellsHoweverEarlyItIsAsked) {
    std::mt19937_64 random(20120401);
    const auto between = [&](int low, int high) {
        return low + static_cast<int>(random() % static_cast<std::uint64_t>(high - low + 1));
    };
    for (int round = 0; round < 300; ++round) {
        Study study = square(between(2, 40), between(1, 5));
        study.y.points = between(2, 40);
        const Picture picture = [waves = between(1, 9), colours = between(2, 4)](double x, double y) {
            return static_cast<int>(colours * (1.0 + std::sin(waves * x) * std::cos(waves * y + x))) % colours;
        };
        const Outcome rounds = refined(study, picture);
        std::vector<int> marks(cell_count(study), unknown_mark);
        std::vector<std::size_t> out;  // asked for, and not computed yet
        std::vector<bool> was_asked(marks.size());
        Refinement refinement = refine(study, marks);
        for (; !refinement.missing.empty(); refinement = refine(study, marks)) {
            for (const std::size_t point : refinement.missing)
                if (!was_asked[point]) {
                    was_asked[point] = true;
                    out.push_back(point);
                }
            // some of those that are out arrive, in any order
            for (int left = between(1, 60); left > 0 && !out.empty(); --left) {
                std::swap(out[random() % out.size()], out.back());
                marks[out.back()] = mark_at(study, picture, out.back());
                out.pop_back();
            }
        }
        ASSERT_TRUE(out.empty());
        ASSERT_EQ(marks, rounds.marks);
        ASSERT_EQ(refinement.sources, rounds.sources);
    }
}

TEST(Refinement, ComputesEveryCellAtLevelZero) {
    const Study study = square(9, 0);
    const Outcome outcome = refined(study, diagonal);
    EXPECT_EQ(outcome.computed(), 81U);
    EXPECT_EQ(outcome.rounds, 1);
    EXPECT_TRUE(outcome.sources.empty()) << "each cell is its own";
}

TEST(Refinement, BeginsWithEveryNthPointAndTheLast) {
    Study study = square(11, 2);
    study.y.points = 6;
    const std::vector<int> nothing(cell_count(study), unknown_mark);
    std::vector<std::size_t> expected;
    for (const std::size_t y : {0U, 4U, 5U})
        for (const std::size_t x : {0U, 4U, 8U, 10U})
            expected.push_back(y * 11 + x);
    EXPECT_EQ(refine(study, nothing).missing, expected);
}

// 3 by 3 points in two directions, the corners known and alike but for one, coming
std::vector<int> corners_but_one(int mark) {
    std::vector<int> marks(18, unknown_mark);
    for (const std::size_t corner : {0U, 2U, 6U, 8U})
        marks[corner] = marks[9 + corner] = 1;
    marks[9 + 8] = mark;
    return marks;
}

Study both_ways(parameters::DriveKind drive) {
    Study study = square(3, 1);
    study.directions = {parameters::Direction::going, parameters::Direction::coming};
    study.base.drive.kind = drive;
    return study;
}

TEST(Refinement, LooksAtEachDirectionOfAConstantDriveAlone) {
    const Study study = both_ways(parameters::DriveKind::constant);
    EXPECT_EQ(refine(study, corners_but_one(unknown_mark)).missing, (std::vector<std::size_t>{4, 9 + 8}));
    EXPECT_EQ(refine(study, corners_but_one(2)).missing,
              (std::vector<std::size_t>{4, 9 + 1, 9 + 3, 9 + 4, 9 + 5, 9 + 7}));
}

TEST(Refinement, LooksAtBothDirectionsOfARunThatGivesBoth) {
    const Study study = both_ways(parameters::DriveKind::sinusoidal);
    EXPECT_EQ(refine(study, corners_but_one(unknown_mark)).missing, std::vector<std::size_t>{8});
    EXPECT_EQ(refine(study, corners_but_one(2)).missing, (std::vector<std::size_t>{1, 3, 4, 5, 7}));
}

TEST(Refinement, ProbesTheMiddleOfABlockWhoseCornersAgree) {
    const Study study = square(5, 2);
    std::vector<int> marks(cell_count(study), unknown_mark);
    for (const std::size_t corner : {0U, 4U, 20U, 24U})
        marks[corner] = 1;
    EXPECT_EQ(refine(study, marks).missing, std::vector<std::size_t>{12});
    // each quarter has the probe as a corner that differs, so it is cut as well
    marks[12] = 2;
    EXPECT_EQ(refine(study, marks).missing.size(), 20U);
}

TEST(Refinement, FollowsABoundaryIntoABlockWhoseCornersAndProbeAgree) {
    // a tongue from the left that ends within the right block, below its probe
    const Study study = [] {
        Study wide = square(9, 3);
        wide.x.points = 17;
        return wide;
    }();
    const auto tongue = [](double x, double y) { return x < 0.7 && y > 0.2 && y < 0.3 ? 1 : 0; };
    const Outcome outcome = refined(study, [&](double x, double y) { return x == 0.0 ? 2 : tongue(x, y); });
    EXPECT_EQ(share_alike(
                  study, [&](double x, double y) { return x == 0.0 ? 2 : tongue(x, y); }, outcome),
              1.0);
}

TEST(Refinement, TakesTheNearestCornerAndTheFirstOfEquallyNearOnes) {
    const Study study = square(5, 2);
    const Outcome outcome = refined(study, uniform);
    EXPECT_EQ(outcome.computed(), 5U);
    EXPECT_EQ(outcome.sources[1], 0U);
    EXPECT_EQ(outcome.sources[2], 0U);
    EXPECT_EQ(outcome.sources[3], 4U);
    EXPECT_EQ(outcome.sources[13], 4U);
    EXPECT_EQ(outcome.sources[18], 24U);
}

// the base grid and the probes are spaced by s in rows that are shifted by s / 2:
// no place is farther than s / 2 from one
RC_GTEST_PROP(Refinement, FindsEveryIslandWiderThanTheBaseGridsStride, ()) {
    const Study study = square(33, 3);
    const int x = *whole_between(0, 32);
    const int y = *whole_between(0, 32);
    const auto island = [&](double share_x, double share_y) {
        return std::hypot(32.0 * share_x - x, 32.0 * share_y - y) < 4.001 ? 1 : 0;
    };
    const Outcome outcome = refined(study, island);
    RC_ASSERT(share_alike(study, island, outcome) == 1.0);
}

RC_GTEST_PROP(Refinement, EndsWithEveryBlockAlikeWhateverThePicture, ()) {
    Study study = square(2, *whole_between(0, most_refinement));
    study.x.points = *whole_between(2, 40);
    study.y.points = *whole_between(2, 40);
    const auto points = static_cast<int>(cell_count(study));
    std::vector<int> picture(static_cast<std::size_t>(points), 0);
    for (int spot = *whole_between(0, 6); spot > 0; --spot)
        picture[static_cast<std::size_t>(*whole_between(0, points - 1))] = spot;
    std::vector<int> marks(picture.size(), unknown_mark);
    Refinement refinement = refine(study, marks);
    for (; !refinement.missing.empty(); refinement = refine(study, marks))
        for (const std::size_t point : refinement.missing) {
            RC_ASSERT(marks[point] == unknown_mark);
            marks[point] = picture[point];
        }
    RC_ASSERT(refinement.sources.size() == (study.refine == 0 ? 0U : marks.size()));
    for (std::size_t point = 0; point < refinement.sources.size(); ++point) {
        const bool is_itself = refinement.sources[point] == point;
        RC_ASSERT(is_itself == (marks[point] != unknown_mark));
        RC_ASSERT(marks[refinement.sources[point]] != unknown_mark);
    }
}

TEST(MarkOf, TellsCellsApartThatRefinementMustNotTakeForAlike) {
    Study study = small_study();
    study.refine = 1;
    Cell quiet;
    quiet.status = Status::done;
    quiet.category = classification::Category::none;
    Cell noisy = quiet;
    noisy.category = classification::Category::squeal;
    Cell torn = quiet;
    torn.agreement = Agreement::differ;
    Cell failed = quiet;
    failed.status = Status::failed;
    EXPECT_NE(mark_of(study, quiet), mark_of(study, noisy));
    EXPECT_NE(mark_of(study, quiet), mark_of(study, torn));
    EXPECT_NE(mark_of(study, quiet), mark_of(study, failed));
    Cell other = quiet;
    set_figure(other, cell_figure("slip"), 0.5);
    EXPECT_EQ(mark_of(study, quiet), mark_of(study, other));
}

TEST(MarkOf, SeesTheOnsetOfFlutter) {
    Study study = small_study();
    study.refine = 1;
    Cell stable;
    stable.status = Status::done;
    stable.category = classification::Category::none;
    set_figure(stable, cell_figure("growth_rate"), -3.0);
    set_figure(stable, cell_figure("mode_frequency"), 450.0);
    Cell fluttering = stable;
    set_figure(fluttering, cell_figure("growth_rate"), 3.0);
    EXPECT_NE(mark_of(study, stable), mark_of(study, fluttering));
    Cell diverging = fluttering;
    set_figure(diverging, cell_figure("mode_frequency"), 0.0);
    EXPECT_NE(mark_of(study, fluttering), mark_of(study, diverging));
}

TEST(Inferred, CellsHaveTheVerdictOfTheirSourceAndNoFigures) {
    SweepResult result;
    result.study = square(3, 1);
    result.sources = {0, 0, 2, 0, 4, 2, 6, 6, 8};
    std::vector<CellVerdict> verdicts(9);
    std::vector<IndexedCell> computed;
    for (const std::size_t index : {0U, 2U, 4U, 6U, 8U}) {
        Cell cell;
        cell.status = Status::done;
        cell.category = classification::Category::creak;
        cell.agreement = Agreement::quiet_unless_disturbed;
        cell.starts = {{Status::done, classification::Category::none}, {Status::done, classification::Category::creak}};
        set_figure(cell, cell_figure("slip"), 0.25 * static_cast<double>(index));
        verdicts[index] = verdict_of(cell);
        computed.push_back({index, cell});
    }
    result.cells = inferred(verdicts, result.sources);
    result.computed = in_memory(std::move(computed));
    EXPECT_TRUE(is_inferred(result, 1));
    EXPECT_FALSE(is_inferred(result, 2));
    EXPECT_EQ(source_of(result, 5), 2U);
    EXPECT_EQ(result.cells[5].category, classification::Category::creak);
    EXPECT_EQ(result.cells[5].agreement, Agreement::quiet_unless_disturbed);
    EXPECT_EQ(result.cells[5].shown_start, 1U);
    EXPECT_EQ(computed_count(result), 5U);
    EXPECT_EQ(figure_of(computed_cell(result, 4), "slip"), 1.0);
    EXPECT_EQ(figure_values(result, cell_figure("slip")), (std::vector<double>{0, 0, 0.5, 0, 1, 0.5, 1.5, 1.5, 2}))
        << "what is drawn there";
}

}  // namespace
}  // namespace stridor::sweep
