// The quad-precision reference (support/oracles/quad_reference) against closed forms, published digits,
// itself and event_driven.

#include "support/oracles/quad_reference.hpp"

#include "stridor/parameters/paper_cases.hpp"
#include "stridor/verification/table_1.hpp"
#include "support/constant_case.hpp"
#include "support/effort.hpp"
#include "support/oracles/event_driven.hpp"
#include "support/oracles/quad.hpp"
#include "support/periods.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace stridor {
namespace {

using model::ContactState;
using parameters::Case;
using parameters::PaperCase;
using support::constant_case;
using support::Quad;
using support::quad_reference;
using support::QuadOptions;

constexpr double pi = 3.14159265358979323846;

// [1] the last bits of a Quad, some of them lost in sums
constexpr double quad_rounding = 1e-31;

double difference(Quad a, Quad b) {
    return static_cast<double>(support::magnitude(a - b));
}

TEST(QuadNumbers, HaveSinesOfThirtyDigits) {
    const auto [sine_30, cosine_30] = support::sine_cosine(support::quad_pi() / 6);
    EXPECT_LT(difference(sine_30, Quad(0.5)), quad_rounding);
    EXPECT_LT(difference(cosine_30 * cosine_30, Quad(0.75)), quad_rounding);
    EXPECT_LT(difference(support::sine_cosine(support::quad_pi()).cosine, Quad(-1)), quad_rounding);
}

// scale (x - a)(x - b)
support::Series<Quad> parabola(Quad a, Quad b, Quad scale) {
    support::Series<Quad> p{};
    p[0] = scale * a * b;
    p[1] = -scale * (a + b);
    p[2] = scale;
    return p;
}

// both inside one step, a billionth of it apart: every method that only looks at the ends misses them
TEST(FirstFall, FindsTheFirstOfTwoNeighbouringRoots) {
    const Quad a = Quad(1) / 3;
    const auto root = support::first_fall(parabola(a, a + Quad(1e-9), 1), 1);
    ASSERT_TRUE(root.has_value());
    EXPECT_LT(difference(*root, a), 1e-22);  // rounding 1e-33 over the slope 1e-9
}

TEST(FirstFall, TakesATouchForNoFall) {
    EXPECT_FALSE(support::first_fall(parabola(Quad(0.625), Quad(0.625), 7), 1).has_value());
}

TEST(FirstFall, LooksNoFurtherThanTheEnd) {
    const Quad a = Quad(1) / 3;
    EXPECT_FALSE(support::first_fall(parabola(a, 2, 1), a - Quad(1e-20)).has_value());
    EXPECT_TRUE(support::first_fall(parabola(a, 2, 1), a + Quad(1e-20)).has_value());
}

// the stick force of a joint at rest on a plate at rest
TEST(FirstFall, FindsNoneInASeriesOfZeros) {
    EXPECT_FALSE(support::first_fall(support::Series<Quad>{}, 1).has_value());
}

// x³ (x - 1/3)(x - 2): the root that has just happened is divided out, the next one stays
TEST(FirstFall, IsNotDisturbedByTheRootThatHasJustHappened) {
    support::Series<Quad> p{};
    const support::Series<Quad> rest = parabola(Quad(1) / 3, 2, 1);
    for (std::size_t k = 0; k < 3; ++k)
        p[k + 3] = rest[k];
    p[2] = Quad(-1e-33);  // as rounding leaves it
    const auto root = support::first_fall(support::without_root_at_zero(p, 3), 1);
    ASSERT_TRUE(root.has_value());
    EXPECT_LT(difference(*root, Quad(1) / 3), quad_rounding);
}

// [s] in a state between two instants
double time_in(ContactState state, const record::ContactHistory& history, double from, double to) {
    double sum = 0.0;
    for (const record::ContactInterval& interval : history)
        if (interval.state == state) sum += std::max(0.0, std::min(interval.to, to) - std::max(interval.from, from));
    return sum;
}

TEST(QuadReference, GivesThePublishedDigitsOfStickSlip) {
    for (const verification::StickSlip& known : std::span(verification::stick_slips).first(support::effort(3U, 1U))) {
        Case c = constant_case(PaperCase::squeak, -0.1257, 2.0);
        c.contact().preload = known.preload;
        c.run.initial = parameters::Initial::stuck;
        const record::ContactHistory history = quad_reference(c).history;
        // half a unit of the last digit printed
        EXPECT_NEAR(time_in(ContactState::stick, history, 1.0, 2.0), known.stick_fraction, 0.51e-6) << known.preload;
        EXPECT_NEAR(support::whole_periods(history, ContactState::stick, 1.0).period, known.period, 0.51e-10)
            << known.preload;
    }
}

// at 90 deg x and y part: N = F, and the joint is the mass on a belt
TEST(QuadReference, SticksAndSlipsAsTheClosedFormOfTheBelt) {
    Case c = constant_case(PaperCase::creak, 0.05, 0.1);
    c.joint().incidence_angle = 90.0;
    c.joint().axial_damping = c.joint().flexural_damping = c.plate.damping = 0.0;
    c.run.initial = parameters::Initial::stuck;
    const double w0 = std::sqrt(c.joint().flexural_stiffness / c.joint().mass);
    const double lag = (c.contact().static_friction - c.contact().kinetic_friction) * c.contact().preload;  // [N]
    const double lambda = w0 * lag / c.joint().flexural_stiffness / c.drive.velocity;
    const double stick = 2.0 * lambda / w0, slip = 2.0 * (pi - std::atan(lambda)) / w0;
    const record::ContactHistory history = quad_reference(c).history;
    ASSERT_GE(history.size(), 4U);
    // the first stick begins at the spring's rest, the last state is cut by the end
    for (std::size_t k = 1; k + 1 < history.size(); ++k) {
        const bool is_stick = history[k].state == ContactState::stick;
        EXPECT_EQ(history[k].state, k % 2 == 0 ? ContactState::stick : ContactState::slip);
        // differences of times below 0.1 s, rounded to 1e-17 s
        EXPECT_NEAR(history[k].to - history[k].from, is_stick ? stick : slip, 1e-16);
    }
}

// Number of changes of state, from the first on, that both make within `tolerance` [s] of each other.
std::size_t common_changes(const record::ContactHistory& a, const record::ContactHistory& b, double tolerance) {
    std::size_t n = 0;
    while (n < std::min(a.size(), b.size()) && a[n].state == b[n].state && std::abs(a[n].from - b[n].from) <= tolerance)
        ++n;
    return n;
}

// Two thirds of the step put the ends of steps elsewhere; truncation and rounding, 1e-30, grow along an irregular
// motion, yet not to the last bit of a double within these times.
TEST(QuadReference, DoesNotDependOnItsStep) {
    for (const PaperCase which : {PaperCase::squeal, PaperCase::squeak, PaperCase::creak}) {
        const Case c = constant_case(which, 0.1, 0.2);
        QuadOptions shorter;
        shorter.step_share = 2.0 / 3.0;
        const record::ContactHistory history = quad_reference(c).history;
        EXPECT_GT(history.size(), 50U);
        EXPECT_EQ(common_changes(history, quad_reference(c, shorter).history, 1e-16), history.size());
    }
}

// event_driven errs by some (10⁴ rad/s · 2e-6 s)⁴ / 120 of a step's motion per step, 1e-9 in all,
// and finds times to 1e-15 s
TEST(QuadReference, AgreesWithTheIndependentEngine) {
    for (const PaperCase which : {PaperCase::squeal, PaperCase::squeak}) {
        const Case c = constant_case(which, 0.1, support::effort(0.5, 0.1));
        const record::ContactHistory history = quad_reference(c).history;
        EXPECT_GT(history.size(), support::effort(400U, 50U));
        EXPECT_EQ(common_changes(history, support::event_driven(c, 2e-6, 1 << 30).history, 1e-9), history.size());
    }
    Case sinusoidal = parameters::paper_case(PaperCase::squeal);
    sinusoidal.run.duration = sinusoidal.run.window = 0.15;
    const record::ContactHistory history = quad_reference(sinusoidal).history;
    EXPECT_GT(history.size(), 20U);
    EXPECT_EQ(common_changes(history, support::event_driven(sinusoidal, 2e-6, 1 << 30).history, 1e-9), history.size());
}

// without a jump of the friction force w leaves zero with w' = 0 too: a double root
TEST(QuadReference, ReleasesAContactWithoutAJumpOfTheFrictionForce) {
    Case c = constant_case(PaperCase::squeal, 0.1, 0.1);
    c.contact().kinetic_friction = c.contact().static_friction;
    const record::ContactHistory history = quad_reference(c).history;
    int releases = 0;
    for (std::size_t k = 1; k < history.size(); ++k)
        releases += history[k - 1].state == ContactState::stick && history[k].state == ContactState::slip ? 1 : 0;
    EXPECT_GT(releases, 10);
    EXPECT_EQ(common_changes(history, support::event_driven(c, 2e-6, 1 << 30).history, 1e-9), history.size());
}

TEST(QuadReference, LeavesAnImpactInsideTheFrictionCone) {
    const Case c = constant_case(PaperCase::squeal, 0.1, 0.1);
    const double reduced = c.joint().mass * c.plate.mass / (c.joint().mass + c.plate.mass);
    const auto impacts = quad_reference(c).impacts;
    EXPECT_GT(impacts.size(), 10U);
    for (const support::QuadImpact& impact : impacts) {
        EXPECT_LT(impact.gap_velocity, 0.0);
        EXPECT_EQ(impact.rebound_velocity, 0.0);
        const double to_stop = std::abs(impact.slip_before) * c.joint().mass;  // [N s]
        const double normal = -reduced * impact.gap_velocity;                  // [N s]
        const bool stops = to_stop <= c.contact().static_friction * normal;
        const double change = stops ? to_stop : c.contact().kinetic_friction * normal;
        EXPECT_NEAR((impact.slip_before - impact.slip_after) * c.joint().mass,
                    std::copysign(change, impact.slip_before), 1e-17);
    }
}

// The impact law moves the rates: with impulses along the normal only the squeal of Table 1 is open for 48.8 %, else
// for 38.6 % (irregular in part: to half a per cent).
TEST(QuadReference, ShowsWhatTheTangentialImpulseDoes) {
    const Case c = parameters::paper_case(PaperCase::squeal);
    QuadOptions normal_only;
    normal_only.impact_friction = support::ImpactFriction::none;
    EXPECT_NEAR(time_in(ContactState::separation, quad_reference(c).history, 0.0, 1.0), 0.386, 5e-3);
    EXPECT_NEAR(time_in(ContactState::separation, quad_reference(c, normal_only).history, 0.0, 1.0), 0.488, 5e-3);
}

// The last bounces before the contact closes are those of a ball: each e times as fast and as long as the one
// before. What the forces change during one is of the order of its duration times the highest frequency, here
// below 1e-7 s 10⁴ rad/s.
TEST(QuadReference, BouncesAsABallBeforeItComesToRest) {
    const Case c = constant_case(PaperCase::squeal, 0.1, 0.02);
    QuadOptions options;
    options.restitution = 0.5;
    const auto impacts = quad_reference(c, options).impacts;
    int bounces = 0;
    for (std::size_t n = 2; n < impacts.size(); ++n) {
        const double before = impacts[n - 1].gap_velocity, now = impacts[n].gap_velocity;
        const double duration = impacts[n].time - impacts[n - 1].time;
        if (duration > 1e-7 || impacts[n - 1].rebound_velocity == 0.0) continue;
        EXPECT_NEAR(now / before, options.restitution, 1e-3);
        ++bounces;
    }
    EXPECT_GT(bounces, 20);
}

}  // namespace
}  // namespace stridor
