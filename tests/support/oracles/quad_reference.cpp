// The equations of Elmaian et al. (2012) as in event_driven.cpp, within a contact state linear:
//
//     m1 x1'' + Cxx x1' + Cxy y1' + Kxx x1 + Kxy y1 = T
//     m1 y1'' + Cxy x1' + Cyy y1' + Kxy x1 + Kyy y1 = N - F
//     m2 y2'' + c2y y2' + k2y y2                    = F - N,      V' = -ω Q, Q' = ω V (constant drive: ω = 0)
//
// Order by order: with u = Σ uₖ τᵏ, t = t₀ + h τ, the k-th coefficients of the forces follow from those of u and u',
// and uₖ₊₁ = h u'ₖ / (k + 1), u'ₖ₊₁ = h u''ₖ / (k + 1). With h (all frequencies) < 1 the series ends below 1e-33.
//
// A state lasts while its event functions are positive (separation: g; slip: N, ±w; stick: mu_s N ∓ T): series too,
// whose first fall through zero is found by first_fall. What has just happened gives an event function a root at
// τ = 0 of known multiplicity, which is divided out: g after lift-off 3 (g'' ~ N = 0), after an impact with N < 0
// 2, after a rebound 1; w after stick 1, or 2 if mu_s = mu_d, where T does not jump. Nothing is decided by the sign
// of a rounding error.

#include "support/oracles/quad_reference.hpp"

#include "support/oracles/quad.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace stridor::support {

namespace {

using model::ContactState;
using QuadSeries = Series<Quad>;

struct Constants {
    Quad m1, m2, kxx, kyy, kxy, cxx, cyy, cxy, k2y, c2y;  // [kg], [N/m], [N*s/m]
    Quad preload, mu_s, mu_d;                             // [N], [1], [1]
    Quad omega;                                           // [rad/s] of the drive, 0 if V is constant
    Quad step;                                            // [s] h
};

struct QuadState {
    Quad x1, y1, y2, vx, vy1, vy2;  // [m], [m/s]
    Quad V, Q;                      // [m/s] surface velocity and its quadrature
};

// a contact state and the roots its event functions have just now
struct Mode {
    ContactState state = ContactState::slip;
    int sign = 1;                      // of the slip velocity
    std::array<std::size_t, 2> roots;  // multiplicity at τ = 0 of each event function
};

// series of everything over one step
struct Expansion {
    QuadSeries x1{}, y1{}, y2{}, vx{}, vy1{}, vy2{}, V{}, Q{};
    QuadSeries N{}, T{};  // [N] closed: normal force; friction force that would keep w' = 0
};

Constants prepare(const parameters::Case& c, const QuadOptions& options) {
    Constants k{};
    const auto [s, q] = sine_cosine(Quad(c.joint().incidence_angle) * quad_pi() / 180);
    const auto rotate = [&, sine = s, cosine = q](double along, double across, Quad& xx, Quad& yy, Quad& xy) {
        const Quad axial = static_cast<Quad>(along);
        const Quad flexural = static_cast<Quad>(across);
        xx = axial * cosine * cosine + flexural * sine * sine;
        yy = axial * sine * sine + flexural * cosine * cosine;
        xy = (axial - flexural) * sine * cosine;
    };
    rotate(c.joint().axial_stiffness, c.joint().flexural_stiffness, k.kxx, k.kyy, k.kxy);
    rotate(c.joint().axial_damping, c.joint().flexural_damping, k.cxx, k.cyy, k.cxy);
    k.m1 = Quad(c.joint().mass);
    k.m2 = Quad(c.plate.mass);
    k.k2y = Quad(c.plate.stiffness);
    k.c2y = Quad(c.plate.damping);
    k.preload = Quad(c.contact().preload);
    k.mu_s = Quad(c.contact().static_friction);
    k.mu_d = Quad(c.contact().kinetic_friction);
    const bool is_constant = c.drive.kind == parameters::DriveKind::constant;
    k.omega = is_constant ? Quad(0) : 2 * quad_pi() * Quad(c.drive.frequency);

    // above every frequency and decay rate of every contact state
    const double lightest = std::min(c.joint().mass, c.plate.mass);
    const double all_springs = c.joint().axial_stiffness + c.joint().flexural_stiffness + c.plate.stiffness;
    const double all_dashpots = c.joint().axial_damping + c.joint().flexural_damping + c.plate.damping;
    const double friction = 1.0 + c.contact().kinetic_friction;
    const double rate = std::sqrt(2.0 * friction * all_springs / lightest) + friction * all_dashpots / lightest +
                        static_cast<double>(k.omega);
    k.step = Quad(options.step_share / rate);
    return k;
}

class Run {
public:
    Run(const parameters::Case& c, const QuadOptions& options) : k_(prepare(c, options)), options_(options) {
        const bool is_constant = c.drive.kind == parameters::DriveKind::constant;
        s_.V = is_constant ? Quad(c.drive.velocity) : Quad(c.drive.amplitude) * k_.omega;
        if (c.run.initial == parameters::Initial::stuck) s_.vx = s_.V;
    }

    QuadMotion motion(Quad duration);

private:
    // forces of the joint's springs and dashpots on mass 1, and of the plate's on mass 2
    Quad joint_x() const { return k_.cxx * s_.vx + k_.cxy * s_.vy1 + k_.kxx * s_.x1 + k_.kxy * s_.y1; }
    Quad joint_y() const { return k_.cxy * s_.vx + k_.cyy * s_.vy1 + k_.kxy * s_.x1 + k_.kyy * s_.y1; }
    Quad plate_y() const { return k_.c2y * s_.vy2 + k_.k2y * s_.y2; }
    Quad normal_force() const { return k_.preload + (k_.m2 * joint_y() - k_.m1 * plate_y()) / (k_.m1 + k_.m2); }
    Quad stick_force() const { return joint_x() - k_.m1 * k_.omega * s_.Q; }

    Expansion expand(Quad h) const;
    QuadState at(const Expansion& e, Quad tau) const;
    std::array<QuadSeries, 2> event_functions(const Expansion& e) const;
    bool advance(Quad end);

    void change(std::size_t which);
    void touch_down();
    void continue_closed();
    void continue_without_slip();
    void enter(ContactState state, int sign, std::array<std::size_t, 2> roots) { mode_ = {state, sign, roots}; }
    void note(Quad gap_velocity);

    Constants k_;
    QuadOptions options_;
    QuadState s_{};
    Mode mode_{};
    Quad t_ = 0;             // [s]
    Quad gap_velocity_ = 0;  // [m/s] g' before the change that has just happened
    QuadMotion motion_;
};

Expansion Run::expand(Quad h) const {
    Expansion e;
    e.x1[0] = s_.x1, e.y1[0] = s_.y1, e.y2[0] = s_.y2;
    e.vx[0] = s_.vx, e.vy1[0] = s_.vy1, e.vy2[0] = s_.vy2;
    e.V[0] = s_.V, e.Q[0] = s_.Q;
    const bool is_open = mode_.state == ContactState::separation;
    const Quad total = k_.m1 + k_.m2;
    for (std::size_t k = 0; k <= series_order; ++k) {
        const Quad F = k == 0 ? k_.preload : Quad(0);
        const Quad jx = k_.cxx * e.vx[k] + k_.cxy * e.vy1[k] + k_.kxx * e.x1[k] + k_.kxy * e.y1[k];
        const Quad jy = k_.cxy * e.vx[k] + k_.cyy * e.vy1[k] + k_.kxy * e.x1[k] + k_.kyy * e.y1[k];
        const Quad plate = k_.c2y * e.vy2[k] + k_.k2y * e.y2[k];
        const Quad surface_acceleration = -k_.omega * e.Q[k];
        e.N[k] = is_open ? Quad(0) : F + (k_.m2 * jy - k_.m1 * plate) / total;
        e.T[k] = jx + k_.m1 * surface_acceleration;
        if (k == series_order) break;

        const Quad next = h / static_cast<Quad>(k + 1);
        e.x1[k + 1] = next * e.vx[k];
        e.y1[k + 1] = next * e.vy1[k];
        e.y2[k + 1] = next * e.vy2[k];
        e.V[k + 1] = next * surface_acceleration;
        e.Q[k + 1] = next * k_.omega * e.V[k];
        e.vx[k + 1] =
            mode_.state == ContactState::stick ? e.V[k + 1] : next * (-mode_.sign * k_.mu_d * e.N[k] - jx) / k_.m1;
        // closed: both masses move alike, to the last bit
        e.vy1[k + 1] = is_open ? next * (-F - jy) / k_.m1 : -next * (jy + plate) / total;
        e.vy2[k + 1] = is_open ? next * (F - plate) / k_.m2 : e.vy1[k + 1];
    }
    return e;
}

QuadState Run::at(const Expansion& e, Quad tau) const {
    QuadState s{value(e.x1, tau),  value(e.y1, tau),  value(e.y2, tau), value(e.vx, tau),
                value(e.vy1, tau), value(e.vy2, tau), value(e.V, tau),  value(e.Q, tau)};
    if (mode_.state == ContactState::stick) s.vx = s.V;
    return s;
}

std::array<QuadSeries, 2> Run::event_functions(const Expansion& e) const {
    std::array<QuadSeries, 2> f{};
    for (std::size_t k = 0; k <= series_order; ++k) {
        if (mode_.state == ContactState::separation) {
            f[0][k] = e.y1[k] - e.y2[k];
        } else if (mode_.state == ContactState::slip) {
            f[0][k] = e.N[k];
            f[1][k] = mode_.sign * (e.vx[k] - e.V[k]);
        } else {
            f[0][k] = k_.mu_s * e.N[k] - e.T[k];
            f[1][k] = k_.mu_s * e.N[k] + e.T[k];
        }
    }
    if (mode_.state == ContactState::separation) f[1][0] = 1;  // a separation ends in one way only
    for (std::size_t which = 0; which < 2; ++which)
        f[which] = without_root_at_zero(f[which], mode_.roots[which]);
    return f;
}

// moves to the end of the step, or to the first change of state in it, which then is made
bool Run::advance(Quad end) {
    const Quad left = end - t_;
    const bool is_last = left <= k_.step;
    const Quad h = is_last ? left : k_.step;
    const Expansion e = expand(h);
    const std::array<QuadSeries, 2> f = event_functions(e);
    std::size_t which = 2;
    Quad tau = 1;
    for (std::size_t i = 0; i < 2; ++i) {
        if (f[i][0] < 0) throw std::runtime_error("a contact state was entered that does not hold");
        if (const auto root = first_fall(f[i], tau)) {
            which = i;
            tau = *root;
        }
    }
    s_ = at(e, tau);
    t_ = which == 2 && is_last ? end : t_ + tau * h;
    mode_.roots = {0, 0};
    if (which == 2) return false;
    change(which);
    return true;
}

void Run::change(std::size_t which) {
    const ContactState before = mode_.state;
    gap_velocity_ = 0;
    if (before == ContactState::separation) {
        touch_down();
    } else if (before == ContactState::slip && which == 0) {
        enter(ContactState::separation, 1, {3, 0});
    } else if (before == ContactState::slip) {
        s_.vx = s_.V;
        continue_without_slip();
    } else {
        // T reached +mu_s N (which = 0) or -mu_s N: slip against it
        enter(ContactState::slip, which == 0 ? -1 : 1, {0, k_.mu_s > k_.mu_d ? 1U : 2U});
    }
    if (mode_.state != before) note(gap_velocity_);
}

void Run::touch_down() {
    const Quad total = k_.m1 + k_.m2;
    const Quad y = (k_.m1 * s_.y1 + k_.m2 * s_.y2) / total;
    const Quad common = (k_.m1 * s_.vy1 + k_.m2 * s_.vy2) / total;
    const Quad w = s_.vx - s_.V;
    gap_velocity_ = s_.vy1 - s_.vy2;
    Quad rebound = -Quad(options_.restitution) * gap_velocity_;
    if (rebound < Quad(options_.settle_velocity)) rebound = 0;
    s_.y1 = s_.y2 = y;
    const Quad impulse = k_.m1 * k_.m2 / total * (rebound - gap_velocity_);
    s_.vy1 = common + k_.m2 / total * rebound;
    s_.vy2 = rebound > 0 ? common - k_.m1 / total * rebound : s_.vy1;
    if (options_.impact_friction == ImpactFriction::cone) {
        const bool stops = k_.m1 * magnitude(w) <= k_.mu_s * impulse;
        const Quad lost = k_.mu_d * impulse / k_.m1;
        s_.vx = stops ? s_.V : s_.vx - (w > 0 ? lost : -lost);
    }
    motion_.impacts.push_back({static_cast<double>(t_), static_cast<double>(gap_velocity_), static_cast<double>(w),
                               static_cast<double>(s_.vx - s_.V), static_cast<double>(rebound)});
    if (rebound > 0)
        enter(ContactState::separation, 1, {1, 0});
    else
        continue_closed();
}

void Run::continue_closed() {
    const Quad w = s_.vx - s_.V;
    if (normal_force() < 0)
        enter(ContactState::separation, 1, {2, 0});
    else if (w != 0)
        enter(ContactState::slip, w > 0 ? 1 : -1, {0, 0});
    else
        continue_without_slip();
}

// w = 0: stick if the cone allows it, else slip against the force that would be needed
void Run::continue_without_slip() {
    const Quad T = stick_force();
    if (magnitude(T) <= k_.mu_s * normal_force())
        enter(ContactState::stick, 1, {0, 0});
    else
        enter(ContactState::slip, T > 0 ? -1 : 1, {0, 1});
}

void Run::note(Quad gap_velocity) {
    const double t = static_cast<double>(t_);
    if (!motion_.history.empty()) motion_.history.back().to = t;
    motion_.history.push_back(
        {mode_.state, t, 0.0, static_cast<double>(s_.vx - s_.V), static_cast<double>(gap_velocity)});
}

QuadMotion Run::motion(Quad duration) {
    continue_closed();
    note(0);
    std::size_t changes = 0;
    while (t_ < duration) {
        changes = advance(duration) ? changes + 1 : 0;
        if (changes > options_.most_changes)
            throw std::runtime_error("the contact chatters at " + std::to_string(static_cast<double>(t_)) + " s");
    }
    motion_.history.back().to = static_cast<double>(duration);
    return motion_;
}

}  // namespace

QuadMotion quad_reference(const parameters::Case& c, const QuadOptions& options) {
    if (c.drive.kind == parameters::DriveKind::sampled) throw std::invalid_argument("no sampled drive here");
    if (c.run.initial == parameters::Initial::sliding) throw std::invalid_argument("no sliding start here");
    return Run(c, options).motion(Quad(c.run.duration));
}

}  // namespace stridor::support
