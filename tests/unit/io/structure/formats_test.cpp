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
