#include "stridor/io/case/own_structure/structure_springs.hpp"

#include "stridor/base/json.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/io/case/case_schema.hpp"
#include "stridor/io/case/packed_case.hpp"
#include "stridor/io/case/ready_files.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/model/built/case_structure.hpp"
#include "stridor/model/linear/frequencies.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/rules/check.hpp"
#include "stridor/parameters/rules/engines.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "structure_texts.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace stridor::io {
namespace {

using parameters::Case;
using parameters::OwnSpring;

constexpr const char* two_rows =
    "[structure]\nrows = [\"x\", \"y\"]\nmass = [[1, 0], [0, 2]]\nstiffness = [[300, -100], [-100, 400]]\n";
constexpr const char* heel = "[[structure.contact]]\nname = \"heel\"\nnormal = \"y\"\ntangent = \"x\"\n";

std::string spring_table(const std::string& lines) {
    return "[[structure.spring]]\n" + lines;
}

std::string case_with(const std::string& springs) {
    return whole_case(std::string(two_rows) + heel + springs);
}

const std::string all_springs =
    spring_table("name = \"rubber\"\ndirection = \"x\"\nstiffness = \"2 N/mm\"\ncubic = 4e6\n") +
    spring_table("name = \"stop\"\ndirection = \"x -y\"\nforce = \"20 N\"\ndeflection = \"1 mm\"\ngap = \"0.1 mm\"\n") +
    spring_table(
        "direction = [0, 1]\ntable = \"-1: -2, 0: 0, 1 mm: 2 N\"\ninterpolation = \"linear\"\n"
        "preload_share = 0.5\n");

TEST(StructureSprings, AreReadWithUnits) {
    const Case c = read_structure_text(case_with(all_springs));
    const std::vector<OwnSpring>& springs = c.own_structure->springs;
    ASSERT_EQ(springs.size(), 3U);
    EXPECT_EQ(springs[0].name, "rubber");
    EXPECT_EQ(springs[0].direction, (std::vector<double>{1, 0}));
    EXPECT_EQ(springs[0].stiffness, 2000.0);
    EXPECT_EQ(springs[0].cubic, 4e6);
    EXPECT_EQ(springs[1].direction, (std::vector<double>{1, -1}));
    EXPECT_EQ(springs[1].force, 20.0);
    EXPECT_EQ(springs[1].deflection, 1e-3);
    EXPECT_EQ(springs[1].exponent, 1.5);
    EXPECT_EQ(springs[1].gap, 1e-4);
    EXPECT_EQ(springs[2].name, "spring3");
    EXPECT_EQ(springs[2].table.deflections, (std::vector<double>{-1, 0, 1e-3}));
    EXPECT_EQ(springs[2].interpolation, parameters::Interpolation::linear);
}

TEST(StructureSprings, AreWrittenPackedAndReadBack) {
    const std::string chain = ready_file("chain") + spring_table("direction = \"x2 -x1\"\ncubic = 3\n");
    for (const auto& [text, without] :
         {std::pair(case_with(all_springs), case_with("")), std::pair(chain, ready_file("chain"))}) {
        const Case c = read_structure_text(text);
        for (const Case& again : {read_structure_text(case_toml(c)), unpacked_case(packed_case(c)),
                                  read_case(parse_toml({text, "a.toml", {}}), readers_without_files())}) {
            EXPECT_EQ(parameters::canonical_text(again), parameters::canonical_text(c));
            ASSERT_EQ(again.own_structure->springs.size(), c.own_structure->springs.size());
            EXPECT_EQ(again.own_structure->springs.front().name, c.own_structure->springs.front().name);
        }
        EXPECT_NE(parameters::canonical_text(read_structure_text(without)), parameters::canonical_text(c));
    }
}

// what a builder makes anew keeps them
TEST(StructureSprings, StayWhereABuilderBuildsAgain) {
    Case c = read_structure_text(ready_file("chain") + spring_table("direction = \"x2 -x1\"\ncubic = 3\n"));
    parameters::rebuild(c, "coupling", 2.0);
    ASSERT_EQ(c.own_structure->springs.size(), 1U);
    EXPECT_EQ(model::structure_of(c).springs.size(), 1U);
}

TEST(StructureSprings, TakeTheirTableFromAFile) {
    const support::ScratchFolder folder;
    storage::write_file((folder.path() / "lip.csv").string(), "deflection [mm];force [N]\n0;0\n1;2\n3;12\n");
    const std::string path = (folder.path() / "lip.toml").string();
    storage::write_file(path, case_with(spring_table("direction = \"y\"\ntable = \"lip.csv\"\n")));
    const Case c = read_case(path);
    EXPECT_EQ(c.own_structure->springs[0].table.deflections, (std::vector<double>{0, 1e-3, 3e-3}));
    EXPECT_EQ(c.own_structure->springs[0].table.forces, (std::vector<double>{0, 2, 12}));
    EXPECT_TRUE(c.own_structure->springs[0].table.file.empty());
    // somebody else's case opens none
    EXPECT_THROW(read_case(parse_toml(load_toml(path, {})), readers_without_files()), Error);
}

TEST(StructureSprings, AreRefusedWithAWayOut) {
    const auto refused = [](const std::string& lines) { return structure_refusal(case_with(spring_table(lines))); };
    const std::vector<std::pair<std::string, std::string>> wrong{
        {"cubic = 3\n", "missing key structure.spring.1.direction"},
        {"direction = \"z\"\ncubic = 3\n", "\"z\""},
        {"direction = \"y -y\"\ncubic = 3\n", "zero"},
        {"direction = \"y\"\ncubik = 3\n", "Did you mean structure.spring.1.cubic?"},
        {"direction = \"y\"\ncubic = 3\nforce = 2\ndeflection = 1\n", "more than one law"},
        {"direction = \"y\"\nforce = 2\n", "without a deflection"},
        {"direction = \"y\"\ngap = 2\n", "gap without a force"},
        {"direction = \"y\"\nforce = 2\ndeflection = 1\nexponent = 0.5\n", "from 1 to 3"},
        {"direction = \"y\"\ntable = \"0: 0, 1: 2, 2: 1\"\n", "falls"},
        {"direction = \"y\"\ntable = \"0: 0, 0: 1\"\n", "they rise"},
        {"direction = \"y\"\ntable = \"0: 0\"\n", "two at least"},
        {"direction = \"y\"\ntable = \"0: 0, 1: 2\"\ninterpolation = \"round\"\n", "no interpolation"},
        {"direction = \"y\"\nstiffness = 2\npreload_share = 1\n", "is linear"},
        {"direction = \"y\"\ncubic = \"3 N/m\"\n", "N/m"},
        {"direction = \"y\"\nagainst = \"x\"\ncubic = 3\n", "at none"},
    };
    for (const auto& [lines, words] : wrong)
        EXPECT_NE(refused(lines).find(words), std::string::npos) << lines << refused(lines);
    const std::string loaded = whole_case(std::string(two_rows) + "load = [0, -5]\n" + heel +
                                          spring_table("direction = \"y\"\ncubic = 3\npreload_share = 1\n"));
    EXPECT_NE(structure_refusal(loaded).find("there is none"), std::string::npos) << structure_refusal(loaded);
}

TEST(StructureSprings, AreForTheExactEngine) {
    const std::string text = case_with(spring_table("direction = \"x\"\ncubic = 3\n"));
    const std::string why = structure_refusal(text, {"run.engine=moreau"});
    EXPECT_NE(why.find("spring \"x\" is not"), std::string::npos) << why;
    EXPECT_NE(why.find("Set run.engine = \"exact\""), std::string::npos) << why;
    const Case c = read_structure_text(text, {"run.engine=auto"});
    EXPECT_EQ(parameters::methods_of(c), std::vector{parameters::Method::taylor});
    // a linear one asks for nothing: it joins the stiffness
    const Case linear = read_structure_text(case_with(spring_table("direction = \"x\"\nstiffness = 3\n")),
                                            {"run.engine=moreau", "run.step=1e-5"});
    EXPECT_EQ(model::structure_of(linear).stiffness(0, 0), 303.0);
    EXPECT_TRUE(model::structure_of(linear).springs.empty());
}

TEST(StructureSprings, BearTheirShareOfThePreload) {
    const std::string lip = spring_table("direction = \"y\"\nforce = 2\ndeflection = \"1 mm\"\npreload_share = 1\n");
    for (const double preload : {0.5, 2.0, 16.0}) {
        const Case c = read_structure_text(case_with(lip), {"preload=" + std::to_string(preload)});
        const model::Structure structure = model::structure_of(c);
        const double e = 1e-3 * std::pow(0.5 * preload, 1.0 / 1.5);
        EXPECT_NEAR(structure.springs[0].rest, e, 1e-12 * e);
        // it presses alone: no force is left, and its slope joins what vibrates
        EXPECT_NEAR(structure.load(1), 0.0, 1e-12 * preload);
        const double open = model::natural_frequencies(structure, model::ContactState::separation).back();
        model::Structure stiff = structure;
        stiff.springs.clear();
        stiff.stiffness(1, 1) += 1.5 * preload / e;
        EXPECT_NEAR(open, model::natural_frequencies(stiff, model::ContactState::separation).back(), 1e-9 * open);
    }
    const Case twice = read_structure_text(case_with(lip), {"structure.spring_scale=2"});
    const Case once = read_structure_text(case_with(lip), {"structure.spring.1.force=4"});
    EXPECT_EQ(model::structure_of(twice).springs[0].rest, model::structure_of(once).springs[0].rest);
    const std::string soft = spring_table("direction = \"y\"\ntable = \"0: 0, 1: 1, 2: 1\"\npreload_share = 1\n");
    EXPECT_THROW(model::structure_of(read_structure_text(case_with(soft), {"preload=2"})), Error);
}

// K and a spring under a load: e is that of the rest
TEST(StructureSprings, AreStretchedByALoad) {
    std::string text = whole_case(std::string(two_rows) + "load = [5, -30]\n" + heel +
                                  spring_table("direction = \"x\"\ncubic = 1e6\n"));
    const std::string preload = "preload = \"2 N\"\n";
    text.erase(text.find(preload), preload.size());
    const Case c = read_structure_text(text);
    const model::Structure structure = model::structure_of(c);
    const double e = structure.springs[0].rest;
    EXPECT_NEAR(300.0 * e + 1e6 * e * e * e, 5.0, 1e-12);
    const Eigen::VectorXd force = Eigen::Vector2d(1e6 * e * e * e, -structure.contacts[0].preload);
    EXPECT_NEAR((structure.load - force).norm(), 0.0, 1e-11);
    EXPECT_NEAR(structure.contacts[0].preload, 30.0 - 100.0 * e, 1e-11);
}

TEST(StructureSprings, StandInTheSchema) {
    const base::Json schema = base::Json::parse(json_schema());
    const base::Json& spring = schema["properties"]["structure"]["properties"]["spring"]["items"];
    for (const std::string_view key : spring_keys())
        EXPECT_TRUE(spring["properties"].contains(std::string(key))) << key;
    EXPECT_EQ(spring["required"], base::Json::array({"direction"}));
    EXPECT_TRUE(schema["properties"]["structure"]["properties"].contains("spring_scale"));
}

}  // namespace
}  // namespace stridor::io
