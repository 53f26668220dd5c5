// The Taylor engine: one contact against the exact engine, several against closed forms, against numbers of a prototype
// written apart from it (an event-driven solver and a time stepping that agree), and against invariances.

#include "support/many_contacts.hpp"

#include "stridor/integration/exact/exact.hpp"
#include "stridor/model/built/bowed_string.hpp"
#include "stridor/model/built/chain_on_belt.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace stridor {
namespace {

using integration::Motion;
using integration::Reason;
using model::ContactState;
using model::PlateJoint;
using parameters::Initial;
using support::expect_sound;
using support::open_share;
using support::plate_joint;
using support::plate_of;
using support::run_taylor;
using support::shares;
using support::slip_share;
using support::stick_share;

struct ExpectedShares {
    double stick, slip, separation;
};

void expect_shares(const Motion& motion, const std::vector<ExpectedShares>& wanted, double tolerance) {
    expect_sound(motion);
    const auto found = shares(motion);
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t k = 0; k < wanted.size(); ++k) {
        EXPECT_NEAR(found[k][stick_share], wanted[k].stick, tolerance) << "contact " << k;
        EXPECT_NEAR(found[k][slip_share], wanted[k].slip, tolerance) << "contact " << k;
        EXPECT_NEAR(found[k][open_share], wanted[k].separation, tolerance) << "contact " << k;
    }
}

// --- one contact: event by event as the exact engine

struct OneContact {
    const char* name;
    double preload, kinetic_friction, velocity;
    double until;  // [s] chaos takes over from there
    double tolerance;
};

class OneContactTest : public testing::TestWithParam<OneContact> {};

TEST_P(OneContactTest, HasTheEventsOfTheExactEngine) {
    const OneContact& one = GetParam();
    const model::Structure structure = plate_of({plate_joint(one.preload, one.kinetic_friction)});
    const Motion motion = run_taylor(structure, one.velocity, Initial::stuck);
    expect_sound(motion);
    const parameters::Case c = support::watched_case(one.velocity, {});
    record::Request request;
    request.history = record::KeepHistory::yes;
    const Motion exact = integration::integrate_exact(
        structure, c.drive, {Initial::stuck, 0.0}, {.early_ending = parameters::EarlyEnding::never},
        record::Recorder(record::schedule(c), request, model::dofs_of(structure)));
    const record::ContactHistory& found = motion.record.histories.front();
    const record::ContactHistory& wanted = exact.record.histories.front();
    std::size_t events = 0;
    for (; events < wanted.size() && wanted[events].from < one.until; ++events) {
        ASSERT_LT(events, found.size());
        ASSERT_EQ(found[events].state, wanted[events].state) << "event " << events;
        ASSERT_NEAR(found[events].from, wanted[events].from, one.tolerance) << "event " << events;
    }
    EXPECT_GT(events, 40U);
}

INSTANTIATE_TEST_SUITE_P(Table1, OneContactTest,
                         testing::Values(OneContact{"F20_mud02", 20.0, 0.2, 0.1, 2.0, 1e-9},
                                         OneContact{"F20_mud06", 20.0, 0.6, 0.1, 2.0, 1e-9},
                                         OneContact{"F200", 200.0, 0.2, 0.1, 2.0, 1e-9},
                                         OneContact{"F200_coming", 200.0, 0.2, -0.1, 2.0, 1e-11},
                                         OneContact{"F2000_coming", 2000.0, 0.2, -0.1, 2.0, 1e-11},
                                         OneContact{"F2000_chaotic", 2000.0, 0.2, 0.1, 0.115, 1e-8}),
                         [](const auto& each) { return std::string(each.param.name); });

// --- two joints on one plate

TEST(TwoJoints, OfUnequalAnglesLockAtOnePeriod) {
    const Motion motion =
        run_taylor(plate_of({plate_joint(200.0, 0.2), plate_joint(200.0, 0.2, 60.0)}), -0.1, Initial::stuck);
    expect_shares(motion, {{0.521001, 0.478999, 0.0}, {0.424485, 0.575515, 0.0}}, 1e-6);
    // two slips of each contact per period
    const std::vector<std::vector<double>> between{{2.40150757e-3, 2.83695265e-3}, {2.54040611e-3, 2.69805412e-3}};
    for (std::size_t k = 0; k < 2; ++k) {
        std::vector<double> begins;
        for (const record::ContactInterval& interval : motion.record.histories[k])
            if (interval.state == ContactState::slip && interval.from > 1.0) begins.push_back(interval.from);
        ASSERT_GT(begins.size(), 300U);
        std::vector<double> steps;
        for (std::size_t n = 0; n + 2 < begins.size(); ++n) {
            EXPECT_NEAR(begins[n + 2] - begins[n], 5.23846022e-3, 1e-8);
            steps.push_back(begins[n + 1] - begins[n]);
        }
        EXPECT_NEAR(*std::min_element(steps.begin(), steps.end()), between[k][0], 1e-8);
        EXPECT_NEAR(*std::max_element(steps.begin(), steps.end()), between[k][1], 1e-8);
    }
}

TEST(TwoJoints, PileUpsOfImpactsHaveALimit) {
    const Motion motion =
        run_taylor(plate_of({plate_joint(100.0, 0.3), plate_joint(100.0, 0.3, 40.0)}), 0.1, Initial::stuck);
    expect_shares(motion, {{0.424864, 0.287752, 0.287384}, {0.116211, 0.809442, 0.074346}}, 1e-6);
}

TEST(TwoJoints, HaveTheSharesOfThePrototype) {
    expect_shares(run_taylor(plate_of({plate_joint(20.0, 0.6), plate_joint(20.0, 0.6, 110.0)}), 0.1, Initial::rest),
                  {{0.212435, 0.075410, 0.712154}, {0.0, 0.073474, 0.926526}}, 2e-6);
    expect_shares(run_taylor(plate_of({plate_joint(20.0, 0.6), plate_joint(20.0, 0.6, 60.0)}), 0.1, Initial::rest),
                  {{0.0171, 0.352, 0.631}, {0.0, 0.384, 0.616}}, 1e-3);
    std::vector<PlateJoint> joints{plate_joint(300.0, 0.3, 62.0), plate_joint(300.0, 0.3, 75.0)};
    for (PlateJoint& joint : joints)
        joint.contact.static_friction = 0.7;
    expect_shares(run_taylor(plate_of(joints), -0.08, Initial::stuck),
                  {{0.45738, 0.54262, 0.0}, {0.58604, 0.41396, 0.0}}, 1e-5);
    // chaotic: a hundred slips in the window
    joints = {plate_joint(2000.0, 0.2), plate_joint(2000.0, 0.2, 80.0)};
    joints[1].joint.mass = 0.2;
    expect_shares(run_taylor(plate_of(joints), -0.1, Initial::stuck), {{0.895, 0.105, 0.0}, {0.919, 0.081, 0.0}}, 0.01);
    joints = {plate_joint(150.0, 0.25, 40.0), plate_joint(60.0, 0.25, 110.0)};
    for (PlateJoint& joint : joints)
        joint.contact.static_friction = 0.6;
    expect_shares(run_taylor(plate_of(joints), 0.2, Initial::stuck), {{0.0, 1.0, 0.0}, {0.0, 1.0, 0.0}}, 0.0);
}

// one such joint squeals on this plate; two lift off at the same instant and slip for ever
TEST(TwoJoints, ThatAreEqualStayEqual) {
    const Motion motion = run_taylor(plate_of({plate_joint(20.0, 0.6), plate_joint(20.0, 0.6)}), 0.1, Initial::rest);
    expect_shares(motion, {{0.0, 1.0, 0.0}, {0.0, 1.0, 0.0}}, 0.0);
    const record::ContactHistory& first = motion.record.histories[0];
    const record::ContactHistory& second = motion.record.histories[1];
    ASSERT_EQ(first.size(), second.size());
    ASSERT_GT(first.size(), 4U);
    EXPECT_NEAR(first[1].from, 0.00461460347, 1e-11);
    for (std::size_t n = 0; n < first.size(); ++n) {
        EXPECT_EQ(first[n].state, second[n].state);
        EXPECT_NEAR(first[n].from, second[n].from, 1e-12);
    }
}

// --- invariances

// two structures in one, that do not touch each other
model::Structure beside(const model::Structure& a, const model::Structure& b) {
    const int first = model::dofs_of(a);
    const int second = model::dofs_of(b);
    model::Structure both = model::structure_of_size(first + second, 0);
    const auto join = [&](Eigen::MatrixXd& to, const Eigen::MatrixXd& x, const Eigen::MatrixXd& y) {
        to.topLeftCorner(first, first) = x;
        to.bottomRightCorner(second, second) = y;
    };
    join(both.mass, a.mass, b.mass);
    join(both.damping, a.damping, b.damping);
    join(both.stiffness, a.stiffness, b.stiffness);
    both.load << a.load, b.load;
    for (const auto& [part, offset] : {std::pair(&a, 0), std::pair(&b, first)})
        for (model::ContactPoint contact : part->contacts) {
            Eigen::VectorXd row = Eigen::VectorXd::Zero(first + second);
            row.segment(offset, contact.normal.size()) = contact.normal;
            contact.normal = row;
            row.setZero();
            row.segment(offset, contact.tangent.size()) = contact.tangent;
            contact.tangent = row;
            both.contacts.push_back(contact);
        }
    return both;
}

TEST(ManyContacts, OfTwoPartsThatDoNotTouchMoveAsEachAlone) {
    const model::Structure one = plate_of({plate_joint(20.0, 0.6)});
    model::Structure two = plate_of({plate_joint(200.0, 0.2)});
    two.contacts.front().drive_share = -1.0;
    const Motion pair = run_taylor(beside(one, two), 0.1, Initial::stuck);
    expect_sound(pair);
    std::size_t k = 0;
    for (const model::Structure* single : std::array<const model::Structure*, 2>{&one, &two}) {
        const Motion alone = run_taylor(*single, 0.1, Initial::stuck);
        const record::ContactHistory& found = pair.record.histories[k++];
        const record::ContactHistory& wanted = alone.record.histories.front();
        ASSERT_EQ(found.size(), wanted.size());
        for (std::size_t n = 0; n < wanted.size(); ++n) {
            ASSERT_EQ(found[n].state, wanted[n].state);
            ASSERT_NEAR(found[n].from, wanted[n].from, 1e-11) << "event " << n;
        }
    }
}

TEST(ManyContacts, HaveTheSameBitsInAnyOrder) {
    model::Structure structure =
        plate_of({plate_joint(100.0, 0.3), plate_joint(100.0, 0.3, 40.0), plate_joint(60.0, 0.3, 110.0)});
    const Motion motion = run_taylor(structure, 0.1, Initial::stuck, {0.3, 0.2});
    std::rotate(structure.contacts.begin(), structure.contacts.begin() + 1, structure.contacts.end());
    const Motion rotated = run_taylor(structure, 0.1, Initial::stuck, {0.3, 0.2});
    for (std::size_t k = 0; k < 3; ++k) {
        const record::ContactHistory& found = rotated.record.histories[k];
        const record::ContactHistory& wanted = motion.record.histories[(k + 1) % 3];
        ASSERT_EQ(found.size(), wanted.size());
        for (std::size_t n = 0; n < wanted.size(); ++n)
            ASSERT_EQ(found[n].from, wanted[n].from);
    }
}

TEST(ManyContacts, HaveTheSameBitsWithForceAndVelocityDoubled) {
    const std::vector<PlateJoint> joints{plate_joint(100.0, 0.3), plate_joint(100.0, 0.3, 40.0)};
    std::vector<PlateJoint> doubled = joints;
    for (PlateJoint& joint : doubled)
        joint.contact.preload *= 2.0;
    const Motion motion = run_taylor(plate_of(joints), 0.1, Initial::stuck, {0.3, 0.2});
    const Motion twice = run_taylor(plate_of(doubled), 0.2, Initial::stuck, {0.3, 0.2});
    for (std::size_t k = 0; k < 2; ++k) {
        ASSERT_EQ(twice.record.histories[k].size(), motion.record.histories[k].size());
        for (std::size_t n = 0; n < motion.record.histories[k].size(); ++n)
            ASSERT_EQ(twice.record.histories[k][n].from, motion.record.histories[k][n].from);
    }
}

// --- Painleve's configuration: n = (0, 1), t = (1, 0), W_nn + mu_d W_nt < 0 for mu_d > 1.25 and V > 0

Motion painleve_run(double kinetic_friction, double velocity) {
    const model::Structure structure = support::painleve_example(kinetic_friction);
    return run_taylor(structure, velocity, Initial::rest, {20.0, 10.0});
}

TEST(ManyContacts, RefusePainlevesConfigurationWhereItOccurs) {
    const Motion refused = painleve_run(1.3, 0.1);
    EXPECT_EQ(refused.outcome.reason, Reason::painleve);
    EXPECT_EQ(refused.pressed, std::vector<std::size_t>{0});
    EXPECT_EQ(refused.outcome.time, 0.0);
    EXPECT_EQ(refused.last_set, std::vector{model::ContactState::slip});
    const Motion sliding = painleve_run(1.3, -0.1);
    EXPECT_EQ(sliding.outcome.reason, Reason::completed);
    EXPECT_EQ(shares(sliding).front()[slip_share], 1.0);
    EXPECT_EQ(painleve_run(1.2, 0.1).outcome.reason, Reason::completed);
}

// --- chain of two blocks on a belt, m = k = N = 1, mu_s = 1, mu_d = 1/2, V = 1/10

Motion chain_run(double first_displacement) {
    const model::ChainBlock block{.friction = model::Coulomb{1.0, 0.5}};
    const model::Structure structure = model::chain_on_belt({block, block}, 1.2);
    integration::InitialState start{Eigen::VectorXd::Zero(4), Eigen::VectorXd::Zero(4)};
    start.displacement(0) = first_displacement;
    return run_taylor(structure, 0.1, start, {40.0, 39.0});
}

void expect_times(const record::ContactHistory& history, const std::vector<double>& times, double tolerance) {
    ASSERT_GE(history.size(), times.size() + 1);
    for (std::size_t n = 0; n < times.size(); ++n)
        EXPECT_NEAR(history[n + 1].from, times[n], tolerance) << "event " << n;
}

TEST(Chain, OfEqualBlocksSticksAndSlipsAsItsClosedFormSays) {
    const Motion motion = chain_run(0.0);
    expect_sound(motion);
    // slips until v = V, then for (mu_s - mu_d)/(k V) twice each, and slips for 2 (pi - atan 5)
    const double until_stuck = std::asin(0.2);
    const double first = until_stuck + (1.0 - 0.5 * (1.0 - std::cos(until_stuck))) / 0.1;
    const double slips = 2.0 * (std::numbers::pi - std::atan(5.0));
    for (const record::ContactHistory& history : motion.record.histories)
        expect_times(history, {until_stuck, first, first + slips, first + slips + 10.0}, 1e-12);
}

TEST(Chain, OfUnequalStartHasTheEventsOfRungeKutta) {
    const Motion motion = chain_run(0.3);
    expect_sound(motion);
    expect_times(motion.record.histories[0],
                 {2.066157008309, 8.792909821550, 13.115476994928, 22.12023972075, 25.45689449152, 35.42627773191},
                 1e-10);
    expect_times(motion.record.histories[1],
                 {0.116923330861, 9.460513696122, 12.400041255399, 21.91573216345, 25.66405194176, 35.53205072698},
                 1e-10);
}

// --- bowed string: it slips for about the share b of each period, at the string's own pitch

Motion string_run(double bow_position, double bow_force) {
    const model::BowedString string{.bow_position = bow_position, .bow_force = bow_force};
    constexpr int modes = 40;
    constexpr double velocity = 0.1;
    const model::Structure structure = model::bowed_string(string, modes);
    return run_taylor(structure, velocity,
                      {Eigen::VectorXd::Zero(modes + 1), model::helmholtz_motion(string, modes, velocity)}, {3.0, 1.0});
}

struct Bowing {
    double position, force, slip_share;
};

class BowedStringTest : public testing::TestWithParam<Bowing> {};

TEST_P(BowedStringTest, HasOneSlipAPeriodBelowSchellengsUpperLimit) {
    const Bowing& bowing = GetParam();
    const Motion motion = string_run(bowing.position, bowing.force);
    expect_sound(motion);
    EXPECT_NEAR(shares(motion).front()[slip_share], bowing.slip_share, 1e-4);
    const record::ContactTally& tally = motion.record.phases.front().contacts.front();
    const long slips = tally.changes[record::change_kind(ContactState::stick, ContactState::slip)].count;
    EXPECT_GE(slips, 199);
    EXPECT_LE(slips, 200);
    EXPECT_LT(bowing.force, model::greatest_bow_force({.bow_position = bowing.position}, 0.1));
}

INSTANTIATE_TEST_SUITE_P(Helmholtz, BowedStringTest,
                         testing::Values(Bowing{0.08, 1.2, 0.0891}, Bowing{0.13, 0.8, 0.1393},
                                         Bowing{0.2, 0.4, 0.2446}));

TEST(BowedString, SlipsSeveralTimesAPeriodAboveTheUpperLimit) {
    const Motion motion = string_run(0.08, 2.0);
    EXPECT_GT(2.0, model::greatest_bow_force({.bow_position = 0.08}, 0.1));
    const record::ContactTally& tally = motion.record.phases.front().contacts.front();
    EXPECT_GT(tally.changes[record::change_kind(ContactState::stick, ContactState::slip)].count, 400);
}

// --- Code_Aster's SDND106 (V5.01.106): 3000 N pull for 0.2 s

Motion run_masses(double pull, const integration::InitialState& start, double duration) {
    const model::Structure structure = support::two_masses(pull);
    parameters::Case c = support::watched_case(0.0, {duration, duration});
    record::Request request{record::KeepHistory::yes, {}};
    request.trace = {.from = 0.0, .to = duration, .interval = 0.01};
    record::Recorder recorder(record::schedule(c), request, 3, 1);
    return integration::integrate_taylor(structure, c.drive, start, {parameters::EarlyEnding::never},
                                         std::move(recorder));
}

TEST(TwoMasses, SlipAndStickAsCodeAsterSays) {
    const integration::InitialState rest{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    const Motion pulled = run_masses(3000.0, rest, 0.2);
    expect_sound(pulled);
    ASSERT_EQ(pulled.record.histories[0].size(), 2U);
    EXPECT_NEAR(pulled.record.histories[0][1].from, std::acos(1.0 - 0.3 * 1e4 / 3000.0) / std::sqrt(1e4 / 5.0), 1e-13);
    const record::Trace& trace = pulled.record.trace;
    const auto at = [&](std::size_t sample, std::size_t dof) { return trace.displacement[dof][sample]; };
    EXPECT_NEAR(at(2, 2), 0.1122103126407706, 1e-12);
    EXPECT_EQ(at(2, 0), 0.0);
    EXPECT_NEAR(at(15, 0), 1.3533376608928975, 1e-12);
    EXPECT_NEAR(at(15, 2), 1.8075324661759522, 1e-12);
    EXPECT_NEAR(at(20, 0), 2.593088362758737, 1e-12);
    EXPECT_NEAR(trace.velocity[0][20], 25.4709724805942, 1e-11);

    integration::InitialState let_go{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    for (std::size_t dof = 0; dof < 3; ++dof) {
        let_go.displacement(static_cast<Eigen::Index>(dof)) = at(20, dof);
        let_go.velocity(static_cast<Eigen::Index>(dof)) = trace.velocity[dof][20];
    }
    const Motion free = run_masses(0.0, let_go, 0.2);
    expect_sound(free);
    EXPECT_NEAR(0.2 + free.record.histories[0][1].from, 0.3149232754474865, 1e-12);
    EXPECT_NEAR(free.record.trace.displacement[0].back(), 3.9556057734976036, 1e-11);
}

}  // namespace
}  // namespace stridor
