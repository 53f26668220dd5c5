// The block of Leine and others (1998): m = k = F_s = 1, F = -F_s sgn(w)/(1 + 3 |w|). Period, slip, stick share,
// largest displacement and where it sticks again are those of an independent program with events, for V = 0.2 and 0.1.

#include "stridor/base/error.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/parameters/rules/check.hpp"
#include "stridor/record/trace.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace stridor {
namespace {

using model::ContactState;

parameters::Case leine(std::vector<std::string> overrides) {
    const std::string path = STRIDOR_SOURCE_DIR "/cases/leine-block.toml";
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    overrides.insert(overrides.end(), {"run.duration=100", "run.window=100"});
    return io::read_case(io::TomlSource{text.str(), path, std::move(overrides)});
}

struct Cycle {
    double period = 0.0;                                        // [s]
    double slip = 0.0;                                          // [s] of it
    double farthest = 0.0;                                      // [m] largest displacement
    double sticks_at = 0.0;                                     // [m]
    double stick_share() const { return 1.0 - slip / period; }  // [1]
};

// the mean of the cycles from the first release on
Cycle cycle_of(const parameters::Case& c) {
    constexpr double drawn = 40.0;  // [s] holds a whole cycle
    const integration::Motion motion = integration::simulate(c, {record::KeepHistory::yes, {0.0, drawn, c.run.step}});
    EXPECT_EQ(motion.outcome.reason, integration::Reason::completed);
    std::vector<double> releases, stops;
    for (const record::ContactInterval& stay : motion.record.histories.front()) {
        if (stay.state == ContactState::slip && stay.from > 0.0) releases.push_back(stay.from);
        if (stay.state == ContactState::stick && !releases.empty()) stops.push_back(stay.from);
    }
    Cycle cycle;
    if (releases.size() < 5) {
        ADD_FAILURE() << releases.size() << " releases";
        return cycle;
    }
    const std::size_t cycles = releases.size() - 1;
    cycle.period = (releases.back() - releases.front()) / static_cast<double>(cycles);
    for (std::size_t k = 0; k < cycles; ++k)
        cycle.slip += (stops[k] - releases[k]) / static_cast<double>(cycles);
    const std::vector<double>& x = motion.record.trace.displacement[0];
    cycle.farthest = *std::max_element(x.begin(), x.end());
    cycle.sticks_at = x.at(static_cast<std::size_t>(std::lround(stops.front() / c.run.step)));
    return cycle;
}

class LeinesBlock : public testing::TestWithParam<std::string> {};

// states change at whole steps: each time is known to a step, and where it sticks to what the belt moves in one
TEST_P(LeinesBlock, SticksAndSlipsAsPublishedWithinTheOrderOfTheStep) {
    double before = 1.0;
    for (const std::string step : {"1e-2", "1e-3", "1e-4"}) {
        const double h = std::stod(step);
        const Cycle fast = cycle_of(leine({"run.engine=" + GetParam(), "run.step=" + step}));
        const Cycle slow = cycle_of(leine({"run.engine=" + GetParam(), "run.step=" + step, "drive.velocity=0.1"}));
        EXPECT_NEAR(fast.period, 12.001031, 2.0 * h + 1e-6) << step;
        EXPECT_NEAR(fast.slip, 4.296000, 2.0 * h + 1e-6) << step;
        EXPECT_NEAR(fast.stick_share(), 0.64203, 0.3 * h + 5e-6) << step;
        EXPECT_NEAR(fast.farthest, 1.133945, 0.2 * h + 1e-6) << step;
        EXPECT_NEAR(fast.sticks_at, -0.541006, 0.2 * h + 1e-6) << step;
        EXPECT_NEAR(slow.period, 17.865990, 2.0 * h + 1e-6) << step;
        EXPECT_NEAR(slow.stick_share(), 0.76076, 0.3 * h + 5e-6) << step;
        const double error = std::abs(fast.period - 12.001031);
        EXPECT_LT(error, before) << step;
        before = error;
    }
}

INSTANTIATE_TEST_SUITE_P(Steps, LeinesBlock, testing::Values("beta_2", "moreau"),
                         [](const auto& engine) { return engine.param; });

// its digits by events: friction_series_test.cpp
TEST(LeinesBlockByEvents, IsRefusedWithAPowerThatIsNoWholeNumber) {
    EXPECT_NO_THROW(leine({"run.engine=exact"}));
    EXPECT_THROW(leine({"run.engine=exact", "stribeck_exponent=1.5"}), Error);
}

}  // namespace
}  // namespace stridor
