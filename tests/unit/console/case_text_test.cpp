#include "stridor/console/results/case_text.hpp"

#include "stridor/io/case/ready_files.hpp"
#include "stridor/io/case/toml_case.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace stridor::console {
namespace {

// [s] that a text foretells for so many steps
double foretold(const std::string& engine, const std::string& modes) {
    const parameters::Case c =
        io::read_case({io::ready_file("string"), "string.toml", {"structure.modes=" + modes, "run.engine=" + engine}});
    const std::string text = case_text(c, {.steps = 1e6, .step_limit = 1.0});
    const std::size_t about = text.find("about ");
    EXPECT_NE(about, std::string::npos) << text;
    return std::strtod(text.c_str() + about + 6, nullptr);
}

// [s] that a text foretells for so many steps of a joint with this friction
double foretold_of(parameters::FrictionKind friction) {
    parameters::Case c;
    c.contact().friction = friction;
    const std::string text = case_text(c, {.steps = 1e6, .step_limit = 1.0});
    return std::strtod(text.c_str() + text.find("about ") + 6, nullptr);
}

// 4.3 us a step: 0.02 to 0.06 s of a simulated second, where the engine of one contact takes 0.001 s
TEST(CaseText, ForetellsMoreTimeForFrictionThatChanges) {
    EXPECT_NEAR(foretold_of(parameters::FrictionKind::coulomb), 0.1, 1e-9);
    EXPECT_NEAR(foretold_of(parameters::FrictionKind::linear), 4.3, 0.1);
}

// a contact on 10 and on 100 modes: 2.45 and 6.5 us a step from event to event, 0.12 and 0.3 us by steps
TEST(CaseText, ForetellsMoreTimeForAStructureOfMoreRows) {
    EXPECT_NEAR(foretold("exact", "10") / foretold("exact", "100"), 2.45 / 6.5, 0.05);
    EXPECT_NEAR(foretold("moreau", "10") / foretold("moreau", "100"), 0.12 / 0.3, 0.05);
}

}  // namespace
}  // namespace stridor::console
