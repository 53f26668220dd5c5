// Moreau's time stepping: against the Taylor engine, against the same scheme of a prototype written apart from it
// (Gauss-Seidel instead of exchanges), and against invariances.

#include "support/effort.hpp"
#include "support/many_contacts.hpp"
#include "support/structures/rubber_strip.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace stridor {
namespace {

using integration::Motion;
using integration::Reason;
using model::PlateJoint;
using parameters::Initial;
using support::open_share;
using support::plate_joint;
using support::plate_of;
using support::run_moreau;
using support::run_taylor;
using support::shares;
using support::slip_share;
using support::stick_share;

model::Structure of_unequal_angles() {
    return plate_of({plate_joint(200.0, 0.2), plate_joint(200.0, 0.2, 60.0)});
}

model::Structure with_pile_ups() {
    return plate_of({plate_joint(100.0, 0.3), plate_joint(100.0, 0.3, 40.0)});
}

std::vector<double> sticks(const Motion& motion) {
    EXPECT_EQ(motion.outcome.reason, Reason::completed);
    std::vector<double> result;
    for (const auto& contact : shares(motion))
        result.push_back(contact[stick_share]);
    return result;
}

void expect_sticks(const Motion& motion, const std::vector<double>& wanted, double tolerance) {
    const std::vector<double> found = sticks(motion);
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t k = 0; k < wanted.size(); ++k)
        EXPECT_NEAR(found[k], wanted[k], tolerance) << "contact " << k;
}

// --- the same scheme, written apart: six digits

TEST(Moreau, HasTheSharesOfThePrototypeForOneContact) {
    const model::Structure one = plate_of({plate_joint(200.0, 0.2)});
    expect_sticks(run_moreau(one, -0.1, Initial::stuck, 4e-6), {0.299932}, 1e-6);
    if (support::is_checked_build) return;
    expect_sticks(run_moreau(one, -0.1, Initial::stuck, 1e-6), {0.297350}, 1e-6);
    expect_sticks(run_moreau(one, -0.1, Initial::stuck, 2.5e-7), {0.296954}, 1e-6);
}

TEST(Moreau, HasTheSharesOfThePrototypeForTwoJoints) {
    expect_sticks(run_moreau(of_unequal_angles(), -0.1, Initial::stuck, 1e-6), {0.521144, 0.424688}, 1e-6);
    if (support::is_checked_build) return;
    expect_sticks(run_moreau(of_unequal_angles(), -0.1, Initial::stuck, 2.5e-7), {0.521012, 0.424498}, 1e-6);
    const Motion piled = run_moreau(with_pile_ups(), 0.1, Initial::stuck, 1e-6);
    expect_sticks(piled, {0.424970, 0.116677}, 1e-6);
    EXPECT_NEAR(shares(piled)[0][open_share], 0.285790, 1e-6);
    std::vector<PlateJoint> joints{plate_joint(300.0, 0.3, 62.0), plate_joint(300.0, 0.3, 75.0)};
    for (PlateJoint& joint : joints)
        joint.contact.static_friction = 0.7;
    expect_sticks(run_moreau(plate_of(joints), -0.08, Initial::stuck, 2.5e-7), {0.457399, 0.586127}, 2e-6);
}

TEST(Moreau, HasTheMeanSharesOfTheStripOfRubber) {
    const support::RubberStrip strip =
        support::read_strip(STRIDOR_SOURCE_DIR "/tests/fixtures/structures/strip_s1.txt");
    const Motion motion = run_moreau(strip.structure, strip.velocity, strip.start, 1e-6, support::strip_watched);
    EXPECT_EQ(motion.outcome.reason, Reason::completed);
    double mean[3]{};
    for (const auto& contact : shares(motion))
        for (std::size_t state = 0; state < 3; ++state)
            mean[state] += contact[state] / 5.0;
    EXPECT_NEAR(mean[stick_share], 0.8339, support::strip_scatter);
    EXPECT_NEAR(mean[open_share], 0.0, 1e-4);
}

// --- against the engine without steps

// the start of a motion, before periods average: times of changes, of first order in the step
TEST(Moreau, ConvergesToTheEventsInFirstOrder) {
    const model::Structure structure = of_unequal_angles();
    const support::Watched watched{0.1, 0.05};
    const record::ContactHistory exact = run_taylor(structure, -0.1, Initial::stuck, watched).record.histories[0];
    for (const double step : {4e-6, 1e-6, 2.5e-7}) {
        const record::ContactHistory stepped =
            run_moreau(structure, -0.1, Initial::stuck, step, watched).record.histories[0];
        ASSERT_EQ(stepped.size(), exact.size());
        for (std::size_t n = 0; n < exact.size(); ++n) {
            EXPECT_EQ(stepped[n].state, exact[n].state);
            EXPECT_NEAR(stepped[n].from, exact[n].from, 6.0 * step) << "event " << n;
        }
    }
}

TEST(Moreau, BalancesItsEnergyInSecondOrder) {
    double before = 0.0;
    for (const double step : {4e-6, 1e-6, 2.5e-7}) {
        const Motion motion = run_moreau(of_unequal_angles(), -0.1, Initial::stuck, step, {0.2, 0.1});
        const double residual = std::abs(motion.energy.relative_residual());
        EXPECT_LT(residual, 2e-8 * (step * step) / 1e-12);
        if (before > 0.0) {
            EXPECT_LT(residual, before / 10.0);
        }
        before = residual;
    }
}

// --- Code_Aster's SDND106: 3000 N pull for 0.2 s

TEST(Moreau, SlipsAndSticksAsCodeAsterSays) {
    constexpr double step = 1e-5;  // [s]
    const auto run = [&](double pull, const integration::InitialState& start) {
        const parameters::Case c = support::watched_case(0.0, {0.21, 0.21});  // the last instant has no sample
        record::Request request{record::KeepHistory::yes, {}};
        request.trace = {.from = 0.0, .to = 0.21, .interval = 0.01};
        return integration::integrate_moreau(support::two_masses(pull), c.drive, start, {step},
                                             record::Recorder(record::schedule(c), request, 3, 1));
    };
    const Motion pulled = run(3000.0, {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()});
    ASSERT_EQ(pulled.record.histories[0].size(), 2U);
    EXPECT_NEAR(pulled.record.histories[0][1].from, 0.035124073655203626, 2.0 * step);
    const record::Trace& trace = pulled.record.trace;
    EXPECT_NEAR(trace.displacement[2][2], 0.1122103126407706, 1e-4 * 0.11);
    EXPECT_NEAR(trace.displacement[0][15], 1.3533376608928975, 1e-4 * 1.35);
    EXPECT_NEAR(trace.displacement[2][15], 1.8075324661759522, 1e-4 * 1.81);
    EXPECT_NEAR(trace.displacement[0][20], 2.593088362758737, 1e-4 * 2.59);
    EXPECT_NEAR(trace.velocity[0][20], 25.4709724805942, 1e-4 * 25.5);
    integration::InitialState let_go{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    for (std::size_t dof = 0; dof < 3; ++dof) {
        let_go.displacement(static_cast<Eigen::Index>(dof)) = trace.displacement[dof][20];
        let_go.velocity(static_cast<Eigen::Index>(dof)) = trace.velocity[dof][20];
    }
    const Motion free = run(0.0, let_go);
    EXPECT_NEAR(0.2 + free.record.histories[0][1].from, 0.3149232754474865, 2.0 * step);
    EXPECT_NEAR(free.record.trace.displacement[0][20], 3.9556057734976036, 1e-4 * 3.96);
}

// --- invariances

TEST(Moreau, HasTheSameBitsInAnyOrderOfContacts) {
    model::Structure structure =
        plate_of({plate_joint(100.0, 0.3), plate_joint(100.0, 0.3, 40.0), plate_joint(60.0, 0.3, 110.0)});
    const Motion motion = run_moreau(structure, 0.1, Initial::stuck, 1e-6, {0.3, 0.2});
    std::rotate(structure.contacts.begin(), structure.contacts.begin() + 1, structure.contacts.end());
    const Motion rotated = run_moreau(structure, 0.1, Initial::stuck, 1e-6, {0.3, 0.2});
    EXPECT_EQ(motion.energy.friction_loss, rotated.energy.friction_loss);
    for (std::size_t k = 0; k < 3; ++k) {
        const record::ContactHistory& found = rotated.record.histories[k];
        const record::ContactHistory& wanted = motion.record.histories[(k + 1) % 3];
        ASSERT_EQ(found.size(), wanted.size());
        ASSERT_GT(found.size(), 10U);
        for (std::size_t n = 0; n < wanted.size(); ++n) {
            ASSERT_EQ(found[n].from, wanted[n].from);
            ASSERT_EQ(found[n].slip_velocity, wanted[n].slip_velocity);
        }
    }
}

TEST(Moreau, HasTheSameBitsWithForceAndVelocityDoubled) {
    const std::vector<PlateJoint> joints{plate_joint(100.0, 0.3), plate_joint(100.0, 0.3, 40.0)};
    std::vector<PlateJoint> doubled = joints;
    for (PlateJoint& joint : doubled)
        joint.contact.preload *= 2.0;
    const Motion motion = run_moreau(plate_of(joints), 0.1, Initial::stuck, 1e-6, {0.3, 0.2});
    const Motion twice = run_moreau(plate_of(doubled), 0.2, Initial::stuck, 1e-6, {0.3, 0.2});
    EXPECT_EQ(twice.energy.friction_loss, 4.0 * motion.energy.friction_loss);
    for (std::size_t k = 0; k < 2; ++k) {
        ASSERT_EQ(twice.record.histories[k].size(), motion.record.histories[k].size());
        for (std::size_t n = 0; n < motion.record.histories[k].size(); ++n) {
            ASSERT_EQ(twice.record.histories[k][n].from, motion.record.histories[k][n].from);
            ASSERT_EQ(twice.record.histories[k][n].slip_velocity, 2.0 * motion.record.histories[k][n].slip_velocity);
        }
    }
}

TEST(Moreau, KeepsEqualJointsEqual) {
    const Motion motion =
        run_moreau(plate_of({plate_joint(20.0, 0.6), plate_joint(20.0, 0.6)}), 0.1, Initial::rest, 1e-6, {1.0, 0.5});
    for (const auto& contact : shares(motion))
        EXPECT_EQ(contact[slip_share], 1.0);
    const record::ContactHistory& first = motion.record.histories[0];
    ASSERT_EQ(first.size(), motion.record.histories[1].size());
    ASSERT_GT(first.size(), 4U);
    EXPECT_NEAR(first[1].from, 0.00461460347, 2e-6);
    for (std::size_t n = 0; n < first.size(); ++n)
        EXPECT_EQ(first[n].from, motion.record.histories[1][n].from);
}

// --- what it refuses

TEST(Moreau, RefusesPainlevesConfigurationWhereItOccurs) {
    const support::Watched watched{20.0, 10.0};
    const auto run = [&](double kinetic_friction, double velocity) {
        return run_moreau(support::painleve_example(kinetic_friction), velocity, Initial::rest, 1e-4, watched);
    };
    const Motion refused = run(1.3, 0.1);
    EXPECT_EQ(refused.outcome.reason, Reason::painleve);
    EXPECT_EQ(refused.pressed, std::vector<std::size_t>{0});
    EXPECT_EQ(refused.outcome.time, 0.0);
    const Motion sliding = run(1.3, -0.1);
    EXPECT_EQ(sliding.outcome.reason, Reason::completed);
    EXPECT_EQ(shares(sliding).front()[slip_share], 1.0);
    EXPECT_EQ(run(1.2, 0.1).outcome.reason, Reason::completed);
}

TEST(Moreau, RefusesAStepOfMoreThanHalfAPeriodOfTheFastestMode) {
    const model::Structure structure = of_unequal_angles();
    const double longest = integration::longest_step(integration::modal_structure(structure));
    EXPECT_EQ(run_moreau(structure, -0.1, Initial::stuck, 1.01 * longest).outcome.reason, Reason::step_limit);
    EXPECT_EQ(run_moreau(structure, -0.1, Initial::stuck, 0.9 * longest).outcome.reason, Reason::completed);
}

}  // namespace
}  // namespace stridor
