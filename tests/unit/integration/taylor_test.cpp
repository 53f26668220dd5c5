#include "stridor/integration/series/taylor.hpp"

#include "stridor/base/error.hpp"
#include "stridor/integration/exact/exact.hpp"
#include "stridor/integration/modal/modal_structure.hpp"
#include "support/many_contacts.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

namespace stridor::integration {
namespace {

using parameters::Initial;
using support::plate_joint;

model::Structure one_joint() {
    return model::joints_on_plate(std::array{plate_joint(200.0, 0.2)}, {});
}

Motion run_case(const parameters::Case& c, const record::Request& request) {
    const model::Structure structure = one_joint();
    return integrate_taylor(structure, c.drive, initial_state(structure, {Initial::rest, 0.0}, 0.0), {},
                            record::Recorder(record::schedule(c), request, model::dofs_of(structure)));
}

void expect_events_of_exact(const parameters::Case& c) {
    record::Request request;
    request.history = record::KeepHistory::yes;
    const model::Structure structure = one_joint();
    const Motion exact = integrate_exact(structure, c.drive, {Initial::rest, 0.0}, {},
                                         record::Recorder(record::schedule(c), request, model::dofs_of(structure)));
    const Motion motion = run_case(c, request);
    ASSERT_EQ(motion.outcome.reason, Reason::completed);
    const record::ContactHistory& found = motion.record.histories.front();
    const record::ContactHistory& wanted = exact.record.histories.front();
    ASSERT_EQ(found.size(), wanted.size());
    ASSERT_GT(found.size(), 100U);
    for (std::size_t n = 0; n < wanted.size(); ++n) {
        ASSERT_EQ(found[n].state, wanted[n].state) << "event " << n;
        ASSERT_NEAR(found[n].from, wanted[n].from, 1e-9) << "event " << n;
    }
    const record::Tally& heard = motion.record.phases.front();
    const record::Tally& known = exact.record.phases.front();
    for (std::size_t dof = 0; dof < heard.vibration.size(); ++dof)
        EXPECT_NEAR(heard.vibration[dof].square_time, known.vibration[dof].square_time,
                    1e-6 * known.vibration[dof].square_time);
}

TEST(Taylor, FollowsASinusoidalDriveAsTheExactEngine) {
    parameters::Case c;
    c.run.duration = c.run.window = 0.4;
    expect_events_of_exact(c);
}

TEST(Taylor, FollowsASampledDriveAsTheExactEngine) {
    parameters::Case c;
    c.drive.kind = parameters::DriveKind::sampled;
    c.drive.times = {0.0, 0.1, 0.25, 0.4};
    c.drive.velocities = {0.0, 0.1, -0.1, 0.05};
    c.run.duration = c.run.window = 0.3;  // small differences grow tenfold each 10 ms after it
    expect_events_of_exact(c);
}

TEST(Taylor, IsNotMovedByBeingSampled) {
    const parameters::Case c = support::watched_case(0.1, {0.2, 0.1});
    record::Request request;
    request.history = record::KeepHistory::yes;
    const Motion plain = run_case(c, request);
    request.trace = {0.0, 0.2, 1e-5};
    const Motion sampled = run_case(c, request);
    EXPECT_EQ(sampled.record.trace.time.size(), 20001U);
    const record::ContactHistory& a = plain.record.histories.front();
    const record::ContactHistory& b = sampled.record.histories.front();
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t n = 0; n < a.size(); ++n)
        EXPECT_EQ(a[n].from, b[n].from);
    // what it shows obeys the laws
    const record::ContactTrace& contact = sampled.record.trace.contacts.front();
    for (std::size_t n = 0; n < contact.state.size(); ++n) {
        EXPECT_GE(contact.gap[n], 0.0);
        EXPECT_LE(std::abs(contact.friction_force[n]), 0.8 * contact.normal_force[n] * (1.0 + 1e-9));
    }
}

// a block that hangs above the surface meets it where free fall on its spring says
TEST(Taylor, BeginsWithAnOpenContact) {
    model::Structure structure = model::structure_of_size(2);
    structure.mass.setIdentity();
    structure.stiffness.setIdentity();
    model::ContactPoint& contact = structure.contacts.front();
    contact.normal << 0.0, 1.0;
    contact.tangent << 1.0, 0.0;
    contact.initial_gap = 0.5;
    contact.friction = model::Coulomb{0.8, 0.5};
    structure.load << 0.0, -1.0;
    // y = cos t - 1 = -1/2 at t = pi/3
    const Motion motion =
        support::run_taylor(structure, 0.1, {Eigen::VectorXd::Zero(2), Eigen::VectorXd::Zero(2)}, {3.0, 3.0});
    ASSERT_EQ(motion.outcome.reason, Reason::completed);
    const record::ContactHistory& history = motion.record.histories.front();
    EXPECT_EQ(history[0].state, model::ContactState::separation);
    EXPECT_NEAR(history[1].from, std::acos(0.5), 1e-14);
    EXPECT_NE(history[1].state, model::ContactState::separation);
}

TEST(Taylor, RefusesOtherImpactsByName) {
    model::Structure structure = one_joint();
    structure.contacts.front().impact = model::Restitution{0.5};
    try {
        support::run_taylor(structure, 0.1, Initial::rest);
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("the Taylor engine knows plastic impacts only"), std::string::npos);
    }
}

TEST(ModalStructure, RefusesMassesThatAreNone) {
    model::Structure structure = one_joint();
    structure.mass(0, 0) = 0.0;
    EXPECT_THROW(modal_structure(structure), Error);
    structure = one_joint();
    structure.stiffness(0, 1) += 1e5;
    EXPECT_THROW(modal_structure(structure), Error);
}

}  // namespace
}  // namespace stridor::integration
