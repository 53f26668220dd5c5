#include "stridor/sweep/cell.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <set>
#include <string>

namespace stridor::sweep {
namespace {

TEST(CellFigures, NameEveryNumberOfACellOnce) {
    const Cell cell;
    std::set<const double*> members;
    std::set<std::string_view> names;
    for (const CellFigure& figure : cell_figures()) {
        members.insert(&(cell.*figure.member));
        names.insert(figure.name);
    }
    // the numbers stand together at the end of a cell
    const auto numbers =
        (reinterpret_cast<const std::byte*>(&cell + 1) - reinterpret_cast<const std::byte*>(&cell.slip)) /
        static_cast<std::ptrdiff_t>(sizeof(double));
    EXPECT_EQ(members.size(), static_cast<std::size_t>(numbers));
    EXPECT_EQ(members.size(), cell_figures().size());
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
        EXPECT_TRUE(std::isnan(cell.*figure.member)) << figure.name;
}

}  // namespace
}  // namespace stridor::sweep
