// A squeak-noise test rig: M. Utzig et al., J. Sound Vib. 501 (2021) 116077, reduced as published with NLstep, example
// 05. Two nodes without mass that slip in a plane, shaken by a force. The figures are those of a
// prototype written apart: leapfrog and projected Gauss-Seidel.

#include "stridor/base/error.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/model/built/case_structure.hpp"
#include "stridor/model/linear/frequencies.hpp"
#include "stridor/parameters/rules/check.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/record/trace.hpp"
#include "support/many_contacts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

namespace stridor {
namespace {

constexpr double period = 1.0 / 7.0;  // [s]

parameters::Case rig(std::vector<std::string> overrides = {}) {
    const std::string path = STRIDOR_SOURCE_DIR "/cases/published/squeak-rig.toml";
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return io::read_case(io::TomlSource{text.str(), path, std::move(overrides)});
}

void expect_frequencies(model::ContactState state, const std::vector<double>& wanted) {
    const std::vector<double> found = model::natural_frequencies(model::structure_of(rig()), state);
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t k = 0; k < wanted.size(); ++k)
        EXPECT_NEAR(found[k] / (2.0 * std::numbers::pi), wanted[k], 1e-6) << "mode " << k;
}

TEST(SqueakRig, HasItsFrequencies) {
    EXPECT_TRUE(parameters::findings(rig()).empty());
    expect_frequencies(model::ContactState::stick, {232.695547, 303.328073, 325.429354, 392.336149, 492.091443});
    expect_frequencies(model::ContactState::separation, {42.467922, 279.709761, 289.324078, 356.849594, 380.807820});
}

TEST(SqueakRig, SqueaksAsPublished) {
    const parameters::Case c = rig();
    record::Request request;
    request.trace = {.from = 6.0 * period, .to = 8.0 * period, .interval = c.run.step};
    integration::Motion motion = integration::simulate(c, request);
    EXPECT_EQ(motion.outcome.reason, integration::Reason::completed);
    EXPECT_LT(std::abs(motion.energy.relative_residual()), 1e-3);
    record::Trace& trace = motion.record.trace;
    record::add_points(trace, parameters::output_weights(c));
    double sum = 0.0, most = 0.0;
    for (const double velocity : trace.velocity.back()) {
        sum += velocity * velocity;
        most = std::max(most, std::abs(velocity));
    }
    const double rms = std::sqrt(sum / static_cast<double>(trace.time.size()));
    EXPECT_NEAR(1e3 * rms, 10.93, 0.05);
    EXPECT_NEAR(1e3 * most, 33.1, 0.1);
    for (const auto& contact : support::shares(motion)) {
        EXPECT_NEAR(contact[support::stick_share], 0.740, 0.003);
        EXPECT_EQ(contact[support::open_share], 0.0);
    }
}

// what it is asked for must stand in the file: each alone is refused by name
TEST(SqueakRig, NeedsStepsWithoutInertia) {
    for (const std::string key : {"run.engine=exact", "run.formulation=standard", "run.formulation=both"})
        EXPECT_THROW(rig({key}), Error) << key;
    EXPECT_THROW(rig({"run.initial=stuck"}), Error);
}

}  // namespace
}  // namespace stridor
