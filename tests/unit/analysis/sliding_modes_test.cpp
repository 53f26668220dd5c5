#include "stridor/analysis/sliding_modes.hpp"

#include "stridor/model/joints_on_plate.hpp"
#include "support/error_text.hpp"
#include "support/property.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace stridor::analysis {
namespace {

using model::Structure;
using parameters::Direction;

// Two equal modes that a contact couples: a mass at (x, y) on a plate without mass that a spring k holds, y = y2.
// M = 1, K = [A, B + sigma mu k; B, A]: squares of the eigenvalues -(A +- i G), G = sqrt(-B (B + sigma mu k)).
struct Coupling {
    double A = 2e5;
    double B = -4e4;
    double k = 1e5;
    double mu = 0.9;
    double damping = 0.0;  // [1/s] of C = damping M

    double G() const { return std::sqrt(-B * (B + mu * k)); }
    // |x / y|^2 of both modes
    double ratio() const { return -(B + mu * k) / B; }
};

Structure coupled(const Coupling& c) {
    Structure s = model::structure_of_size(3, 1);
    s.mass.diagonal() << 1.0, 1.0, 0.0;
    s.damping = c.damping * s.mass;
    s.stiffness << c.A, c.B, 0.0, c.B, c.A - c.k, 0.0, 0.0, 0.0, c.k;
    s.load << 0.0, -1.0, 0.0;
    s.contacts[0].normal << 0.0, 1.0, -1.0;
    s.contacts[0].tangent << 1.0, 0.0, 0.0;
    s.contacts[0].friction = model::Coulomb{c.mu, c.mu};
    return s;
}

double sum(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

// whose friction is T = +mu N while it slides that way
Direction fluttering(const Coupling& c) {
    const Structure s = coupled(c);
    return sliding_stability(s, Direction::going).kind == StabilityKind::flutter ? Direction::going : Direction::coming;
}

TEST(SlidingModes, OfTwoCoupledModesAreHalfOfEach) {
    const Coupling c;
    const SlidingModes modes = sliding_modes(coupled(c), fluttering(c));
    ASSERT_EQ(modes.modes.size(), 1U);
    const SlidingMode& mode = modes.modes.front();
    // the free modes are (1, 1) and (1, -1)
    constexpr double two_pi = 6.283185307179586;
    EXPECT_NEAR(modes.free_frequencies[0], std::sqrt(c.A + c.B) / two_pi, 1e-9);
    EXPECT_NEAR(modes.free_frequencies[1], std::sqrt(c.A - c.B) / two_pi, 1e-9);
    const double size = std::hypot(c.A, c.G());
    EXPECT_NEAR(mode.eigenvalue.real(), std::sqrt(0.5 * (size - c.A)), 1e-9);
    EXPECT_NEAR(mode.eigenvalue.imag(), std::sqrt(0.5 * (size + c.A)), 1e-9);
    for (const double share : mode.energy_shares)
        EXPECT_NEAR(share, 0.5, 1e-12);
    // rows are (x, y, y)
    for (const double mac : mode.mac)
        EXPECT_NEAR(mac, (c.ratio() + 4.0) / (3.0 * (c.ratio() + 2.0)), 1e-12);
    // nothing but friction feeds it
    EXPECT_NEAR(mode.contact_growth.front(), mode.eigenvalue.real(), 1e-9);
    EXPECT_EQ(mode.damping_growth, 0.0);
}

TEST(SlidingModes, NeedInertiaWhereNoContactHolds) {
    Structure held = coupled({});
    EXPECT_NO_THROW(steady_sliding(held, Direction::going));
    held.contacts[0].normal << 0.0, 1.0, 0.0;  // the plate without mass is nobody's now
    EXPECT_TRUE(support::thrown_by([&] {
                    steady_sliding(held, Direction::going);
                }).says("a motion that the closed contacts allow moves no mass"));
}

TEST(SlidingModes, LoseToDampingWhatTheClosedFormSays) {
    Coupling c;
    c.damping = 3.0;
    const SlidingModes modes = sliding_modes(coupled(c), fluttering(c));
    ASSERT_EQ(modes.modes.size(), 1U);
    const SlidingMode& mode = modes.modes.front();
    const double rate = std::norm(mode.eigenvalue);
    EXPECT_NEAR(mode.damping_growth, -c.damping * rate / (rate + c.A), 1e-9);
    EXPECT_NEAR(mode.contact_growth.front() + mode.damping_growth, mode.eigenvalue.real(), 1e-9);
}

TEST(SlidingModes, AreTheFreeModesWithoutFriction) {
    Coupling c;
    c.mu = 0.0;
    c.damping = 1.0;
    const SlidingModes modes = sliding_modes(coupled(c), Direction::going);
    ASSERT_EQ(modes.modes.size(), 1U) << "the least damped, as none grows";
    const SlidingMode& mode = modes.modes.front();
    const std::size_t own = mode.energy_shares[0] > 0.5 ? 0 : 1;
    EXPECT_NEAR(mode.energy_shares[own], 1.0, 1e-12);
    EXPECT_NEAR(mode.mac[own], 1.0, 1e-12);
    EXPECT_NEAR(mode.contact_growth.front(), 0.0, 1e-12);
    EXPECT_NEAR(mode.damping_growth, -0.5, 1e-9);
}

// joints of many kinds on one plate
Structure wild() {
    std::vector<model::PlateJoint> joints(static_cast<std::size_t>(*support::whole_between(2, 4)));
    for (model::PlateJoint& joint : joints) {
        joint.joint.incidence_angle = *support::number_between(20.0, 160.0);
        joint.joint.axial_stiffness *= *support::number_between(0.3, 3.0);
        joint.contact.static_friction = 0.8;
        joint.contact.kinetic_friction = *support::number_between(0.0, 0.8);
    }
    return model::joints_on_plate(joints, {});
}

RC_GTEST_PROP(SlidingModes, GrowByWhatContactsAndDampingAdd, ()) {
    const Structure s = wild();
    for (const Direction direction : {Direction::going, Direction::coming}) {
        const SlidingModes modes = sliding_modes(s, direction, 8);
        const SlidingStability stability = sliding_stability(s, direction);
        RC_ASSERT(!modes.modes.empty());
        // rounding of eigenvalues up to 1e4 1/s, its square root where two meet
        RC_ASSERT(std::abs(modes.modes.front().eigenvalue.real() - stability.growth) < 1e-3);
        for (const SlidingMode& mode : modes.modes) {
            RC_ASSERT(std::abs(sum(mode.energy_shares) - 1.0) < 1e-9);
            const double added = sum(mode.contact_growth) + mode.damping_growth;
            RC_ASSERT(std::abs(added - mode.eigenvalue.real()) < 1e-7 * std::abs(mode.eigenvalue));
            RC_ASSERT(mode.damping_growth <= 0.0);
            RC_ASSERT(std::abs(mode.shape.cwiseAbs().maxCoeff() - 1.0) < 1e-12);
        }
    }
}

RC_GTEST_PROP(SlidingModes, DoNotDependOnTheNumbersOfTheContacts, ()) {
    const Structure s = wild();
    Structure other = s;
    std::swap(other.contacts.front(), other.contacts.back());
    const SlidingModes modes = sliding_modes(s, Direction::going);
    const SlidingModes swapped = sliding_modes(other, Direction::going);
    const SlidingMode& one = modes.modes.front();
    const SlidingMode& same = swapped.modes.front();
    // two modes that meet turn rounding into its square root
    RC_ASSERT(std::abs(one.eigenvalue - same.eigenvalue) < 1e-3);
    RC_ASSERT(std::abs(one.contact_growth.front() - same.contact_growth.back()) < 1e-2);
}

TEST(SlidingModes, OfNoFreeMotionAreNone) {
    Structure s = model::structure_of_size(1, 1);
    s.mass << 1.0;
    s.stiffness << 1.0;
    s.load << -1.0;
    s.contacts[0].normal << 1.0;
    s.contacts[0].tangent << 0.0;
    EXPECT_TRUE(sliding_modes(s, Direction::going).modes.empty());
}

}  // namespace
}  // namespace stridor::analysis
