// With a_0 = M^-1 (f_0 - C u' - K u) and W = (n, t)' M^-1 (n, t), a closed contact has n.u'' = 0:
//
//     slip, T = r N:  N = -n.a_0/(W_nn + r W_nt)        stick:  W (N, T) = -(n.a_0, t.a_0)

#include "support/oracles/rubbing_by_runge_kutta.hpp"

#include <Eigen/Dense>
#include <boost/numeric/odeint.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace stridor::support {

namespace {

namespace odeint = boost::numeric::odeint;
using model::ContactState;
using Real = long double;
using Rows = Eigen::Matrix<Real, 3, 1>;
using Square = Eigen::Matrix<Real, 3, 3>;
using Pair = Eigen::Matrix<Real, 2, 1>;
using JointState = std::array<Real, 7>;  // u [m], u' [m/s], friction state [1]

constexpr Real step_error = 1e-17L;
constexpr Real event_error = 1e-19L;  // [s]

// with the way of a slip, -1 or 1
struct Doing {
    ContactState state = ContactState::stick;
    Real way = 1;
    Real since = 0;  // [s]
};

class Rubbed {
public:
    Rubbed(const model::Structure& structure, const LawAnew& law, double V)
        : law_(law),
          V_(V),
          inverse_(structure.mass.cast<Real>().inverse()),
          damping_(structure.damping.cast<Real>()),
          stiffness_(structure.stiffness.cast<Real>()),
          load_(structure.load.cast<Real>()),
          normal_(structure.contacts[0].normal.cast<Real>()),
          tangent_(structure.contacts[0].tangent.cast<Real>()) {
        const Eigen::Matrix<Real, 3, 2> both = (Eigen::Matrix<Real, 3, 2>() << normal_, tangent_).finished();
        push_ = inverse_ * both;
        compliance_ = both.transpose() * push_;
        if (compliance_(0, 1) != 0) throw std::invalid_argument("an impact along the normal pushes along the tangent");
    }

    bool has_state() const { return static_cast<bool>(law_.rate); }
    Real slip_velocity(const JointState& s) const { return tangent_.dot(Rows(s[3], s[4], s[5])) - V_; }
    Real gap(const JointState& s) const { return normal_.dot(Rows(s[0], s[1], s[2])); }
    Real limit(const Doing& doing, Real time) const { return law_.limit(time - doing.since); }

    // N and T
    Pair forces(const Doing& doing, const JointState& s) const {
        const Rows free = free_acceleration(s);
        if (doing.state == ContactState::separation) return Pair::Zero();
        const Pair wanted(-normal_.dot(free), -tangent_.dot(free));
        if (doing.state == ContactState::stick) return compliance_.inverse() * wanted;
        const Real ratio = -doing.way * law_.resistance(doing.way * slip_velocity(s), turned(doing, s[6]));
        const Real N = wanted(0) / (compliance_(0, 0) + ratio * compliance_(0, 1));
        return Pair(N, ratio * N);
    }

    void rates(const Doing& doing, const JointState& s, JointState& rate) const {
        const Rows a = free_acceleration(s) + push_ * forces(doing, s);
        rate = {s[3], s[4], s[5], a(0), a(1), a(2), 0};
        if (has_state() && doing.state == ContactState::slip)
            rate[6] = turned(doing, law_.rate(doing.way * slip_velocity(s), turned(doing, s[6])));
    }

    // impulses that end the slip, without the normal's
    void end_slip(JointState& s) const { push(s, Pair(0, -slip_velocity(s) / compliance_(1, 1))); }

    // at rest it sticks, or slips as its force pulls
    Doing rested(const JointState& s, Real time) const {
        const Doing stuck{ContactState::stick, 1, time};
        const Pair force = forces(stuck, s);
        if (std::abs(force(1)) <= limit(stuck, time) * force(0)) return stuck;
        return {ContactState::slip, force(1) > 0 ? Real(-1) : Real(1), time};
    }

    Doing after_impact(JointState& s, Real time) const {
        const Real w = slip_velocity(s), way = w > 0 ? 1 : -1;
        const Real P = -normal_.dot(Rows(s[3], s[4], s[5])) / compliance_(0, 0);
        const Real stops = has_state() ? law_.impact_limit : law_.limit(0);
        if (std::abs(w) <= stops * P * compliance_(1, 1)) {
            push(s, Pair(P, -w / compliance_(1, 1)));
            if (!has_state()) return opened(rested(s, time), s, time);
            return opened({ContactState::slip, slip_that_begins(s), time}, s, time);
        }
        const Real left = fastest_left(std::abs(w), P * compliance_(1, 1));
        push(s, Pair(P, way * (left - std::abs(w)) / compliance_(1, 1)));
        return opened({ContactState::slip, way, time}, s, time);
    }

    // of a law with a state, where w = 0: which way the force pulls it
    Real slip_that_begins(const JointState& s) const {
        JointState rate;
        rates({ContactState::slip, 1, 0}, s, rate);
        return tangent_.dot(Rows(rate[3], rate[4], rate[5])) > 0 ? 1 : -1;
    }

    // what the record says
    ContactState told(const Doing& doing, const JointState& s) const {
        if (doing.state != ContactState::slip || !has_state()) return doing.state;
        return std::abs(slip_velocity(s)) < law_.creep_speed ? ContactState::stick : ContactState::slip;
    }

    std::ptrdiff_t corners_below(const JointState& s) const {
        const Real speed = std::abs(slip_velocity(s));
        return std::upper_bound(law_.corners.begin(), law_.corners.end(), speed) - law_.corners.begin();
    }

    Rows free_acceleration(const JointState& s) const {
        return inverse_ * (load_ - damping_ * Rows(s[3], s[4], s[5]) - stiffness_ * Rows(s[0], s[1], s[2]));
    }

private:
    Real turned(const Doing& doing, Real state) const { return law_.state_turns ? doing.way * state : state; }

    Doing opened(const Doing& closed, const JointState& s, Real time) const {
        return forces(closed, s)(0) < 0 ? Doing{ContactState::separation, 1, time} : closed;
    }

    // the fastest slip v = w - reach mu(v) after an impact: downwards from w where friction falls with speed; halved
    // where it rises so steeply that this swings
    Real fastest_left(Real w, Real reach) const {
        const auto after = [&](Real speed) {
            return std::max(Real(0), w - reach * (law_.impact ? law_.impact(speed) : law_.resistance(speed, 0)));
        };
        Real left = w;
        for (int turn = 0; turn < 1000; ++turn) {
            const Real next = after(left);
            if (std::abs(next - left) <= 1e-19L * w) return next;
            left = next;
        }
        Real low = 0, high = w;
        for (int turn = 0; turn < 200; ++turn) {
            const Real middle = (low + high) / 2;
            (after(middle) > middle ? low : high) = middle;
        }
        return high;
    }

    void push(JointState& s, const Pair& impulse) const {
        const Rows change = push_ * impulse;
        for (int row = 0; row < 3; ++row)
            s[static_cast<std::size_t>(3 + row)] += change(row);
    }

    const LawAnew& law_;
    Real V_;
    Square inverse_, damping_, stiffness_;
    Rows load_, normal_, tangent_;
    Eigen::Matrix<Real, 3, 2> push_;
    Eigen::Matrix<Real, 2, 2> compliance_;
};

// what is above zero while a state lasts; that of its own kind first: the gap, or the speed of slip
struct Margins {
    Real own = 1;
    Real normal_force = 1;
    Real room = 1;  // to the limit of a stick
};

Margins margins(const Rubbed& rubbed, const Doing& doing, const JointState& s, Real time) {
    if (doing.state == ContactState::separation) return {rubbed.gap(s), 1, 1};
    const Pair force = rubbed.forces(doing, s);
    if (doing.state == ContactState::slip) return {doing.way * rubbed.slip_velocity(s), force(0), 1};
    return {1, force(0), rubbed.limit(doing, time) * force(0) - std::abs(force(1))};
}

bool lasts(const Margins& now, bool has_begun) {
    return (now.own > 0 || !has_begun) && now.normal_force >= 0 && now.room >= 0;
}

// the state that follows; the motion is put where the event leaves it
Doing changed(const Rubbed& rubbed, const Doing& doing, JointState& s, Real time) {
    if (doing.state == ContactState::separation) return rubbed.after_impact(s, time);
    if (margins(rubbed, doing, s, time).normal_force < 0) {
        s[6] = 0;
        return {ContactState::separation, 1, time};
    }
    if (doing.state == ContactState::stick)
        return {ContactState::slip, rubbed.forces(doing, s)(1) > 0 ? Real(-1) : Real(1), time};
    rubbed.end_slip(s);
    return rubbed.has_state() ? Doing{ContactState::slip, -doing.way, time} : rubbed.rested(s, time);
}

}  // namespace

std::vector<RubbingEvent> rubbing_by_runge_kutta(const model::Structure& structure, const LawAnew& law, double V,
                                                 double until, std::size_t most) {
    using Stepper = odeint::runge_kutta_fehlberg78<JointState, Real>;
    const Rubbed rubbed(structure, law, V);
    JointState s{};
    for (int row = 0; row < 3; ++row)
        s[static_cast<std::size_t>(3 + row)] = Real(structure.contacts[0].tangent(row)) * Real(V);
    Doing doing{rubbed.has_state() ? ContactState::slip : ContactState::stick, V > 0 ? Real(-1) : Real(1), 0};
    ContactState told = rubbed.told(doing, s);
    std::vector<RubbingEvent> events;
    const Real first_step = 1e-3L * std::sqrt(Real((structure.mass * structure.stiffness.inverse()).trace()));
    Real time = 0, step = first_step;
    auto stepper = odeint::make_controlled<Stepper>(step_error, step_error);
    for (bool has_begun = false; time < until && events.size() < most;) {
        const auto motion = [&](const JointState& at, JointState& rate, Real) { rubbed.rates(doing, at, rate); };
        const JointState before = s;
        const Real from = time;
        step = std::min({step, law.longest_step, Real(until) - time});
        if (stepper.try_step(motion, s, time, step) != odeint::success) continue;
        const auto length = time - from;
        const std::ptrdiff_t stretch = rubbed.corners_below(before);
        const auto goes_on = [&](const JointState& at, Real when) {
            return lasts(margins(rubbed, doing, at, when), has_begun) && rubbed.told(doing, at) == told &&
                   (doing.state != ContactState::slip || rubbed.corners_below(at) == stretch);
        };
        if (!goes_on(s, time)) {
            Real low = 0, high = length;
            const auto stepped = [&](Real part) {
                JointState there = before;
                Stepper().do_step(motion, there, from, part);
                return there;
            };
            while (high - low > event_error) {
                const Real middle = (low + high) / 2;
                if (middle <= low || middle >= high) break;
                (goes_on(stepped(middle), from + middle) ? low : high) = middle;
            }
            s = stepped(high);
            time = from + high;
            step = std::min(step, first_step);
            if (!lasts(margins(rubbed, doing, s, time), has_begun)) {
                doing = changed(rubbed, doing, s, time);
                has_begun = false;
            }
        }
        has_begun = has_begun || margins(rubbed, doing, s, time).own > 0;
        if (rubbed.told(doing, s) == told) continue;
        told = rubbed.told(doing, s);
        events.push_back({static_cast<double>(time), told});
    }
    return events;
}

}  // namespace stridor::support
