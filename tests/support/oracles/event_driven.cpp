// The equations of motion of Elmaian et al. (2012), written out for (x1, y1, y2):
//
//     m1 x1'' + Cxx x1' + Cxy y1' + Kxx x1 + Kxy y1 = T
//     m1 y1'' + Cxy x1' + Cyy y1' + Kxy x1 + Kyy y1 = N - F
//     m2 y2'' + c2y y2' + k2y y2                    = F - N
//
// closed: y1 = y2 = y, both lines added give y''; N = F - m2 y'' - c2y y' - k2y y. Slip: T = -mu_d N sign(w). Stick:
// x1'' = V', T follows from the first line. Impact: plastic, momentum in y kept, impulse P = m1
// (y' after - y1' before); the tangential impulse stops the slip if m1 |w| <= mu_s P, else it is mu_d P against w.

#include "support/oracles/event_driven.hpp"

#include <cmath>
#include <stdexcept>

namespace stridor::support {

namespace {

using model::ContactState;
using State = std::array<double, 6>;  // x1, y1, y2, x1', y1', y2'

constexpr double pi = 3.14159265358979323846;

State plus(const State& a, const State& b, double factor) {
    State sum = a;
    for (std::size_t k = 0; k < sum.size(); ++k)
        sum[k] += factor * b[k];
    return sum;
}

class System {
public:
    explicit System(const parameters::Case& c) : c_(c) {
        const double angle = c.joint().incidence_angle * pi / 180.0;
        const double along = std::cos(angle), across = std::sin(angle);
        const auto rotate = [&](double axial, double flexural, double& xx, double& yy, double& xy) {
            xx = axial * along * along + flexural * across * across;
            yy = axial * across * across + flexural * along * along;
            xy = (axial - flexural) * across * along;
        };
        rotate(c.joint().axial_stiffness, c.joint().flexural_stiffness, kxx_, kyy_, kxy_);
        rotate(c.joint().axial_damping, c.joint().flexural_damping, cxx_, cyy_, cxy_);
    }

    double surface_velocity(double t) const {
        const double omega = 2.0 * pi * c_.drive.frequency;
        return c_.drive.kind == parameters::DriveKind::constant ? c_.drive.velocity
                                                                : c_.drive.amplitude * omega * std::cos(omega * t);
    }
    double surface_acceleration(double t) const {
        const double omega = 2.0 * pi * c_.drive.frequency;
        return c_.drive.kind == parameters::DriveKind::constant
                   ? 0.0
                   : -c_.drive.amplitude * omega * omega * std::sin(omega * t);
    }

    // forces of the joint's springs and dashpots on mass 1, and of the plate's on mass 2
    double joint_x(const State& s) const { return cxx_ * s[3] + cxy_ * s[4] + kxx_ * s[0] + kxy_ * s[1]; }
    double joint_y(const State& s) const { return cxy_ * s[3] + cyy_ * s[4] + kxy_ * s[0] + kyy_ * s[1]; }
    double plate_y(const State& s) const { return c_.plate.damping * s[5] + c_.plate.stiffness * s[2]; }

    double closed_acceleration(const State& s) const {
        return -(joint_y(s) + plate_y(s)) / (c_.joint().mass + c_.plate.mass);
    }
    double normal_force(const State& s) const {
        return c_.contact().preload - c_.plate.mass * closed_acceleration(s) - plate_y(s);
    }
    double stick_force(const State& s, double t) const {
        return c_.joint().mass * surface_acceleration(t) + joint_x(s);
    }

    // what must stay positive for the state to last; sign is that of the slip velocity
    double margin(ContactState state, double sign, const State& s, double t) const {
        if (state == ContactState::separation) return s[1] - s[2];
        const double N = normal_force(s);
        if (state == ContactState::slip) return std::min(N, sign * (s[3] - surface_velocity(t)) * force_per_velocity);
        return std::min(N, c_.contact().static_friction * N - std::abs(stick_force(s, t)));
    }

    State derivative(ContactState state, double sign, const State& s, double t) const {
        State d{s[3], s[4], s[5], 0.0, 0.0, 0.0};
        if (state == ContactState::separation) {
            d[3] = -joint_x(s) / c_.joint().mass;
            d[4] = (-c_.contact().preload - joint_y(s)) / c_.joint().mass;
            d[5] = (c_.contact().preload - plate_y(s)) / c_.plate.mass;
            return d;
        }
        d[4] = d[5] = closed_acceleration(s);
        d[3] = state == ContactState::stick
                   ? surface_acceleration(t)
                   : (-sign * c_.contact().kinetic_friction * normal_force(s) - joint_x(s)) / c_.joint().mass;
        return d;
    }

    State step(ContactState state, double sign, const State& s, double t, double h) const {
        const State k1 = derivative(state, sign, s, t);
        const State k2 = derivative(state, sign, plus(s, k1, 0.5 * h), t + 0.5 * h);
        const State k3 = derivative(state, sign, plus(s, k2, 0.5 * h), t + 0.5 * h);
        const State k4 = derivative(state, sign, plus(s, k3, h), t + h);
        State next = s;
        for (std::size_t k = 0; k < next.size(); ++k)
            next[k] += h / 6.0 * (k1[k] + 2.0 * k2[k] + 2.0 * k3[k] + k4[k]);
        return next;
    }

    // velocities just after the surfaces met
    State impact(State s, double t) const {
        const double m1 = c_.joint().mass, m2 = c_.plate.mass;
        const double common = (m1 * s[4] + m2 * s[5]) / (m1 + m2);
        const double impulse = m1 * (common - s[4]);
        const double w = s[3] - surface_velocity(t);
        const bool stops = m1 * std::abs(w) <= c_.contact().static_friction * impulse;
        s[3] = stops ? surface_velocity(t) : s[3] - std::copysign(c_.contact().kinetic_friction * impulse / m1, w);
        s[4] = s[5] = common;
        return s;
    }

    // the state a closed contact goes on in, and the sign of its slip
    ContactState closed_state(const State& s, double t, double& sign) const {
        const double N = normal_force(s);
        if (N < 0.0) return ContactState::separation;
        const double w = s[3] - surface_velocity(t);
        if (w != 0.0) {
            sign = w > 0.0 ? 1.0 : -1.0;
            return ContactState::slip;
        }
        const double T = stick_force(s, t);
        if (std::abs(T) <= c_.contact().static_friction * N) return ContactState::stick;
        sign = T > 0.0 ? -1.0 : 1.0;
        return ContactState::slip;
    }

private:
    // makes a slip velocity comparable with a force in one minimum: only signs matter
    static constexpr double force_per_velocity = 1e3;

    const parameters::Case& c_;
    double kxx_ = 0.0, kyy_ = 0.0, kxy_ = 0.0;  // [N/m]
    double cxx_ = 0.0, cyy_ = 0.0, cxy_ = 0.0;  // [N*s/m]
};

}  // namespace

IndependentMotion event_driven(const parameters::Case& c, double step, int sample_every) {
    const System system(c);
    IndependentMotion motion;
    State s{};
    if (c.run.initial == parameters::Initial::stuck) s[3] = system.surface_velocity(0.0);
    double sign = 1.0;
    ContactState state = system.closed_state(s, 0.0, sign);
    motion.history.push_back({state, 0.0, 0.0, 0.0, 0.0});

    const auto steps = std::lround(c.run.duration / step);
    for (long n = 0; n < steps; ++n) {
        if (n % sample_every == 0) {
            motion.time.push_back(static_cast<double>(n) * step);
            motion.position.push_back({s[0], s[1], s[2]});
        }
        double t = static_cast<double>(n) * step;
        const double end = static_cast<double>(n + 1) * step;
        for (int changes = 0; t < end; ++changes) {
            if (changes > 1000) throw std::runtime_error("the contact chatters");
            State next = system.step(state, sign, s, t, end - t);
            if (system.margin(state, sign, next, end) >= 0.0) {
                s = next;
                break;
            }
            // the first instant within the step at which the state no longer lasts
            double low = 0.0, high = end - t;
            while (high - low > 1e-15) {
                const double middle = 0.5 * (low + high);
                if (system.margin(state, sign, system.step(state, sign, s, t, middle), t + middle) >= 0.0)
                    low = middle;
                else
                    high = middle;
            }
            s = system.step(state, sign, s, t, high);
            t += high;
            if (state == ContactState::separation) {
                s = system.impact(s, t);
                s[1] = s[2] = (c.joint().mass * s[1] + c.plate.mass * s[2]) / (c.joint().mass + c.plate.mass);
            } else if (state == ContactState::slip && system.normal_force(s) > 0.0) {
                s[3] = system.surface_velocity(t);  // the slip velocity ran through zero
            }
            const ContactState before = state;
            state = system.closed_state(s, t, sign);
            if (state == before) continue;
            motion.history.back().to = t;
            motion.history.push_back({state, t, 0.0, s[3] - system.surface_velocity(t), s[4] - s[5]});
        }
    }
    motion.history.back().to = static_cast<double>(steps) * step;
    return motion;
}

}  // namespace stridor::support
