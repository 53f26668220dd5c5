#include "stridor/io/case/case_changes.hpp"

#include "io_support.hpp"
#include "stridor/io/case/ready_files.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "structure_texts.hpp"

#include <gtest/gtest.h>

#include <initializer_list>
#include <vector>

namespace stridor::io {
namespace {

using parameters::Case;

Case squeal_case() {
    return parameters::paper_case(parameters::PaperCase::squeal);
}

Case with(const Case& c, const std::vector<CaseChange>& changes) {
    return changed(c, changes);
}

// a structure of matrices, not of a builder
Case given_structure() {
    return read_structure_text(
        whole_case("[structure]\nrows = [\"x\", \"y\"]\nmass = [[1, 0], [0, 2]]\nstiffness = [[3, -1], [-1, 4]]\n"
                   "[[structure.contact]]\nname = \"tip\"\nnormal = \"y\"\ntangent = \"-x\"\n"));
}

TEST(CaseChanges, AreWhatOverridesOfTheFileAre) {
    const std::vector<std::vector<std::string>> all{{"contact.preload=0.2 kN"},
                                                    {"mu_s=0.5", "mu_d=0.4"},
                                                    {"drive.kind=constant", "drive.velocity=-50 mm/s"},
                                                    {"joint.axial_damping=damping ratio 0.1", "joint.mass=0.3"},
                                                    {"run.engine=beta_2"}};
    for (const std::vector<std::string>& overrides : all) {
        std::vector<CaseChange> changes;
        for (const std::string& text : overrides)
            changes.push_back({text.substr(0, text.find('=')), text.substr(text.find('=') + 1)});
        EXPECT_EQ(parameters::canonical_text(with(squeal_case(), changes)),
                  parameters::canonical_text(read_case({squeal_toml(), "squeal.toml", overrides})));
    }
}

TEST(CaseChanges, AreRefusedAsOverridesAreButWithoutPlace) {
    const std::vector<std::pair<CaseChange, std::string>> wrong{
        {{"contact.preloda", "20"}, "contact.preload"}, {{"contact.preload=1", 20.0}, "no key"},
        {{"contact.preload", -1.0}, "out of range"},    {{"contact.preload", "20 kg"}, "a mass"},
        {{"contact.kinetic_friction", 0.9}, "exceeds"}, {{"drive.velocity", 0.1}, "means nothing for this case"},
        {{"drive.kind", "constant"}, "drive.velocity"}, {{"mass", 1.0}, "joint.mass"},
        {{"title", "two\nlines"}, "control character"}};
    for (const auto& [change, words] : wrong) {
        expect_error(error_of([&] { with(squeal_case(), {change}); }), words, "");
    }
}

TEST(CaseChanges, KeepBitsOfNumbersAndLettersOfTexts) {
    const double preload = 0.1 + 0.2;
    EXPECT_EQ(with(squeal_case(), {{"F", preload}}).contact().preload, preload);
    EXPECT_EQ(with(squeal_case(), {{"title", "\"quoted\" = so"}}).title, "\"quoted\" = so");
}

TEST(CaseChanges, ReachOneOfSeveralJoints) {
    const Case lips = parameters::two_lips();
    const std::string key = "joint." + lips.joints[1].name + ".contact.preload";
    const Case after = with(lips, {{key, "7 N"}});
    EXPECT_EQ(after.contact().preload, lips.contact().preload);
    EXPECT_EQ(after.joints[1].contact.preload, 7.0);
}

TEST(CaseChanges, LeaveMatricesWhereTheyAre) {
    const Case before = given_structure();
    const Case after = with(before, {{"structure.stiffness_scale", 2.0}, {"contact.preload", 3.0}});
    EXPECT_EQ(after.own_structure, before.own_structure);
    EXPECT_EQ(after.structure_scales.stiffness, 2.0);
    EXPECT_EQ(after.contact().preload, 3.0);
    expect_error(error_of([&] { with(before, {{"structure.rows", "z"}}); }), "cannot be set", "");
}

TEST(CaseChanges, MakeABuildersStructureAnew) {
    const Case chain = read_structure_text(ready_file("chain"));
    const double* mass = parameters::recipe_number(chain, "mass");
    ASSERT_NE(mass, nullptr);
    const Case heavier = with(chain, {{"structure.mass", 2.0 * *mass}});
    EXPECT_EQ(heavier.own_structure->mass[0], 2.0 * chain.own_structure->mass[0]);
}

TEST(CaseChanges, KeepSamplesWhoseFileIsGone) {
    Case c = squeal_case();
    c.drive.kind = parameters::DriveKind::sampled;
    c.drive.file = "gone.csv";
    c.drive.times = {0.0, 1.0, 2.0};
    c.drive.velocities = {0.1, 0.2, -0.1};
    const Case after = with(c, {{"contact.preload", 30.0}});
    EXPECT_EQ(after.drive.velocities, c.drive.velocities);
    EXPECT_EQ(error_of([&] { with(c, {{"drive.file", "other.csv"}}); })->kind(), ErrorKind::io);
}

}  // namespace
}  // namespace stridor::io
