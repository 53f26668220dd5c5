#include "stridor/io/case/own_structure/built_structure.hpp"
#include "stridor/io/case/ready_files.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/sweep/study.hpp"
#include "structure_texts.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace stridor::io {
namespace {

using parameters::Case;

TEST(BuiltStructure, IsBuiltAndVaried) {
    const Case c =
        read_structure_text(ready_file("chain"), {"structure.blocks=3", "structure.stiffness_scale=2", "preload=3"});
    EXPECT_EQ(c.own_structure->contacts.size(), 3U);
    EXPECT_EQ(c.structure_scales.stiffness, 2.0);
    EXPECT_EQ(parameters::contact_of(c, 1).preload, 1.0);
    EXPECT_EQ(read_structure_text(ready_file("string")).own_structure->row.size(), 41U);
    const Case beam = read_structure_text(whole_case(
        "[structure]\nbuilder = \"beam\"\nlength = \"100 mm\"\nmass_per_length = 0.024\n"
        "bending_stiffness = 0.014\naxial_stiffness = 4.2e4\ndamping_ratio = 0.01\nincidence_angle = 60\nmodes = 4\n"));
    EXPECT_EQ(beam.own_structure->row.size(), 5U);
}

// what an axis of a chart sets is what the file would say
TEST(BuiltStructure, IsBuiltAnewWithAnotherNumber) {
    Case c = read_structure_text(ready_file("string"));
    EXPECT_EQ(parameters::get_quantity(c, *parameters::find_field("structure.position")), 0.13);
    for (const auto& [key, value] : {std::pair("structure.position", "0.25"), {"structure.frequency", "440"}})
        parameters::set_from_text(c, *parameters::find_field(key), value);
    const Case read = read_structure_text(ready_file("string"), {"position=0.25", "structure.frequency=440"});
    EXPECT_EQ(case_toml(c), case_toml(read));
    EXPECT_EQ(parameters::canonical_text(c), parameters::canonical_text(read));
    EXPECT_NE(parameters::canonical_text(c), parameters::canonical_text(read_structure_text(ready_file("string"))));

    std::string text = ready_file("chain");
    text.insert(text.find("\n[contact]"), "initial_displacement = [0.3, 0, 0, 0]\n");
    Case chain = read_structure_text(text);
    parameters::set_from_text(chain, *parameters::find_field("structure.coupling"), "2");
    EXPECT_EQ(chain.own_structure->initial_displacement, (std::vector<double>{0.3, 0, 0, 0}));
    EXPECT_EQ(chain.own_structure->stiffness[2], -2.0);
    Case heard =
        read_structure_text(ready_file("chain") + "[[structure.output]]\nname = \"apart\"\ndirection = \"x2 -x1\"\n");
    parameters::set_from_text(heard, *parameters::find_field("structure.coupling"), "2");
    ASSERT_EQ(heard.own_structure->outputs.size(), 1U) << "what is heard is not built anew";
    EXPECT_FALSE(parameters::find_field("structure.position")->belongs(chain));
}

TEST(BuiltStructure, IsBuiltAnewInEachColumnOfAChart) {
    sweep::Study study{.base = read_structure_text(ready_file("string")),
                       .x = {"structure.position", 0.05, 0.2, 4},
                       .y = {"contact.preload", 0.5, 2.0, 3},
                       .starts = {}};
    EXPECT_EQ(parameters::get_quantity(sweep::case_at(study, {0, 1, 2}), "structure.position"),
              sweep::value_at(study.x, 2));
    const std::string text = sweep::canonical_text(study);
    study.base = read_structure_text(ready_file("string"), {"position=0.31"});
    EXPECT_EQ(sweep::canonical_text(study), text) << "the axis replaces the case's own";
    study.base = read_structure_text(ready_file("string"), {"structure.frequency=100"});
    EXPECT_NE(sweep::canonical_text(study), text);
    study.x.parameter = "structure.coupling";
    EXPECT_THROW(sweep::check(study), Error);
}

TEST(BuiltStructure, HasItsNumbersInTheirRange) {
    const std::string text = replaced(ready_file("string"), "damping_ratio", "bridge_resistance = 10\ndamping_ratio");
    EXPECT_EQ(parameters::get_quantity(read_structure_text(text), "structure.bridge_resistance"), 10.0);
    for (const char* wrong : {"structure.position=0", "structure.position=1", "structure.bridge_resistance=0"})
        EXPECT_NE(structure_refusal(text, {wrong}).find("is out of range"), std::string::npos) << wrong;
    EXPECT_NE(structure_refusal(text, {"structure.start=sleep"}).find("\"rest\" or \"helmholtz\""), std::string::npos);
    // of a builder, and there is none
    const auto error = error_of([] {
        read_case(TomlSource{ready_file("squeal"), "a.toml", {"structure.position=0.2"}});
    });
    ASSERT_TRUE(error.has_value());
    EXPECT_NE(std::string(error->what()).find("structure.position means nothing for this case"), std::string::npos);
}

TEST(BuiltStructure, HasOutputsBesideIt) {
    const Case c =
        read_structure_text(ready_file("chain") + "\n[[structure.output]]\nname = \"apart\"\ndirection = \"x2 -x1\"\n");
    ASSERT_EQ(c.own_structure->outputs.size(), 1U);
    const Case back = read_structure_text(case_toml(c, {Comments::none, ""}));
    EXPECT_EQ(back.own_structure->outputs[0].weights, c.own_structure->outputs[0].weights);
}

}  // namespace
}  // namespace stridor::io
