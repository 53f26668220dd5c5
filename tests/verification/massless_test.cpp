// The time stepping whose contacts have no inertia: closed forms, orders, and the same structures with inertia.

#include "stridor/integration/steps/massless.hpp"

#include "stridor/base/error.hpp"
#include "stridor/integration/steps/formulations.hpp"
#include "stridor/model/linear/modal_damping.hpp"
#include "support/effort.hpp"
#include "support/many_contacts.hpp"
#include "support/structures/blocks_on_plane.hpp"
#include "support/structures/rubber_strip.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace stridor {
namespace {

using integration::InitialState;
using integration::Massless;
using integration::Motion;
using integration::Reason;

Motion run_massless(const model::Structure& structure, double velocity, const InitialState& start,
                    const Massless& settings, const support::Watched& watched, double interval = 0.0) {
    const parameters::Case c = support::watched_case(velocity, watched);
    record::Request request{record::KeepHistory::yes, {}};
    request.trace = {.from = 0.0, .to = watched.duration, .interval = interval};
    return integration::integrate_massless(structure, c.drive, start, settings,
                                           record::Recorder(record::schedule(c), request, model::dofs_of(structure),
                                                            static_cast<int>(structure.contacts.size())));
}

// a mass of 2 kg on a spring of 800 N/m to a foot without mass, pressed by 10 N, that slips at 3 N: rows x, foot along
// and across
model::Structure mass_with_foot() {
    model::Structure structure = model::structure_of_size(3);
    structure.mass(0, 0) = 2.0;
    structure.stiffness << 800, -800, 0, -800, 800, 0, 0, 0, 1e4;
    structure.load(2) = -10.0;
    structure.contacts.front().normal << 0.0, 0.0, 1.0;
    structure.contacts.front().tangent << 0.0, 1.0, 0.0;
    structure.contacts.front().friction = model::Coulomb{0.3, 0.3};
    return structure;
}

// the foot sticks, slips with a constant force until the mass stands still, and sticks for ever
TEST(Massless, FootOfAMassSlipsOnce) {
    const double omega = 20.0, speed = 0.5, limit = 3.0, step = 1e-5;
    const double slips_at = std::asin(limit * omega / (800.0 * speed)) / omega;
    const double left = speed * std::cos(omega * slips_at);
    const double sticks_at = slips_at + left / (limit / 2.0);
    const double foot = 0.5 * left * left / (limit / 2.0);
    InitialState start{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    start.velocity(0) = speed;
    const Motion motion = run_massless(mass_with_foot(), 0.0, start, {step}, {1.0, 1.0}, 1e-3);
    EXPECT_EQ(motion.outcome.reason, Reason::completed);
    const record::ContactHistory& history = motion.record.histories[0];
    ASSERT_EQ(history.size(), 3U);
    EXPECT_NEAR(history[1].from, slips_at, 2.0 * step);
    EXPECT_NEAR(history[2].from, sticks_at, 2.0 * step);
    const record::Trace& trace = motion.record.trace;
    for (std::size_t n = 0; n < trace.time.size(); ++n) {
        if (trace.time[n] < sticks_at + 1e-3) continue;
        const double swing = limit / 800.0 * std::cos(omega * (trace.time[n] - sticks_at));
        EXPECT_NEAR(trace.displacement[1][n], foot, 1e-6);
        EXPECT_NEAR(trace.displacement[0][n], foot + swing, 1e-6);
        EXPECT_NEAR(trace.contacts[0].normal_force[n], 10.0, 1e-9);
    }
    EXPECT_NEAR(motion.energy.friction_loss, limit * foot, 1e-5);
    EXPECT_LT(std::abs(motion.energy.relative_residual()), 1e-5);
}

// a shaken mass drags its foot to and fro: what the shaker does is what friction takes and what swings
TEST(Massless, AccountsForTheWorkOfAShaker) {
    model::Structure structure = mass_with_foot();
    structure.shaken = Eigen::Vector3d(1.0, 0.0, 0.0);
    parameters::Case c = support::watched_case(0.0, {2.0, 2.0});
    c.drive.kind = parameters::DriveKind::force;
    c.drive.force = 6.0;
    c.drive.frequency = 2.0;
    c.drive.ramp = 0.05;
    const InitialState still{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    const Motion motion = integration::integrate_massless(structure, c.drive, still, {1e-5},
                                                          record::Recorder(record::schedule(c), {}, 3, 1));
    EXPECT_EQ(motion.outcome.reason, Reason::completed);
    EXPECT_GT(motion.energy.friction_loss, 0.1);
    EXPECT_GT(motion.energy.drive_work, motion.energy.friction_loss);
    EXPECT_LT(std::abs(motion.energy.relative_residual()), 1e-5);
}

TEST(Massless, ConvergesInSecondOrderWhereNothingChanges) {
    InitialState start{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    start.velocity(0) = 0.05;
    double before = 0.0;
    for (const double step : {4e-4, 2e-4, 1e-4}) {
        const record::Trace trace = run_massless(mass_with_foot(), 0.0, start, {step}, {1.0, 1.0}, 4e-4).record.trace;
        double most = 0.0;
        for (std::size_t n = 0; n < trace.time.size(); ++n)
            most = std::max(most, std::abs(trace.displacement[0][n] - 0.05 / 20.0 * std::sin(20.0 * trace.time[n])));
        if (before > 0.0) {
            EXPECT_NEAR(before / most, 4.0, 0.1);
        }
        before = most;
    }
}

// a body of 0.1 kg on oblique springs slides on a foot without mass, however stiff: when its vibration has died away,
// to 1e-5 at half of the run where the foot has 1e6 N/m, n.K^-1 (f0 + N (n + mu t)) = 0, and N swings no more
TEST(Massless, NormalForceOfSteadySlidingDoesNotSwing) {
    for (const double foot : {1e4, 1e6, 1e8}) {
        model::Structure body = model::structure_of_size(4);
        body.mass(0, 0) = body.mass(1, 1) = 0.1;
        body.stiffness << 1e5 + foot, 3e4, -foot, 0, 3e4, 1.3e5 + foot, 0, -foot, -foot, 0, foot, 0, 0, -foot, 0, foot;
        body.damping = model::modal_damping(body.mass, body.stiffness, 0.05);
        body.load(3) = -5.0;
        body.contacts.front().normal << 0.0, 0.0, 0.0, 1.0;
        body.contacts.front().tangent << 0.0, 0.0, 1.0, 0.0;
        body.contacts.front().friction = model::Coulomb{0.6, 0.6};
        const Eigen::VectorXd normal = body.contacts.front().normal;
        const Eigen::VectorXd pushes = normal + 0.6 * body.contacts.front().tangent;
        const auto solver = body.stiffness.ldlt();
        const double steady = -normal.dot(solver.solve(body.load)) / normal.dot(solver.solve(pushes));
        const Eigen::VectorXd zero = Eigen::VectorXd::Zero(4);
        const Motion motion = run_massless(body, 0.1, {zero, zero}, {1e-5}, {1.0, 0.5}, 1e-4);
        ASSERT_EQ(motion.outcome.reason, Reason::completed) << foot;
        const record::Trace& trace = motion.record.trace;
        for (std::size_t n = trace.time.size() / 2; n < trace.time.size(); ++n)
            ASSERT_NEAR(trace.contacts[0].normal_force[n], steady, 1e-3 * steady) << foot << " " << trace.time[n];
    }
}

// the residual flexibility and the modes that are left make the statics of the whole structure
TEST(Massless, KeepsTheStaticsOfTheStructure) {
    const model::Structure strip =
        support::read_strip(STRIDOR_SOURCE_DIR "/tests/fixtures/structures/strip_s1.txt").structure;
    const integration::MasslessStructure massless = integration::massless_structure(strip, 0.0);
    const auto modes = static_cast<Eigen::Index>(massless.modal.modes());
    EXPECT_GE(modes, 10);
    EXPECT_LT(modes, 40);
    Eigen::MatrixXd directions(40, 10), kept(10, modes);
    for (Eigen::Index row = 0; row < 10; ++row) {
        const model::ContactPoint& contact = strip.contacts[massless.modal.number[static_cast<std::size_t>(row / 2)]];
        directions.col(row) = row % 2 == 0 ? contact.normal : contact.tangent;
        kept.row(row) = directions.col(row).transpose() * massless.modal.shapes;
    }
    const Eigen::Map<const Eigen::VectorXd> square(massless.modal.square_frequency.data(), modes);
    const Eigen::MatrixXd sum = kept * square.cwiseInverse().asDiagonal() * kept.transpose() + massless.flexibility;
    const Eigen::MatrixXd whole = directions.transpose() * strip.stiffness.ldlt().solve(directions);
    EXPECT_LT((sum - whole).cwiseAbs().maxCoeff(), 1e-12 * whole.cwiseAbs().maxCoeff());
}

// with one coefficient nothing jumps where a contact breaks: inertia at the contacts changes little
TEST(Massless, SharesOfTheStripOfRubberAreThoseWithInertia) {
    support::RubberStrip strip = support::read_strip(STRIDOR_SOURCE_DIR "/tests/fixtures/structures/strip_s1.txt");
    for (model::ContactPoint& contact : strip.structure.contacts)
        contact.friction = model::Coulomb{0.5, 0.5};
    const support::Watched watched{support::effort(0.4, 0.15), support::effort(0.3, 0.1)};
    const auto mean_stick = [](const Motion& motion) {
        EXPECT_EQ(motion.outcome.reason, Reason::completed);
        double stick = 0.0;
        for (const auto& contact : support::shares(motion))
            stick += contact[support::stick_share] / 5.0;
        return stick;
    };
    const double with = mean_stick(support::run_moreau(strip.structure, strip.velocity, strip.start, 1e-6, watched));
    const double without = mean_stick(run_massless(strip.structure, strip.velocity, strip.start, {1e-6, 0.0}, watched));
    const double coarse = mean_stick(run_massless(strip.structure, strip.velocity, strip.start, {2e-6, 0.0}, watched));
    EXPECT_NEAR(without, with, 0.01);
    EXPECT_NEAR(without, coarse, support::effort(0.001, 0.003));  // a mean over a third of the time scatters more
}

TEST(Massless, BalancesTheEnergyOfAPlane) {
    const InitialState rest{Eigen::VectorXd::Zero(9), Eigen::VectorXd::Zero(9)};
    model::Structure blocks = support::coupled_blocks({0.4, -1.3, 2.2});
    // feet of a tenth of a millimetre a newton in series
    const Eigen::Index n = 9;
    model::Structure with_feet = model::structure_of_size(18, 3);
    with_feet.mass.topLeftCorner(n, n) = blocks.mass;
    with_feet.damping.topLeftCorner(n, n) = blocks.damping;
    with_feet.stiffness.topLeftCorner(n, n) = blocks.stiffness + 1e5 * Eigen::MatrixXd::Identity(n, n);
    with_feet.stiffness.bottomRightCorner(n, n) = 1e5 * Eigen::MatrixXd::Identity(n, n);
    with_feet.stiffness.topRightCorner(n, n) = -1e5 * Eigen::MatrixXd::Identity(n, n);
    with_feet.stiffness.bottomLeftCorner(n, n) = -1e5 * Eigen::MatrixXd::Identity(n, n);
    with_feet.load.tail(n) = blocks.load;
    for (std::size_t k = 0; k < 3; ++k) {
        with_feet.contacts[k] = blocks.contacts[k];
        for (auto* direction :
             {&with_feet.contacts[k].normal, &with_feet.contacts[k].tangent, &with_feet.contacts[k].second_tangent}) {
            Eigen::VectorXd moved = Eigen::VectorXd::Zero(18);
            moved.tail(n) = *direction;
            *direction = moved;
        }
        with_feet.contacts[k].friction = model::Coulomb{0.4, 0.4};
    }
    const InitialState still{Eigen::VectorXd::Zero(18), Eigen::VectorXd::Zero(18)};
    double before = 0.0;
    for (const double h : {4e-5, 1e-5}) {
        const Motion motion = run_massless(with_feet, 0.01, still, {h}, {0.5, 0.5});
        EXPECT_EQ(motion.outcome.reason, Reason::completed);
        EXPECT_GT(motion.record.histories[0].size(), 2U);
        const double residual = std::abs(motion.energy.relative_residual());
        EXPECT_LT(residual, 1e-3);
        if (before > 0.0) {
            EXPECT_LT(residual, before / 3.0);
        }
        before = residual;
    }
}

TEST(Massless, BothFormulationsStandSideBySide) {
    const support::RubberStrip strip =
        support::read_strip(STRIDOR_SOURCE_DIR "/tests/fixtures/structures/strip_s1.txt");
    parameters::Case c = support::watched_case(strip.velocity, {0.02, 0.01});
    const auto recorder = [&] { return record::Recorder(record::schedule(c), {}, model::dofs_of(strip.structure), 5); };
    const Motion both = integration::integrate_twice(strip.structure, c.drive, strip.start,
                                                     {2e-6, parameters::Formulation::both}, recorder());
    const Motion alone = integration::integrate_twice(strip.structure, c.drive, strip.start,
                                                      {2e-6, parameters::Formulation::massless}, recorder());
    ASSERT_TRUE(both.massless.has_value());
    EXPECT_FALSE(alone.massless.has_value());
    for (std::size_t k = 0; k < 5; ++k) {
        const record::ContactTally& beside = both.massless->phases[0].contacts[k];
        const record::ContactTally& own = alone.record.phases[0].contacts[k];
        EXPECT_EQ(beside.time, own.time);
        ASSERT_TRUE(beside.coarser.has_value() && own.coarser.has_value());
        EXPECT_EQ(beside.coarser->time, own.coarser->time);
    }
    EXPECT_NE(both.record.phases[0].contacts[0].time, alone.record.phases[0].contacts[0].time);
}

std::string massless_refusal(const model::Structure& structure, const Massless& settings) {
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(model::dofs_of(structure));
    try {
        run_massless(structure, 0.1, {zero, zero}, settings, {0.01, 0.01});
    } catch (const Error& error) {
        return error.problem().what;
    }
    return "";
}

// without damping of what has no mass
TEST(Massless, DampsTheModesOfRowsWithMass) {
    model::Structure held = mass_with_foot();
    held.stiffness(1, 1) = 1200.0;  // its foot by 400 N/m: one mode
    const Eigen::MatrixXd damping = model::modal_damping(held.mass, held.stiffness, 0.1);
    Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero(3, 3);
    // 800 and 400 N/m in series hold 2 kg
    wanted(0, 0) = 2.0 * 0.1 * std::sqrt(2.0 * 800.0 * 400.0 / 1200.0);
    EXPECT_LT((damping - wanted).cwiseAbs().maxCoeff(), 1e-12 * wanted(0, 0));
}

TEST(Massless, RefusesWhatItCannotSolve) {
    model::Structure damped = mass_with_foot();
    damped.damping(1, 1) = 1.0;
    EXPECT_EQ(massless_refusal(damped, {}), "a row without mass has damping");
    model::Structure loose = mass_with_foot();
    loose.stiffness(2, 2) = 0.0;
    EXPECT_EQ(massless_refusal(loose, {}), "the stiffness does not hold what has no mass");
    const support::RubberStrip strip =
        support::read_strip(STRIDOR_SOURCE_DIR "/tests/fixtures/structures/strip_s1.txt");
    EXPECT_EQ(massless_refusal(strip.structure, {1e-6, 1e9}),
              "too few modes move without inertia to carry the contacts");
    EXPECT_EQ(massless_refusal(strip.structure, {1e-6, 1e-3}), "no mode is left with inertia");
    // contacts that are springs of 200 kHz
    EXPECT_EQ(massless_refusal(strip.structure, {1e-6, 3600.0}), "the modes without inertia do not carry the contacts");
    // the mass of a joint stands at its contact
    for (const double angle : {60.0, 70.0, 110.0})
        EXPECT_EQ(massless_refusal(support::plate_of({support::plate_joint(100.0, 0.5, angle)}), {}),
                  "no number of modes without inertia carries the contacts");
    const Motion coarse = run_massless(strip.structure, strip.velocity, strip.start, {1.0}, {10.0, 10.0});
    EXPECT_EQ(coarse.outcome.reason, Reason::step_limit);
}

}  // namespace
}  // namespace stridor
