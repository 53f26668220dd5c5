// A start of the user's own, as case files have it.

#include "io_support.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/io/case/packed_case.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/record/schedule.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace stridor::io {
namespace {

using parameters::Case;
using parameters::ContactStart;

const std::vector<std::string> constant{"drive.kind=constant", "drive.velocity=0.1", "run.initial=given"};

Case begun(std::vector<std::string> overrides) {
    overrides.insert(overrides.begin(), constant.begin(), constant.end());
    return read_case(TomlSource{squeal_toml(), "case.toml", std::move(overrides)});
}

std::optional<Error> refused(std::vector<std::string> overrides) {
    return error_of([&] { begun(std::move(overrides)); });
}

TEST(GivenStart, IsReadByNameAndBySymbol) {
    const Case c = begun({"x1_0=1 um", "joint.initial_normal=2 um", "vx1_0=40 mm/s", "vy1_0=0.1", "y2_0=-1 um",
                          "plate.initial_normal_velocity=0.2", "contact.initial_state=separation"});
    EXPECT_EQ(c.run.initial, parameters::Initial::given);
    EXPECT_EQ(c.joints[0].start.tangential, 1e-6);
    EXPECT_EQ(c.joints[0].start.normal, 2e-6);
    EXPECT_EQ(c.joints[0].start.tangential_velocity, 0.04);
    EXPECT_EQ(c.joints[0].start.normal_velocity, 0.1);
    EXPECT_EQ(c.joints[0].start.contact, ContactStart::separation);
    EXPECT_EQ(c.plate.initial_normal, -1e-6);
    EXPECT_EQ(c.plate.initial_normal_velocity, 0.2);
}

TEST(GivenStart, SurvivesItsFileAndItsBytes) {
    const Case c = begun({"x1_0=1 um", "y1_0=2 um", "contact.initial_state=separation"});
    const std::string text = case_toml(c, {.comments = Comments::none, .heading = ""});
    EXPECT_EQ(parameters::canonical_text(read_case(TomlSource{text, "again.toml", {}})), parameters::canonical_text(c));
    EXPECT_EQ(parameters::canonical_text(unpacked_case(packed_case(c))), parameters::canonical_text(c));
}

// cases from before there was one keep their hash
TEST(GivenStart, StandsInNoOtherCase) {
    const std::string text = parameters::canonical_text(read_case(TomlSource{squeal_toml(), "case.toml", {}}));
    EXPECT_EQ(text.find("initial_"), std::string::npos);
    EXPECT_EQ(text.find("drive.phase"), std::string::npos);
}

TEST(GivenStart, IsRefusedInsideThePlate) {
    const std::optional<Error> error = refused({"y1_0=-1 um"});
    ASSERT_TRUE(error);
    const std::string what = error->what();
    EXPECT_NE(what.find("begins with a gap of -1e-06 m"), std::string::npos) << what;
    EXPECT_NE(what.find("Let them touch, or begin with an open gap."), std::string::npos) << what;
    const std::string text = replaced(squeal_toml(), "initial = \"rest\"", "initial = \"given\"");
    const std::string inside = replaced(text, "[plate]", "initial_normal = -1e-6\n[plate]");
    const auto in_file = error_of([&] { read_case(TomlSource{inside, "case.toml", {}}); });
    ASSERT_TRUE(in_file);
    EXPECT_NE(std::string(in_file->what()).find("[case.toml:"), std::string::npos) << in_file->what();
}

TEST(GivenStart, IsRefusedWhereNoContactStateHasItsVelocity) {
    const std::optional<Error> error = refused({"vy1_0=-0.1"});
    ASSERT_TRUE(error);
    EXPECT_NE(std::string(error->what()).find("begins to close at 0.1 m/s"), std::string::npos) << error->what();
    // with an open gap it falls, as fast as one likes; a plate that gives way opens it
    EXPECT_NO_THROW(begun({"vy1_0=-0.1", "y1_0=1 um"}));
    EXPECT_NO_THROW(begun({"vy2_0=-0.1"}));
    EXPECT_NO_THROW(begun({"vy1_0=-0.1", "vy2_0=-0.1"}));
}

TEST(GivenStart, IsRefusedWithAStateThatItsMotionDoesNotHave) {
    const auto says = [](const std::vector<std::string>& overrides, const std::string& words) {
        const std::optional<Error> error = refused(overrides);
        return error && std::string(error->what()).find(words) != std::string::npos;
    };
    EXPECT_TRUE(says({"contact.initial_state=separation"}, "is said to begin separated, and is closed"));
    EXPECT_TRUE(says({"contact.initial_state=slip", "y1_0=1 um"}, "is said to begin in contact, and is separated"));
    EXPECT_TRUE(says({"contact.initial_state=stick", "y1_0=1 um"}, "is said to begin in contact, and is separated"));
    EXPECT_TRUE(says({"contact.initial_state=slip", "vx1_0=0.1"}, "is said to slip, and moves with its surface"));
    EXPECT_NO_THROW(begun({"contact.initial_state=slip"}));
    EXPECT_NO_THROW(begun({"contact.initial_state=stick"}));
}

TEST(GivenStart, OfOneOfSeveralJointsIsItsOwn) {
    const std::string text = case_toml(parameters::two_lips(), {.comments = Comments::none, .heading = ""});
    const Case c = read_case(TomlSource{text, "lips.toml", {"run.initial=given", "joint.lower.x1_0=1 um"}});
    EXPECT_EQ(c.joints[0].start.tangential, 0.0);
    EXPECT_EQ(c.joints[1].start.tangential, 1e-6);
    const auto error = error_of([&] {
        read_case(TomlSource{text, "lips.toml", {"run.initial=given", "joint.lower.initial_normal=-1 um"}});
    });
    ASSERT_TRUE(error);
    EXPECT_NE(std::string(error->what()).find("contact \"lower\""), std::string::npos) << error->what();
}

// so long that a string keeps it elsewhere
TEST(GivenStart, IsRefusedByTheNameOfItsJointHoweverLong) {
    const std::string name = "lower_lip_of_the_front_door_at_its_upper_hinge";
    std::string text = case_toml(parameters::two_lips(), {.comments = Comments::none, .heading = ""});
    const std::string short_name = "\"lower\"";
    for (std::size_t at = text.find(short_name); at != std::string::npos; at = text.find(short_name, at + 1))
        text.replace(at, short_name.size(), "\"" + name + "\"");
    const auto error = error_of([&] {
        read_case(TomlSource{text, "lips.toml", {"run.initial=given", "joint." + name + ".initial_normal=-1 um"}});
    });
    ASSERT_TRUE(error);
    EXPECT_NE(std::string(error->what()).find("contact \"" + name + "\""), std::string::npos) << error->what();
}

TEST(GivenStart, HasNoMeaningForAnotherStart) {
    const auto error = error_of([] {
        read_case(TomlSource{squeal_toml(), "case.toml", {"joint.initial_tangential=1 um"}});
    });
    ASSERT_TRUE(error);
    EXPECT_NE(std::string(error->what()).find("run.initial = \"given\""), std::string::npos) << error->what();
}

TEST(GivenStart, OfAnOwnStructureIsItsLists) {
    const std::string text =
        "[structure]\nmass = [[1.0, 0.0], [0.0, 1.0]]\nstiffness = [[1e4, 0.0], [0.0, 1e4]]\n"
        "damping_ratio = 0.01\ninitial_displacement = [1e-4, 2e-4]\ninitial_velocity = [0.3, 0.0]\n"
        "[[structure.contact]]\nname = \"foot\"\nnormal = [0, 1]\ntangent = [1, 0]\n"
        "[contact]\npreload = 10\nstatic_friction = 0.5\nkinetic_friction = 0.3\n"
        "[drive]\nkind = \"constant\"\nvelocity = 0.1\n[run]\ninitial = \"given\"\nduration = 0.1\n";
    const Case c = read_case(TomlSource{text, "own.toml", {}});
    record::Request request{record::KeepHistory::yes, {0.0, 0.01, 1e-3}};
    const integration::Motion motion = integration::simulate(c, request);
    EXPECT_NEAR(motion.record.trace.displacement[1].front(), 2e-4, 1e-18);
    EXPECT_NEAR(motion.record.trace.velocity[0].front(), 0.3, 1e-15);
    EXPECT_EQ(motion.record.histories[0].front().state, model::ContactState::separation);
    // from the rest a start leaves gaps as they are
    EXPECT_TRUE(error_of([&] { read_case(TomlSource{text, "own.toml", {"run.initial=rest"}}); }));
}

// the drive is read at the phase, and a first half period that has begun is not judged as a whole one
TEST(GivenStart, BeginsAtAPhaseOfTheDrive) {
    const Case whole = read_case(TomlSource{squeal_toml(), "case.toml", {"run.initial=given"}});
    const Case turned = read_case(TomlSource{squeal_toml(), "case.toml", {"run.initial=given", "drive.phase=90"}});
    EXPECT_NEAR(parameters::turns_at_start(turned.drive), 0.25, 1e-15);
    const auto first = [](const Case& c) { return record::schedule(c).spans.front(); };
    EXPECT_EQ(first(whole).phase, record::Phase::going);
    EXPECT_EQ(first(turned).phase, record::Phase::coming);
    EXPECT_NEAR(first(turned).to, 0.1 * 0.45, 1e-12);  // a whole coming phase begins at the turn
}

}  // namespace
}  // namespace stridor::io
