// Files of Nastran as its users reported them: the numbers that are right are known.

#include "stridor/reduction/part_figures.hpp"
#include "structure_texts.hpp"
#include "structure_writers.hpp"

#include <fmt/format.h>

namespace stridor::io::structure {
namespace {

using reduction::ElasticPart;

const std::string nastran_folder = STRIDOR_SOURCE_DIR "/tests/fixtures/structures/nastran/";

ElasticPart part_in(const std::string& file) {
    return read_part({.files = {nastran_folder + file}});
}

// a chain of three masses of 0.5 kg on springs of 1e6 N/m, held at one end: ω² = 2 k/m (1 - cos((2j - 1) π/7))
void expect_chain(const ElasticPart& part, const std::string& shown) {
    const std::vector<double> frequencies = part_vibration(part, 3).frequencies;
    ASSERT_EQ(frequencies.size(), 3U) << shown;
    EXPECT_NEAR(frequencies[0], 100.170, 5e-4) << shown;
    EXPECT_NEAR(frequencies[1], 280.669, 5e-4) << shown;
    EXPECT_NEAR(frequencies[2], 405.578, 5e-4) << shown;
}

bool has_note(const ElasticPart& part, const std::string& words) {
    return std::any_of(part.notes.begin(), part.notes.end(),
                       [&](const std::string& note) { return note.find(words) != std::string::npos; });
}

TEST(NastranReports, DenseColumnsCountTheirPrintedNumbers) {
    expect_chain(part_in("31_dense_ascii_double.op4"), "type 2");
}

TEST(NastranReports, OfAnExternalSuperelementStiffnessAndMassAreTaken) {
    const ElasticPart part = part_in("32_extseout.op4");
    expect_chain(part, "KXX, MXX");
    EXPECT_TRUE(has_note(part, "not the stiffness, mass or damping: BXX1 (empty), K4XX1 (empty)"));
}

// MSC Quick Reference Guide, "Format of Bulk Data Entries": a longer line goes on by itself
TEST(NastranReports, FreeFieldsBeyondTheTenthAreRead) {
    expect_chain(part_in("34_free_field_short.pch"), "continued by +");
    expect_chain(part_in("34_free_field_long.pch"), "one line");
}

// columns of zeros before and behind the values are not written; two columns of integers may be 16 wide
TEST(NastranReports, Output4HeadersVary) {
    const std::string end = "       4       1       1\n 1.000000000E+00\n";
    const std::string stiffness =
        "       1       1       2\n 2.000000000E+06-1.000000000E+06\n"
        "       2       1       3\n-1.000000000E+06 2.000000000E+06-1.000000000E+06\n"
        "       3       2       2\n-1.000000000E+06 1.000000000E+06\n" +
        end;
    const std::string mass =
        "       1       1       1\n 5.000000000E-01\n       2       2       1\n 5.000000000E-01\n"
        "       3       3       1\n 5.000000000E-01\n" +
        end;
    const auto with = [&](const std::string& columns, const std::string& format) {
        return TextFiles{{"j", columns + "       6       2KAA     " + format + "\n" + stiffness + columns +
                                   "       6       2MAA     " + format + "\n" + mass}};
    };
    const std::string narrow = "       3       3";
    const std::string wide = "               3              -3";
    for (const auto& [columns, format] : {std::pair(narrow, "1P,5E16.9"), std::pair(narrow, ""),
                                          std::pair(narrow, "5e16.9"), std::pair(wide, "1P,5E16.9|I16")})
        expect_chain(part_of(with(columns, format), {.files = {"j"}}), columns + format);
    expect_refused(with(narrow, "1P,3E23.16"), {.files = {"j"}},
                   "by the header of KAA a line holds 3 numbers of 23 columns");
    // a name may begin with a digit, and stands before the others
    const TextFiles named{{"j", narrow + "       2       21MAT    1P,5E16.9\n" + mass + with(narrow, "").at("j")}};
    EXPECT_TRUE(has_note(part_of(named, {.files = {"j"}}), "1MAT"));
}

// a chain as dense columns, each value as wide as it is printed
std::string printed_chain(const std::string& name, const std::vector<std::vector<double>>& rows, int digits) {
    std::string text = fmt::format("{:8d}{:8d}       6       2{:<8}\n", rows.size(), rows.size(), name);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        text += fmt::format("{:8d}       1{:8d}\n", k + 1, rows.size());
        for (const double value : rows[k])
            text += fmt::format("{:>{}}", fmt::format("{:.{}E}", value, digits), digits + 7);
        text += "\n";
    }
    return text + fmt::format("{:8d}       1       1\n{:>{}}\n", rows.size() + 1, "1.0E+00", digits + 7);
}

const std::vector<std::vector<double>> chain_stiffness{{2e6, -1e6, 0.0}, {-1e6, 2e6, -1e6}, {0.0, -1e6, 1e6}};
const std::vector<std::vector<double>> chain_mass{{0.5, 0.0, 0.0}, {0.0, 0.5, 0.0}, {0.0, 0.0, 0.5}};

TEST(NastranReports, WithoutAFormatNumbersAreAsWideAsTheFirstLineShows) {
    for (const int digits : {9, 12, 16, 17})
        expect_chain(
            part_of({{"j", printed_chain("KAA", chain_stiffness, digits) + printed_chain("MAA", chain_mass, digits)}},
                    {.files = {"j"}}),
            std::to_string(digits));
}

// MUG1 recovers displacements; without a mass the part has none
TEST(NastranReports, ANameThatOnlyBeginsLikeAMassIsNone) {
    const std::string stiffness = printed_chain("KAA", chain_stiffness, 9);
    for (const std::string name : {"MUG1", "MES1", "MQG1O", "MSEAL"}) {
        const TextFiles files{{"j", stiffness + printed_chain(name, chain_mass, 9)}};
        expect_refused(files, {.files = {"j"}}, "there is no mass among the files");
        expect_refused(files, {.files = {"j"}}, "found are KAA, " + name);
        expect_chain(part_of(files, {.stiffness = "j:KAA", .mass = "j:" + name}), name);
    }
    const std::string mass = printed_chain("MAA", chain_mass, 9);
    const ElasticPart part =
        part_of({{"j", stiffness + mass + printed_chain("BUG1", chain_mass, 9)}}, {.files = {"j"}});
    EXPECT_EQ(part.damping.nonZeros(), 0) << "nor is BUG1 a damping";
    EXPECT_TRUE(has_note(part, "BUG1"));
    for (const auto& [k, m] : {std::pair("KSEAL", "MSEAL"), std::pair("KXX", "MAA"), std::pair("KSTIFF", "MASS"),
                               std::pair("K2PP", "M2PP"), std::pair("KAAX", "MAAX")})
        expect_chain(
            part_of({{"j", printed_chain(k, chain_stiffness, 9) + printed_chain(m, chain_mass, 9)}}, {.files = {"j"}}),
            k);
}

// of single numbers each is one word of a string
TEST(NastranReports, SingleNumbersAreOneWordEach) {
    const auto with = [](const std::string& name, const std::string& sign, const std::string& string) {
        std::string text = "       2      " + sign + "2       6       1" + name + "     1P,5E15.8\n";
        for (const std::string row : {"1", "2"})
            text += "       " + row + "       0       " + (sign == "-" ? "3" : "2") + "\n" +
                    (string.empty() ? std::to_string(65536 * 2 + std::stoi(row)) : string + row) +
                    "\n 4.00000000E+00\n";
        return text + "       3       1       1\n 1.00000000E+00\n";
    };
    for (const auto& [sign, string] : {std::pair("-", "       2       "), std::pair(" ", "")}) {
        const ElasticPart part =
            part_of({{"j", with("KAA", sign, string) + with("MAA", sign, string)}}, {.files = {"j"}});
        EXPECT_EQ(part.stiffness.coeff(1, 1), 4.0) << sign;
        EXPECT_EQ(part.stiffness.nonZeros(), 2) << sign;
    }
}

// as of 65536 rows strings begin with two integers, whatever the sign
TEST(NastranReports, TallMatricesHaveLongStrings) {
    std::string text = "   65536   65536       6       2KGG     1P,3E23.16\n";
    text += "   65536       0       4\n       3   65536\n 2.0000000000000000E+00\n";
    text += "   65537       1       1\n 1.0000000000000000E+00\n";
    const ElasticPart block = block_part();
    const ElasticPart part = part_of(
        {{"j", text + output4(block.stiffness, "KAA", Sparse::none) + output4(block.mass, "MAA", Sparse::none)}},
        {.files = {"j"}});
    EXPECT_EQ((part.stiffness - block.stiffness).norm(), 0.0);
    EXPECT_TRUE(has_note(part, "KGG"));
}

// complex loads and transformations of any shape stand between those of the structure
TEST(NastranReports, ComplexAndRectangularNeighboursAreNamedAndLeft) {
    const ElasticPart block = block_part();
    const std::string complex =
        "       2       2       1       4MUG1    1P,3E23.16\n       1       1       4\n 1.0000000000000000E+00"
        " 2.0000000000000000E+00 3.0000000000000000E+00\n 4.0000000000000000E+00\n       3       1       1\n"
        " 1.0000000000000000E+00\n";
    const std::string sparse =
        "       2       3       2       3MES1    1P,3E23.16\n       1       0       3\n  196609\n"
        " 1.0000000000000000E+00 2.0000000000000000E+00\n       3       1       1\n 1.0000000000000000E+00\n";
    std::string text = complex + output4(block.stiffness, "KAA", Sparse::none) + sparse;
    text += output4(block.mass, "MAA", Sparse::packed);
    const ElasticPart part = part_of({{"j", text}}, {.files = {"j"}});
    EXPECT_EQ((part.mass - block.mass).norm(), 0.0);
    EXPECT_TRUE(has_note(part, "MUG1 (rectangular or complex), MES1 (rectangular or complex)"));
}

TEST(NastranReports, OfSeveralModelsOneIsNamed) {
    const ElasticPart block = block_part();
    TextFiles files;
    for (const std::string name : {"KGG", "MGG", "KAA", "MAA"})
        files["j"] += output4(name[0] == 'K' ? block.stiffness : block.mass, name, Sparse::none);
    expect_refused(files, {.files = {"j"}},
                   "there is more than one stiffness (KGG, KAA could be it). Name each matrix: --stiffness FILE:NAME "
                   "--mass FILE:NAME");
    const ElasticPart part = part_of(files, {.stiffness = "j:KAA", .mass = "j:MAA"});
    EXPECT_EQ((part.stiffness - block.stiffness).norm(), 0.0);
    expect_refused(files, {.stiffness = "j:KHH", .mass = "j:MAA"},
                   "there is no square matrix KHH in it (it holds KGG, MGG, KAA, MAA)");
}

TEST(NastranReports, PunchFilesHoldMoreThanAPart) {
    const std::string matrices =
        "$TITLE   = PART\n"
        "DMIG    UACCEL         0       9       2       0                       1 $ a row for each load\n"
        "DMIG    UACCEL         2       0               1       3     1.0\n"
        "DMIG    KAAX           0       6       2       0\n"
        "DMIG\tKAAX\t1\t1\t\t1\t1\t2.0E6\n"
        "DMIG    MAAX           0       6       2       0\n"
        "DMIG    MAAX           1       1               1       1     0.5\n";
    const ElasticPart part = part_of({{"j.pch", matrices}}, {.files = {"j.pch"}});
    EXPECT_EQ(part.stiffness.coeff(0, 0), 2e6) << "tabs end at every eighth column";
    EXPECT_TRUE(has_note(part, "UACCEL"));
}

TEST(NastranReports, NothingOfALineIsDropped) {
    const std::string head = "DMIG,KAAX,0,6,2,0\n";
    const auto refused = [&](const std::string& line, const std::string& sentence) {
        expect_refused({{"j.pch", head + line}}, {.files = {"j.pch"}}, sentence);
    };
    refused("DMIG,KAAX,1,1,,1,1,2.0E6,,2,1\n", "2.1 of the matrix KAAX has no value");
    refused("DMIG,KAAX,1,1,,1,1,2.0E6,,,,5.0\n", "\"\" is no node");
    refused(
        "DMIG    KAAX           1       1               1       1     1.0                       2       1     3.0\n",
        "text stands behind column 80");
    refused("DMIG*   KAAX                           1               1\n" + std::string("*      ") +
                "                1               1     1.0                        2               1     3.0\n",
            "[j.pch:3]");
    // a value of 24 columns ends in the field of the imaginary part
    const std::string column = "DMIG*   KAAX                           1               1\n";
    refused(column + "*                      1               1  2.0000000000000000E+06\n",
            "\"0000E+06\" stands behind a value of KAAX, which is real");
    const auto with_zero = [&](const std::string& zero) {
        return part_of({{"j.pch", head + column + "*                      1               1 2.000000000E+06" + zero +
                                      "\nDMIG,MAAX,0,6,2,0\nDMIG,MAAX,1,1,,1,1,0.5,0.0\n"}},
                       {.files = {"j.pch"}});
    };
    for (const std::string zero : {"", "             0.0", " 0.000000000E+00", "               0"})
        EXPECT_EQ(with_zero(zero).stiffness.coeff(0, 0), 2e6) << zero;
}

// np.savez without names
TEST(NumpyReports, ArraysWithoutNamesAreNamedByTheUser) {
    const std::string k = npy("<f8", "(1, 1)", little<double>({2e6}));
    const std::string m = npy("<f8", "(1, 1)", little<double>({0.5}));
    const TextFiles files{{"p.npz", zip({{"arr_0.npy", k}, {"arr_1.npy", m}, {"nodes.npy", npy("|S1", "(1,)", "1")}})}};
    expect_refused(files, {.files = {"p.npz"}}, "found are arr_0, arr_1, nodes (rectangular or complex)");
    EXPECT_EQ(part_of(files, {.stiffness = "p.npz:arr_0", .mass = "p.npz:arr_1"}).stiffness.coeff(0, 0), 2e6);
}

}  // namespace
}  // namespace stridor::io::structure
