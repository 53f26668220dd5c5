#include "support/oracles/belt_by_runge_kutta.hpp"

#include <boost/numeric/odeint.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace stridor::support {

namespace {

using Real = long double;
using State = std::array<Real, 2>;  // x [m], x' [m/s]
namespace odeint = boost::numeric::odeint;

constexpr Real tolerance = 1e-16L;
constexpr Real event_accuracy = 1e-17L;  // [s]

struct Slipping {
    const model::Belt& belt;
    const model::FrictionLaw& law;
    double V;
    model::Slip way;
    const std::vector<double>& corners;

    // corners below the speed of slip
    std::ptrdiff_t corners_below(const State& s) const {
        const Real speed = (way == model::Slip::forward ? 1 : -1) * (s[1] - Real(V));
        return std::upper_bound(corners.begin(), corners.end(), static_cast<double>(speed)) - corners.begin();
    }

    void operator()(const State& s, State& rate, Real) const {
        const Real friction = slip_ratio(law, way, static_cast<double>(s[1] - Real(V))) * Real(belt.preload);
        rate = {s[1], (friction - Real(belt.damping) * s[1] - Real(belt.stiffness) * s[0]) / Real(belt.mass)};
    }
};

// by one step of this length, which the stepper's error allows
State stepped(const Slipping& motion, State s, Real time, Real step) {
    odeint::runge_kutta_fehlberg78<State, Real> stepper;
    stepper.do_step(motion, s, time, step);
    return s;
}

// goes on until the slip velocity changes its sign, or until `until`
void slip(const Slipping& motion, State& s, Real& time, Real until) {
    auto stepper = odeint::make_controlled<odeint::runge_kutta_fehlberg78<State, Real>>(tolerance, tolerance);
    const Real sign = motion.way == model::Slip::forward ? 1 : -1;
    const auto slips = [&](const State& state) { return sign * (state[1] - Real(motion.V)) > 0; };
    const Real first_step = 1e-3L * std::sqrt(Real(motion.belt.mass) / Real(motion.belt.stiffness));
    Real step = first_step;
    for (bool has_begun = false; time < until;) {
        const State before = s;
        const Real from = time;
        if (stepper.try_step(motion, s, time, step) != odeint::success) continue;
        if (slips(s)) has_begun = true;
        if (!has_begun) continue;
        const std::ptrdiff_t stretch = motion.corners_below(before);
        const bool is_event = !slips(s);
        if (!is_event && motion.corners_below(s) == stretch) continue;
        Real low = 0, high = time - from;
        while (high - low > event_accuracy) {
            const Real middle = (low + high) / 2;
            if (middle <= low || middle >= high) break;
            const State there = stepped(motion, before, from, middle);
            const bool is_before = is_event ? slips(there) : motion.corners_below(there) == stretch;
            (is_before ? low : high) = middle;
        }
        s = stepped(motion, before, from, high);
        time = from + high;
        if (is_event) return;
        step = std::min(step, first_step);
    }
}

}  // namespace

std::vector<BeltEvent> belt_by_runge_kutta(const model::Belt& belt, const model::FrictionLaw& law, double V,
                                           double until, const std::vector<double>& corners) {
    std::vector<BeltEvent> events;
    State s{0, V};
    Real time = 0;
    const Real V_long = V, pull = stick_limit(law, model::Slip::backward) * Real(belt.preload);
    while (time < until) {
        // stuck: the spring and the dashpot pull back until friction gives in, T = k x + c V
        const Real place = (pull - Real(belt.damping) * V_long) / Real(belt.stiffness);
        time += (place - s[0]) / V_long;
        s = {place, V_long};
        if (time >= until) break;
        events.push_back({static_cast<double>(time), false, static_cast<double>(s[0])});
        slip({belt, law, V, model::Slip::backward, corners}, s, time, until);
        if (time >= until) break;
        events.push_back({static_cast<double>(time), true, static_cast<double>(s[0])});
    }
    return events;
}

}  // namespace stridor::support
