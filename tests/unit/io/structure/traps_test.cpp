// What finite-element programs write that is not what it seems: each is refused, or taken, by its own sentence.

#include "stridor/io/structure/calculix.hpp"
#include "structure_texts.hpp"
#include "structure_writers.hpp"

namespace stridor::io::structure {
namespace {

using reduction::ElasticPart;

const std::string traps = block_folder + "traps/";

// two rows held by springs: enough for what is wrong elsewhere
const std::string small_sti = "1 1 2.0e+00\n1 2 -1.0e+00\n2 2 2.0e+00\n";
const std::string small_mas = "1 1 1.0e+00\n1 2 0.0e+00\n2 2 1.0e+00\n";

TextFiles job(const std::string& dof, const std::string& deck = "", const std::string& sti = small_sti,
              const std::string& mas = small_mas) {
    TextFiles files{{"j.sti", sti}, {"j.mas", mas}, {"j.dof", dof}};
    if (!deck.empty()) files["j.inp"] = deck;
    return files;
}

void expect_job_refused(const TextFiles& files, const std::string& sentence) {
    expect_refused(files, {.files = {"j.sti"}}, sentence);
}

const std::string two_nodes = "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n";

TEST(CalculixTraps, ExpandedBeamsAreRefused) {
    expect_refused({{"b31.sti", text_of(traps + "b31.sti")},
                    {"b31.mas", text_of(traps + "b31.mas")},
                    {"b31.dof", text_of(traps + "b31.dof")}},
                   {.files = {"b31.dof"}},
                   "the label 1.2 stands for several rows (CalculiX gives further rows the number of an old node");
}

TEST(CalculixTraps, ADeckWithoutMatricesSaysHowToWriteThem) {
    expect_refused({{"seal.inp", two_nodes}}, {.files = {"seal.inp"}}, "there is no seal.sti beside it");
}

// an equation, a transformed system and a rigid body: rows vanish, and rotations come under labels of translations
TEST(CalculixTraps, DependentRowsAreAbsentAndRotationsNamed) {
    const TextFiles files{{"eq.sti", text_of(traps + "eq.sti")},
                          {"eq.mas", text_of(traps + "eq.mas")},
                          {"eq.dof", text_of(traps + "eq.dof")},
                          {"eq.inp", text_of(traps + "eq.inp")},
                          {"mesh.inp", text_of(block_folder + "mesh.inp")}};
    const ElasticPart part = part_of(files, {.files = {"eq.sti"}});
    EXPECT_NO_THROW(expect_sound(part));
    EXPECT_EQ(rows_of(part), 136);
    EXPECT_EQ(named_rows(part, "9001").size(), 3U);
    EXPECT_EQ(named_rows(part, "9002:456").size(), 3U);
    EXPECT_TRUE(support::thrown_by([&] { named_rows(part, "9002:1"); }).says("node 9002 has no row for component 1"));
    EXPECT_TRUE(support::thrown_by([&] { named_rows(part, "1000:3"); }).says("node 1000 has no row for component 3"));
    EXPECT_TRUE(support::thrown_by([&] { named_rows(part, "1003.1"); }).says("node 1003 has no row for component 1"));
    EXPECT_TRUE(support::thrown_by([&] { named_rows(part, "FOOT"); }).says("node 1008 has no row"));
    ASSERT_EQ(part.notes.size(), 3U);
    EXPECT_EQ(part.notes[0], "the deck holds *EQUATION: rows that depend on others are absent");
}

TEST(CalculixTraps, RotationsOfARigidBodyWithoutANameAreRefused) {
    expect_job_refused(job("1.1\n99.1\n", two_nodes + "*RIGID BODY, NSET=A, REF NODE=1\n"),
                       "node 99 is not in the deck (CalculiX made it itself");
}

TEST(CalculixTraps, LongNodeNumbersAndComponentsAreText) {
    const ElasticPart part = part_of(job("1234567.1\n1234567.2\n"), {.files = {"j.sti"}});
    EXPECT_EQ(describe(part.labels[1]), "1234567.2");
    expect_job_refused(job("1000.1\n1000.10\n"), "\"1000.10\" is no node.component");
    expect_job_refused(job("1000.1\n1.0005e3\n"), "\"1.0005e3\" is no node.component");
    expect_job_refused(job("1000.1\n1000.0\n"), "the component of 1000.0 is none of 1, 2 and 3");
}

TEST(CalculixTraps, MatricesOfAnotherRunAreRefused) {
    expect_job_refused(job("1.1\n1.2\n1.3\n"), "the stiffness has 2 rows, j.dof has 3 labels");
    expect_job_refused(job("1.1\n1.2\n", "", small_sti, small_mas + "3 3 1.0\n"),
                       "the mass has 3 rows, j.dof has 2 labels");
    expect_job_refused(job(""), "there is no label in it");
    expect_job_refused(job("1.1\n1.2\n", "", ""), "there is no entry in it");
}

TEST(CalculixTraps, ContactPairsAreRefused) {
    expect_job_refused(job("1.1\n2.1\n", two_nodes + "*CONTACT PAIR, INTERACTION=SI1\nS, M\n"),
                       "the model has a contact pair (its springs would stand in the stiffness");
}

TEST(CalculixTraps, MatricesInSystemsOfTransformedNodesAreRefused) {
    const std::string step = "*STEP\n*FREQUENCY, SOLVER=MATRIXSTORAGE, GLOBAL=NO\n*END STEP\n";
    expect_job_refused(job("1.1\n2.1\n", two_nodes + "*TRANSFORM, NSET=A\n1,0,0,0,1,0\n" + step),
                       "the matrices are in the systems of transformed nodes (GLOBAL=NO stores them so");
    EXPECT_NO_THROW(part_of(job("1.1\n2.1\n", two_nodes + step), {.files = {"j.sti"}}));
}

TEST(CalculixTraps, TiesAreToldOf) {
    const ElasticPart part = part_of(job("1.1\n2.1\n", two_nodes + "*Tie, NAME=T\nA,B\n"), {.files = {"j.sti"}});
    ASSERT_EQ(part.notes.size(), 1U);
    EXPECT_EQ(part.notes[0], "the deck holds *TIE: rows that depend on others are absent");
}

TEST(CalculixTraps, CondensedStiffnessCannotVibrate) {
    expect_refused({{"s.mtx", text_of(traps + "substructure_stiffness_only.mtx")}}, {.stiffness = "s.mtx"},
                   "it holds the matrix of a substructure without its mass (CalculiX condenses the stiffness alone");
}

TEST(CalculixTraps, DamagedLinesAreRefusedWhereTheyStand) {
    const auto place_of_error = [](const TextFiles& files) {
        const auto thrown = support::thrown_by([&] { part_of(files, {.files = {"j.sti"}}); });
        return thrown.message;
    };
    EXPECT_NE(place_of_error(job("1.1\n1.2\n", "", "1 1 2.0\n1 x 2.0\n")).find("\"x\" is no whole number"),
              std::string::npos);
    EXPECT_NE(place_of_error(job("1.1\n1.2\n", "", "1 1 2.0\n1 x 2.0\n")).find("[j.sti:2:3]"), std::string::npos);
    EXPECT_NE(place_of_error(job("1.1\n1.2\n", "", "1 1 nan\n")).find("\"nan\" is no finite number"),
              std::string::npos);
    EXPECT_NE(place_of_error(job("1.1\n1.2\n", "", "1 1 2.0 7\n")).find("is more than the line should hold"),
              std::string::npos);
    EXPECT_NE(place_of_error(job("1.1\n1.2\n", "", "0 1 2.0\n")).find("there is no row 0, column 1"),
              std::string::npos);
    expect_job_refused(job("1.1\n1.2\n", "", small_sti + "2 2 3.0\n"), "holds the entry 1.2, 1.2 twice");
}

TEST(CalculixDeck, ReadsNodesAndSetsAsTheyAreWritten) {
    const std::string deck =
        "** a comment\n*Node , nset = All\n 1 , 0.5, , -1e-3\n2, 1.\n*nset, nset=A, generate\n1, 2\n"
        "*NSET,NSET=B\nA,\n*NSET,NSET=a\n7\n*INCLUDE, INPUT=\"more.inp\"\n3, 0., 0., 0.\n";
    TextFiles files = job("1.1\n2.1\n", deck);
    files["more.inp"] = "*NODE\n5, 1, 2, 3\n";
    const ElasticPart part = part_of(files, {.files = {"j.sti"}});
    EXPECT_EQ(part.positions.at("1"), Eigen::Vector3d(0.5, 0.0, -1e-3));
    EXPECT_EQ(part.positions.at("5"), Eigen::Vector3d(1.0, 2.0, 3.0));
    EXPECT_FALSE(part.positions.contains("3"));  // data behind an include belong to no card
    EXPECT_EQ(find_set(part, "all")->nodes, (std::vector<std::string>{"1", "2"}));
    EXPECT_EQ(find_set(part, "B")->nodes, (std::vector<std::string>{"1", "2"}));
    EXPECT_EQ(find_set(part, "A")->nodes, (std::vector<std::string>{"1", "2", "7"}));
}

TEST(CalculixDeck, RefusesWhatDoesNotEndOrIsNotThere) {
    TextFiles files = job("1.1\n2.1\n", "*INCLUDE, INPUT=j.inp\n");
    expect_job_refused(files, "the includes do not end");
    expect_job_refused(job("1.1\n2.1\n", "*INCLUDE, INPUT=gone.inp\n"), "the included file \"gone.inp\" is not there");
    expect_job_refused(job("1.1\n2.1\n", "*INCLUDE\n"), "*INCLUDE names no file");
    expect_job_refused(job("1.1\n2.1\n", "*NSET\n1\n"), "the node set has no name");
    expect_job_refused(job("1.1\n2.1\n", "*NSET, NSET=A\nB\n"), "there is no node set \"B\"");
    expect_job_refused(job("1.1\n2.1\n", "*NSET, NSET=A\nA\n"), "the node set A holds itself");
    expect_job_refused(job("1.1\n2.1\n", "*NSET, NSET=A, GENERATE\n1, 1000000000\n"), "these nodes cannot be counted");
}

// 2 kB of deck asked for 120 million nodes
TEST(CalculixDeck, BoundsItsSetsTogether) {
    const std::string too_many = "the node sets hold more than 4000000 nodes together";
    expect_job_refused(job("1.1\n2.1\n", "*NSET, NSET=A, GENERATE\n1, 100000000\n"), too_many);
    std::string sets;
    for (int k = 0; k < 5; ++k)
        sets += "*NSET, NSET=A" + std::to_string(k) + ", GENERATE\n1, 1000000\n";
    expect_job_refused(job("1.1\n2.1\n", sets), too_many);
    sets = "*NSET, NSET=A, GENERATE\n1, 100000\n";
    for (int k = 0; k < 40; ++k)
        sets += "*NSET, NSET=B" + std::to_string(k) + "\nA\n";
    expect_job_refused(job("1.1\n2.1\n", sets), too_many);
}

TEST(CalculixDeck, BoundsItsNamesOfSets) {
    std::string sets = two_nodes;
    for (int k = 0; k < 100'001; ++k)
        sets += "*NSET, NSET=A" + std::to_string(k) + "\n1\n";
    expect_job_refused(job("1.1\n2.1\n", sets), "there are more than 100000 node sets");
}

TEST(MatrixTraps, BothTrianglesMustAgree) {
    const auto general = [](const std::string& across) {
        return TextFiles{
            {"k", "%%MatrixMarket matrix coordinate real general\n2 2 4\n1 1 2\n1 2 -1\n2 1 " + across + "\n2 2 2\n"},
            {"m", "%%MatrixMarket matrix coordinate real symmetric\n2 2 2\n1 1 1\n2 2 1\n"}};
    };
    const PartFiles files{.stiffness = "k", .mass = "m"};
    EXPECT_NO_THROW(part_of(general("-1.00000000001"), files));
    // two of the largest numbers have a mean, though no sum
    TextFiles large = general("1e308");
    large["k"].replace(large["k"].find("1 2 -1"), 6, "1 2 1e308");
    EXPECT_NO_THROW(part_of(large, files));
    expect_refused(general("-1.0000001"), files, "the matrix is not symmetric (at row 2, column 1 it holds");
    expect_refused(general("0"), files, "the matrix is not symmetric");
}

// three programs call their files .mtx
TEST(MatrixTraps, MtxFilesAreToldByTheirBytes) {
    const std::string mass = "%%MatrixMarket matrix coordinate real symmetric\n2 2 2\n1 1 1\n2 2 1\n";
    for (const std::string& stiffness :
         {std::string("%%MatrixMarket matrix coordinate real symmetric\n2 2 3\n1 1 2\n2 1 -1\n2 2 2\n"),
          std::string("** ASSEMBLED\n7,1, 7,1, 2.0\n7,2, 7,1, -1.0\n7,2, 7,2, 2.0\n"),
          std::string("1 1 2.0\n1 2 -1.0\n2 1 -1.0\n2 2 2.0\n")}) {
        const ElasticPart part =
            part_of({{"k.mtx", stiffness}, {"m.mtx", mass}}, {.stiffness = "k.mtx", .mass = "m.mtx"});
        EXPECT_EQ(part.stiffness.coeff(0, 1), -1.0) << stiffness;
        EXPECT_EQ(part.stiffness.coeff(1, 1), 2.0) << stiffness;
    }
}

TEST(MatrixTraps, OtherKindsOfMatrixMarketAreRefused) {
    const std::string good = "%%MatrixMarket matrix coordinate real symmetric\n2 2 2\n1 1 1\n2 2 1\n";
    const auto refused = [&](const std::string& text, const std::string& sentence) {
        expect_refused({{"k", text}, {"m", good}}, {.stiffness = "k", .mass = "m"}, sentence);
    };
    refused("%%MatrixMarket matrix coordinate complex symmetric\n1 1 1\n1 1 1 0\n",
            "\"COMPLEX\" is no kind of numbers");
    refused("%%MatrixMarket matrix coordinate pattern symmetric\n1 1 1\n1 1\n", "\"PATTERN\" is no kind of numbers");
    refused("%%MatrixMarket matrix coordinate real skew-symmetric\n1 1 0\n", "\"SKEW-SYMMETRIC\" is no symmetry");
    refused("%%MatrixMarket matrix coordinate real general\n2 3 1\n1 1 1\n", "the matrix has 2 rows and 3 columns");
    refused("%%MatrixMarket matrix coordinate real symmetric\n2 2 3\n1 1 1\n2 2 1\n", "it says 3 entries, and holds 2");
    refused("%%MatrixMarket matrix coordinate real symmetric\n2 2 2\n1 1 1\n3 3 1\n", "there is no row 3, column 3");
    refused("%%MatrixMarket matrix coordinate real symmetric\n2 2 4\n1 1 1\n2 2 1\n1 2 1\n2 1 1\n",
            "holds entries on both sides of the diagonal");
    refused("%%MatrixMarket matrix coordinate real symmetric\n1000000000 1000000000 1\n1 1 1\n",
            "has 1000000000 rows, but only 1 entries");
    refused("%%MatrixMarket matrix array real symmetric\n2 2\n1\n0\n", "it says 3 entries, and holds 2");
}

TEST(MatrixTraps, StiffnessAndMassMustBeThereOnce) {
    const std::string good = "%%MatrixMarket matrix coordinate real symmetric\n2 2 2\n1 1 1\n2 2 1\n";
    const std::string three = "%%MatrixMarket matrix coordinate real symmetric\n3 3 3\n1 1 1\n2 2 1\n3 3 1\n";
    expect_refused({{"k", good}}, {.stiffness = "k"}, "there is no mass among the files");
    expect_refused({{"m", good}}, {.mass = "m"}, "there is no stiffness among the files");
    expect_refused({{"k", good}}, {.files = {"k"}}, "it does not say whether it is stiffness or mass");
    expect_refused({{"k", good}, {"STIF.mtx", good}, {"m", good}},
                   {.files = {"STIF.mtx"}, .stiffness = "k", .mass = "m"}, "there is more than one stiffness");
    expect_refused({{"k", good}, {"m", three}}, {.stiffness = "k", .mass = "m"},
                   "the mass has 3 rows, the stiffness 2 (both must be of the same model)");
    expect_refused({{"x", "hello\n"}}, {.files = {"x"}}, "it is no file of a part that is known");
    const auto missing = support::thrown_by([] { part_of({}, {.files = {"gone.mtx"}}); });
    EXPECT_EQ(missing.kind, ErrorKind::io);
    EXPECT_TRUE(missing.says("cannot open \"gone.mtx\"")) << missing.message;
}

TEST(LabelTraps, TablesMustFitTheMatrices) {
    const std::string good = "%%MatrixMarket matrix coordinate real symmetric\n2 2 2\n1 1 1\n2 2 1\n";
    const auto refused = [&](const std::string& table, const std::string& sentence) {
        expect_refused({{"k", good}, {"m", good}, {"t.csv", table}}, {.stiffness = "k", .mass = "m", .labels = "t.csv"},
                       sentence);
    };
    refused("node,component\n1,1\n", "it labels 1 rows, the stiffness has 2");
    refused("node,component\n1,1\n1,1\n", "the label 1.1 stands for two rows");
    refused("node,component\n1,1\n,2\n", "the row has no node");
    refused("node,component\n1,1\n1,sideways\n", "\"sideways\" is no component");
    refused("node,component,x [kg],y,z\n1,1,0,0,0\n1,2,0,0,0\n", "\"kg\" is no length");
    refused("node,component,x,y,z\n1,1,0,far,0\n1,2,0,0,0\n", "\"far\" is no coordinate");
    refused("node,component,x,y,z\n1,1,0,5,0,0\n1,2,0,0,0\n", "the row has 6 fields");
    refused("node,component,node\n1,1,2\n1,2,2\n", "two columns are called \"node\"");
    refused("knot,way\n1,1\n", "it holds no labels");
    std::string sets = "node,component,set\n";
    for (int k = 0; k < 100'001; ++k)
        sets += (k % 5000 == 0 ? "\n1,1,A" : " A") + std::to_string(k);
    refused(sets + "\n", "there are more than 100000 node sets");
    const ElasticPart part =
        part_of({{"k", good}, {"m", good}, {"t.csv", "component;node\nUY;7\n# the same node turns\nrotz;7\n"}},
                {.stiffness = "k", .mass = "m", .labels = "t.csv"});
    EXPECT_EQ(describe(part.labels[0]), "7.2");
    EXPECT_EQ(describe(part.labels[1]), "7.6");
}

// a beam as Abaqus writes it: internal nodes, a held row with 1e36, lower triangle by columns
TEST(AbaqusTraps, HeldRowsAreTakenOutAndInternalNodesKept) {
    const std::string stiffness =
        "-1,1, -1,1,  3.3e+01\n2,1, -1,1, -2.5e+01\n2,1, 2,1,  5.0e+01\n1,1, 1,1,  1.0e+36\n2,1, 1,1, -3.0e+02\n";
    const std::string mass = "-1,1, -1,1, 1.0\n2,1, 2,1, 1.0\n1,1, 1,1, 1.0\n1,1, 2,1, 0.25\n";
    const ElasticPart part =
        part_of({{"job_STIF1.mtx", stiffness}, {"job_MASS1.mtx", mass}}, {.files = {"job_STIF1.mtx", "job_MASS1.mtx"}});
    EXPECT_NO_THROW(expect_sound(part));
    ASSERT_EQ(rows_of(part), 2);
    EXPECT_EQ(part.stiffness.coeff(0, 1), -25.0);
    EXPECT_EQ(part.mass.coeff(1, 1), 1.0);
    EXPECT_EQ(part.notes.at(0), "1 row held by a penalty of 1e30 or more was taken out");
    EXPECT_NO_THROW(named_rows(part, "internal 1.1"));
    EXPECT_TRUE(support::thrown_by([&] { named_rows(part, "1.1"); }).says("is no set, node or row"));
}

// Abaqus lists one triangle, either of them, or both
TEST(AbaqusTraps, AnyTriangleIsTheSameMatrix) {
    const std::string diagonal = "2,1, 2,1, 4.0\n3,1, 3,1, 5.0\n";
    const std::string mass = "2,1, 2,1, 1.0\n3,1, 3,1, 1.0\n";
    for (const std::string& across : {std::string("3,1, 2,1, -2.0\n"), std::string("2,1, 3,1, -2.0\n"),
                                      std::string("2,1, 3,1, -2.0\n3,1, 2,1, -2.0\n")}) {
        const ElasticPart part = part_of({{"STIF", diagonal + across}, {"MASS", mass}}, {.files = {"STIF", "MASS"}});
        EXPECT_EQ(part.stiffness.coeff(0, 1), -2.0) << across;
        EXPECT_EQ(part.stiffness.coeff(1, 0), -2.0) << across;
    }
}

TEST(AbaqusTraps, OtherTextsAreRefused) {
    const std::string mass = "2,1, 2,1, 1.0\n";
    const auto refused = [&](const std::string& stiffness, const std::string& sentence) {
        expect_refused({{"STIF", stiffness}, {"MASS", mass}}, {.files = {"STIF", "MASS"}}, sentence);
    };
    refused("** Assembled nodal loads\n*CLOAD, REAL\n2,3,  5.4e+04\n", "it holds loads");
    refused("2,8, 2,8, 1.0\n", "the component 8 of node 2 is none of 1 to 6");
    refused("2 8 2 8 1.0\n", "the component 8 of node 2 is none of 1 to 6");
    refused("2 1 2 1 1.0\n2 1 3\n", "a component");
    refused("3,1, 3,1, 1.0\n", "the mass has a row 2.1 that the stiffness lacks (both must be of the same model)");
    refused("2,1, 2,1, 1.0\n2,1, 3,1, 0.5\n3,1, 2,1, 0.6\n3,1, 3,1, 1.0\n", "the matrix is not symmetric");
    refused("2,1, 2,1, 1.0\n2,1, 2,1, 1.0\n", "holds the entry 2.1, 2.1 twice");
}

const std::string element_head =
    "**\n*User Element, Nodes=3, LINEAR\n** ELEMENT NODES\n**      10,      20,\n**  -1\n      1, 2\n      3, 1\n";
const std::string element_stiffness =
    "*MATRIX,TYPE=STIFFNESS\n 4.0,\n -1.0, 5.0,\n 0.0, -2.0, 6.0, 0.0,\n -3.0, 0.0, 7.0, 0,0,0,0, 8.0\n";
const std::string element_mass = "*MATRIX, TYPE=MASS\n1.0, 0, 1.0, 0,\n0, 1.0, 0, 0, 0, 1.0,0,0,0,0,1.0\n";

// a substructure of two nodes with two degrees of freedom each, and a mode in an internal node
TEST(AbaqusTraps, SubstructuresAreTakenWithTheirMass) {
    const std::string load = "*MATRIX,TYPE=LOAD CASE\n1,1,1,1,1,1,1,1,1,1,1,1,1,1,1\n";
    const ElasticPart part =
        part_of({{"s.mtx", element_head + element_stiffness + element_mass + load}}, {.files = {"s.mtx"}});
    EXPECT_NO_THROW(expect_sound(part));
    ASSERT_EQ(rows_of(part), 5);
    std::string labels;
    for (const auto& label : part.labels)
        labels += describe(label) + " ";
    EXPECT_EQ(labels, "10.1 10.2 20.1 20.2 internal 3.1 ");
    EXPECT_EQ(part.stiffness.coeff(1, 2), -2.0);
    EXPECT_EQ(part.stiffness.coeff(3, 1), -3.0);
    EXPECT_EQ(part.stiffness.coeff(3, 0), 0.0);
    EXPECT_EQ(part.mass.coeff(4, 4), 1.0);
}

TEST(AbaqusTraps, SubstructuresThatDoNotFitAreRefused) {
    const auto refused = [](const std::string& text, const std::string& sentence) {
        expect_refused({{"s.mtx", text}}, {.files = {"s.mtx"}}, sentence);
    };
    refused(element_head + element_stiffness, "it holds the matrix of a substructure without its mass");
    refused(element_head + element_mass, "it holds the matrix of a substructure without its mass");
    refused(element_head + element_stiffness + "1.0\n", "the stiffness has 16 values (5 rows have 15 in a triangle");
    refused(element_head + element_stiffness + element_mass + element_mass, "there is more than one mass");
    refused(element_head + element_stiffness + "*MATRIX,TYPE=MASS\n1.0, one\n", "\"one\" is no finite number");
    refused("*USER ELEMENT, LINEAR\n1\n" + element_mass, "the number of nodes is missing, too large or there twice");
    refused("*USER ELEMENT, NODES=900000, LINEAR\n1\n" + element_mass, "the number of nodes is missing, too large");
    refused(element_head + "*USER ELEMENT, NODES=3, LINEAR\n", "the number of nodes is missing, too large or there");
    refused("*USER ELEMENT, NODES=2, LINEAR\n1\n" + element_mass, "the element has 2 nodes, and lists 0");
    refused("*USER ELEMENT, NODES=2, LINEAR\n" + element_mass, "it does not say which degrees of freedom");
    refused("*USER ELEMENT, NODES=2, LINEAR\n1\n3, 1\n" + element_mass, "there is no node at position 3");
    refused("*USER ELEMENT, NODES=2, LINEAR\n11\n" + element_mass, "the degree of freedom \"11\" is none of 1 to 6");
    refused("*USER ELEMENT, NODES=2, LINEAR\n1,2,3,4,5,6,1\n" + element_mass,
            "a node has more than 6 degrees of freedom");
    refused("*USER ELEMENT, NODES=1, LINEAR\n** ELEMENT NODES\n** 7\n1\n*MATRIX,TYPE=STIFFNESS\n1,2\n",
            "the stiffness has more than 1 values");
}

// all entries, as an element without symmetry has them
TEST(AbaqusTraps, WholeMatricesOfSubstructuresMustBeSymmetric) {
    const std::string head = "*USER ELEMENT, NODES=2, LINEAR, UNSYMM\n** ELEMENT NODES\n** 7, 8\n3\n";
    const std::string mass = "*MATRIX,TYPE=MASS\n1,0,0,1\n";
    const ElasticPart part =
        part_of({{"s.mtx", head + "*MATRIX,TYPE=STIFFNESS\n2,-1\n-1,2\n" + mass}}, {.files = {"s.mtx"}});
    EXPECT_EQ(part.stiffness.coeff(0, 1), -1.0);
    expect_refused({{"s.mtx", head + "*MATRIX,TYPE=STIFFNESS\n2,-1\n-1.5,2\n" + mass}}, {.files = {"s.mtx"}},
                   "matrix stiffness is not symmetric");
}

TEST(AnsysTraps, OtherFormatsAndBothTrianglesAreRead) {
    const auto matrix = [](const std::string& across) {
        return "Stiffness matrix\n 10 1 1 2 0\nRUA                 2             2             4       0\n"
               "(3I6)           (10I8)          (1P,2E12.4)         (1P,2E12.4)\n"
               "     1     3     5\n       1       2       1       2\n  2.0000E+00 -1.0000E+00\n" +
               across + "  2.0000E+00\n";
    };
    const TextFiles others{{"m", "%%MatrixMarket matrix coordinate real symmetric\n2 2 2\n1 1 1\n2 2 1\n"},
                           {"map", " Matrix Eqn  Node  DOF\n 1 7 UX\n 2 7 UY\n"}};
    TextFiles files = others;
    files["k"] = matrix(" -1.0000E+00");
    const ElasticPart part = part_of(files, {.files = {"k", "map"}, .mass = "m"});
    EXPECT_EQ(part.stiffness.coeff(0, 1), -1.0);
    EXPECT_EQ(part.stiffness.coeff(1, 1), 2.0);
    files["k"] = matrix(" -1.5000E+00");
    expect_refused(files, {.files = {"k", "map"}, .mass = "m"}, "the matrix is not symmetric");
}

TEST(AnsysTraps, PointersThatDoNotRiseAreRefused) {
    const std::string head =
        "Stiffness matrix\n 10 3 2 2 0\nRSA                 2             2             2       0\n"
        "(I14)           (I14)           (d25.15)            (d25.15)\n";
    const std::string body = "             1\n             2\n  0.5D+00\n  0.5D+00\n";
    const std::string mass = "%%MatrixMarket matrix coordinate real symmetric\n2 2 2\n1 1 1\n2 2 1\n";
    const auto refused = [&](const std::string& text, const std::string& sentence) {
        expect_refused({{"k", text}, {"m", mass}}, {.files = {"k"}, .mass = "m"}, sentence);
    };
    refused(head + "             1\n             4\n             3\n" + body,
            "the pointers of the columns do not rise");
    refused(head + "             1\n             2\n             9\n" + body,
            "the pointers do not fit the number of entries");
    refused(
        head + "             1\n             2\n             3\n             1\n             7\n  0.5D+00\n  0.5D+00\n",
        "there is no row 7");
    refused(head + "             1\n             2\n             3\n             1\n", "the matrix is cut off");
    refused("Stiffness matrix\n 10 3 2 2 0\nCSA                 2             2             2       0\n",
            "matrices of type CSA are not read");
    const ElasticPart part = part_of({{"k", head + "             1\n             2\n             3\n" + body},
                                      {"m", mass},
                                      {"map", " Matrix Eqn  Node  DOF\n 1 10002 UY\n 2 21 ROTZ\n"}},
                                     {.files = {"k", "map"}, .mass = "m"});
    EXPECT_EQ(describe(part.labels[0]), "10002.2");  // the order of rows is not that of nodes
    EXPECT_EQ(describe(part.labels[1]), "21.6");
    expect_refused({{"k", head + "             1\n             2\n             3\n" + body},
                    {"m", mass},
                    {"map", " Matrix Eqn  Node  DOF\n 1 10002 TEMP\n 2 21 ROTZ\n"}},
                   {.files = {"k", "map"}, .mass = "m"}, "\"TEMP\" is no displacement or rotation");
}

}  // namespace
}  // namespace stridor::io::structure
