#include "stridor/integration/exact/limit_cycle.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace stridor::integration {
namespace {

using Finding = CycleWatch::Finding;

constexpr double velocity = 0.1;  // [m/s]
constexpr double rate = 1000.0;   // [1/s]
constexpr int closed = 2;         // degrees of freedom of the closed contact

struct Entered {
    ContactMode mode = ContactMode::open;
    double place = 0.0;  // [m]
};

// a period of four events, 10 ms each; the last two of them enter the same state at different places
const std::vector<Entered> period{{ContactMode::stick, 0.0},
                                  {ContactMode::slip_backward, 1e-4},
                                  {ContactMode::open, -2e-4},
                                  {ContactMode::slip_backward, 3e-4}};

// the findings of so many events of periods in which all places move by `drift` each, of the first one
std::vector<Finding> findings(CycleWatch& watch, std::size_t events, const std::vector<double>& drift) {
    std::vector<Finding> all;
    for (std::size_t k = 0; k < events; ++k) {
        const Entered& entered = period[k % period.size()];
        Lanes s{};
        s.at[0] = entered.place + drift[k / period.size()];
        s.at[closed] = velocity;
        all.push_back(watch.note(0.01 * static_cast<double>(k), entered.mode, s));
    }
    return all;
}

TEST(CycleWatch, FindsAPeriodThatCameTwice) {
    CycleWatch watch(velocity, rate, closed);
    const std::vector<Finding> all = findings(watch, 9, {0.0, 0.0, 0.0});
    std::vector<Finding> expected(9, Finding::nothing);
    expected[4] = Finding::first_return;
    expected[8] = Finding::cycle;
    EXPECT_EQ(all, expected);
    EXPECT_EQ(watch.cycle().events, 4);
    EXPECT_NEAR(watch.cycle().period, 0.04, 1e-15);
    EXPECT_NEAR(watch.cycle().time, 0.08, 1e-15);
    EXPECT_NEAR(watch.period_begin(), 0.04, 1e-15);
    EXPECT_EQ(watch.cycle().residual, 0.0);
}

// 1e-9 of the velocities is a return, if the next one is closer; what grows is none
TEST(CycleWatch, TakesOnlyWhatComesCloser) {
    constexpr double near = 1e-9 * 2.0 * velocity / rate;  // [m] the drive's velocity and the mass's
    CycleWatch closing(velocity, rate, closed), parting(velocity, rate, closed), far(velocity, rate, closed);
    EXPECT_EQ(findings(closing, 9, {0.0, 0.9 * near, 1.2 * near}).back(), Finding::cycle);
    EXPECT_NEAR(closing.cycle().residual, 0.3e-9, 1e-12);
    EXPECT_EQ(findings(parting, 9, {0.0, 0.3 * near, 0.9 * near}).back(), Finding::nothing);
    EXPECT_EQ(findings(far, 9, {0.0, 1.1 * near, 1.1 * near})[4], Finding::nothing);
}

}  // namespace
}  // namespace stridor::integration
