// A joint that stiffens, from the text of a case to what engines see.

#include "stridor/io/case/packed_case.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/model/built/case_structure.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/parameters/rules/engines.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "support/error_text.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace stridor::io {
namespace {

using parameters::Case;
using support::thrown_by;

std::string stiffening(const std::string& lines) {
    std::string text = case_toml(parameters::paper_case(parameters::PaperCase::squeal), {});
    const std::string usual = "stiffening = \"none\"";
    return text.replace(text.find(usual), usual.size(), lines);
}

Case read_stiffening(const std::string& lines, const std::string& name = "case.toml") {
    return read_case(TomlSource{stiffening(lines), name, {}});
}

TEST(StiffeningCase, KeepsItsNumbersWhereverItGoes) {
    for (const char* lines : {"stiffening = \"cubic\"\naxial_cubic = \"1e17 N/m^3\"\nflexural_cubic = -2e14",
                              "stiffening = \"table\"\naxial_force = \"-1: -2, 0: 0, 1 mm: 20 N\""}) {
        const Case c = read_stiffening(lines);
        const std::string text = parameters::canonical_text(c);
        EXPECT_NE(text.find("joint.stiffening"), std::string::npos) << text;
        EXPECT_EQ(parameters::canonical_text(read_case(TomlSource{case_toml(c, {}), "again.toml", {}})), text);
        EXPECT_EQ(parameters::canonical_text(unpacked_case(packed_case(c))), text);
        EXPECT_EQ(parameters::engine_of(c), parameters::Engine::exact);
        EXPECT_FALSE(model::structure_of(c).springs.empty());
    }
}

TEST(StiffeningCase, IsNotToldOfALinearJoint) {
    const Case c = parameters::paper_case(parameters::PaperCase::squeal);
    EXPECT_EQ(parameters::canonical_text(c).find("stiffening"), std::string::npos);
    EXPECT_TRUE(parameters::names_of_springs(c).empty());
    EXPECT_TRUE(model::structure_of(c).springs.empty());
}

TEST(StiffeningCase, ReadsItsForceFromAFile) {
    const support::ScratchFolder folder;
    storage::write_file(folder / "lip.csv", "force [N];deflection [mm]\n0;0\n0,5;1\n2;2\n");
    const std::string path = (folder / "case.toml").string();
    const Case c = read_stiffening("stiffening = \"table\"\naxial_force = \"lip.csv\"", path);
    EXPECT_EQ(c.joint().axial_force.deflections, (std::vector<double>{0.0, 1e-3, 2e-3}));
    EXPECT_EQ(c.joint().axial_force.forces, (std::vector<double>{0.0, 0.5, 2.0}));
    const std::string text = stiffening("stiffening = \"table\"\naxial_force = \"lip.csv\"");
    EXPECT_TRUE(thrown_by([&] {
                    read_case(parse_toml({text, "case.toml", {}}), readers_without_files());
                }).says("joint.axial_force is no file here"));
}

TEST(StiffeningCase, IsRefusedWhereItMeansNothing) {
    const auto refused = [](const std::string& lines, const std::string& says) {
        EXPECT_TRUE(thrown_by([&] { model::structure_of(read_stiffening(lines)); }).says(says)) << says;
    };
    refused("stiffening = \"cubic\"", "joint.axial_cubic");
    refused("stiffening = \"table\"", "joint.axial_force");
    refused("stiffening = \"table\"\naxial_force = \"0: 0, 1: 2, 2: 1\"", "row 3 of the table of force");
    refused("axial_cubic = 4", "joint.axial_cubic means nothing");
    refused("stiffening = \"cubic\"\naxial_cubic = -1e19", "the joint gives way");
    const std::string beta = stiffening("stiffening = \"cubic\"\naxial_cubic = 1e17");
    EXPECT_TRUE(thrown_by([&] {
                    read_case(TomlSource{beta, "case.toml", {"run.engine=beta_2"}});
                }).says("knows linear springs only"));
}

TEST(StiffeningCase, NamesTheSpringsOfSeveralJoints) {
    Case c = read_stiffening("stiffening = \"cubic\"\naxial_cubic = 1e17\nflexural_cubic = 1e15");
    EXPECT_EQ(parameters::names_of_springs(c), (std::vector<std::string>{"axial", "flexural"}));
    c.joints.push_back(c.joints.front());
    c.joints[0].name = "lip", c.joints[1].name = "foot";
    c.joints[1].joint.flexural_cubic = 0.0;
    EXPECT_EQ(parameters::names_of_springs(c), (std::vector<std::string>{"lip.axial", "lip.flexural", "foot.axial"}));
    EXPECT_EQ(model::structure_of(c).springs.size(), 3U);
}

}  // namespace
}  // namespace stridor::io
