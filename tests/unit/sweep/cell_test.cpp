#include "stridor/sweep/cell.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <set>
#include <string>

namespace stridor::sweep {
namespace {

TEST(CellFigures, NameEveryNumberOfACellOnce) {
    std::set<std::size_t> places;
    std::set<std::string_view> names;
    for (const CellFigure& figure : cell_figures()) {
        EXPECT_LT(figure.place, cell_figures().size());
        places.insert(figure.place);
        names.insert(figure.name);
    }
    EXPECT_EQ(places.size(), cell_figures().size());
    EXPECT_EQ(names.size(), cell_figures().size());
}

TEST(CellFigures, HaveNamesThatAreWordsAndSayTheirUnit) {
    const std::string letters = "abcdefghijklmnopqrstuvwxyz0123456789_";
    for (const CellFigure& figure : cell_figures()) {
        EXPECT_EQ(figure.name.find_first_not_of(letters), std::string_view::npos) << figure.name;
        EXPECT_FALSE(figure.unit.empty()) << figure.name;
        EXPECT_FALSE(figure.sentence.empty()) << figure.name;
    }
}

TEST(CellFigures, AreFoundByName) {
    for (const CellFigure& figure : cell_figures())
        EXPECT_EQ(find_cell_figure(figure.name), &figure);
    EXPECT_EQ(find_cell_figure("loudness"), nullptr);
}

TEST(Cell, HasNoFiguresBeforeItIsDone) {
    const Cell cell;
    EXPECT_NE(cell.status, Status::done);
    for (const CellFigure& figure : cell_figures())
        EXPECT_TRUE(std::isnan(figure_of(cell, figure))) << figure.name;
}

}  // namespace
}  // namespace stridor::sweep
