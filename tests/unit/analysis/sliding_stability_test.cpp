#include "stridor/analysis/sliding_stability.hpp"

#include "stridor/model/built/joints_on_plate.hpp"
#include "stridor/model/built/mass_on_belt.hpp"
#include "stridor/model/built/rubbing_system.hpp"
#include "stridor/verification/table_1.hpp"
#include "support/error_text.hpp"
#include "support/property.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

namespace stridor::analysis {
namespace {

using parameters::Case;
using parameters::Direction;

enum class Damping { table_1, none };

SlidingStability at(double kinetic_friction, double angle = 70.0, Direction direction = Direction::going,
                    Damping damping = Damping::table_1) {
    Case c;
    c.joint().incidence_angle = angle;
    c.contact().kinetic_friction = kinetic_friction;
    c.contact().static_friction = kinetic_friction;
    if (damping == Damping::none) c.joint().axial_damping = c.joint().flexural_damping = c.plate.damping = 0.0;
    return sliding_stability(model::rubbing_system(c), direction);
}

// the friction at which `is_beyond` turns from false to true, to 1e-9
template <typename Predicate>
double bisected(double below, double above, Predicate is_beyond) {
    EXPECT_FALSE(is_beyond(below));
    EXPECT_TRUE(is_beyond(above));
    while (above - below > 1e-9) {
        const double middle = 0.5 * (below + above);
        (is_beyond(middle) ? above : below) = middle;
    }
    return above;
}

double damped_onset(double angle) {
    return bisected(0.1, 1.0, [&](double mu) { return at(mu, angle).kind == StabilityKind::flutter; });
}

// frequencies are known to five digits, onsets to the digits printed
TEST(SlidingStability, OfFrictionlessSlidingHasTheModesOfTheClosedContact) {
    const SlidingStability result = at(0.0);
    EXPECT_EQ(result.kind, StabilityKind::stable);
    ASSERT_EQ(result.modes.size(), 2U);
    EXPECT_NEAR(result.modes[0].frequency, verification::slip_frequencies[0], 0.01);
    EXPECT_NEAR(result.modes[1].frequency, verification::slip_frequencies[1], 0.01);
    EXPECT_NEAR(result.normal_force, 20.0, 1e-12);
}

TEST(SlidingStability, FrictionDrawsTheModesTogetherGoingAndApartComing) {
    const SlidingStability going = at(0.2);
    EXPECT_NEAR(going.modes[0].frequency, 460.37, 0.01);
    EXPECT_NEAR(going.modes[1].frequency, 833.51, 0.01);
    const SlidingStability coming = at(0.2, 70.0, Direction::coming);
    EXPECT_NEAR(coming.modes[0].frequency, 407.76, 0.01);
    EXPECT_NEAR(coming.modes[1].frequency, 987.36, 0.01);
    EXPECT_EQ(going.kind, StabilityKind::stable);
    EXPECT_EQ(coming.kind, StabilityKind::stable);
}

TEST(Flutter, GrowthAtTheSquealCase) {
    const SlidingStability result = at(0.6);
    EXPECT_EQ(result.kind, StabilityKind::flutter);
    EXPECT_NEAR(result.growth, verification::squeal_growth, 0.01);
    EXPECT_NEAR(result.frequency, verification::squeal_frequency, 0.05);
}

TEST(Flutter, BeginsWithTheDampingOfTable1) {
    EXPECT_NEAR(damped_onset(70.0), verification::damped_flutter_onset, 5e-6);
}

TEST(Flutter, BeginsByAngle) {
    for (const auto& [angle, onset] : verification::flutter_onsets)
        EXPECT_NEAR(damped_onset(angle), onset, 5e-4) << angle;
}

// undamped modes meet at 607.99 Hz and grow; at 2.576 the growing pair stops oscillating and two real roots are left
TEST(Flutter, OfTheUndampedSystemIsABandOfFriction) {
    const auto kind = [](double mu) { return at(mu, 70.0, Direction::going, Damping::none).kind; };
    const double onset = bisected(0.2, 0.7, [&](double mu) { return kind(mu) == StabilityKind::flutter; });
    EXPECT_NEAR(onset, verification::undamped_flutter_onset, 5e-6);
    // growth and detuning rise as the square root of mu - onset: 740 1/s and 17 Hz at 0.1 above it
    EXPECT_NEAR(at(onset, 70.0, Direction::going, Damping::none).frequency, verification::undamped_flutter_frequency,
                0.01);
    EXPECT_NEAR(bisected(1.0, 3.0, [&](double mu) { return kind(mu) == StabilityKind::divergence; }),
                verification::undamped_divergence_onset, 5e-4);
}

// the stiffness against the sliding force vanishes: N grows beyond all bounds, then there is no equilibrium at all
TEST(Locking, BeginsWhereTheNormalForceHasItsPole) {
    const double onset = bisected(3.0, 5.0, [](double mu) { return at(mu).kind == StabilityKind::locked; });
    EXPECT_NEAR(onset, verification::locking_onset, 5e-4);
    EXPECT_GT(at(onset - 1e-6).normal_force, 1e6);
    EXPECT_LT(at(onset + 1e-6).normal_force, -1e6);
    EXPECT_EQ(at(onset - 1e-6).kind, StabilityKind::divergence);
}

TEST(Coming, IsNeverUnstable) {
    for (int k = 0; k <= 1000; ++k)
        ASSERT_EQ(at(0.01 * k, 70.0, Direction::coming).kind, StabilityKind::stable) << 0.01 * k;
}

// without damping a stable mode has no growth at all: rounding must not call it flutter
RC_GTEST_PROP(SlidingStability, OfAnUndampedSystemIsNotFlutterByRounding, ()) {
    const double mu = *support::number_between(0.0, 0.48);
    RC_ASSERT(at(mu, 70.0, Direction::going, Damping::none).kind == StabilityKind::stable);
}

RC_GTEST_PROP(SlidingStability, IsMirroredByTheIncidenceAngle, ()) {
    const double angle = *support::whole_between(0, 180 * 16) / 16.0;
    const double mu = *support::number_between(0.0, 1.0);
    const SlidingStability going = at(mu, angle, Direction::going);
    const SlidingStability coming = at(mu, 180.0 - angle, Direction::coming);
    // rounding of eigenvalues up to 1e4 1/s, its square root where two meet
    RC_ASSERT(std::abs(going.growth - coming.growth) < 1e-3);
    RC_ASSERT(std::abs(going.frequency - coming.frequency) < 1e-3 || std::abs(going.growth) < 10.0);
}

TEST(BeltOscillator, SlidesSteadilyWithItsOwnDamping) {
    // x'' + 4 x' + 100 x = T/m: -2 +- i sqrt(96)
    const auto structure = model::mass_on_belt({2.0, 200.0, 8.0, 50.0, {0.8, 0.3}});
    const SlidingStability result = sliding_stability(structure, Direction::going);
    EXPECT_EQ(result.kind, StabilityKind::stable);
    EXPECT_NEAR(result.growth, -2.0, 1e-12);
    EXPECT_NEAR(result.frequency, std::sqrt(96.0) / (2.0 * std::numbers::pi), 1e-12);
    EXPECT_NEAR(result.normal_force, 50.0, 1e-12);
}

// --- several contacts

// equal joints on one plate move as one joint of so many times the mass and stiffness, or against each other
TEST(SlidingOfSeveral, EqualJointsHasTheModesOfOneAndThoseAgainstEachOther) {
    const Case c;  // Table 1's squeal
    const model::PlateJoint half{.joint = c.joint(), .contact = c.contact()};
    parameters::Plate plate = c.plate;
    plate.mass *= 2.0;
    plate.stiffness *= 2.0;
    plate.damping *= 2.0;
    const SlidingStability one = sliding_stability(model::rubbing_system(c), Direction::going);
    const SlidingStability two =
        sliding_stability(model::joints_on_plate(std::array{half, half}, plate), Direction::going);
    EXPECT_EQ(two.kind, one.kind);
    EXPECT_NEAR(two.growth, one.growth, 1e-8);
    EXPECT_NEAR(two.normal_force, one.normal_force, 1e-10);
    EXPECT_TRUE(two.open.empty());
    for (const Eigenmode& mode : one.modes)
        EXPECT_TRUE(std::any_of(two.modes.begin(), two.modes.end(), [&](const Eigenmode& other) {
            return std::abs(other.frequency - mode.frequency) < 1e-6 && std::abs(other.growth - mode.growth) < 1e-6;
        })) << mode.frequency;
}

// a bar on two feet that its friction tips: the rear foot lifts off where mu h is half the distance of the feet
TEST(SlidingOfSeveral, LiftsOffTheFootThatFrictionUnloads) {
    const auto bar = [](double mu) {
        model::Structure s = model::structure_of_size(3, 2);  // x, y, turn of the centre; feet at x = -+1, 0.5 below
        s.mass = s.stiffness = s.damping = Eigen::MatrixXd::Identity(3, 3);
        s.stiffness *= 1e-6;  // soft springs: the feet carry all
        s.load << 0.0, -1.0, 0.0;
        for (std::size_t k = 0; k < 2; ++k) {
            const double x = k == 0 ? -1.0 : 1.0;
            s.contacts[k].normal << 0.0, 1.0, x;
            s.contacts[k].tangent << 1.0, 0.0, 0.5;
            s.contacts[k].friction = model::Coulomb{mu, mu};
        }
        return sliding_stability(s, Direction::going);
    };
    EXPECT_TRUE(bar(1.9).open.empty());
    EXPECT_EQ(bar(2.1).open.size(), 1U);
    EXPECT_GT(bar(2.1).normal_force, 0.9);
}

TEST(ClassifyModes, ListsOneOfEachPairByRisingFrequency) {
    using C = std::complex<double>;
    const SlidingStability result = classify_modes({C(-1.0, 20.0), C(-1.0, -20.0), C(3.0, 10.0), C(3.0, -10.0)}, 5.0);
    ASSERT_EQ(result.modes.size(), 2U);
    EXPECT_LT(result.modes[0].frequency, result.modes[1].frequency);
    EXPECT_EQ(result.growth, 3.0);
    EXPECT_EQ(result.kind, StabilityKind::flutter);
    EXPECT_EQ(classify_modes({C(1.0, 0.0), C(-2.0, 0.0)}, 5.0).kind, StabilityKind::divergence);
    EXPECT_EQ(classify_modes({C(-1.0, 0.0), C(-2.0, 0.0)}, 5.0).kind, StabilityKind::stable);
    EXPECT_EQ(classify_modes({C(-1.0, 0.0), C(-2.0, 0.0)}, -5.0).kind, StabilityKind::locked);
    EXPECT_EQ(classify_modes({}, 5.0).kind, StabilityKind::stable);
}

using model::Structure;

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
