// Matrices of NumPy and SciPy: what SciPy 1.10 wrote of the block, what small writers make of it, and what is refused.

#include "stridor/io/structure/numpy_array.hpp"
#include "stridor/io/structure/numpy_matrix.hpp"
#include "structure_texts.hpp"
#include "structure_writers.hpp"

#include <limits>

namespace stridor::io::structure {
namespace {

using reduction::ElasticPart;

std::map<std::string, std::string> csr(const std::string& data, const std::string& indices, const std::string& indptr,
                                       const std::string& format = npy("|S3", "()", "csr")) {
    return {{"data.npy", data},
            {"indices.npy", indices},
            {"indptr.npy", indptr},
            {"format.npy", format},
            {"shape.npy", npy("<i8", "(2,)", little<std::int64_t>({2, 2}))}};
}

// 2 -1; -1 2
const std::string good_data = npy("<f8", "(4,)", little<double>({2.0, -1.0, -1.0, 2.0}));
const std::string good_indices = npy("<i4", "(4,)", little<std::int32_t>({0, 1, 0, 1}));
const std::string good_pointers = npy("<i4", "(3,)", little<std::int32_t>({0, 2, 4}));

const std::string good_mass = zip({{"M.npy", npy("<f8", "(2, 2)", little<double>({1.0, 0.0, 0.0, 1.0}))}});

void expect_npz_refused(const std::map<std::string, std::string>& members, const std::string& sentence) {
    expect_refused({{"k.npz", zip(members)}, {"m.npz", good_mass}}, {.files = {"m.npz"}, .stiffness = "k.npz"},
                   sentence);
}

TEST(Numpy, ReadsWhatScipyWrote) {
    const ElasticPart block = block_part();
    const ElasticPart part = part_of({{"k.npz", text_of(block_folder + "block_stiffness.npz")},
                                      {"m.npz", text_of(block_folder + "block_mass.npz")},
                                      {"rows.csv", label_table(block, ',')}},
                                     {.stiffness = "k.npz", .mass = "m.npz", .labels = "rows.csv"});
    expect_same(part, block, "SciPy");
}

TEST(Numpy, TakesNumbersOfAnyWidthAndOrder) {
    const auto values = [](const std::string& descr, const std::string& bytes) {
        return reals_of(read_numpy_array(npy(descr, "(2,)", bytes), "a.npy"));
    };
    const std::vector<double> wanted{1.0, -2.0};
    EXPECT_EQ(values("<f8", little<double>({1.0, -2.0})), wanted);
    EXPECT_EQ(values(">f8", big<double>({1.0, -2.0})), wanted);
    EXPECT_EQ(values("<f4", little<float>({1.0F, -2.0F})), wanted);
    EXPECT_EQ(values(">f4", big<float>({1.0F, -2.0F})), wanted);
    EXPECT_EQ(values("<i8", little<std::int64_t>({1, -2})), wanted);
    EXPECT_EQ(values(">i4", big<std::int32_t>({1, -2})), wanted);
    EXPECT_EQ(values("<i2", little<std::int16_t>({1, -2})), wanted);
    EXPECT_EQ(values("|i1", "\x01\xfe"), wanted);
    EXPECT_EQ(values("|u1", "\x01\xfe"), (std::vector<double>{1.0, 254.0}));
    const NumpyArray turned = read_numpy_array(npy("<f8", "(1, 2)", little<double>({1.0, -2.0}), "True"), "a.npy");
    EXPECT_TRUE(turned.is_column_major);
    EXPECT_EQ(turned.shape, (std::vector<std::uint64_t>{1, 2}));
}

TEST(Numpy, TakesDenseMatricesByName) {
    const std::string k = npy("<f8", "(2, 2)", little<double>({2.0, -1.0, -1.0, 3.0}));
    const std::string m = npy("<i4", "(2, 2)", little<std::int32_t>({1, 0, 0, 1}), "True");
    for (const auto& [stiffness, mass, damping] :
         {std::array{"K", "M", "C"}, std::array{"stiffness", "mass", "damping"}, std::array{"KAAX", "MAAX", "BAAX"}}) {
        const ElasticPart part = part_of({{"part.npz", zip({{std::string(stiffness) + ".npy", k},
                                                            {std::string(mass) + ".npy", m},
                                                            {std::string(damping) + ".npy", k}})}},
                                         {.files = {"part.npz"}});
        EXPECT_EQ(part.stiffness.coeff(1, 1), 3.0);
        EXPECT_EQ(part.stiffness.coeff(0, 1), -1.0);
        EXPECT_EQ(part.mass.coeff(1, 1), 1.0);
        EXPECT_EQ(part.damping.coeff(0, 0), 2.0);
    }
    const ElasticPart plain = part_of({{"k.npy", k}, {"m.npy", m}}, {.stiffness = "k.npy", .mass = "m.npy"});
    EXPECT_EQ(plain.stiffness.coeff(1, 1), 3.0);
}

// element by element, as SciPy keeps what is assembled; and a triangle alone
TEST(Numpy, SumsEntriesOfOnePlaceAsScipyMeansThem) {
    const std::map<std::string, std::string> coo{
        {"data.npy", npy("<f8", "(4,)", little<double>({1.0, 1.0, -1.0, 2.0}))},
        {"row.npy", npy("<i4", "(4,)", little<std::int32_t>({0, 0, 0, 1}))},
        {"col.npy", npy("<i4", "(4,)", little<std::int32_t>({0, 0, 1, 1}))},
        {"format.npy", npy("|S3", "()", "coo")},
        {"shape.npy", npy("<i8", "(2,)", little<std::int64_t>({2, 2}))}};
    const ElasticPart part =
        part_of({{"k.npz", zip(coo)}, {"m.npz", good_mass}}, {.files = {"m.npz"}, .stiffness = "k.npz"});
    EXPECT_EQ(part.stiffness.coeff(0, 0), 2.0);
    EXPECT_EQ(part.stiffness.coeff(1, 0), -1.0);
    EXPECT_EQ(part.stiffness.coeff(1, 1), 2.0);
}

TEST(NumpyTraps, SparseMatricesThatDoNotFitAreRefused) {
    const auto data = [](const std::string& shape, std::vector<double> values) {
        return npy("<f8", shape, little<double>(values));
    };
    const auto whole = [](const std::string& shape, std::vector<std::int32_t> values) {
        return npy("<i4", shape, little<std::int32_t>(values));
    };
    expect_npz_refused(csr(data("(3,)", {1, 2, 3}), good_indices, good_pointers), "its arrays do not fit each other");
    expect_npz_refused(csr(good_data, good_indices, whole("(2,)", {0, 4})), "its arrays do not fit each other");
    expect_npz_refused(csr(good_data, good_indices, whole("(3,)", {0, 5, 4})), "its arrays do not fit each other");
    expect_npz_refused(csr(good_data, good_indices, whole("(3,)", {1, 2, 4})), "its arrays do not fit each other");
    expect_npz_refused(csr(good_data, whole("(4,)", {0, 2, 0, 1}), good_pointers), "there is no row 2");
    expect_npz_refused(csr(good_data, whole("(4,)", {0, -1, 0, 1}), good_pointers), "there is no row -1");
    expect_npz_refused(csr(good_data, good_data, good_pointers),
                       "it holds no whole numbers (rows and columns are) [k.npz: indices]");
    expect_npz_refused(
        csr(data("(4,)", {2, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), 2}),
            good_indices, good_pointers),
        "element 1 is nan");
    expect_npz_refused(csr(data("(4,)", {2, -1, -1.1, 2}), good_indices, good_pointers), "the matrix is not symmetric");
    expect_npz_refused(csr(good_data, good_indices, good_pointers, npy("|S3", "()", "dia")),
                       "it holds a matrix in SciPy's format \"dia\" (csr, csc and coo are read). Save it as");
    auto members = csr(good_data, good_indices, good_pointers);
    members.erase("indptr.npy");
    expect_npz_refused(members, "it lacks the array \"indptr\"");
    members = csr(good_data, good_indices, good_pointers);
    members["shape.npy"] = npy("<i8", "(2,)", little<std::int64_t>({2, 3}));
    expect_npz_refused(members, "the matrix is not square");
    members["shape.npy"] = npy("<i8", "(2,)", little<std::int64_t>({2000000000, 2000000000}));
    expect_npz_refused(members, "its arrays do not fit each other");
}

TEST(NumpyTraps, OtherArraysAreRefused) {
    const auto refused = [](const std::string& bytes, const std::string& sentence) {
        expect_refused({{"k.npy", bytes}, {"m.npz", good_mass}}, {.files = {"m.npz"}, .stiffness = "k.npy"}, sentence);
    };
    refused(npy("<c16", "(1, 1)", little<double>({1.0, 0.0})), "its numbers are complex");
    refused(npy("|O", "(1, 1)", "pickle"), "its elements are of type \"|O\"");
    refused(npy("<f16", "(1, 1)", std::string(16, '\0')), "its elements are of type \"<f16\"");
    refused(npy("|S0", "(1, 1)", ""), "its elements are of type \"|S0\"");
    refused(npy("|b1", "(1, 1)", "\1"), "it holds no numbers");
    refused(npy("<f8", "(1, 2)", little<double>({1.0, 0.0})), "the array is not square");
    refused(npy("<f8", "(1,)", little<double>({1.0})), "the array is not square");
    refused(npy("<f8", "(1, 1, 1)", little<double>({1.0})), "the array has more than two indices");
    refused(npy("<f8", "(2, 2)", little<double>({1.0})), "the array says 4 elements of 8 bytes, and holds 8 bytes");
    refused(npy("<f8", "(2147483647, 2147483647)", ""), "the array says 4611686014132420609 elements");
    refused(npy("<f8", "(2147483648, 1)", ""), "a length of its shape is missing or too large");
    refused(npy("<f8", "(-1, 1)", ""), "a length of its shape is missing or too large");
    refused(npy("<f8", "(1, 1)", little<double>({std::numeric_limits<double>::infinity()})), "element 0 is inf");
    refused(npy("<f8", "(1, 1", ""), "the header of the array is damaged");
    refused(npy("<f8", "(1, 1)", "", "Maybe"), "fortran_order is neither True nor False");
    refused(npy_of("{'descr': [('x', '<f8')], 'fortran_order': False, 'shape': (1, 1)}", std::string(8, '\0')),
            "its elements have several fields");
    refused("\x93NUMPY\x09" + std::string(20, '\0'), "version 9 of .npy is not known");
    refused("\x93NUMPY\x01" + std::string(1, '\0') + "\xff\xff{'descr'", "the array is cut off");
    refused("\x93NUMPY", "it is no array of NumPy");
}

TEST(NumpyTraps, OtherArchivesAreRefused) {
    const auto refused = [](const std::string& bytes, const std::string& sentence) {
        expect_refused({{"k.npz", bytes}}, {.files = {"k.npz"}}, sentence);
    };
    const std::string whole = text_of(block_folder + "block_stiffness.npz");
    refused(whole.substr(0, 4000), "it is no whole zip archive");
    std::string flipped = whole;
    flipped[5000] = static_cast<char>(flipped[5000] ^ 0x10);
    refused(flipped, "it is no whole zip archive");
    refused(zip({{"readme.txt", "hello"}}), "it holds something else than arrays of NumPy");
    refused(zip({{"P.npy", "whatever"}}), "there is no matrix in it");
    refused(good_mass, "there is no stiffness among the files");
    std::map<std::string, std::string> many;
    for (int k = 0; k < 101; ++k)
        many[std::to_string(k) + ".npy"] = "";
    refused(zip(many), "it holds more than 100 files");
}

}  // namespace
}  // namespace stridor::io::structure
