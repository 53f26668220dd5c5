#include "stridor/console/results/case_text.hpp"

#include "stridor/io/case/ready_files.hpp"
#include "stridor/io/case/toml_case.hpp"

#include <gtest/gtest.h>

#include <string>

namespace stridor::console {
namespace {

TEST(CaseText, TellsTheTimeOfARun) {
    parameters::Case c;
    EXPECT_NE(case_text(c, {.steps = 1e6, .seconds = 4.3}).find("1e+06 steps and the events, about 4.3 s of one core"),
              std::string::npos);
    c.run.engine = parameters::Engine::beta_2;
    EXPECT_NE(case_text(c, {.steps = 1e6, .seconds = 0.025, .step_limit = 1e-4})
                  .find("about 0.025 s of one core; largest stable step 0.0001 s"),
              std::string::npos);
}

// [s] that a step of a bowed string takes
double step_of_string(const std::string& engine, const std::string& modes) {
    const integration::Cost cost = integration::cost(
        io::read_case({io::ready_file("string"), "string.toml", {"structure.modes=" + modes, "run.engine=" + engine}}));
    return cost.seconds / cost.steps;
}

// a contact on 10 and on 100 modes, measured from event to event beside other work: 2.4 and 6.4 us a step
TEST(Cost, OfAStructureOfMoreRowsIsMore) {
    EXPECT_NEAR(step_of_string("exact", "10"), 1.8e-6, 0.8e-6);
    EXPECT_NEAR(step_of_string("exact", "100"), 6e-6, 2e-6);
    EXPECT_NEAR(step_of_string("moreau", "10") / step_of_string("moreau", "100"), 0.12 / 0.3, 0.05);
}

}  // namespace
}  // namespace stridor::console
