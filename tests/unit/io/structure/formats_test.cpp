// The block of CalculiX written as the other programs would write it: every reader gives the same matrices, bit for
// bit.

#include "structure_texts.hpp"
#include "structure_writers.hpp"

namespace stridor::io::structure {
namespace {

using reduction::ElasticPart;

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
    const ElasticPart parted = part_of({{"job_STIF2.mtx", parted_by_blanks(abaqus(block, block.stiffness))},
                                        {"job_MASS2.mtx", parted_by_blanks(abaqus(block, block.mass))}},
                                       {.files = {"job_STIF2.mtx", "job_MASS2.mtx"}});
    expect_same(parted, block, "Abaqus, labels");
    const ElasticPart unlabelled = part_of({{"job_STIF2.mtx", coordinates(block.stiffness)},
                                            {"job_MASS2.mtx", coordinates(block.mass)},
                                            {"rows.csv", label_table(block, ',')}},
                                           {.files = {"job_STIF2.mtx", "job_MASS2.mtx"}, .labels = "rows.csv"});
    expect_same(unlabelled, block, "Abaqus, coordinates");
}

TEST(StructureFormats, AbaqusSubstructuresGiveTheSameMatrices) {
    const ElasticPart block = block_part();
    expect_same(part_of({{"job.mtx", user_element(block)}}, {.files = {"job.mtx"}}), block, "user element");
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

TEST(StructureFormats, BinaryOutput4GivesTheSameMatrices) {
    const ElasticPart block = block_part();
    for (const bool is_big_endian : {false, true})
        for (const bool is_wide : {false, true})
            for (const Sparse sparse : {Sparse::none, Sparse::packed, Sparse::big}) {
                const Output4Words how{.is_big_endian = is_big_endian, .is_wide = is_wide, .sparse = sparse};
                const ElasticPart part = part_of({{"job.op4", output4_binary(block.stiffness, "KAAX", how) +
                                                                  output4_binary(block.mass, "MAAX", how)},
                                                  {"rows.csv", label_table(block, ',')}},
                                                 {.files = {"job.op4"}, .labels = "rows.csv"});
                expect_same(part, block, "binary OUTPUT4");
            }
}

TEST(StructureFormats, SingleOutput4GivesSevenDigits) {
    ElasticPart block = block_part();
    for (reduction::SparseMatrix* matrix : {&block.stiffness, &block.mass})
        *matrix = matrix->cast<float>().cast<double>();
    for (const bool is_big_endian : {false, true})
        for (const Sparse sparse : {Sparse::none, Sparse::packed, Sparse::big}) {
            const Output4Words how{.is_big_endian = is_big_endian, .is_single = true, .sparse = sparse};
            const ElasticPart part = part_of(
                {{"job.op4", output4_binary(block.stiffness, "KAAX", how) + output4_binary(block.mass, "MAAX", how)},
                 {"rows.csv", label_table(block, ',')}},
                {.files = {"job.op4"}, .labels = "rows.csv"});
            expect_same(part, block, "binary OUTPUT4 of single numbers");
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

/// Files of one format, and how far their numbers are kept.
struct WrittenPart {
    std::string format;
    TextFiles texts;
    PartFiles files;
    double kept = 0.0;  // [1] of each entry; 0: to the last bit
};

std::vector<WrittenPart> written_parts(const ElasticPart& block) {
    const std::string table = label_table(block, ',');
    return {
        {"Matrix Market",
         {{"k", matrix_market(block.stiffness, false)}, {"m", matrix_market(block.mass, false)}, {"rows.csv", table}},
         {.stiffness = "k", .mass = "m", .labels = "rows.csv"}},
        {"SciPy",
         {{"k", scipy(block.stiffness)}, {"m", scipy(block.mass)}, {"rows.csv", table}},
         {.stiffness = "k", .mass = "m", .labels = "rows.csv"}},
        {"Abaqus",
         {{"STIF", abaqus(block, block.stiffness)}, {"MASS", abaqus(block, block.mass)}},
         {.files = {"STIF", "MASS"}}},
        {"Abaqus' substructure", {{"s", user_element(block)}}, {.files = {"s"}}},
        {"OUTPUT4",
         {{"j", output4(block.stiffness, "KAAX", Sparse::packed) + output4(block.mass, "MAAX", Sparse::big)},
          {"rows.csv", table}},
         {.files = {"j"}, .labels = "rows.csv"}},
        {"binary OUTPUT4",
         {{"j", output4_binary(block.stiffness, "KAAX", {.sparse = Sparse::big}) +
                    output4_binary(block.mass, "MAAX", {.sparse = Sparse::big})},
          {"rows.csv", table}},
         {.files = {"j"}, .labels = "rows.csv"}},
        {"Ansys",
         {{"k", harwell_boeing(block.stiffness, "Stiffness")},
          {"m", harwell_boeing(block.mass, "Mass")},
          {"map", mapping(block)}},
         {.files = {"k", "m", "map"}}},
        // nine digits fit into a field of DMIG
        {"DMIG",
         {{"j", grids(block) + dmig(block, block.stiffness, "KAAX") + dmig(block, block.mass, "MAAX")}},
         {.files = {"j"}},
         0.5e-8}};
}

// CalculiX's own files, and eight others
TEST(StructureFormats, OfOneBlockAreTheSamePart) {
    const ElasticPart block = block_part();
    for (const WrittenPart& written : written_parts(block)) {
        const ElasticPart part = part_of(written.texts, written.files);
        EXPECT_NO_THROW(expect_sound(part)) << written.format;
        ASSERT_EQ(part.labels, block.labels) << written.format;
        for (const auto& [got, wanted] :
             {std::pair(&part.stiffness, &block.stiffness), std::pair(&part.mass, &block.mass)}) {
            ASSERT_EQ(got->nonZeros(), wanted->nonZeros()) << written.format;
            for (Eigen::Index column = 0; column < wanted->outerSize(); ++column)
                for (reduction::SparseMatrix::InnerIterator entry(*wanted, column); entry; ++entry)
                    ASSERT_LE(std::abs(got->coeff(entry.row(), column) - entry.value()),
                              written.kept * std::abs(entry.value()))
                        << written.format;
        }
    }
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
