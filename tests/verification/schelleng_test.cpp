// The bowed string between Schelleng's limits: its verdict over bow force and bow position.

#include "stridor/classification/contact_rules.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/io/case/ready_files.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/model/built/bowed_string.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "support/effort.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace stridor {
namespace {

constexpr double resistance = 20.0;  // [kg/s] of the bridge
constexpr double velocity = 0.1;     // [m/s] of the bow
constexpr double pitch = 200.0;      // [Hz]

parameters::Case violin_string() {
    std::string text = io::ready_file("string");
    text.insert(text.find("\n[contact]"), "bridge_resistance = 20\n");
    return io::read_case(io::TomlSource{text,
                                        "string.toml",
                                        {"structure.modes=60", "structure.damping_ratio=2e-4", "run.duration=1",
                                         "run.window=0.5", "verdict.creak_stick=1"}});
}

// one slip in each period of the string, about as long as the bow's place says
bool is_helmholtz_motion(parameters::Case c, double position, double force) {
    parameters::set_quantity(c, "structure.position", position);
    parameters::set_quantity(c, "contact.preload", force);
    const integration::Motion motion = integration::simulate(c);
    const classification::Verdict verdict = classification::classify_phase(motion.record.phases.front(), c.verdict);
    return verdict.category == classification::Category::squeal &&
           std::abs(verdict.evidence.alternation.frequency / pitch - 1.0) < 0.02 &&
           verdict.evidence.judged_rates.slip < 2.0 * position;
}

class Schelleng : public testing::TestWithParam<double> {};

TEST_P(Schelleng, UpperLimitEndsHelmholtzMotionWithin15Percent) {
    const double position = GetParam();
    const double limit = model::greatest_bow_force({.bow_position = position}, velocity);
    const parameters::Case c = violin_string();
    EXPECT_TRUE(is_helmholtz_motion(c, position, 0.85 * limit));
    EXPECT_FALSE(is_helmholtz_motion(c, position, 1.15 * limit));
}

TEST_P(Schelleng, LowerLimitIsNecessary) {
    const double position = GetParam();
    const double limit = model::least_bow_force({.bridge_resistance = resistance, .bow_position = position}, velocity);
    EXPECT_FALSE(is_helmholtz_motion(violin_string(), position, limit));
}

INSTANTIATE_TEST_SUITE_P(BowPositions, Schelleng,
                         testing::ValuesIn(support::effort(std::vector{0.0253, 0.0451, 0.0801, 0.1425},
                                                           std::vector{0.1425})));

}  // namespace
}  // namespace stridor
