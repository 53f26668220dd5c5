// Each law of friction on Table 1's joint, whose contact sticks, slips, opens and meets: all of its events are those of
// an independent integrator in long double. A motion multiplies what disturbs it from event to event. So each event may
// lie apart by what a share of 1e-13 of the mass, a thousand roundings, moves the independent one's, and is looked at
// while that is below 1e-9 s.

#include "stridor/integration/exact/exact.hpp"
#include "stridor/integration/series/taylor.hpp"
#include "support/many_contacts.hpp"
#include "support/oracles/rubbing_by_runge_kutta.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace stridor {
namespace {

using model::ContactState;
using parameters::FrictionKind;
using parameters::Initial;
using parameters::RestKind;
using support::LawAnew;
using Real = long double;

constexpr double event_within = 1e-9;     // [s] how far an event may be known
constexpr std::size_t most_events = 60;   // [1] that are compared
constexpr double law_duration = 0.03;     // [s]
constexpr double law_velocity = -0.1257;  // [m/s]

struct LawOnJoint {
    std::string name;
    model::FrictionLaw law;
    LawAnew anew;
    model::RestGrowth rest{};
    double preload = 200.0;    // [N]
    double V = law_velocity;   // [m/s]
    double creep_speed = 0.0;  // [m/s]
    std::size_t fewest = 20;   // [1] events that are to be seen
};

std::function<Real(Real)> constant_limit(double limit) {
    return [=](Real) { return Real(limit); };
}

LawOnJoint linear() {
    LawOnJoint given{"linear", model::Linear{0.8, 0.2, 0.5}, {}};
    given.anew.limit = constant_limit(0.8);
    given.anew.corners = {Real(0.2) / Real(0.5)};
    given.anew.resistance = [](Real speed, Real) { return std::max(Real(0), Real(0.2) - Real(0.5) * speed); };
    return given;
}

// (|w|/v_s)^delta at which what is left of the fall is far below rounding
Real fallen_power(FrictionKind kind) {
    return kind == FrictionKind::stribeck_rational ? Real(1e22) : Real(60);
}

LawOnJoint stribeck(const std::string& name, FrictionKind kind, double exponent, double viscous, double v_s = 0.05) {
    constexpr double mu_s = 0.8, mu_d = 0.2;
    LawOnJoint given{name, model::Stribeck{mu_s, mu_d, v_s, exponent, viscous, kind}, {}};
    given.anew.limit = constant_limit(mu_s);
    // far beyond v_s stages of a step see a constant: a step may not pass the fall unseen
    given.anew.corners = {Real(v_s) * std::pow(fallen_power(kind), Real(1) / Real(exponent))};
    given.anew.resistance = [=](Real speed, Real) {
        const Real x = std::pow(speed / Real(v_s), static_cast<int>(exponent));
        const Real left = kind == FrictionKind::stribeck ? std::exp(-x) : 1 / (1 + x);
        return Real(mu_d) + (Real(mu_s) - Real(mu_d)) * left + Real(viscous) * speed;
    };
    return given;
}

const std::vector<double> table_speeds{0.0, 0.02, 0.06, 0.15, 0.5};  // [m/s]
const std::vector<double> table_rows{0.7, 0.5, 0.3, 0.2, 0.25};

// [s/m] at a row of the cubic: Fritsch and Butland's mean of the slopes beside it. At the first row that of the
// parabola through three rows; at the last that would turn round, and is three times the slope before it
Real cubic_slope(std::size_t row) {
    const auto width = [](std::size_t k) { return Real(table_speeds[k + 1]) - Real(table_speeds[k]); };
    const auto slope = [&](std::size_t k) { return (Real(table_rows[k + 1]) - Real(table_rows[k])) / width(k); };
    if (row == 0) return slope(0) + width(0) / (width(0) + width(1)) * (slope(0) - slope(1));
    if (row + 1 == table_speeds.size()) return 3 * slope(row - 1);
    const Real before = slope(row - 1), after = slope(row);
    if (before * after <= 0) return 0;
    const Real share = (1 + width(row) / (width(row - 1) + width(row))) / 3;
    return before * after / (share * after + (1 - share) * before);
}

LawOnJoint by_table(parameters::Interpolation interpolation) {
    const bool is_cubic = interpolation == parameters::Interpolation::cubic;
    auto curve =
        std::make_shared<const model::MeasuredCurve>(model::measured_curve(table_speeds, table_rows, interpolation));
    LawOnJoint given{is_cubic ? "table, cubic" : "table, linear", model::Measured{0.8, curve, {-12.0, 0.43}}, {}};
    given.anew.limit = constant_limit(0.8);
    given.anew.corners.assign(table_speeds.begin() + 1, table_speeds.end());
    given.anew.resistance = [=](Real speed, Real) {
        if (speed >= Real(table_speeds.back())) return Real(table_rows.back());
        std::size_t row = 0;
        while (speed >= Real(table_speeds[row + 1]))
            ++row;
        const Real width = Real(table_speeds[row + 1]) - Real(table_speeds[row]);
        const Real s = (speed - Real(table_speeds[row])) / width, r = 1 - s;
        const Real from = table_rows[row], to = table_rows[row + 1];
        if (!is_cubic) return r * from + s * to;
        return r * r * (1 + 2 * s) * from + s * s * (1 + 2 * r) * to +
               s * r * width * (r * cubic_slope(row) - s * cubic_slope(row + 1));
    };
    return given;
}

LawOnJoint resting(const std::string& name, const model::RestGrowth& rest) {
    LawOnJoint given{name, model::Coulomb{0.6, 0.2}, {}, rest};
    given.anew.limit = [=](Real rested) {
        const Real x = rested / Real(rest.time);
        return Real(0.6) + Real(rest.growth) * (rest.kind == RestKind::logarithmic
                                                    ? std::log1p(x)
                                                    : -std::expm1(-std::pow(x, Real(rest.exponent))));
    };
    given.anew.resistance = [](Real, Real) { return Real(0.2); };
    return given;
}

LawOnJoint bristles(const std::string& name, const model::LuGre& law) {
    LawOnJoint given{name, law, {}};
    const model::Stribeck& curve = law.curve;
    const auto bearing = [=](Real speed) {
        const Real x = std::pow(speed / Real(curve.velocity), static_cast<int>(curve.exponent));
        const Real mu_d = curve.kinetic_coefficient;
        return mu_d + (Real(curve.static_coefficient) - mu_d) * std::exp(-x);
    };
    const auto bend = [=](Real speed, Real state) {
        return speed - Real(law.stiffness) * speed / bearing(speed) * (state / Real(law.stiffness));
    };
    given.anew.resistance = [=](Real speed, Real state) {
        return state + Real(law.damping) * bend(speed, state) + Real(curve.viscous) * speed;
    };
    given.anew.corners = {Real(curve.velocity) *
                          std::pow(fallen_power(FrictionKind::stribeck), Real(1) / Real(curve.exponent))};
    given.anew.rate = [=](Real speed, Real state) { return Real(law.stiffness) * bend(speed, state); };
    given.anew.impact = [=](Real speed) { return bearing(speed) + Real(curve.viscous) * speed; };
    given.anew.impact_limit = curve.static_coefficient;
    given.anew.state_turns = true;
    given.creep_speed = 0.02;
    return given;
}

LawOnJoint rate_and_state(const std::string& name, const model::RateAndState& law) {
    LawOnJoint given{name, law, {}};
    const Real a = law.direct_effect, b = law.evolution_effect, V_0 = law.velocity, D_c = law.length;
    const Real mu_0 = law.coefficient;
    given.anew.resistance = [=](Real speed, Real state) {
        return a * std::asinh(speed / (2 * V_0) * std::exp((mu_0 + b * state) / a));
    };
    const bool is_slip_law = law.kind == FrictionKind::ruina;
    // the slip law has its logarithm of |w|, at rest of 1e-15 V_0
    given.anew.rate = [=](Real speed, Real state) {
        if (is_slip_law) return -speed / D_c * (std::log(std::abs(speed) / V_0 + Real(1e-15)) + state);
        return (V_0 * std::exp(-state) - speed) / D_c;
    };
    given.anew.impact = [=](Real speed) {
        const Real state = -std::log(speed / V_0 + Real(1e-15));
        return a * std::asinh(speed / (2 * V_0) * std::exp((mu_0 + b * state) / a));
    };
    given.creep_speed = 0.02;
    return given;
}

// a speed below zero, which a step may try, has exp(|w|/v_s): long steps are wrong before their error tells
LawOnJoint in_steps_of(double longest, LawOnJoint given) {
    given.anew.longest_step = longest;
    return given;
}

LawOnJoint pressed(double preload, LawOnJoint given) {
    given.preload = preload;
    given.V = -given.V;
    return given;
}

std::vector<LawOnJoint> laws_on_joints() {
    return {
        linear(),
        stribeck("stribeck", FrictionKind::stribeck, 1.0, 0.1),
        stribeck("stribeck, Gaussian", FrictionKind::stribeck, 2.0, 0.0),
        stribeck("stribeck-rational", FrictionKind::stribeck_rational, 1.0, 0.1),
        stribeck("stribeck-rational, square", FrictionKind::stribeck_rational, 2.0, 0.0),
        // far beyond v_s friction has fallen to the last bit: nothing of the series tells that it will rise again
        in_steps_of(1e-6, stribeck("stribeck, fallen", FrictionKind::stribeck, 1.0, 0.1, 2e-4)),
        stribeck("stribeck, Gaussian, fallen", FrictionKind::stribeck, 2.0, 0.0, 2e-3),
        stribeck("stribeck-rational, fallen", FrictionKind::stribeck_rational, 20.0, 0.0, 5e-3),
        by_table(parameters::Interpolation::cubic),
        by_table(parameters::Interpolation::linear),
        resting("rest, logarithmic", {RestKind::logarithmic, 0.05, 1e-4}),
        resting("rest, Kato", {RestKind::kato, 0.2, 1e-3, 0.5}),
        bristles("lugre", {{0.8, 0.2, 0.05, 1.0, 1.0}, 2e5, 0.2}),
        pressed(20.0, bristles("dahl", {{0.6, 0.6, 1.0, 1.0, 0.0}, 2e5, 0.0})),
        pressed(20.0, rate_and_state("dieterich", {FrictionKind::dieterich, 0.6, 0.1, 0.05, 1e-4, 0.1})),
        pressed(20.0, rate_and_state("ruina", {FrictionKind::ruina, 0.6, 0.1, 0.05, 1e-4, 0.1})),
    };
}

model::Structure joint_with(const LawOnJoint& given) {
    model::Structure structure = support::plate_of({support::plate_joint(given.preload, 0.2)});
    structure.contacts[0].friction = given.law;
    structure.contacts[0].rest = given.rest;
    structure.contacts[0].creep_speed = given.creep_speed;
    return structure;
}

record::ContactHistory history_of(const model::Structure& structure, double V) {
    return support::run_taylor(structure, V, Initial::stuck, {law_duration, law_duration}).record.histories.front();
}

TEST(LawEvents, AreThoseOfAnIndependentIntegrator) {
    std::set<std::pair<ContactState, ContactState>> all;
    for (LawOnJoint& given : laws_on_joints()) {
        given.anew.creep_speed = given.creep_speed;
        const model::Structure structure = joint_with(given);
        const record::ContactHistory history = history_of(structure, given.V);
        model::Structure disturbed = structure;
        disturbed.mass(0, 0) *= 1.0 + 1e-13;
        const auto events = [&](const model::Structure& each) {
            return support::rubbing_by_runge_kutta(each, given.anew, given.V, law_duration, most_events);
        };
        const std::vector<support::RubbingEvent> wanted = events(structure), moved = events(disturbed);
        double within = 1e-13;  // [s]
        std::size_t compared = 0;
        for (; compared < std::min(wanted.size(), moved.size()); ++compared) {
            within = std::max(within, std::abs(moved[compared].time - wanted[compared].time));
            if (moved[compared].state != wanted[compared].state || within > event_within) break;
            ASSERT_LT(compared + 1, history.size()) << given.name;
            const record::ContactInterval& found = history[compared + 1];
            ASSERT_EQ(found.state, wanted[compared].state) << given.name << " " << compared;
            ASSERT_NEAR(found.from, wanted[compared].time, within) << given.name << " " << compared;
            all.insert({history[compared].state, found.state});
        }
        EXPECT_GE(compared, given.fewest) << given.name;
    }
    // stick, slip and separation, from each to each, but none opens out of a stick
    EXPECT_EQ(all.size(), 5U);
}

// laws whose numbers leave constant coefficients, and Coulomb's of these
std::vector<std::pair<LawOnJoint, model::Coulomb>> laws_of_constants() {
    const auto flat = [](parameters::Interpolation interpolation) {
        return model::Measured{0.8,
                               std::make_shared<const model::MeasuredCurve>(
                                   model::measured_curve({0.0, 0.05, 0.3}, {0.2, 0.2, 0.2}, interpolation)),
                               {}};
    };
    const model::Coulomb two{0.8, 0.2}, one{0.6, 0.6};
    return {
        {{"linear", model::Linear{0.8, 0.2, 0.0}, {}}, two},
        {{"stribeck", model::Stribeck{0.6, 0.6, 0.05, 1.0, 0.0}, {}}, one},
        {{"stribeck, Gaussian", model::Stribeck{0.6, 0.6, 0.05, 2.0, 0.0}, {}}, one},
        {{"stribeck-rational", model::Stribeck{0.6, 0.6, 0.05, 1.0, 0.0, FrictionKind::stribeck_rational}, {}}, one},
        {{"table, cubic", flat(parameters::Interpolation::cubic), {}}, two},
        {{"table, linear", flat(parameters::Interpolation::linear), {}}, two},
        {{"rest, logarithmic", two, {}, {RestKind::logarithmic, 0.0, 1.0}}, two},
        {{"rest, Kato", two, {}, {RestKind::kato, 0.0, 1.0, 0.5}}, two},
    };
}

TEST(LawEvents, OfConstantCoefficientsAreThoseOfTheExactEngine) {
    for (const auto& [given, coulomb] : laws_of_constants())
        for (const double preload : {20.0, 200.0}) {
            const LawOnJoint pressed_joint = pressed(preload, given);
            model::Structure constant = joint_with(pressed_joint);
            constant.contacts[0].friction = coulomb;
            constant.contacts[0].rest = {};
            const parameters::Case c = support::watched_case(pressed_joint.V, {law_duration, law_duration});
            record::Request request;
            request.history = record::KeepHistory::yes;
            const record::ContactHistory wanted =
                integration::integrate_exact(constant, c.drive, {Initial::stuck, 0.0}, {},
                                             record::Recorder(record::schedule(c), request, model::dofs_of(constant)))
                    .record.histories.front();
            const record::ContactHistory found = history_of(joint_with(pressed_joint), pressed_joint.V);
            ASSERT_EQ(found.size(), wanted.size()) << given.name << " " << preload;
            EXPECT_GT(found.size(), 5U) << given.name << " " << preload;
            for (std::size_t n = 0; n < found.size(); ++n) {
                EXPECT_EQ(found[n].state, wanted[n].state) << given.name << " " << n;
                EXPECT_NEAR(found[n].from, wanted[n].from, 1e-12) << given.name << " " << n;
            }
        }
}

}  // namespace
}  // namespace stridor
