// run.formulation = "both", from outside: the standard run, and contacts without inertia beside it.

#include "support/json_of.hpp"
#include "support/process.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

using nlohmann::json;
using stridor::support::Finished;
using stridor::support::json_of;
using stridor::support::run;

namespace {

// a lip of rubber, reduced to its edge: five contacts and twenty modes
class Formulations : public testing::Test {
protected:
    void SetUp() override {
        const std::string part = STRIDOR_SOURCE_DIR "/tests/fixtures/structures/lip/lip.sti";
        const std::string reduced = folder_.path() / "lip.nc";
        EXPECT_EQ(run({"structure", "reduce", part, "--boundary", "EDGE", "--modes", "20", "-o", reduced}).exit_code,
                  0);
        text_ = "[structure]\nfile = \"" + reduced + R"("
damping_ratio = "2 %"
[[structure.contact]]
set = "EDGE"
normal = "z"
tangent = "x"
[contact]
preload = "2 N"
static_friction = 0.7
kinetic_friction = 0.6
[drive]
kind = "constant"
velocity = "0.1 m/s"
[run]
duration = 0.1
window = 0.05
engine = "moreau"
)";
    }

    std::string simulated(const std::string& formulation, const std::string& form) const {
        const Finished finished = run({"simulate", "-", "--set", "run.formulation=" + formulation, form}, {}, text_);
        EXPECT_EQ(finished.exit_code, 0) << finished.err;
        return finished.out;
    }

    json phase_of(const std::string& formulation) const {
        return json_of(simulated(formulation, "--json"))["phases"][0];
    }

    stridor::support::ScratchFolder folder_;
    std::string text_;
};

TEST_F(Formulations, AreTwoRunsSideBySide) {
    const json both = phase_of("both"), standard = phase_of("standard");
    const json massless = phase_of("massless");
    EXPECT_EQ(both["verdict"], standard["verdict"]);
    EXPECT_EQ(both["contacts"], standard["contacts"]);
    EXPECT_FALSE(standard.contains("massless"));
    EXPECT_EQ(both["massless"]["category"], massless["verdict"]["category"]);
    EXPECT_EQ(both["massless"]["agrees"], both["verdict"]["category"] == both["massless"]["category"]);
    ASSERT_EQ(both["massless"]["contacts"].size(), 5U);
    for (std::size_t k = 0; k < 5; ++k) {
        EXPECT_EQ(both["massless"]["contacts"][k]["rates"], massless["contacts"][k]["rates"]);
        EXPECT_EQ(both["massless"]["contacts"][k]["verdict"], massless["contacts"][k]["verdict"]);
        EXPECT_TRUE(both["massless"]["contacts"][k]["verdict"].contains("step_change"));
    }
}

TEST_F(Formulations, SayInWordsHowFarTheyAreApart) {
    const json both = phase_of("both");
    const std::string text = simulated("both", "--set=run.step=1e-6");
    EXPECT_NE(text.find("\nwithout inertia at the contacts shares differ by at most: slip "), std::string::npos)
        << text;
    EXPECT_NE(text.find("\nwithout inertia, shares changed from twice the step by at most: slip "), std::string::npos)
        << text;
    EXPECT_EQ(text.find("the formulations disagree") == std::string::npos, both["massless"]["agrees"]) << text;
}

// the longest step is that of the formulation which asks for the shorter one
TEST_F(Formulations, TakeAStepThatBothCanTake) {
    const auto limit = [&](const std::string& formulation) {
        return json_of(simulated(formulation, "--json"))["engine"]["step_limit"].get<double>();
    };
    const double standard = limit("standard"), massless = limit("massless");
    EXPECT_LT(1.03 * massless, standard);
    EXPECT_EQ(limit("both"), massless);
    const auto check = [&](const std::string& formulation) {
        return run({"check", "-", "--set", "run.formulation=" + formulation, "--set",
                    "run.step=" + json(1.02 * massless).dump()},
                   {}, text_);
    };
    EXPECT_EQ(check("standard").exit_code, 0);
    EXPECT_EQ(check("both").exit_code, 2);
}

// the mass of a joint stands at its contact
TEST_F(Formulations, OfJointsIsTheStandardOne) {
    const Finished finished = run({"simulate", "-", "--set", "run.engine=moreau", "--set", "run.formulation=both"}, {},
                                  run({"init", "two-lips"}).out);
    EXPECT_EQ(finished.exit_code, 2);
    EXPECT_NE(finished.err.find("the contact of a joint has inertia"), std::string::npos) << finished.err;
}

}  // namespace
