// The block of CalculiX written as the other programs would write it: every reader gives the same matrices, bit for
// bit.

#include "structure_texts.hpp"

#include <fmt/format.h>

#include <functional>

namespace stridor::io::structure {
namespace {

using reduction::ElasticPart;
using reduction::SparseMatrix;

/// Calls back with row and column from 0 for each entry of one triangle (row >= column), or of both.
void each_entry(const SparseMatrix& matrix, bool both, const std::function<void(int, int, double)>& take) {
    for (int column = 0; column < matrix.outerSize(); ++column)
        for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
            if (both || entry.row() >= column) take(static_cast<int>(entry.row()), column, entry.value());
}

std::string matrix_market(const SparseMatrix& matrix, bool both) {
    std::string lines;
    int count = 0;
    each_entry(matrix, both, [&](int row, int column, double value) {
        lines += fmt::format("{} {} {:.17g}\n", row + 1, column + 1, value);
        ++count;
    });
    return fmt::format("%%MatrixMarket matrix coordinate real {}\n% a comment\n{} {} {}\n{}",
                       both ? "general" : "symmetric", matrix.rows(), matrix.rows(), count, lines);
}

std::string matrix_market_array(const SparseMatrix& matrix) {
    std::string text = fmt::format("%%MatrixMarket matrix array real general\n{} {}\n", matrix.rows(), matrix.cols());
    const Eigen::MatrixXd dense(matrix);
    for (Eigen::Index k = 0; k < dense.size(); ++k)
        text += fmt::format("{:.17g}\n", dense.data()[k]);
    return text;
}

std::string label_table(const ElasticPart& part, char mark) {
    std::string text = fmt::format("node{0}component{0}x [mm]{0}y [mm]{0}z [mm]{0}set\n", mark);
    for (const auto& label : part.labels) {
        const Eigen::Vector3d place = 1e3 * part.positions.at(label.node);
        const bool is_foot = std::stoi(label.node) < 1012;
        text += fmt::format("{1}{0}{2}{0}{3}{0}{4}{0}{5}{0}{6}\n", mark, label.node, label.component, place[0],
                            place[1], place[2], is_foot ? "FOOT NALL" : "NALL");
    }
    return text;
}

std::string abaqus(const ElasticPart& part, const SparseMatrix& matrix) {
    std::string text = "** ASSEMBLED MATRIX\n";
    each_entry(matrix, false, [&](int row, int column, double value) {
        const auto& a = part.labels[static_cast<std::size_t>(row)];
        const auto& b = part.labels[static_cast<std::size_t>(column)];
        text += fmt::format("{},{}, {},{}, {:.17e}\n", a.node, a.component, b.node, b.component, value);
    });
    return text;
}

std::string coordinates(const SparseMatrix& matrix) {
    std::string text;
    each_entry(matrix, true, [&](int row, int column, double value) {
        text += fmt::format("{:>8} {:>8}  {:.16E}\n", row + 1, column + 1, value);
    });
    return text;
}

// a field of 16 columns holds some ten digits: so that the same numbers come back, they are rounded before
double rounded(double value) {
    return std::stod(fmt::format("{:.8e}", value));
}

SparseMatrix rounded(SparseMatrix matrix) {
    for (int column = 0; column < matrix.outerSize(); ++column)
        for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
            entry.valueRef() = rounded(entry.value());
    return matrix;
}

std::string fortran(double value) {
    std::string text = fmt::format("{:.8e}", value);
    text.replace(text.find('e'), 1, "D");
    return text;
}

std::string dmig(const ElasticPart& part, const SparseMatrix& matrix, const std::string& name) {
    std::string text =
        fmt::format("DMIG    {:8}       0       6       2       0                {:>8}\n", name, matrix.cols());
    for (int column = 0; column < matrix.outerSize(); ++column) {
        const auto& label = part.labels[static_cast<std::size_t>(column)];
        text += fmt::format("DMIG*   {:16}{:>16}{:>16}\n", name, label.node, label.component);
        for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
            if (entry.row() >= column)
                text +=
                    fmt::format("*       {:>16}{:>16}{:>16}\n", part.labels[static_cast<std::size_t>(entry.row())].node,
                                part.labels[static_cast<std::size_t>(entry.row())].component, fortran(entry.value()));
    }
    return text;
}

std::string grids(const ElasticPart& part) {
    std::string text = "$ places\n";
    for (const auto& [node, place] : part.positions)
        text += fmt::format("GRID*   {:>16}{:>16}{:>16.9E}{:>16.9E}\n*       {:>16.9E}\n", node, "", place[0], place[1],
                            place[2]);
    return text;
}

enum class Sparse { none, packed, big };

std::string output4(const SparseMatrix& matrix, const std::string& name, Sparse sparse) {
    const auto rows = matrix.rows();
    std::string text =
        fmt::format("{:8}{:8}{:8}{:8}{:<8}1P,3E23.16\n", rows, sparse == Sparse::big ? -rows : rows, 6, 2, name);
    const auto values = [&](const std::vector<double>& numbers) {
        for (std::size_t k = 0; k < numbers.size(); ++k)
            text += fmt::format("{:23.16E}{}", numbers[k], k % 3 == 2 || k + 1 == numbers.size() ? "\n" : "");
    };
    const Eigen::MatrixXd dense(matrix);
    for (Eigen::Index column = 0; column < rows; ++column) {
        if (sparse == Sparse::none) {
            text += fmt::format("{:8}{:8}{:8}\n", column + 1, 1, 2 * rows);
            values({dense.col(column).begin(), dense.col(column).end()});
            continue;
        }
        std::vector<std::pair<Eigen::Index, std::vector<double>>> strings;
        for (SparseMatrix::InnerIterator entry(matrix, static_cast<int>(column)); entry; ++entry) {
            if (strings.empty() ||
                strings.back().first + static_cast<Eigen::Index>(strings.back().second.size()) != entry.row())
                strings.push_back({entry.row(), {}});
            strings.back().second.push_back(entry.value());
        }
        std::size_t words = 0;
        for (const auto& each : strings)
            words += 2 * each.second.size() + (sparse == Sparse::big ? 2 : 1);
        text += fmt::format("{:8}{:8}{:8}\n", column + 1, 0, words);
        for (const auto& [first, numbers] : strings) {
            if (sparse == Sparse::big)
                text += fmt::format("{:8}{:8}\n", 2 * numbers.size() + 1, first + 1);
            else
                text += fmt::format("{:12}\n", first + 1 + 65536 * static_cast<Eigen::Index>(2 * numbers.size() + 1));
            values(numbers);
        }
    }
    return text + fmt::format("{:8}{:8}{:8}\n{:23.16E}\n", rows + 1, 1, 1, 1.0);
}

std::string harwell_boeing(const SparseMatrix& matrix, const std::string& title) {
    std::vector<int> pointers{1};
    std::vector<int> rows;
    std::vector<double> values;
    for (int column = 0; column < matrix.outerSize(); ++column) {
        for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
            if (entry.row() >= column) {
                rows.push_back(static_cast<int>(entry.row()) + 1);
                values.push_back(entry.value());
            }
        pointers.push_back(static_cast<int>(rows.size()) + 1);
    }
    std::string text = title + " matrix from ANSYS FULL file dumped into Harwell-Boeing format\n";
    text += fmt::format("{:14}{:14}{:14}{:14}{:14}\n", pointers.size() + 2 * rows.size() + 2, pointers.size(),
                        rows.size(), values.size(), 2);
    text += fmt::format("RSA           {:14}{:14}{:14}{:14}\n", matrix.rows(), matrix.rows(), rows.size(), 0);
    text +=
        "(I14)           (I14)           (d25.15)            (d25.15)\nF                          1             2\n";
    for (const int each : pointers)
        text += fmt::format("{:14}\n", each);
    for (const int each : rows)
        text += fmt::format("{:14}\n", each);
    for (const double each : values) {
        std::string number = fmt::format("{:25.17e}", each);
        text += number.replace(number.find('e'), 1, "D") + "\n";
    }
    return text + "    0.0D+00\n    0.0D+00\n";
}

std::string mapping(const ElasticPart& part) {
    std::string text = "    Matrix Eqn          Node    DOF     \n";
    const std::array<const char*, 3> names{"UX", "UY", "UZ"};
    for (std::size_t row = 0; row < part.labels.size(); ++row)
        text += fmt::format("{:14}{:>14}    {}\n", row + 1, part.labels[row].node,
                            names.at(static_cast<std::size_t>(part.labels[row].component - 1)));
    return text;
}

void expect_same(const ElasticPart& part, const ElasticPart& block, const std::string& format) {
    EXPECT_NO_THROW(expect_sound(part)) << format;
    ASSERT_EQ(part.labels, block.labels) << format;
    EXPECT_EQ((part.stiffness - block.stiffness).norm(), 0.0) << format;
    EXPECT_EQ((part.mass - block.mass).norm(), 0.0) << format;
}

TEST(StructureFormats, MatrixMarketGivesTheSameMatrices) {
    const ElasticPart block = block_part();
    for (const bool both : {false, true})
        for (const char mark : {',', ';', '\t'}) {
            const ElasticPart part = part_of({{"k.mtx", matrix_market(block.stiffness, both)},
                                              {"m.mtx", matrix_market(block.mass, both)},
                                              {"rows.csv", label_table(block, mark)}},
                                             {.stiffness = "k.mtx", .mass = "m.mtx", .labels = "rows.csv"});
            expect_same(part, block, "Matrix Market");
            EXPECT_NEAR((part.positions.at("1011") - block.positions.at("1011")).norm(), 0.0, 1e-15);
            EXPECT_EQ(find_set(part, "FOOT")->nodes, find_set(block, "FOOT")->nodes);
        }
    const ElasticPart part = part_of({{"job_STIF.mtx", matrix_market_array(block.stiffness)},
                                      {"job_MASS.mtx", matrix_market_array(block.mass)},
                                      {"rows.csv", label_table(block, ',')}},
                                     {.files = {"job_STIF.mtx", "job_MASS.mtx", "rows.csv"}});
    expect_same(part, block, "array");
}

TEST(StructureFormats, AbaqusGivesTheSameMatrices) {
    const ElasticPart block = block_part();
    const ElasticPart part =
        part_of({{"job_STIF2.mtx", abaqus(block, block.stiffness)}, {"job_MASS2.mtx", abaqus(block, block.mass)}},
                {.files = {"job_STIF2.mtx", "job_MASS2.mtx"}});
    expect_same(part, block, "Abaqus");
    const ElasticPart unlabelled = part_of({{"job_STIF2.mtx", coordinates(block.stiffness)},
                                            {"job_MASS2.mtx", coordinates(block.mass)},
                                            {"rows.csv", label_table(block, ',')}},
                                           {.files = {"job_STIF2.mtx", "job_MASS2.mtx"}, .labels = "rows.csv"});
    expect_same(unlabelled, block, "Abaqus, coordinates");
}

TEST(StructureFormats, DmigGivesTheSameMatrices) {
    ElasticPart block = block_part();
    block.stiffness = rounded(block.stiffness);
    block.mass = rounded(block.mass);
    const ElasticPart part =
        part_of({{"job.pch", grids(block) + dmig(block, block.stiffness, "KAAX") + dmig(block, block.mass, "MAAX")}},
                {.files = {"job.pch"}});
    expect_same(part, block, "DMIG");
    EXPECT_NEAR((part.positions.at("1059") - block.positions.at("1059")).norm(), 0.0, 1e-11);
}

TEST(StructureFormats, Output4GivesTheSameMatrices) {
    const ElasticPart block = block_part();
    for (const Sparse sparse : {Sparse::none, Sparse::packed, Sparse::big}) {
        const ElasticPart part =
            part_of({{"job.op4", output4(block.stiffness, "KAAX", sparse) + output4(block.mass, "MAAX", sparse)},
                     {"rows.csv", label_table(block, ',')}},
                    {.files = {"job.op4"}, .labels = "rows.csv"});
        expect_same(part, block, "OUTPUT4");
    }
}

TEST(StructureFormats, AnsysGivesTheSameMatrices) {
    const ElasticPart block = block_part();
    const ElasticPart part = part_of({{"k.matrix", harwell_boeing(block.stiffness, "Stiffness")},
                                      {"m.matrix", harwell_boeing(block.mass, "Mass")},
                                      {"k.mapping", mapping(block)}},
                                     {.files = {"k.matrix", "m.matrix", "k.mapping"}});
    expect_same(part, block, "Harwell-Boeing");
}

TEST(StructureFormats, LineEndsDoNotMatter) {
    const ElasticPart block = block_part();
    std::string stiffness = matrix_market(block.stiffness, false);
    for (std::size_t at = stiffness.find('\n'); at != std::string::npos; at = stiffness.find('\n', at + 2))
        stiffness.replace(at, 1, "\r\n");
    const ElasticPart part = part_of(
        {{"k.mtx", stiffness}, {"m.mtx", matrix_market(block.mass, false)}, {"rows.csv", label_table(block, ',')}},
        {.stiffness = "k.mtx", .mass = "m.mtx", .labels = "rows.csv"});
    expect_same(part, block, "CR LF");
}

TEST(StructureFormats, ADampingIsTaken) {
    const ElasticPart block = block_part();
    const ElasticPart part =
        part_of({{"k.mtx", matrix_market(block.stiffness, false)}, {"m.mtx", matrix_market(block.mass, false)}},
                {.stiffness = "k.mtx", .mass = "m.mtx", .damping = "k.mtx"});
    EXPECT_EQ((part.damping - block.stiffness).norm(), 0.0);
    EXPECT_EQ(describe(part.labels[143]), "144");
    ASSERT_EQ(part.notes.size(), 1U);
    EXPECT_NE(part.notes[0].find("without labels the rows are numbered"), std::string::npos);
}

}  // namespace
}  // namespace stridor::io::structure
