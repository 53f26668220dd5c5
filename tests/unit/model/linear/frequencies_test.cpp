#include "stridor/model/linear/frequencies.hpp"

#include "stridor/model/built/mass_on_belt.hpp"
#include "stridor/model/built/rubbing_system.hpp"
#include "stridor/verification/table_1.hpp"
#include "support/property.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

namespace stridor::model {
namespace {

// [Hz], of the paper's system at Table 1's values
std::vector<double> hertz(ContactState state) {
    std::vector<double> frequencies = natural_frequencies(rubbing_system({}), state);
    for (double& frequency : frequencies)
        frequency /= 2.0 * std::numbers::pi;
    return frequencies;
}

void expect_near(const std::vector<double>& found, std::span<const double> exact) {
    ASSERT_EQ(found.size(), exact.size());
    for (std::size_t k = 0; k < exact.size(); ++k)
        EXPECT_NEAR(found[k], exact[k], 1e-4 * exact[k]);
}

// open: sqrt(k1j/m1), sqrt(k1i/m1) whatever the angle, sqrt(k2y/m2)
TEST(NaturalFrequencies, Open) {
    expect_near(hertz(ContactState::separation), verification::open_frequencies);
}

TEST(NaturalFrequencies, SlippingWithoutFriction) {
    expect_near(hertz(ContactState::slip), verification::slip_frequencies);
}

// stuck: sqrt((Kyy + k2y) / (m1 + m2))
TEST(NaturalFrequencies, Stuck) {
    expect_near(hertz(ContactState::stick), verification::stick_frequencies);
}

TEST(NaturalFrequencies, OfTheBeltOscillator) {
    const auto structure = mass_on_belt({2.0, 800.0, 0.0, 1.0, {}});
    expect_near(natural_frequencies(structure, ContactState::slip), std::array{20.0});
    EXPECT_TRUE(natural_frequencies(structure, ContactState::stick).empty());
    EXPECT_EQ(natural_frequencies(structure, ContactState::separation).front(), 0.0);  // free across the belt
}

// each constraint can only raise them (Rayleigh): f_k open <= f_k closed <= f_k+1 open
RC_GTEST_PROP(NaturalFrequencies, OfAConstrainedSystemInterlace, ()) {
    parameters::Case c;
    c.joint().incidence_angle = *support::number_between(0.0, 180.0);
    c.plate.mass = *support::number_between(0.01, 2.0);
    c.plate.stiffness = *support::number_between(1e5, 1e7);
    const auto structure = rubbing_system(c);
    const auto open = natural_frequencies(structure, ContactState::separation);
    const auto slip = natural_frequencies(structure, ContactState::slip);
    const auto stick = natural_frequencies(structure, ContactState::stick);
    const auto is_below = [](double a, double b) { return a <= b * (1.0 + 1e-9); };  // square root of rounding
    for (std::size_t k = 0; k < slip.size(); ++k)
        RC_ASSERT(is_below(open[k], slip[k]) && is_below(slip[k], open[k + 1]));
    RC_ASSERT(is_below(slip[0], stick[0]) && is_below(stick[0], slip[1]));
}

}  // namespace
}  // namespace stridor::model
