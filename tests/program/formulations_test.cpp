// run.formulation = "both", from outside: the standard run, and contacts without inertia beside it.

#include "support/json_of.hpp"
#include "support/process.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

using nlohmann::json;
using stridor::support::Finished;
using stridor::support::json_of;
using stridor::support::run;

namespace {

std::string simulated(const std::string& formulation, const std::string& form) {
    const Finished finished = run({"simulate", "-", "--set", "run.engine=moreau", "--set", "run.duration=0.2", "--set",
                                   "run.window=0.1", "--set", formulation, form},
                                  {}, run({"init", "two-lips"}).out);
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    return finished.out;
}

json phase_of(const std::string& formulation) {
    return json_of(simulated(formulation, "--json"))["phases"][0];
}

TEST(Formulations, AreTwoRunsSideBySide) {
    const json both = phase_of("run.formulation=both"), standard = phase_of("run.formulation=standard");
    const json massless = phase_of("run.formulation=massless");
    EXPECT_EQ(both["verdict"], standard["verdict"]);
    EXPECT_EQ(both["contacts"], standard["contacts"]);
    EXPECT_FALSE(standard.contains("massless"));
    EXPECT_EQ(both["massless"]["category"], massless["verdict"]["category"]);
    EXPECT_EQ(both["massless"]["agrees"], both["verdict"]["category"] == both["massless"]["category"]);
    ASSERT_EQ(both["massless"]["contacts"].size(), 2U);
    for (std::size_t k = 0; k < 2; ++k)
        EXPECT_EQ(both["massless"]["contacts"][k]["rates"], massless["contacts"][k]["rates"]);
}

// two lips lock where their contacts have inertia, and slide where they have none
TEST(Formulations, SayInWordsThatTheirVerdictsDiffer) {
    const json both = phase_of("run.formulation=both");
    ASSERT_EQ(both["massless"]["agrees"], false);
    const std::string text = simulated("run.formulation=both", "--set=run.step=1e-6");
    const std::string with = both["verdict"]["category"], without = both["massless"]["category"];
    EXPECT_NE(text.find("\nwithout inertia at the contacts shares differ by at most: slip "), std::string::npos)
        << text;
    EXPECT_NE(text.find("\nall: the formulations disagree: " + with + " with inertia at the contacts, " + without +
                        " without\n"),
              std::string::npos)
        << text;
}

}  // namespace
