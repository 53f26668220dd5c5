#include "stridor/sweep/cell_choice.hpp"

#include "stridor/base/error.hpp"

#include <gtest/gtest.h>

namespace stridor::sweep {
namespace {

using parameters::Direction;

Study study() {
    Study study;
    study.x = {"contact.preload", 1.0, 100.0, 3, Scale::logarithmic};  // 1, 10, 100
    study.y = {"contact.kinetic_friction", 0.0, 1.0, 3, Scale::linear};
    return study;
}

TEST(ParseCell, ReadsBothAxesAndADirection) {
    const CellChoice choice = parse_cell("y=0.6, x = 20 N,direction=coming");
    EXPECT_EQ(choice.x, "20 N");
    EXPECT_EQ(choice.y, "0.6");
    EXPECT_EQ(choice.direction, Direction::coming);
    EXPECT_FALSE(parse_cell("x=1,y=2").direction.has_value());
}

TEST(ParseCell, RefusesAnythingElse) {
    for (const char* text : {"", "x=1", "x=1,x=2,y=3", "x=,y=1", "z=1,y=2", "x=1,y=2,direction=up"})
        EXPECT_THROW(parse_cell(text), Error) << text;
}

TEST(NearestCell, IsNearestInTheScaleOfTheAxis) {
    const CellPlace place = nearest_cell(study(), parse_cell("x=30 N,y=0.7"));  // 30 is nearer to 10 than to 100 ...
    EXPECT_EQ(place.ix, 1);                                                     // ... by ratio, 31.6 is the middle
    EXPECT_EQ(place.iy, 1);
    EXPECT_EQ(nearest_cell(study(), parse_cell("x=0.033 kN,y=0.8")).ix, 2);
}

TEST(NearestCell, RefusesWhatLiesOutside) {
    EXPECT_THROW(nearest_cell(study(), parse_cell("x=101 N,y=0.5")), Error);
    EXPECT_THROW(nearest_cell(study(), parse_cell("x=10 N,y=-0.1")), Error);
}

TEST(NearestCell, LiesInTheDirectionAskedForIfTheChartHasIt) {
    EXPECT_EQ(nearest_cell(study(), parse_cell("x=1,y=0")).direction, 0U);
    EXPECT_EQ(nearest_cell(study(), parse_cell("x=1,y=0,direction=coming")).direction, 1U);
    Study coming = study();
    coming.directions = {Direction::coming};
    EXPECT_EQ(nearest_cell(coming, parse_cell("x=1,y=0")).direction, 0U);
    EXPECT_EQ(nearest_cell(coming, parse_cell("x=1,y=0,direction=coming")).direction, 0U);
    EXPECT_THROW(nearest_cell(coming, parse_cell("x=1,y=0,direction=going")), Error);
}

TEST(CellName, CanBeAskedForAgain) {
    const CellPlace place{0, 2, 1, 0};
    EXPECT_EQ(cell_name(study(), place), "x=10 N,y=1");
    const CellPlace again = nearest_cell(study(), parse_cell(cell_name(study(), place)));
    EXPECT_EQ(again.ix, place.ix);
    EXPECT_EQ(again.iy, place.iy);
}

}  // namespace
}  // namespace stridor::sweep
