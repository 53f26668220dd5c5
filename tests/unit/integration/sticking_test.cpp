#include "stridor/integration/proofs/sticking.hpp"

#include "stridor/integration/simulate.hpp"
#include "stridor/model/built/mass_on_belt.hpp"
#include "stridor/model/built/rubbing_system.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "support/property.hpp"
#include "support/seal_lip.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace stridor::integration {
namespace {

using parameters::Case;
using record::Future;

// how a run ends; the outlook is the same for all its phases
record::Ending ending(const Case& c) {
    return simulate(c).record.phases.front().contacts.front().ending;
}

record::Outlook at_rest(const Case& c) {
    const model::Structure structure = model::rubbing_system(c);
    const Eigen::Vector3d carried(c.drive.velocity, 0.0, 0.0);
    return outlook_of_stick(structure, velocity_profile(c.drive),
                            {Eigen::Vector3d::Zero(), carried, c.drive.velocity, 0.0, 0.0});
}

// N grows with x by k2y Kxy/(Kyy + k2y), T by Kxx - Kxy²/(Kyy + k2y): their ratio is the friction that locks
double locking_friction(const Case& c) {
    const model::Structure s = model::rubbing_system(c);
    const double Kxx = s.stiffness(0, 0), Kxy = s.stiffness(0, 1), both = s.stiffness(1, 1) + c.plate.stiffness;
    return (Kxx - Kxy * Kxy / both) / (c.plate.stiffness * Kxy / both);
}

TEST(Stick, OfALockingLipIsForEver) {
    EXPECT_EQ(at_rest(support::seal_lip()).future, Future::sticks);
    const record::Ending end = ending(support::seal_lip());
    EXPECT_EQ(end.state, model::ContactState::stick);
    EXPECT_EQ(end.outlook.future, Future::sticks);
    EXPECT_NEAR(end.since, 28e-6, 1e-6);
}

TEST(Stick, LocksFromTheClosedFormOn) {
    Case c = support::seal_lip();
    const double locking = locking_friction(c);
    EXPECT_NEAR(locking, 0.734, 5e-4);
    c.contact().static_friction = locking * (1.0 + 1e-6);
    EXPECT_EQ(at_rest(c).future, Future::sticks);
    c.contact().static_friction = locking * (1.0 - 1e-6);
    EXPECT_EQ(at_rest(c).future, Future::releases);
    c.contact().static_friction = 1.2;
    c.drive.velocity = -0.05;  // coming the normal force falls
    EXPECT_EQ(at_rest(c).future, Future::releases);
}

// N = F + x k2y Kxy/(Kyy + k2y), but for the dashpots
TEST(Stick, CarriesMoreWithTheWayAsTheClosedFormSays) {
    const Case c = support::seal_lip();
    const model::Structure s = model::rubbing_system(c);
    const double both = s.stiffness(1, 1) + c.plate.stiffness;
    const double slope = c.plate.stiffness * s.stiffness(0, 1) / both;
    EXPECT_NEAR(slope, 9.7e3, 50.0);
    EXPECT_NEAR(at_rest(c).drag.slope, slope, 1e-9 * slope);
    const record::Drag drag = ending(c).outlook.drag;
    EXPECT_NEAR(drag.slope, slope, 1e-9 * slope);
    EXPECT_NEAR(drag.way, c.drive.velocity * c.run.duration, 2e-6);
    EXPECT_NEAR(drag.from, c.contact().preload, 0.1);
    EXPECT_NEAR(drag.to, c.contact().preload + slope * c.drive.velocity * c.run.duration, 0.1);
    Case coming = c;
    coming.drive.velocity = -0.05;
    EXPECT_NEAR(at_rest(coming).drag.slope, -slope, 1e-9 * slope);
}

// x2 = A sin(omega t), slow: N swings by A k2y Kxy/(Kyy + k2y)
TEST(Stick, OfASinusoidalDriveCarriesMostAtTheEndsOfItsStroke) {
    Case c = support::seal_lip();
    c.drive.kind = parameters::DriveKind::sinusoidal;
    c.drive.amplitude = 0.3e-3;
    c.drive.frequency = 0.1;
    c.run.duration = c.run.window = 20.0;
    const model::Structure s = model::rubbing_system(c);
    const double swing =
        c.drive.amplitude * c.plate.stiffness * s.stiffness(0, 1) / (s.stiffness(1, 1) + c.plate.stiffness);
    const record::Ending end = ending(c);
    ASSERT_EQ(end.outlook.future, Future::sticks);
    EXPECT_NEAR(end.outlook.drag.way, 2.0 * c.drive.amplitude, 1e-12);
    EXPECT_NEAR(0.5 * (end.outlook.drag.to - end.outlook.drag.from), swing, 1e-3 * swing);
    EXPECT_EQ(end.outlook.drag.slope, 0.0);
}

// alpha = 0 decouples x and y: T = k x reaches mu_s F after mu_s F/(k V)
TEST(Release, OfAMassOnABeltComesWhenTheSpringPullsItLoose) {
    Case c = support::seal_lip();
    c.joint().incidence_angle = 0.0;
    const record::Outlook outlook = at_rest(c);
    EXPECT_EQ(outlook.future, Future::releases);
    const double exact =
        c.contact().static_friction * c.contact().preload / (c.joint().axial_stiffness * c.drive.velocity);
    EXPECT_NEAR(outlook.release, exact, 0.01 * exact);  // the dashpot's share: c V/(mu_s F) = 0.8 %
}

// a slow belt: the run ends before the first slip, and longer runs show that it comes
TEST(Release, ComesWhereItWasForetold) {
    Case c = support::seal_lip();
    c.drive.velocity = -1e-3;
    c.run.duration = c.run.window = 0.05;
    c.run.initial = parameters::Initial::stuck;
    const record::Ending early = ending(c);
    ASSERT_EQ(early.state, model::ContactState::stick);
    ASSERT_EQ(early.outlook.future, Future::releases);
    ASSERT_GT(early.outlook.release, 0.05);
    c.run.duration = c.run.window = 1.01 * early.outlook.release;
    const Motion later = simulate(c, {record::KeepHistory::yes, {}});
    ASSERT_GT(later.record.histories.front().size(), 1U);
    EXPECT_NEAR(later.record.histories.front()[0].to, early.outlook.release, 1e-3 * early.outlook.release);
}

// under a sinusoidal drive the bound is the swing of the forces; a hundred periods hold what the proof says
RC_GTEST_PROP(Stick, ThatIsProvenHolds, ()) {
    Case c = support::seal_lip();
    c.joint().incidence_angle = *support::number_between(0.0, 180.0);
    c.contact().preload = *support::number_between(1.0, 20.0);
    c.contact().static_friction = *support::number_between(0.2, 1.5);
    c.contact().kinetic_friction = 0.9 * c.contact().static_friction;
    c.drive.kind =
        *support::whole_between(0, 1) == 0 ? parameters::DriveKind::sinusoidal : parameters::DriveKind::constant;
    c.drive.amplitude = *support::number_between(1e-4, 2e-3);
    c.drive.frequency = *support::number_between(2.0, 40.0);
    c.drive.velocity = *support::number_between(-0.1, 0.1);
    c.run.early_ending = parameters::EarlyEnding::never;
    c.run.duration = 0.5;
    c.run.window = 0.5;
    const record::Ending first = ending(c);
    RC_PRE(first.outlook.future == Future::sticks);
    c.run.duration = 2.0;
    const record::Ending later = ending(c);
    RC_ASSERT(later.state == model::ContactState::stick);
    RC_ASSERT(later.since == first.since);
}

// The motion of a contact that swings with the plate, and its forces: M u" + C u' + K u = f0 + n N + t T with n.u = 0
// and t.u = A cos(phi), solved at once for u, N and T. The mean and the complex amplitudes.
struct Swing {
    double amplitude = 0.0;  // [m] A
    double omega = 0.0;      // [rad/s]
    Eigen::VectorXd mean;    // of (u, -N, -T)
    Eigen::VectorXcd swing;  // of the same

    // [N] the smaller of mu_s N - T and mu_s N + T over a period
    double least_margin(double static_friction) const {
        double least = std::numeric_limits<double>::infinity();
        for (const double side : {-1.0, 1.0}) {
            const auto margin = [&](const auto& all) {
                return -static_friction * all(all.size() - 2) - side * all(all.size() - 1);
            };
            least = std::min(least, margin(mean) - std::abs(margin(swing)));
        }
        return least;
    }

    StuckState at(double phase) const {
        const Eigen::Index dofs = mean.size() - 2;
        const std::complex<double> turned = std::polar(1.0, phase), rate(0.0, omega);
        return {mean.head(dofs) + (turned * swing.head(dofs)).real(), (rate * turned * swing.head(dofs)).real(),
                -omega * amplitude * std::sin(phase), -omega * omega * amplitude * std::cos(phase), 0.0};
    }
};

Swing swing_with_the_plate(const Case& c) {
    const model::Structure s = model::rubbing_system(c);
    const Eigen::Index dofs = s.load.size();
    const double omega = 2.0 * std::acos(-1.0) * c.drive.frequency;
    Eigen::MatrixXcd held = Eigen::MatrixXcd::Zero(dofs + 2, dofs + 2);
    held.block(0, dofs, dofs, 1) = s.contacts.front().normal.cast<std::complex<double>>();
    held.block(0, dofs + 1, dofs, 1) = s.contacts.front().tangent.cast<std::complex<double>>();
    held.bottomLeftCorner(2, dofs) = held.topRightCorner(dofs, 2).transpose();
    Eigen::MatrixXcd moving = held;
    held.topLeftCorner(dofs, dofs) = s.stiffness.cast<std::complex<double>>();
    moving.topLeftCorner(dofs, dofs) = (s.stiffness - omega * omega * s.mass).cast<std::complex<double>>() +
                                       std::complex<double>(0.0, omega) * s.damping.cast<std::complex<double>>();
    Eigen::VectorXcd rest = Eigen::VectorXcd::Zero(dofs + 2), carried = rest;
    rest.head(dofs) = s.load.cast<std::complex<double>>();
    carried(dofs + 1) = c.drive.amplitude;
    return {c.drive.amplitude, omega, (held.inverse() * rest).real(), moving.inverse() * carried};
}

// damping and inertia count at this frequency: the plate's swing leads to forces out of step with it
TEST(Stick, UnderASinusoidalDriveIsJudgedAlikeAtEveryInstant) {
    Case c = support::seal_lip();
    c.drive.kind = parameters::DriveKind::sinusoidal;
    c.drive.amplitude = 5e-4;
    c.drive.frequency = 150.0;
    const Swing swing = swing_with_the_plate(c);
    double slips = 0.0, sticks = 10.0;  // [1] the friction from which on it sticks lies between
    ASSERT_GT(swing.least_margin(sticks), 0.0);
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = 0.5 * (slips + sticks);
        (swing.least_margin(middle) > 0.0 ? sticks : slips) = middle;
    }
    ASSERT_GT(sticks, 0.3);
    for (int eighth = 0; eighth < 8; ++eighth) {
        const StuckState now = swing.at(0.25 * std::acos(-1.0) * eighth + 0.3);
        c.contact().static_friction = sticks * (1.0 + 1e-6);
        EXPECT_EQ(outlook_of_stick(model::rubbing_system(c), velocity_profile(c.drive), now).future, Future::sticks)
            << eighth;
        c.contact().static_friction = sticks * (1.0 - 1e-6);
        EXPECT_EQ(outlook_of_stick(model::rubbing_system(c), velocity_profile(c.drive), now).future, Future::releases)
            << eighth;
    }
}

TEST(Stick, OfASampledDriveIsUnknown) {
    Case c = support::seal_lip();
    c.drive.kind = parameters::DriveKind::sampled;
    c.drive.times = {0.0, c.run.duration};
    c.drive.velocities = {0.05, 0.05};
    EXPECT_EQ(at_rest(c).future, Future::unknown);
}

// a free vibration that could break the stick leaves it open
TEST(Stick, WithMuchVibrationLeftIsUnknown) {
    Case c = support::seal_lip();
    const model::Structure structure = model::rubbing_system(c);
    const Eigen::Vector3d shaken(0.05, -0.5, -0.5);
    EXPECT_EQ(outlook_of_stick(structure, velocity_profile(c.drive), {Eigen::Vector3d::Zero(), shaken, 0.05, 0.0, 0.0})
                  .future,
              Future::unknown);
}

// no free motion at all: the mass on a belt
TEST(Stick, WithoutFreeMotionsIsDecidedByTheDrive) {
    const model::Structure belt = model::mass_on_belt({});
    parameters::Drive drive;
    drive.kind = parameters::DriveKind::constant;
    drive.velocity = 0.1;
    const record::Outlook outlook = outlook_of_stick(
        belt, velocity_profile(drive), {Eigen::Vector2d::Zero(), Eigen::Vector2d(0.1, 0.0), 0.1, 0.0, 0.0});
    EXPECT_EQ(outlook.future, Future::releases);
}

// both engines say the same of the same end
TEST(Stick, IsForEverByBothEngines) {
    Case c = support::seal_lip();
    c.run.engine = parameters::Engine::beta_2;
    c.run.duration = c.run.window = 0.1;
    EXPECT_EQ(ending(c).outlook.future, Future::sticks);
}

}  // namespace
}  // namespace stridor::integration
