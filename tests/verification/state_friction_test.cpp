// Friction with a state of the contact, by Taylor series: an independent integrator, closed forms, Coulomb's limit, and
// the critical stiffness of rate and state.

#include "stridor/analysis/sliding_stability.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/integration/run/end_state.hpp"
#include "stridor/integration/series/taylor.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/model/built/case_structure.hpp"
#include "stridor/model/built/mass_on_belt.hpp"
#include "stridor/model/laws/friction.hpp"
#include "stridor/record/trace.hpp"
#include "support/many_contacts.hpp"

#include <boost/numeric/odeint.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace stridor {
namespace {

using integration::Motion;
using parameters::Initial;

struct BristlesOnBelt {
    std::string name;
    model::Belt belt;
    model::LuGre law;
    double V = 0.0;         // [m/s]
    double duration = 0.0;  // [s]
};

// mass, stiffness, damping, preload; mu_s, mu_d, v_s, delta, k_v; sigma_0, sigma_1
std::vector<BristlesOnBelt> bristles_on_belts() {
    return {
        {"of the paper of 1995", {1.0, 2.0, 0.0, 1.0, {}}, {{1.5, 1.0, 1e-3, 2.0, 0.4}, 1e5, std::sqrt(1e5)}, 0.1, 9.0},
        {"Dahl's", {1.0, 100.0, 0.0, 5.0, {}}, {{0.6, 0.6, 1.0, 1.0, 0.0}, 500.0, 0.0}, 0.05, 2.0},
        {"damped", {2.0, 3e5, 5.0, 80.0, {}}, {{0.8, 0.5, 0.04, 2.0, 0.2}, 1e5, 10.0}, 0.05, 0.05},
        {"of Tustin's curve", {1.0, 1.0, 0.01, 1.0, {}}, {{0.9, 0.4, 0.15, 1.0, 0.5}, 200.0, 0.2}, 0.1, 20.0},
    };
}

model::Structure belt_of(const model::Belt& belt, const model::FrictionLaw& law) {
    model::Structure structure = model::mass_on_belt(belt);
    structure.contacts[0].friction = law;
    return structure;
}

Motion sampled(const model::Structure& structure, double V, const integration::InitialState& start, double duration,
               double interval) {
    const parameters::Case c = support::watched_case(V, {duration, duration});
    return integration::integrate_taylor(
        structure, c.drive, start, {},
        record::Recorder(record::schedule(c), {record::KeepHistory::yes, {0.0, duration, interval}}, 2));
}

Motion moved(const BristlesOnBelt& given, double sign = 1.0) {
    const model::Structure structure = belt_of(given.belt, given.law);
    const double V = sign * given.V;
    return sampled(structure, V, integration::initial_state(structure, {Initial::stuck, 0.0}, V), given.duration,
                   given.duration / 200.0);
}

// x [m], x' [m/s], z [m] at instants, by the method of Fehlberg, of orders 7 and 8, of Boost's odeint, in long double.
// The law is written anew, for both signs of the slip; each change of it ends a step, since the law has a corner there.
using Real = long double;
using BristleState = std::array<Real, 3>;

struct BristleMotion {
    const BristlesOnBelt& given;
    Real way = -1;

    void operator()(const BristleState& s, BristleState& rate, Real) const {
        const model::LuGre& law = given.law;
        const Real w = s[1] - Real(given.V), speed = way * w;
        const Real mu_s = law.curve.static_coefficient, mu_d = law.curve.kinetic_coefficient;
        const Real power = std::pow(std::abs(speed) / Real(law.curve.velocity), Real(law.curve.exponent));
        const Real g = mu_d + (mu_s - mu_d) * std::exp(-power);
        rate[2] = w - Real(law.stiffness) * speed / g * s[2];
        const Real T = -Real(given.belt.preload) *
                       (Real(law.stiffness) * s[2] + Real(law.damping) * rate[2] + Real(law.curve.viscous) * w);
        rate[0] = s[1];
        rate[1] = (T - Real(given.belt.damping) * s[1] - Real(given.belt.stiffness) * s[0]) / Real(given.belt.mass);
    }
};

std::vector<BristleState> by_runge_kutta(const BristlesOnBelt& given, const std::vector<double>& instants) {
    namespace odeint = boost::numeric::odeint;
    using Stepper = odeint::runge_kutta_fehlberg78<BristleState, Real>;
    constexpr Real tolerance = 1e-16L;
    auto stepper = odeint::make_controlled<Stepper>(tolerance, tolerance);
    BristleMotion motion{given};
    BristleState s{0, given.V, 0};
    Real time = 0, step = 1e-6L;
    std::vector<BristleState> found;
    const auto has_way = [&](const BristleState& state) { return motion.way * (state[1] - Real(given.V)) >= 0; };
    for (const double instant : instants) {
        while (time < Real(instant)) {
            const BristleState before = s;
            const Real from = time;
            step = std::min(step, Real(instant) - time);
            if (stepper.try_step(motion, s, time, step) != odeint::success) continue;
            if (has_way(s)) continue;
            Real low = 0, high = time - from;
            const auto stepped = [&](Real length) {
                BristleState there = before;
                Stepper().do_step(motion, there, from, length);
                return there;
            };
            while (high - low > 1e-18L) {
                const Real middle = (low + high) / 2;
                if (middle <= low || middle >= high) break;
                (has_way(stepped(middle)) ? low : high) = middle;
            }
            s = stepped(high);
            time = from + high;
            motion.way = -motion.way;
            step = std::min(step, 1e-6L);
        }
        found.push_back(s);
    }
    return found;
}

TEST(StateFriction, MovesAsAnIndependentIntegratorHasIt) {
    for (const BristlesOnBelt& given : bristles_on_belts()) {
        const Motion motion = moved(given);
        ASSERT_EQ(motion.outcome.reason, integration::Reason::completed) << given.name;
        const record::Trace& trace = motion.record.trace;
        const std::vector<BristleState> wanted = by_runge_kutta(given, trace.time);
        double x_size = 0.0, v_size = 0.0;
        for (const BristleState& s : wanted) {
            x_size = std::max(x_size, static_cast<double>(std::abs(s[0])));
            v_size = std::max(v_size, static_cast<double>(std::abs(s[1])));
        }
        double x_error = 0.0, v_error = 0.0;
        for (std::size_t k = 0; k < trace.time.size(); ++k) {
            x_error = std::max(x_error, std::abs(trace.displacement[0][k] - static_cast<double>(wanted[k][0])));
            v_error = std::max(v_error, std::abs(trace.velocity[0][k] - static_cast<double>(wanted[k][1])));
        }
        EXPECT_LT(x_error, 1e-10 * x_size) << given.name;
        EXPECT_LT(v_error, 1e-10 * v_size) << given.name;
    }
}

TEST(StateFriction, NeverSticksAndSaysSo) {
    for (const BristlesOnBelt& given : bristles_on_belts()) {
        const Motion motion = moved(given);
        ASSERT_EQ(motion.record.histories.front().size(), 1U) << given.name;
        EXPECT_EQ(motion.record.histories.front().front().state, model::ContactState::slip);
        EXPECT_EQ(motion.record.phases.front().contacts.front().ending.outlook.future, record::Future::creeps);
    }
}

TEST(StateFriction, AccountsForAllEnergyAndAddsNone) {
    for (BristlesOnBelt given : bristles_on_belts()) {
        // the bound of Barabanov and Ortega
        given.law.curve.viscous =
            given.law.damping * (given.law.curve.static_coefficient / given.law.curve.kinetic_coefficient - 1.0);
        EXPECT_FALSE(doubt_of(given.law)) << given.name;
        const double whole = given.duration;
        for (const double share : {0.01, 0.1, 0.3, 1.0}) {
            given.duration = share * whole;
            const Motion motion = moved(given);
            EXPECT_GE(motion.energy.friction_loss, 0.0) << given.name;
            EXPECT_LT(std::abs(motion.energy.relative_residual()), 1e-12) << given.name;
        }
    }
}

TEST(StateFriction, IsDoubtedWhereItMayAddEnergy) {
    EXPECT_TRUE(doubt_of(bristles_on_belts().front().law));
    EXPECT_FALSE(doubt_of(bristles_on_belts()[1].law));
    EXPECT_FALSE(doubt_of(model::Coulomb{0.8, 0.6}));
}

TEST(StateFriction, MirrorsBitForBit) {
    for (const BristlesOnBelt& given : bristles_on_belts()) {
        const Motion here = moved(given), there = moved(given, -1.0);
        const record::Trace &a = here.record.trace, &b = there.record.trace;
        ASSERT_EQ(a.time.size(), b.time.size());
        for (std::size_t k = 0; k < a.time.size(); ++k) {
            ASSERT_EQ(a.displacement[0][k], -b.displacement[0][k]) << given.name << " " << a.time[k];
            ASSERT_EQ(a.contacts[0].friction_force[k], -b.contacts[0].friction_force[k]) << given.name;
        }
        EXPECT_EQ(here.energy.friction_loss, there.energy.friction_loss);
    }
}

// let go at 1 m on a plane at rest: of Coulomb's friction a half swing about mu N/k, one the other way
TEST(StateFriction, ComesToCoulombsMotionAsBristlesStiffen) {
    constexpr double mu = 0.1, duration = 4.5;  // k = m = N = 1: within the second half swing
    const double coulomb = -mu + (1.0 - 3.0 * mu) * -std::cos(duration - M_PI) * 1.0;
    double last = 0.0;
    for (const double stiffness : {1e3, 1e4, 1e5}) {
        const model::Structure structure =
            belt_of({1.0, 1.0, 0.0, 1.0, {}}, model::LuGre{{mu, mu, 1.0, 1.0, 0.0}, stiffness, 0.0});
        integration::InitialState start{Eigen::Vector2d(1.0, 0.0), Eigen::Vector2d::Zero()};
        const Motion motion = sampled(structure, 1e-300, start, duration, duration);
        const double error = std::abs(motion.record.trace.displacement[0].back() - coulomb);
        EXPECT_LT(error, 1.5 * mu / std::sqrt(stiffness));
        // where the motion turns, bristles bend the other way over a way of 2 mu/sigma_0, in a time as its root
        if (last > 0.0) {
            EXPECT_NEAR(last / error, std::sqrt(10.0), 0.05);
        }
        last = error;
    }
}

// Table 1's joints: contacts close, open and turn their slips round
TEST(StateFriction, MovesContactsThatOpenAndMeet) {
    for (const std::vector<model::PlateJoint>& joints :
         {std::vector{support::plate_joint(20.0, 0.6)},
          {support::plate_joint(2000.0, 0.2), support::plate_joint(1500.0, 0.3, 75.0)}}) {
        model::Structure structure = support::plate_of(joints);
        for (model::ContactPoint& contact : structure.contacts)
            contact.friction = model::LuGre{{0.8, 0.6, 0.05, 1.0, 0.1}, 2e5, 0.2};
        const Motion here = support::run_taylor(structure, 0.1, Initial::rest, {0.05, 0.05});
        support::expect_sound(here);
        for (const record::ContactHistory& history : here.record.histories) {
            EXPECT_GT(history.size(), 10U);
            for (const record::ContactInterval& stay : history)
                EXPECT_NE(stay.state, model::ContactState::stick);
        }
        const Motion again = support::run_taylor(structure, 0.1, Initial::rest, {0.05, 0.05});
        EXPECT_EQ(here.energy.friction_loss, again.energy.friction_loss);
    }
}

parameters::Case bristled_joint() {
    parameters::Case c;
    c.contact().friction = parameters::FrictionKind::lugre;
    c.contact().bristle_stiffness = 2e5;
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = 0.1;
    c.run.duration = c.run.window = 0.02;
    return c;
}

TEST(StateFriction, GoesOnFromItsEndBitForBit) {
    const parameters::Case c = bristled_joint();
    const record::Request request{record::KeepHistory::yes, {0.0, c.run.duration, 1e-4}};
    parameters::Case half = c;
    half.run.duration = half.run.window = 0.5 * c.run.duration;
    const integration::EndState end = integration::run_to_end(half).state;
    ASSERT_EQ(end.friction_states.size(), 1U);
    parameters::Case rest = c;
    rest.run.window = half.run.duration;
    const record::Trace whole = integration::simulate(rest, request).record.trace;
    const record::Trace later = integration::go_on(rest, end, request).record.trace;
    const std::size_t before = whole.time.size() - later.time.size();
    for (std::size_t k = 0; k < later.time.size(); ++k)
        ASSERT_EQ(later.displacement[0][k], whole.displacement[0][before + k]) << later.time[k];
}

TEST(StateFriction, BeginsAnotherRunInTheStateOfItsEnd) {
    parameters::Case c = bristled_joint();
    const integration::EndState end = integration::run_to_end(c).state;
    const parameters::Case next = integration::begun_at(c, end);
    EXPECT_EQ(next.joints[0].start.friction_state, end.friction_states[0]);
    const model::Structure structure = model::structure_of(next);
    EXPECT_EQ(integration::initial_state(next, structure, 0.1).friction_states[0], end.friction_states[0]);
}

TEST(StateFriction, IsUndecidedAndNeverQuiet) {
    const Motion motion = integration::simulate(bristled_joint());
    const classification::Verdict verdict =
        classification::classify_phase(motion.record.phases.front(), parameters::Thresholds{});
    EXPECT_EQ(verdict.category, classification::Category::undecided);
    EXPECT_NE(verdict.reasons.back().find("creeps"), std::string::npos);
}

TEST(StateFriction, BeginsSlidingWithTheStateOfASteadySlip) {
    for (const BristlesOnBelt& given : bristles_on_belts())
        for (const double V : {given.V, -given.V}) {
            const model::Structure structure = belt_of(given.belt, given.law);
            const Motion motion =
                sampled(structure, V, integration::initial_state(structure, {Initial::sliding, 0.0}, V), 0.01, 0.001);
            for (const double velocity : motion.record.trace.velocity[0])
                EXPECT_NEAR(velocity, 0.0, 1e-12 * std::abs(V)) << given.name;
        }
}

TEST(StateFriction, IsRefusedByNameByOtherEngines) {
    const model::Structure structure = belt_of(bristles_on_belts()[1].belt, bristles_on_belts()[1].law);
    EXPECT_ANY_THROW(support::run_moreau(structure, 0.1, Initial::stuck, 1e-5));
}

// below 0.2 V a slip counts as a stick: what is told changes at that speed, and the motion not at all
TEST(CreepSpeed, DividesTheMotionWhereTheSpeedPassesIt) {
    for (const BristlesOnBelt& given : bristles_on_belts()) {
        const double speed = 0.2 * given.V;
        model::Structure structure = belt_of(given.belt, given.law);
        structure.contacts[0].creep_speed = speed;
        const Motion motion =
            sampled(structure, given.V, integration::initial_state(structure, {Initial::stuck, 0.0}, given.V),
                    given.duration, given.duration / 200.0);
        const record::Trace &trace = motion.record.trace, &usual = moved(given).record.trace;
        const record::ContactHistory& history = motion.record.histories.front();
        ASSERT_GT(history.size(), 1U) << given.name;
        for (std::size_t k = 1; k < history.size(); ++k) {
            EXPECT_NE(history[k].state, history[k - 1].state) << given.name;
            EXPECT_NEAR(std::abs(history[k].slip_velocity), speed, 1e-12 * given.V) << given.name;
        }
        std::size_t stay = 0;
        for (std::size_t k = 0; k < trace.time.size(); ++k) {
            EXPECT_NEAR(trace.displacement[0][k], usual.displacement[0][k], 1e-9) << given.name;
            while (stay + 1 < history.size() && history[stay + 1].from <= trace.time[k])
                ++stay;
            const double slip = std::abs(trace.velocity[0][k] - given.V);
            if (std::abs(slip - speed) < 1e-9 * given.V) continue;
            EXPECT_EQ(history[stay].state == model::ContactState::stick, slip < speed) << given.name << trace.time[k];
        }
    }
}

// a mass that the belt drags along and that jumps back
parameters::Case stick_slip(parameters::FrictionKind friction) {
    parameters::Case c;
    c.joint().mass = 0.1;
    c.joint().incidence_angle = 0.0;
    c.joint().axial_stiffness = 1e5;
    c.joint().axial_damping = 4.0;
    c.contact().preload = 10.0;
    c.contact().friction = friction;
    c.contact().static_friction = 0.8;
    c.contact().kinetic_friction = 0.4;
    c.contact().stribeck_velocity = 1e-3;
    c.contact().bristle_stiffness = 3e7;
    c.verdict.creep_speed = 1e-3;
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = 0.005;
    c.run.duration = 0.4;
    c.run.window = 0.3;
    return c;
}

classification::Verdict verdict_of(const parameters::Case& c) {
    return classification::classify_phase(integration::simulate(c).record.phases.front(), c.verdict);
}

TEST(CreepSpeed, GivesTheVerdictOfCoulombsStickSlip) {
    const classification::Verdict coulomb = verdict_of(stick_slip(parameters::FrictionKind::coulomb));
    const classification::Verdict bristled = verdict_of(stick_slip(parameters::FrictionKind::lugre));
    ASSERT_EQ(coulomb.category, classification::Category::creak);
    EXPECT_EQ(bristled.category, coulomb.category);
    EXPECT_NEAR(bristled.evidence.judged_rates.stick, coulomb.evidence.judged_rates.stick, 0.02);
}

TEST(CreepSpeed, CallsASteadySlideQuietWhereItLasts) {
    parameters::Case c = stick_slip(parameters::FrictionKind::lugre);
    c.drive.velocity = 0.5;
    c.run.initial = Initial::sliding;
    EXPECT_EQ(verdict_of(c).category, classification::Category::none);
    // friction that falls with speed outweighs the dashpot: it grows, too slowly to be heard in this run
    c.contact().stribeck_velocity = 0.5;
    c.joint().axial_damping = 2.0;
    c.run.perturbation = 1e-9;
    c.run.duration = c.run.window = 0.02;
    const classification::Verdict growing = verdict_of(c);
    EXPECT_EQ(growing.category, classification::Category::undecided);
    EXPECT_NE(growing.reasons.back().find("grows"), std::string::npos) << growing.reasons.back();
}

TEST(CreepSpeed, DoesNotCallCreepQuiet) {
    parameters::Case c = stick_slip(parameters::FrictionKind::lugre);
    c.drive.velocity = 1e-4;
    const classification::Verdict verdict = verdict_of(c);
    EXPECT_EQ(verdict.category, classification::Category::undecided);
    EXPECT_NE(verdict.reasons.back().find("creeps in all"), std::string::npos) << verdict.reasons.back();
}

TEST(CreepSpeed, GoesOnFromItsEndBitForBit) {
    parameters::Case c = stick_slip(parameters::FrictionKind::lugre);
    c.run.duration = c.run.window = 0.05;
    const integration::EndState end = integration::run_to_end(c).state;
    parameters::Case whole = c;
    whole.run.duration = 0.1;
    const record::Request request{record::KeepHistory::yes, {}};
    const auto told = integration::simulate(whole, request).record.histories.front();
    const auto later = integration::go_on(whole, end, request).record.histories.front();
    ASSERT_GT(later.size(), 4U);
    for (std::size_t k = 1; k <= 4; ++k)
        EXPECT_EQ(later[later.size() - k].from, told[told.size() - k].from);
}

// J. R. Rice and A. Ruina 1983: (b - a) N/D_c (1 + m V²/(a N D_c))
struct RateAndStateBlock {
    double a, b, length, preload, V;

    double critical_stiffness() const { return (b - a) * preload / length * (1.0 + V * V / (a * preload * length)); }
    model::Structure on(double stiffness, parameters::FrictionKind kind) const {
        return belt_of({1.0, stiffness, 0.0, preload, {}}, model::RateAndState{kind, 0.6, a, b, length, V});
    }
};

constexpr RateAndStateBlock fast{0.01, 0.015, 1e-5, 5e6, 0.1}, slow{0.003, 0.008, 1e-6, 1e6, 1e-3};

TEST(RateAndState, LosesSteadySlidingAtTheCriticalStiffness) {
    for (const RateAndStateBlock& block : {fast, slow})
        for (const parameters::FrictionKind kind :
             {parameters::FrictionKind::dieterich, parameters::FrictionKind::ruina})
            for (const auto direction : {parameters::Direction::going, parameters::Direction::coming})
                for (const double share : {-1e-6, 1e-6}) {
                    const double stiffness = block.critical_stiffness() * (1.0 + share);
                    const analysis::SlidingStability found =
                        analysis::sliding_stability(block.on(stiffness, kind), direction, block.V);
                    EXPECT_EQ(found.growth > 0.0, share < 0.0) << stiffness << " " << found.growth;
                }
}

// [1/s] growth of a small disturbance, from its largest velocities early and late
double simulated_growth(const model::Structure& structure, double V, double duration) {
    const integration::InitialState start = integration::initial_state(structure, {Initial::sliding, 1e-6 * V}, V);
    const Motion motion = sampled(structure, V, start, duration, duration / 2e4);
    EXPECT_EQ(motion.outcome.reason, integration::Reason::completed);
    const std::vector<double>& v = motion.record.trace.velocity[0];
    const auto largest = [&](double from, double to) {
        const auto at = [&](double share) {
            return v.begin() + static_cast<long>(share * static_cast<double>(v.size() - 1));
        };
        return std::abs(*std::max_element(at(from), at(to)));
    };
    return std::log(largest(0.75, 1.0) / largest(0.25, 0.5)) / (0.5 * duration);
}

TEST(RateAndState, GrowsBelowAndDecaysAboveTheCriticalStiffness) {
    for (const parameters::FrictionKind kind : {parameters::FrictionKind::dieterich, parameters::FrictionKind::ruina})
        for (const double share : {-1e-3, 1e-3}) {
            const model::Structure structure = fast.on(fast.critical_stiffness() * (1.0 + share), kind);
            const double expected = analysis::sliding_stability(structure, parameters::Direction::going, fast.V).growth;
            const double found = simulated_growth(structure, fast.V, 0.5);
            EXPECT_EQ(found > 0.0, share < 0.0);
            EXPECT_NEAR(found, expected, 0.05 * std::abs(expected));
        }
}

}  // namespace
}  // namespace stridor
