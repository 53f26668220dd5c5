// Friction in a plane: the circular cone of contacts with two tangents, by time steps. Closed forms of a block on a
// plane, and invariances.

#include "stridor/base/error.hpp"
#include "support/many_contacts.hpp"
#include "support/structures/blocks_on_plane.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace stridor {
namespace {

using Eigen::Vector3d;
using integration::InitialState;
using integration::Motion;
using integration::Reason;
using support::block_on_plane;
using support::BlockOnPlane;
using support::coupled_blocks;

constexpr double plane_step = 1e-5;  // [s]

// samples at each `interval` [s] over a surface of velocity V
Motion run_plane(const model::Structure& structure, double velocity, const InitialState& start, double duration,
                 double interval, double h = plane_step) {
    const parameters::Case c = support::watched_case(velocity, {duration, duration});
    record::Request request{record::KeepHistory::yes, {}};
    request.trace = {.from = 0.0, .to = duration, .interval = interval};
    return integration::integrate_moreau(structure, c.drive, start, {h},
                                         record::Recorder(record::schedule(c), request, model::dofs_of(structure),
                                                          static_cast<int>(structure.contacts.size())));
}

// a pull of 6 N along x and 8 N along y against 3 N of friction: it slips along the pull from the first step on
TEST(Cone, BlockSlipsAlongAnObliquePull) {
    const model::Structure block = block_on_plane({.pull_x = 6.0, .pull_y = 8.0}, {0.4, 0.3}, 0.7);
    const Motion motion = run_plane(block, 0.0, {Vector3d::Zero(), Vector3d::Zero()}, 0.5, 0.1);
    EXPECT_EQ(motion.outcome.reason, Reason::completed);
    const double acceleration = (10.0 - 0.3 * 10.0) / 2.0;
    for (std::size_t n = 1; n < motion.record.trace.time.size(); ++n) {
        const double t = motion.record.trace.time[n];
        EXPECT_NEAR(motion.record.trace.displacement[0][n], 0.6 * 0.5 * acceleration * t * t, 1e-10);
        EXPECT_NEAR(motion.record.trace.displacement[1][n], 0.8 * 0.5 * acceleration * t * t, 1e-10);
        EXPECT_EQ(motion.record.trace.contacts[0].state[n], model::ContactState::slip);
    }
    EXPECT_LT(std::abs(motion.energy.relative_residual()), 1e-10);
}

// each component of the pull is below the limit of 4 N, and a pyramid would hold it: the circle of 4 N does not
TEST(Cone, LimitIsACircle) {
    for (const auto& [pull, holds] : std::vector<std::pair<double, bool>>{{2.82, true}, {2.84, false}}) {
        const model::Structure block = block_on_plane({.pull_x = pull, .pull_y = pull}, {0.4, 0.4});
        const Motion motion = run_plane(block, 0.0, {Vector3d::Zero(), Vector3d::Zero()}, 0.1, 0.0);
        EXPECT_EQ(support::shares(motion)[0][support::stick_share], holds ? 1.0 : 0.0) << pull;
    }
}

// thrown with 0.5 m/s: it stops on a straight line after v/(mu g), and sticks
TEST(Cone, ThrownBlockStopsOnAStraightLine) {
    const model::Structure block = block_on_plane({}, {0.4, 0.3}, -1.1);
    const Motion motion = run_plane(block, 0.0, {Vector3d::Zero(), Vector3d(0.3, -0.4, 0.0)}, 0.5, 0.02);
    const double slowing = 0.3 * 10.0 / 2.0;
    const record::ContactHistory& history = motion.record.histories[0];
    ASSERT_EQ(history.size(), 2U);
    EXPECT_EQ(history[0].state, model::ContactState::slip);
    EXPECT_NEAR(history[0].slip_velocity, 0.5, 1e-12);
    EXPECT_NEAR(history[1].from, 0.5 / slowing, 2.0 * plane_step);
    EXPECT_EQ(history[1].state, model::ContactState::stick);
    const record::Trace& trace = motion.record.trace;
    for (std::size_t n = 0; n < trace.time.size(); ++n)
        EXPECT_NEAR(trace.displacement[0][n] * -4.0, trace.displacement[1][n] * 3.0, 1e-12);
    EXPECT_NEAR(trace.displacement[0].back(), 0.6 * 0.5 * 0.25 / slowing, 1e-5);
    EXPECT_NEAR(motion.energy.friction_loss, 0.25, 1e-5);  // all of m v²/2
}

// on a moving belt the velocity relative to it is what friction is against: along a straight line in the belt's frame
TEST(Cone, FrictionIsAgainstTheVelocityRelativeToTheBelt) {
    const model::Structure block = block_on_plane({}, {0.4, 0.3}, 0.2);
    const Motion motion = run_plane(block, 0.4, {Vector3d::Zero(), Vector3d(0.0, 0.3, 0.0)}, 0.3, 0.01);
    const record::Trace& trace = motion.record.trace;
    for (std::size_t n = 0; n < trace.time.size(); ++n) {
        const double left = std::max(0.0, 0.5 - 1.5 * trace.time[n]);  // [m/s] of w, which keeps its direction
        EXPECT_NEAR(trace.velocity[0][n] - 0.4, -0.8 * left, 1e-10 + 2.0 * 1.5 * plane_step);
        EXPECT_NEAR(trace.velocity[1][n], 0.6 * left, 1e-10 + 2.0 * 1.5 * plane_step);
        if (left < 1e-3) continue;
        // T = -mu_d N w/|w|, at right angles to nothing but w's normal
        const double c = std::cos(0.2), s = std::sin(0.2);
        EXPECT_NEAR(trace.contacts[0].friction_force[n], -3.0 * (-0.8 * c + 0.6 * s), 1e-9);
    }
}

// unequal springs make curves of the slips: two directions that turn all the time
const BlockOnPlane curving{.mass = 2.0, .along_x = 200.0, .along_y = 900.0, .preload = 10.0};

TEST(Cone, TurnedTangentsChangeNothing) {
    const InitialState start{Vector3d(0.0, 0.015, 0.0), Vector3d(0.02, -0.1, 0.0)};
    const Motion straight = run_plane(block_on_plane(curving, {0.6, 0.4}), 0.05, start, 2.0, 0.01);
    for (const double turn : {0.3, 1.2, 2.9}) {
        const Motion turned = run_plane(block_on_plane(curving, {0.6, 0.4}, turn), 0.05, start, 2.0, 0.01);
        ASSERT_EQ(turned.record.histories[0].size(), straight.record.histories[0].size());
        EXPECT_GT(turned.record.histories[0].size(), 2U);
        for (std::size_t n = 0; n < straight.record.trace.time.size(); ++n)
            for (std::size_t dof = 0; dof < 2; ++dof)
                EXPECT_NEAR(turned.record.trace.displacement[dof][n], straight.record.trace.displacement[dof][n],
                            1e-10);
    }
}

TEST(Cone, TurnedTangentsOfCoupledContactsChangeNothing) {
    const InitialState start{Eigen::VectorXd::Zero(9), Eigen::VectorXd::Zero(9)};
    const Motion straight = run_plane(coupled_blocks({0.0, 0.0, 0.0}), 0.01, start, 0.6, 0.005);
    const Motion turned = run_plane(coupled_blocks({0.4, -1.3, 2.2}), 0.01, start, 0.6, 0.005);
    EXPECT_EQ(straight.outcome.reason, Reason::completed);
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_GT(straight.record.histories[k].size(), 3U);
        ASSERT_EQ(turned.record.histories[k].size(), straight.record.histories[k].size());
        for (std::size_t n = 0; n < straight.record.histories[k].size(); ++n)
            EXPECT_EQ(turned.record.histories[k][n].from, straight.record.histories[k][n].from);
    }
    for (std::size_t n = 0; n < straight.record.trace.time.size(); ++n)
        for (std::size_t dof = 0; dof < 9; ++dof)
            EXPECT_NEAR(turned.record.trace.displacement[dof][n], straight.record.trace.displacement[dof][n], 1e-9);
}

// a second direction in which nothing moves changes nothing
TEST(Cone, IsTheLawOfOneTangentWhereTheOtherStandsStill) {
    const model::Structure one =
        support::plate_of({support::plate_joint(200.0, 0.2), support::plate_joint(150.0, 0.3, 60.0)});
    const Eigen::Index dofs = model::dofs_of(one);
    model::Structure two = model::structure_of_size(static_cast<int>(dofs) + 2, 2);
    two.mass.setIdentity();
    two.mass.topLeftCorner(dofs, dofs) = one.mass;
    two.stiffness = 1e5 * Eigen::MatrixXd::Identity(dofs + 2, dofs + 2);
    two.stiffness.topLeftCorner(dofs, dofs) = one.stiffness;
    two.damping.topLeftCorner(dofs, dofs) = one.damping;
    two.load.head(dofs) = one.load;
    for (std::size_t k = 0; k < 2; ++k) {
        two.contacts[k].normal.head(dofs) = one.contacts[k].normal;
        two.contacts[k].tangent.head(dofs) = one.contacts[k].tangent;
        two.contacts[k].second_tangent = Eigen::VectorXd::Zero(dofs + 2);
        two.contacts[k].second_tangent(dofs + static_cast<Eigen::Index>(k)) = 1.0;
        two.contacts[k].friction = one.contacts[k].friction;
    }
    const support::Watched watched{0.05, 0.05};
    const Motion wanted = support::run_moreau(one, -0.1, parameters::Initial::stuck, 1e-6, watched);
    const Motion found = support::run_moreau(two, -0.1, parameters::Initial::stuck, 1e-6, watched);
    for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_GT(wanted.record.histories[k].size(), 10U);
        ASSERT_EQ(found.record.histories[k].size(), wanted.record.histories[k].size());
        for (std::size_t n = 0; n < wanted.record.histories[k].size(); ++n) {
            EXPECT_EQ(found.record.histories[k][n].state, wanted.record.histories[k][n].state);
            EXPECT_NEAR(found.record.histories[k][n].from, wanted.record.histories[k][n].from, 1e-12);
        }
    }
}

TEST(Cone, BalancesItsEnergy) {
    const InitialState start{Vector3d(0.1, 0.05, 0.0), Vector3d(0.2, -0.6, 0.0)};
    const Motion block = run_plane(block_on_plane(curving, {0.6, 0.4}), 0.3, start, 2.0, 0.0);
    EXPECT_LT(std::abs(block.energy.relative_residual()), 1e-6);
    const InitialState rest{Eigen::VectorXd::Zero(9), Eigen::VectorXd::Zero(9)};
    double before = 0.0;
    for (const double h : {4e-5, 1e-5, 2.5e-6}) {
        const Motion coupled = run_plane(coupled_blocks({0.4, -1.3, 2.2}), 0.2, rest, 0.3, 0.0, h);
        const double residual = std::abs(coupled.energy.relative_residual());
        EXPECT_LT(residual, 1e-4);
        if (before > 0.0) {
            EXPECT_LT(residual, before / 3.0);
        }
        before = residual;
    }
}

// a shaken block: where nothing slips it swings as an oscillator does, and the work of the force is in the balance
TEST(Cone, ForceShakesAFreeBlock) {
    model::Structure block = block_on_plane({.mass = 2.0, .along_x = 800.0, .along_y = 800.0}, {0.0, 0.0});
    block.shaken = Vector3d(1.0, 0.5, 0.0);
    parameters::Case c = support::watched_case(0.0, {2.0, 1.0});
    c.drive.kind = parameters::DriveKind::force;
    c.drive.force = 4.0;
    c.drive.frequency = 2.0;
    c.drive.ramp = 1e-9;
    record::Request request;
    request.trace = {.from = 0.0, .to = 2.0, .interval = 0.05};
    const Motion motion = integration::integrate_moreau(block, c.drive, {Vector3d::Zero(), Vector3d::Zero()}, {1e-4},
                                                        record::Recorder(record::schedule(c), request, 3, 1));
    const double omega = 4.0 * std::acos(-1.0), own = 20.0;
    const double swing = 4.0 / 2.0 / (own * own - omega * omega);
    const record::Trace& trace = motion.record.trace;
    ASSERT_GT(trace.time.size(), 30U);
    for (std::size_t n = 0; n < trace.time.size(); ++n) {
        const double t = trace.time[n];
        EXPECT_NEAR(trace.displacement[0][n], swing * (std::cos(omega * t) - std::cos(own * t)), 1e-7);
        EXPECT_NEAR(trace.displacement[1][n], 0.5 * trace.displacement[0][n], 1e-12);
    }
    EXPECT_LT(std::abs(motion.energy.relative_residual()), 1e-10);
}

std::string plane_refusal(const model::Structure& structure, bool by_events) {
    try {
        const InitialState start{Vector3d::Zero(), Vector3d::Zero()};
        if (by_events)
            support::run_taylor(structure, 0.1, start);
        else
            support::run_moreau(structure, 0.1, start, 1e-5);
    } catch (const Error& error) {
        return error.problem().what + "; " + error.problem().why;
    }
    return "";
}

TEST(Cone, IsRefusedByNameWhereItIsNotKnown) {
    EXPECT_EQ(plane_refusal(block_on_plane({}, {0.4, 0.3}), true),
              "the Taylor engine knows one direction of slip; its events, or the trial of its steps, are of one");
    model::Structure shaken = support::painleve_example(0.3);
    shaken.shaken = Eigen::Vector2d(1.0, 0.0);
    EXPECT_NE(plane_refusal(shaken, true).find("knows no drive by force"), std::string::npos);
    model::Structure directional = block_on_plane({}, {0.4, 0.3});
    directional.contacts.front().friction = model::Directional{};
    EXPECT_NE(plane_refusal(directional, false).find("circular cone"), std::string::npos);
}

}  // namespace
}  // namespace stridor
