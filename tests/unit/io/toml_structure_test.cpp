#include "stridor/io/case/own_structure/toml_structure.hpp"

#include "stridor/io/case/own_structure/structure_contacts.hpp"
#include "stridor/io/case/ready_files.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/rules/check.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "stridor/sweep/study.hpp"
#include "structure_texts.hpp"
#include "support/canary.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace stridor::io {
namespace {

using parameters::Case;
using parameters::OwnStructure;

constexpr const char* matrices =
    "[structure]\nrows = [\"x\", \"y\"]\nmass = [[1, 0], [0, 2]]\nstiffness = [[3, -1], [-1, 4]]\n";

constexpr const char* tip_contact = "[[structure.contact]]\nname = \"tip\"\nnormal = \"y\"\ntangent = \"-x\"\n";

void expect_structure_refused(const std::string& text, const std::string& words) {
    EXPECT_NE(structure_refusal(text).find(words), std::string::npos) << words << "\n" << structure_refusal(text);
}

TEST(TomlStructure, HasItsMatricesInTheFile) {
    const Case c = read_structure_text(whole_case(std::string(matrices) + "damping_ratio = \"1 %\"\n" + tip_contact));
    ASSERT_NE(c.own_structure, nullptr);
    const OwnStructure& own = *c.own_structure;
    EXPECT_EQ(own.row, (std::vector<std::string>{"x", "y"}));
    EXPECT_EQ(own.stiffness, (std::vector<double>{3, -1, -1, 4}));
    EXPECT_EQ(own.following.ratio, 0.01);
    ASSERT_EQ(own.contacts.size(), 1U);
    EXPECT_EQ(own.contacts[0].name, "tip");
    EXPECT_EQ(own.contacts[0].normal, (std::vector<double>{0, 1}));
    EXPECT_EQ(own.contacts[0].tangent, (std::vector<double>{-1, 0}));
    EXPECT_EQ(parameters::contact_of(c, 0).preload, 2.0);
    EXPECT_EQ(parameters::contact_of(c, 0).kinetic_friction, 0.5);
}

TEST(TomlStructure, IsWrittenAndReadBack) {
    for (const std::string& text :
         {whole_case(
              std::string(matrices) + "loss_factor = 0.02\nrayleigh_stiffness = \"1 ms\"\n" + tip_contact +
              "initial_gap = \"1 mm\"\nstatic_friction = 1.25\nkinetic_friction = 0.1\npreload_share = 0\n" +
              "[[structure.contact]]\nname = \"foot\"\nnormal = [0.5, 1]\ntangent = [1, 0]\npreload_share = 2\n" +
              "position = [0.5, 0, -0.25]\n"),
          ready_file("chain"), ready_file("string")}) {
        const Case c = read_structure_text(text);
        const Case again = read_structure_text(case_toml(c));
        EXPECT_EQ(parameters::canonical_text(again), parameters::canonical_text(c));
        EXPECT_NE(parameters::canonical_text(c).find("structure.content = "), std::string::npos);
        EXPECT_EQ(again.own_structure->contacts.back().position, c.own_structure->contacts.back().position);
    }
}

constexpr const char* three_rows =
    "[structure]\nmass = [[1, 0, 0], [0, 2, 0], [0, 0, 3]]\nstiffness = [[3, 0, 0], [0, 4, 0], [0, 0, 5]]\n";
constexpr const char* plane_contact =
    "[[structure.contact]]\nname = \"pad\"\nnormal = \"u3\"\ntangent = \"u1\"\nsecond_tangent = \"-u2\"\n";

TEST(TomlStructure, HasContactsThatSlipInAPlane) {
    const std::string text = whole_case(std::string(three_rows) + plane_contact + "second_drive_share = 0.25\n");
    const Case c = read_structure_text(text, {"run.engine=moreau"});
    const parameters::OwnContact& contact = c.own_structure->contacts[0];
    EXPECT_EQ(contact.second_tangent, (std::vector<double>{0, -1, 0}));
    EXPECT_EQ(contact.second_drive_share, 0.25);
    EXPECT_TRUE(parameters::findings(c).empty());
    EXPECT_EQ(parameters::canonical_text(read_structure_text(case_toml(c))), parameters::canonical_text(c));
    expect_structure_refused(text,
                             "the exact engine knows one direction of slip: contact \"pad\" slips in two directions");
    expect_structure_refused(whole_case(std::string(three_rows) + replaced(plane_contact, "-u2", "u1")),
                             "the second tangent of contact \"pad\" is made of its normal and tangent");
    expect_structure_refused(whole_case(std::string(matrices) + tip_contact + "second_drive_share = 1\n"),
                             "second_drive_share stands without a second_tangent");
}

TEST(TomlStructure, IsShakenByAForce) {
    const std::string drive = "kind = \"force\"\nforce = \"3 N\"\nfrequency = \"7 Hz\"\nramp = \"20 ms\"";
    const std::string constant = "kind = \"constant\"\nvelocity = 0.1";
    const std::string shaken =
        replaced(whole_case(std::string(matrices) + "force = [0.5, -1]\n" + tip_contact), constant, drive);
    const Case c = read_structure_text(shaken, {"run.engine=moreau"});
    EXPECT_EQ(c.own_structure->force, (std::vector<double>{0.5, -1}));
    EXPECT_EQ(c.drive.force, 3.0);
    EXPECT_EQ(parameters::canonical_text(read_structure_text(case_toml(c))), parameters::canonical_text(c));
    expect_structure_refused(shaken, "the exact engine knows no drive by force");
    expect_structure_refused(replaced(whole_case(std::string(matrices) + tip_contact), constant, drive),
                             "a drive by force has nothing that it shakes");
    expect_structure_refused(whole_case(std::string(matrices) + "force = [1]\n" + tip_contact),
                             "structure.force has 1 numbers");
}

TEST(TomlStructure, HasItsMatricesInFilesBesideIt) {
    const ScratchFolder folder;
    const auto put = [&](const char* name, const std::string& text) {
        storage::write_file((folder / name).string(), text);
    };
    put("m.csv", "1,0\n0,2\n");
    put("k.csv", "3;-1\n-1;4\n");
    put("contacts.csv",
        "# where it rubs\nname,normal,tangent,initial_gap [mm],preload_share,position\ntip,u2,-u1,0,1,0 0 0.5\n"
        "toe,u1,u2,1,,\n");
    put("case.toml", whole_case("[structure]\nmass = \"m.csv\"\nstiffness = \"k.csv\"\ncontacts = \"contacts.csv\"\n"));
    const Case c = read_case((folder / "case.toml").string());
    EXPECT_EQ(c.own_structure->stiffness, (std::vector<double>{3, -1, -1, 4}));
    ASSERT_EQ(c.own_structure->contacts.size(), 2U);
    EXPECT_EQ(c.own_structure->contacts[1].initial_gap, 1e-3);
    EXPECT_EQ(c.own_structure->contacts[0].position, (std::array{0.0, 0.0, 0.5}));
    EXPECT_EQ(c.own_structure->contacts[1].position, std::nullopt);
    EXPECT_EQ(c.own_structure->contacts[1].preload_share, 0.0);
    put("contacts.csv", "name,normal,tangent,static_friction\ntip,u2,-u1,0,5\n");
    const auto shifted = support::error_of([&] { read_case((folder / "case.toml").string()); });
    ASSERT_TRUE(shifted) << "0,5 between commas is two fields";
    EXPECT_NE(std::string(shifted->what()).find("the row has 5 fields"), std::string::npos) << shifted->what();
    put("m.mtx", "%%MatrixMarket matrix coordinate real symmetric\n2 2 2\n1 1 1\n2 2 2\n");
    put("k.mtx", "%%MatrixMarket matrix coordinate real symmetric\n2 2 3\n1 1 3\n2 1 -1\n2 2 4\n");
    put("rows.csv", "node,component,x,y,z,set\n7,x,0,0,0,TIP\n7,z,0,0,0,TIP\n");
    put("case.toml", whole_case("[structure]\nmass = \"m.mtx\"\nstiffness = \"k.mtx\"\nlabels = \"rows.csv\"\n"
                                "[[structure.contact]]\nset = \"TIP\"\nnormal = \"z\"\ntangent = \"-x\"\n"));
    const Case labelled = read_case((folder / "case.toml").string());
    EXPECT_EQ(labelled.own_structure->row, (std::vector<std::string>{"7.1", "7.3"}));
    EXPECT_EQ(labelled.own_structure->contacts[0].name, "7");
    // the same structure but for its second contact
    EXPECT_EQ(labelled.own_structure->contacts[0].normal, c.own_structure->contacts[0].normal);
}

TEST(TomlStructure, PairsNodesOfTwoSetsThatAreNearest) {
    const ScratchFolder folder;
    const auto put = [&](const char* name, const std::string& text) {
        storage::write_file((folder / name).string(), text);
    };
    std::string unit = "%%MatrixMarket matrix coordinate real symmetric\n8 8 8\n";
    for (int k = 1; k <= 8; ++k)
        unit += std::to_string(k) + " " + std::to_string(k) + " 1\n";
    put("unit.mtx", unit);
    put("rows.csv",
        "node,component,x,y,z,set\n1,x,0,0,0,LIP\n1,z,0,0,0,LIP\n2,x,1,0,0,LIP\n2,z,1,0,0,LIP\n"
        "3,x,1.1,0,0,PANE\n3,z,1.1,0,0,PANE\n4,x,0.2,0,0,PANE\n4,z,0.2,0,0,PANE\n");
    put("case.toml",
        whole_case("[structure]\nmass = \"unit.mtx\"\nstiffness = \"unit.mtx\"\nlabels = \"rows.csv\"\n"
                   "[[structure.contact]]\nname = \"seal\"\nset = \"LIP\"\nagainst = \"PANE\"\nnormal = \"z\"\n"
                   "tangent = [2, 0, 0]\npreload_share = 1\n"));
    const Case c = read_case((folder / "case.toml").string());
    ASSERT_EQ(c.own_structure->contacts.size(), 2U);
    EXPECT_EQ(c.own_structure->contacts[0].name, "seal 1");
    EXPECT_EQ(c.own_structure->contacts[0].normal, (std::vector<double>{0, 1, 0, 0, 0, 0, 0, -1}));
    EXPECT_EQ(c.own_structure->contacts[1].tangent, (std::vector<double>{0, 0, 1, 0, -1, 0, 0, 0}));
    EXPECT_EQ(parameters::contact_of(c, 1).preload, 1.0);
    // its own node's, not that of the other part
    EXPECT_EQ(c.own_structure->contacts[1].position, (std::array{1.0, 0.0, 0.0}));
    EXPECT_EQ(parameters::places_along_line(*c.own_structure), (std::vector<double>{0.0, 1.0}));
}

TEST(TomlStructure, HasPlacesAlongItsLineWhereAllAreKnown) {
    OwnStructure own;
    EXPECT_TRUE(parameters::places_along_line(own).empty());
    own.contacts = {{.position = {{0.0, 3.0, 1.0}}}, {.position = {{0.5, 1.0, 1.0}}}, {.position = {{1.0, 2.0, 1.0}}}};
    EXPECT_EQ(parameters::places_along_line(own), (std::vector<double>{2.0, 0.0, 1.0}));
    own.contacts[2].position = own.contacts[1].position = own.contacts[0].position;
    EXPECT_TRUE(parameters::places_along_line(own).empty()) << "all at one place";
    own.contacts[1].position.reset();
    EXPECT_TRUE(parameters::places_along_line(own).empty());
    expect_structure_refused(whole_case(std::string(matrices) + tip_contact + "position = [1, 2]\n"), "position");
}

TEST(TomlStructure, IsPressedByALoadOrByGaps) {
    const std::string without = replaced(shared_sections, "preload = \"2 N\"\n", "");
    const Case loaded = read_structure_text(std::string(matrices) + "load = [0, -3]\n" + tip_contact + without);
    EXPECT_FALSE(parameters::is_preloaded(loaded));
    const Case pressed =
        read_structure_text(std::string(matrices) + tip_contact + "initial_gap = \"-0.1 mm\"\n" + without);
    EXPECT_EQ(pressed.own_structure->contacts[0].initial_gap, -1e-4);
    expect_structure_refused(whole_case(std::string(matrices) + "load = [0, -3]\n" + tip_contact),
                             "contact.preload means nothing for this structure");
}

// springs may hold nothing, or all but a motion: that is no negative stiffness
TEST(TomlStructure, MayMoveFreely) {
    for (const char* stiffness : {"[[0, 0], [0, 0]]", "[[0, 0], [0, 4]]", "[[1, -1], [-1, 1]]"})
        EXPECT_NO_THROW(read_structure_text(
            whole_case(replaced(matrices, "[[3, -1], [-1, 4]]", stiffness) + std::string(tip_contact))))
            << stiffness;
}

// nothing presses it: what it has is a velocity
TEST(TomlStructure, MayFlyTowardsTheSurface) {
    const std::string without = replaced(shared_sections, "preload = \"2 N\"\n", "");
    const Case c = read_structure_text(std::string(matrices) + "initial_velocity = [0, -1]\n" + tip_contact +
                                       "initial_gap = \"1 mm\"\n" + without);
    EXPECT_FALSE(parameters::is_preloaded(c));
    EXPECT_EQ(c.own_structure->contacts[0].initial_gap, 1e-3);
    expect_structure_refused(
        std::string(matrices) + "initial_velocity = [0, 0]\n" + tip_contact + "initial_gap = \"1 mm\"\n" + without,
        "nothing presses the structure");
}

TEST(TomlStructure, ThatIsWrongIsRefusedWithOneSentence) {
    const std::string m = matrices;
    const std::string c = tip_contact;
    const auto with = [&](const std::string& what, const std::string& by) {
        return whole_case(replaced(m, what, by) + c);
    };
    const auto touching = [&](const std::string& what, const std::string& by) {
        return whole_case(m + replaced(c, what, by));
    };
    expect_structure_refused(whole_case("[structure]\n" + c), "nothing says what the structure is");
    expect_structure_refused(whole_case(m), "the structure has no contact");
    expect_structure_refused(whole_case("[structure]\nmass = \"m.csv\"\nstiffness = \"k.mtx\"\n" + c),
                             "structure.mass is CSV, and another matrix is not");
    expect_structure_refused(with("[0, 2]]", "[0]]"), "structure.mass has 2 rows, and 1 numbers in row 2");
    expect_structure_refused(with("[[1, 0], [0, 2]]", "[[1]]"), "the stiffness has 2 rows, the mass 1");
    expect_structure_refused(with("[-1, 4]", "[-2, 4]"), "not symmetric");
    expect_structure_refused(with("[0, 2]]", "[0, -2]]"), "the mass is negative for some motion");
    expect_structure_refused(with("[-1, 4]", "[-1, 0.3]"), "the stiffness is negative for some motion");
    expect_structure_refused(with("[[3, -1]", "[[-3, -1]"), "the stiffness is negative for some motion");
    expect_structure_refused(with("[-1, 4]", "[-1, 0.33333]"), "the stiffness is negative for some motion");
    expect_structure_refused(with("[0, 2]]", "[0, 0]]"), "row y has no mass");
    expect_structure_refused(with("[[1, 0], [0, 2]]", "[[0, 1], [1, 0]]"), "mass");
    expect_structure_refused(with("[0, 2]]", "[0, nan]]"), "the mass holds nan");
    expect_structure_refused(with("\"x\", \"y\"", "\"x\", \"x\""), "x");
    expect_structure_refused(with("\"x\", \"y\"", "\"x\""), "structure.rows has 1 names");
    expect_structure_refused(with("mass", "masss"), "unknown key structure.masss");
    expect_structure_refused(touching("\"y\"", "\"z\""), "\"z\" is no set, node or row");
    expect_structure_refused(touching("\"y\"", "[0, 0]"), "the normal is zero");
    expect_structure_refused(touching("\"y\"", "\"x\""), "the tangent of contact \"tip\" is along its normal");
    expect_structure_refused(touching("\"y\"", "[2, 1e-7]"), "the tangent of contact \"tip\" is along its normal");
    expect_structure_refused(touching("\"y\"", "[0, 1, 0]"), "the normal has 3 components");
    expect_structure_refused(touching("\"y\"", "\"y -y\""), "the normal is zero");
    expect_structure_refused(touching("name = \"tip\"\n", ""), "this contact has no name");
    expect_structure_refused(touching("name = \"tip\"", "node = 12"), "\"12\" is no set, node or row");
    expect_structure_refused(touching("tangent", "tangents"), "unknown key structure.contact.1.tangents");
    expect_structure_refused(touching("name", "set = \"LIP\"\nname"), "there is no node set \"LIP\"");
    expect_structure_refused(whole_case(m + c + "initial_gap = 1\n"), "nothing presses the structure");
    expect_structure_refused(whole_case(m + c + "preload_share = 0\n"), "touches without load");
    expect_structure_refused(whole_case(m + "load = [0, 1]\n" + c + "preload_share = 1\n"),
                             "a load stands beside shares");
    expect_structure_refused(whole_case(m + "load = [0]\n" + c), "structure.load has 1 numbers");
    expect_structure_refused(whole_case(m + c + c), "two contacts are called \"tip\"");
    expect_structure_refused(whole_case(m + c + replaced(c, "tip", "toe")), "\"tip\" and \"toe\" are one");
    expect_structure_refused(whole_case(m + c + "kinetic_friction = 1.5\n[[structure.contact]]\nname = \"toe\"\n" +
                                        "normal = \"x\"\ntangent = \"y\"\n"),
                             "has mu_d = 1.5 above mu_s = 1");
    expect_structure_refused(whole_case(m + c + "kinetic_friction = 0.5\n"),
                             "contact.kinetic_friction means nothing for this structure");
    expect_structure_refused(whole_case(m + "initial_displacement = [0, 1]\n" + c), "along its normal");
    expect_structure_refused(whole_case("[structure]\nbuilder = \"chains\"\n"), "\"chains\" builds no structure");
    expect_structure_refused(whole_case("[structure]\nbuilder = \"chain\"\nblocks = 1.5\nmass = 1\nstiffness = 1\n"),
                             "it must be a whole number");
    expect_structure_refused(whole_case("[structure]\nbuilder = \"chain\"\nblocks = 2\nmass = 1\n"),
                             "missing key structure.stiffness");
    expect_structure_refused(
        whole_case("[structure]\nbuilder = \"chain\"\nblocks = 2\nmass = \"1 N\"\nstiffness = 1\n"), "kg");
    const auto missing =
        error_of([&] { read_structure_text(whole_case("[structure]\nfile = \"nowhere.sti\"\n" + c)); });
    ASSERT_TRUE(missing.has_value());
    EXPECT_EQ(missing->kind(), ErrorKind::io);
    expect_structure_refused(whole_case(m + c + "[plate]\nmass = 1\n"), "plate stands beside [structure]");
    expect_structure_refused(replaced(whole_case(m + c), "duration = 3", "duration = 3\nengine = \"beta_2\""),
                             "the beta_2 engine knows the paper's joint");
    expect_structure_refused(replaced(whole_case(m + c), "duration = 3", "duration = 3\ninitial = \"sliding\""),
                             "does not start sliding");
}

TEST(TomlStructure, NamesOutputs) {
    const std::string mc = std::string(matrices) + tip_contact;
    const Case c =
        read_structure_text(whole_case(mc + "[[structure.output]]\nname = \"far end\"\ndirection = \"y -x\"\n"
                                            "[[structure.output]]\ndirection = [0.5, 2]\n"));
    const std::vector<parameters::OwnOutput>& outputs = c.own_structure->outputs;
    ASSERT_EQ(outputs.size(), 2U);
    EXPECT_EQ(outputs[0].name, "far end");
    EXPECT_EQ(outputs[0].weights, (std::vector<double>{-1, 1}));
    EXPECT_EQ(outputs[1].name, "output2");
    EXPECT_EQ(outputs[1].weights, (std::vector<double>{0.5, 2}));
    const Case back = read_structure_text(case_toml(c, {Comments::none, ""}));
    ASSERT_EQ(back.own_structure->outputs.size(), 2U);
    EXPECT_EQ(back.own_structure->outputs[1].weights, outputs[1].weights);
    EXPECT_EQ(content_hash(*c.own_structure), content_hash(*read_structure_text(whole_case(mc)).own_structure))
        << "an output changes no result";
    const auto refused = [&](const std::string& output, const std::string& words) {
        expect_structure_refused(whole_case(mc + "[[structure.output]]\n" + output), words);
    };
    refused("direction = \"z\"\n", "is no set, node or row");
    refused("direction = \"x -x\"\n", "the direction is zero");
    refused("direction = [1, 2, 3]\n", "3 components");
    refused("name = \"tip\"\ndirection = \"x\"\n", "a contact has it");
    refused("direction = \"x\"\n", "a row has it");
    refused("name = \"a\"\n", "direction");
    refused("nam = \"a\"\ndirection = \"x\"\n", "unknown key");
}

TEST(Outputs, StandAtRowsThatAReducedPartRecovers) {
    reduction::Reduction reduced;
    reduced.part.labels = {{"5", 1}, {"5", 3}, {"mode 1", 0}};
    reduced.recovered = {{"9", 1}, {"9", 3}};
    reduced.recovery = Eigen::MatrixXd(2, 3);
    reduced.recovery << 0.5, 0.0, 2.0, 0.0, 0.25, -1.0;
    const auto weights = [&](const NamedOutput& named) { return outputs_at(reduced, {named}, {}).front().weights; };
    EXPECT_EQ(weights({"", "9", "-x", {}}), (std::vector<double>{-0.5, 0.0, -2.0}));
    EXPECT_EQ(weights({"", "5", "z", {}}), (std::vector<double>{0.0, 1.0, 0.0}));
    EXPECT_EQ(weights({"a", "", "9.3 5.1", {}}), (std::vector<double>{1.0, 0.25, -1.0}));
    EXPECT_EQ(weights({"a", "", std::vector<double>{1, 2, 3}, {}}), (std::vector<double>{1.0, 2.0, 3.0}));
    EXPECT_EQ(outputs_at(reduced, {{"", "9", "-x", {}}}, {}).front().name, "9.-x");
    EXPECT_TRUE(error_of([&] { weights({"", "9", "y", {}}); })) << "that row is not recovered";
}

TEST(TomlStructure, OpensNoFileForSomebodyElse) {
    support::Canary canary;
    const std::string rows = "[structure]\nmass = [[1]]\nstiffness = [[1]]\n";
    for (const std::string& path : {canary.file(), canary.pipe()})
        for (const char* key : {"file", "labels", "contacts", "mass", "stiffness", "damping"}) {
            const std::string name = std::string(key) + " = \"" + path + "\"\n";
            const std::string text = std::string_view(key) == "mass" || std::string_view(key) == "stiffness"
                                         ? "[structure]\n" + name
                                         : rows + name;
            const auto error = error_of([&] { read_case(parse_toml({text, "c.toml", {}}), readers_without_files()); });
            ASSERT_TRUE(error.has_value()) << text;
            EXPECT_NE(std::string(error->what()).find("names a file"), std::string::npos) << error->what();
            EXPECT_FALSE(canary.was_opened()) << text;
        }
    EXPECT_NO_THROW(read_case(parse_toml({ready_file("chain"), "chain.toml", {}}), readers_without_files()));
}

TEST(TomlStructure, LeavesPlatesToJoints) {
    EXPECT_NE(structure_refusal(squeal_toml(), {"structure.stiffness_scale=2"}).find("its joints stand on a plate"),
              std::string::npos);
}

}  // namespace
}  // namespace stridor::io
