// What DMIG and OUTPUT4 files of Nastran and its kin hold that is not what it seems: each is refused, or taken, by its
// own sentence.

#include "stridor/io/structure/nastran/dmig.hpp"
#include "structure_texts.hpp"
#include "structure_writers.hpp"

#include <limits>

namespace stridor::io::structure {
namespace {

using reduction::ElasticPart;

const std::string dmig_mass =
    "DMIG    MAAX           0       6       2       0\nDMIG    MAAX           1       1"
    "               1       1     1.0\n";

void expect_dmig_refused(const std::string& text, const std::string& sentence) {
    expect_refused({{"j.pch", text}}, {.files = {"j.pch"}}, sentence);
}

TEST(DmigTraps, ValuesTouchTheirComponents) {
    const DmigFile file =
        read_dmig(input_of("DMIG    KAAX           0       6       2       0\n"
                           "DMIG*   KAAX                           2               1\n"
                           "*                      1               1-1.866666647D+07\n"
                           "*                      2               1 3.0+5\n"));
    ASSERT_EQ(file.matrices.size(), 1U);
    ASSERT_EQ(file.matrices[0].entries.size(), 2U);
    EXPECT_EQ(file.matrices[0].entries[0].value(), -1.866666647e7);
    EXPECT_EQ(file.matrices[0].entries[1].value(), 3e5);
}

// the example of the reference guide: two rows on a continuation, numbers without E, and a scalar point
TEST(DmigTraps, ShortAndFreeFieldsAreTheSame) {
    const std::string head = "DMIG    KAAX    0       1       2       0\nDMIG    MAAX    0       1       2       0\n";
    const std::string fixed =
        "DMIG    KAAX    27      1               27      1       3.+5    0.\n"
        "        50              1.0     0.\n";
    const std::string parted = "DMIG,KAAX,27,1,,27,1,3.+5,0.\n,50,,1.0,0.\n";
    for (const std::string& each : {fixed, parted}) {
        const DmigFile file = read_dmig(input_of("DMIG    KAAX    0       1       2       0\n" + each));
        ASSERT_EQ(file.matrices.at(0).labels.size(), 2U);
        EXPECT_EQ(describe(file.matrices[0].labels[0]), "27.1");
        EXPECT_EQ(describe(file.matrices[0].labels[1]), "50");
        ASSERT_EQ(file.matrices[0].entries.size(), 2U);
        EXPECT_EQ(file.matrices[0].entries[0].value(), 3e5);
        EXPECT_EQ(file.matrices[0].entries[1].value(), 1.0);
    }
}

// each line of a column of any length is taken and forgotten; one without fields says nothing
TEST(DmigTraps, ColumnsAreAsLongAsTheyAre) {
    std::string text = "DMIG,KAAX,0,6,2,0\nDMIG,KAAX,1,1,,1,1,1.\n";
    for (int k = 2; k <= 2000; ++k)
        text += "," + std::to_string(k) + ",1,0.5,," + std::to_string(k) + ",2,0.25\n,\n";
    const DmigFile file = read_dmig(input_of(text + "GRID,1,,3.,4.,5.\n"));
    EXPECT_EQ(file.matrices.at(0).entries.size(), 3999U);
    EXPECT_EQ(file.matrices[0].entries.back().value(), 0.25);
    EXPECT_EQ(file.positions.at("1").z(), 5.0);
}

TEST(DmigTraps, MoreMatricesThanAPartHasAreRefused) {
    std::string text;
    for (int k = 0; k < 65; ++k)
        text += "DMIG,K" + std::to_string(k) + ",0,6,2,0\n";
    expect_dmig_refused(text, "there are more than 64 matrices");
}

TEST(DmigTraps, OtherMatricesAreRefused) {
    expect_dmig_refused("DMIG    KAAX           0       6       4       0\n" + dmig_mass,
                        "found are KAAX (rectangular or complex), MAAX");
    expect_dmig_refused("DMIG    KAAX           0       9       2       0\n" + dmig_mass,
                        "there is no stiffness among the files (a structure vibrates by its stiffness and its mass; "
                        "found are KAAX (rectangular or complex), MAAX). Add it, or name it with --stiffness "
                        "FILE:NAME");
    expect_dmig_refused(dmig_mass + dmig_mass, "the matrix MAAX comes twice");
    expect_dmig_refused("DMIG    KAAX           1       1               1       1     1.0\n",
                        "the matrix KAAX has no header");
    expect_dmig_refused(
        "DMIG    KAAX           0       6       2       0\nDMIG    KAAX           1       7"
        "               1       1     1.0\n",
        "there is no component 7 of node 1");
    expect_dmig_refused(dmig_mass, "there is no stiffness among the files");
}

TEST(DmigTraps, NodesOfOtherSystemsAreRefused) {
    expect_dmig_refused("GRID    5               1.0     2.0     3.0     7\n" + dmig_mass,
                        "the displacements of node 5 are in the coordinate system 7");
    expect_dmig_refused("GRID*   5               3               1.0             2.0\n*       3.0\n" + dmig_mass,
                        "node 5 is placed in the coordinate system 3");
}

TEST(DmigTraps, LoadsAndStructuralDampingAreLeftOut) {
    const auto matrix = [](const std::string& name) {
        return "DMIG    " + name + "       0       6       2       0\nDMIG    " + name +
               "       1       1               1       1     1.0\n";
    };
    const ElasticPart part = part_of({{"j.pch", matrix("KAAX    ") + matrix("MAAX    ") + matrix("K4AAX   ") +
                                                    matrix("PAX     ") + matrix("BAAX    ")}},
                                     {.files = {"j.pch"}});
    EXPECT_EQ(part.damping.rows(), 1);
    EXPECT_EQ(part.notes.at(0), "K4AAX holds structural damping, which is left out");
    EXPECT_EQ(part.notes.at(1), "left out, as it is not the stiffness, mass or damping: PAX");
}

TEST(Output4Traps, WhatDoesNotFitIsRefused) {
    const std::string table = "node,component\n1,1\n2,1\n";
    const auto refused = [&](const std::string& text, const std::string& sentence) {
        expect_refused({{"j.op4", text}, {"t.csv", table}}, {.files = {"j.op4"}, .labels = "t.csv"}, sentence);
    };
    const std::string header = "       2      -2       6       2KAAX    1P,3E23.16\n";
    const std::string column = "       1       0       4\n       3       1\n 1.0000000000000000E+00\n";
    refused(header + column, "the matrix KAAX is cut off");
    refused("       2      -2       6       4KAAX    1P,3E23.16\n       3       1       1\n 1.0E+00\n",
            "found are KAAX (rectangular or complex)");
    refused(header + "       1       0       4\n       3       9\n 1.0E+00\n", "there is no row 9");
    refused(header + "       1       0       4\n       9       1\n 1.0E+00\n", "a string of 8 words does not fit");
    refused(header + "       7       0       4\n       3       1\n 1.0E+00\n", "there is no column 7");
    refused(header + column + "       3       1       1\n 1.0E+00\nrubbish\n", "it is no header of a matrix");
    refused(header + "       1       0       4\n       3       1\n one\n", "\"one\" is no finite number");
}

TEST(Output4Traps, BinaryRecordsThatDoNotFitAreRefused) {
    const std::string table = "node,component\n1,1\n2,1\n";
    const auto refused = [&](const std::string& bytes, const std::string& sentence) {
        expect_refused({{"j.op4", bytes}, {"t.csv", table}}, {.files = {"j.op4"}, .labels = "t.csv"}, sentence);
    };
    const Output4Words how;
    const auto header = [&](std::int64_t columns, std::int64_t rows, std::int64_t type) {
        return Output4Record(how).integer(columns).integer(rows).integer(6).integer(type).text("KAAX").take();
    };
    const auto column = [&](std::int64_t number, std::int64_t first, std::int64_t words) {
        return Output4Record(how).integer(number).integer(first).integer(words);
    };
    const std::string head = header(2, 2, 2);
    const std::string good = column(1, 1, 4).real(1.0).real(2.0).take();
    refused(head, "the file is cut off (it ends within matrix KAAX)");
    refused(head + good.substr(0, 20), "the record at byte 32 does not end where it says");
    refused(head + good + "abc", "the file is cut off");
    refused(header(2, 2, 4) + good + column(3, 1, 2).real(1.0).take(), "found are KAAX (rectangular or complex)");
    refused(header(2, 2, 7) + good, "matrix KAAX: its first record is damaged");
    refused(header(-2, 2, 2) + good, "matrix KAAX: its first record is damaged");
    refused(head + column(7, 1, 4).real(1.0).real(2.0).take(), "matrix KAAX: there is no column 7 (it has 2)");
    refused(head + column(1, 2, 4).real(1.0).real(2.0).take(), "matrix KAAX: there is no row 3 (it has 2)");
    refused(head + column(1, -1, 4).real(1.0).real(2.0).take(), "matrix KAAX: there is no row 0 (it has 2)");
    refused(head + column(1, 1, 8).real(1.0).real(2.0).take(), "column 1 says 8 words, and holds 4");
    refused(head + column(1, 1, 3).integer(1).real(2.0).take(), "3 words are no whole number of values");
    refused(head + column(1, 0, 3).integer(65536 * 9 + 1).real(2.0).take(), "a string of 8 words does not fit");
    refused(head + column(1, 1, 4).real(std::numeric_limits<double>::quiet_NaN()).real(2.0).take(), "it holds nan");
    refused(head + Output4Record(how).integer(1).take(), "a record is too short");
    // loads are rectangular, and left out
    const std::string end = column(3, 1, 2).real(1.0).take();
    const std::string load = Output4Record(how).integer(1).integer(2).integer(2).integer(2).text("PAX").take() + good +
                             column(2, 1, 2).real(1.0).take();
    const std::string mass = Output4Record(how).integer(2).integer(2).integer(6).integer(2).text("MAAX").take() +
                             column(1, 1, 2).real(1.0).take() + column(2, 2, 2).real(1.0).take() + end;
    const std::string stiffness = head + column(1, 1, 2).real(3.0).take() + column(2, 2, 2).real(3.0).take() + end;
    const ElasticPart part =
        part_of({{"j.op4", stiffness + load + mass}, {"t.csv", table}}, {.files = {"j.op4"}, .labels = "t.csv"});
    EXPECT_EQ(part.stiffness.coeff(1, 1), 3.0);
}

// columns without an entry are absent; strings of one column stand one behind the other
TEST(Output4Traps, NullColumnsAreAbsent) {
    const std::string end = "       4       1       1\n 1.0000000000000000E+00\n";
    const std::string first = "       1       0       4\n       3       1\n 2.0000000000000000E+00\n";
    const std::string third = "       3       0       4\n       3       3\n 5.0000000000000000E+00\n";
    const auto whole = [&](const std::string& name) {
        return "       3      -3       6       2" + name + "    1P,3E23.16\n" + first + third + end;
    };
    const ElasticPart part = part_of({{"j.op4", whole("KAAX") + whole("MAAX")}}, {.files = {"j.op4"}});
    EXPECT_EQ(part.stiffness.coeff(2, 2), 5.0);
    EXPECT_EQ(part.stiffness.nonZeros(), 2);
    expect_refused({{"j.op4", whole("KAAX") + whole("MAAX")}}, {.files = {"j.op4"}},
                   "row 2 has neither stiffness nor mass");
    expect_refused({{"j.op4", whole("KAAX") + whole("KAAX") + whole("MAAX")}}, {.files = {"j.op4"}},
                   "there is more than one stiffness");
}

// any Fortran format may stand in the fourth line; a matrix of no symmetric type lists both triangles

}  // namespace
}  // namespace stridor::io::structure
