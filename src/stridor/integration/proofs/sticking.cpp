// While the contact sticks, u = r x + B q: r moves with the plate (n.r = 0, t.r = 1, x' = V), the columns of B are the
// motions that the contact leaves free. With hats for what B reduces (M̂ = BᵀMB ...):
//
//     M̂ q" + Ĉ q' + K̂ q = Bᵀ(f0 - M r x" - C r x' - K r x)
//
// q is a forced part, linear in time (constant drive) or sinusoidal, and a rest e that dies away: its energy
// (e'.M̂e' + e.K̂e)/2 never grows, and bounds (e, e') for ever (lyapunov.hpp). The margins of the stick,
// f = mu_s N -+ T, are linear in all of it. So f(t) >= forced part - |share of (e, e')|.
// A forced part that stays above that bound proves the stick; one that falls below zero proves its end.

#include "stridor/integration/proofs/sticking.hpp"

#include "stridor/base/decompositions.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/integration/proofs/lyapunov.hpp"
#include "stridor/model/linear/complement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>

namespace stridor::integration {

namespace {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using record::Future;
using record::Outlook;

// what rounding may make of a margin, as a share of the forces it is the difference of
constexpr double margin_rounding = 0x1p-40;

double modulus(const std::complex<double>& number) {
    return std::sqrt(number.real() * number.real() + number.imag() * number.imag());
}

// a margin of the stick over time
struct ForceMargin {
    double now = 0.0;        // [N] its forced part at this instant; of a sinusoidal drive without what oscillates
    double slope = 0.0;      // [N/s] of the forced part
    double amplitude = 0.0;  // [N] of what oscillates with the drive
    double vibration = 0.0;  // [N] most that the free vibration takes from it
    double rounding = 0.0;   // [1] share of now below which nothing is known
};

// both margins, and the normal force that they are made of
struct Holding {
    std::array<ForceMargin, 2> margins;
    record::Drag drag;
};

class Stick {
public:
    Stick(const model::Structure& s, const model::ContactPoint& point, const StuckState& now)
        : s_(s),
          limits_{stick_limit(point.friction, model::Slip::backward),
                  stick_limit(point.friction, model::Slip::forward)},
          now_(now) {
        MatrixXd contact(s.load.size(), 2);
        contact << point.normal, point.tangent;
        forces_ = (contact.transpose() * contact).inverse() * contact.transpose();
        carried_ = forces_.row(1).transpose();
        free_ = model::orthogonal_complement(contact);
        mass_ = model::reduced(free_, s.mass, free_);
        damping_ = model::reduced(free_, s.damping, free_);
        stiffness_ = model::reduced(free_, s.stiffness, free_);
        const Eigen::Index m = free_.cols();
        MatrixXd energy = MatrixXd::Zero(2 * m, 2 * m);
        energy.topLeftCorner(m, m) = stiffness_;
        energy.bottomRightCorner(m, m) = mass_;
        if (m > 0) twice_energy_ = LastingBound(energy);
        x_ = point.tangent.dot(now.displacement);
    }

    bool is_dissipative() const {
        if (free_.cols() == 0) return true;
        return stiffness_.llt().info() == Eigen::Success && damping_.ldlt().isPositive();
    }

    Holding under_constant_drive() const;
    Holding under_sinusoidal_drive(double omega) const;

private:
    // mu_s N - T, which ends in slip backward, and mu_s N + T, forward
    template <typename Forces>
    auto margin_of(const Forces& forces, std::size_t k) const {
        return limits_[k] * forces(0) + (k == 0 ? -1.0 : 1.0) * forces(1);
    }

    // what free motions must balance at rest when the contact stands at x, moving with V
    VectorXd rest(double x, double velocity) const {
        return free_.transpose() * (s_.load - s_.stiffness * carried_ * x - s_.damping * carried_ * velocity);
    }

    double vibration(std::size_t k, const VectorXd& e, const VectorXd& e_rate) const;

    // of a normal force that grows by `slope` [N/s]
    record::Drag drag(double normal_force, double slope) const {
        const double lasted = now_.time - now_.since;
        const double speed = std::abs(now_.surface_velocity);
        return {normal_force - slope * lasted, normal_force, speed * lasted, speed > 0.0 ? slope / speed : 0.0};
    }

    const model::Structure& s_;
    std::array<double, 2> limits_;  // [1] of the stick, shape [margin]
    const StuckState& now_;
    MatrixXd forces_;                      // shape [2][dof]: N and T of a force along n and t
    VectorXd carried_;                     // r
    MatrixXd free_;                        // B
    MatrixXd mass_, damping_, stiffness_;  // reduced by B
    LastingBound<MatrixXd> twice_energy_;  // of (e, e')
    double x_ = 0.0;                       // [m] t.u
};

double Stick::vibration(std::size_t k, const VectorXd& e, const VectorXd& e_rate) const {
    if (e.size() == 0) return 0.0;
    const MatrixXd inertia = s_.mass * free_ * mass_.inverse();
    const MatrixXd of_place = forces_ * (s_.stiffness * free_ - inertia * stiffness_);
    const MatrixXd of_rate = forces_ * (s_.damping * free_ - inertia * damping_);
    const double sign = k == 0 ? -1.0 : 1.0;
    VectorXd share(2 * e.size()), vibration(2 * e.size());
    share << (limits_[k] * of_place.row(0) + sign * of_place.row(1)).transpose(),
        (limits_[k] * of_rate.row(0) + sign * of_rate.row(1)).transpose();
    vibration << e, e_rate;
    return twice_energy_.size(vibration) * twice_energy_.gain(share);
}

Holding Stick::under_constant_drive() const {
    const double V = now_.surface_velocity;
    const MatrixXd flexibility = stiffness_.inverse();
    const VectorXd q_slope = flexibility * (free_.transpose() * (s_.stiffness * carried_)) * -V;
    const VectorXd q_now = flexibility * (rest(x_, V) - damping_ * q_slope);
    const VectorXd u_now = carried_ * x_ + free_ * q_now;
    const VectorXd u_slope = carried_ * V + free_ * q_slope;
    const VectorXd f_now = forces_ * (s_.stiffness * u_now + s_.damping * u_slope - s_.load);
    const VectorXd f_slope = forces_ * (s_.stiffness * u_slope);
    const VectorXd e = free_.transpose() * (now_.displacement - u_now);
    const VectorXd e_rate = free_.transpose() * (now_.velocity - u_slope);

    std::array<ForceMargin, 2> margins;
    for (std::size_t k = 0; k < margins.size(); ++k) {
        margins[k].now = margin_of(f_now, k);
        margins[k].slope = margin_of(f_slope, k);
        const double slope_size = limits_[k] * std::abs(f_slope(0)) + std::abs(f_slope(1));
        if (std::abs(margins[k].slope) <= margin_rounding * slope_size) margins[k].slope = 0.0;
        margins[k].vibration = vibration(k, e, e_rate);
        margins[k].rounding = margin_rounding * (limits_[k] * std::abs(f_now(0)) + std::abs(f_now(1)));
    }
    const double terms = forces_.row(0).cwiseAbs() * (s_.stiffness.cwiseAbs() * u_slope.cwiseAbs());
    return {margins, drag(f_now(0), std::abs(f_slope(0)) > margin_rounding * terms ? f_slope(0) : 0.0)};
}

// x = x_c + Re(X exp(i omega t)), so V = Re(i omega X) and V' = -omega² Re X
Holding Stick::under_sinusoidal_drive(double omega) const {
    using Complex = std::complex<double>;
    const Complex X(-now_.surface_acceleration / (omega * omega), -now_.surface_velocity / omega);
    const double centre = x_ - X.real();
    const VectorXd q_centre = stiffness_.inverse() * rest(centre, 0.0);
    const MatrixXcd dynamic =
        (s_.stiffness - omega * omega * s_.mass).cast<Complex>() + Complex(0.0, omega) * s_.damping.cast<Complex>();
    const MatrixXcd reduced = free_.transpose().cast<Complex>() * dynamic * free_.cast<Complex>();
    const VectorXcd pushed = free_.transpose().cast<Complex>() * dynamic * carried_.cast<Complex>() * -X;
    const VectorXcd Q = reduced.inverse() * pushed;
    const VectorXd u_centre = carried_ * centre + free_ * q_centre;
    const VectorXcd u_swing = carried_.cast<Complex>() * X + free_.cast<Complex>() * Q;
    const VectorXd f_centre = forces_ * (s_.stiffness * u_centre - s_.load);
    const VectorXcd f_swing = forces_.cast<Complex>() * dynamic * u_swing;
    const VectorXd e = free_.transpose() * (now_.displacement - u_centre - u_swing.real());
    const VectorXd e_rate = free_.transpose() * (now_.velocity - (u_swing * Complex(0.0, omega)).real());

    std::array<ForceMargin, 2> margins;
    for (std::size_t k = 0; k < margins.size(); ++k) {
        margins[k].now = margin_of(f_centre, k);
        margins[k].amplitude = modulus(margin_of(f_swing, k));
        margins[k].vibration = vibration(k, e, e_rate);
        margins[k].rounding =
            margin_rounding * (limits_[k] * std::abs(f_centre(0)) + std::abs(f_centre(1)) + margins[k].amplitude);
    }
    const double swing = modulus(f_swing(0));
    return {margins, {f_centre(0) - swing, f_centre(0) + swing, 2.0 * modulus(X), 0.0}};
}

Outlook judge(const Holding& holding, double time) {
    Outlook outlook{Future::sticks};
    outlook.drag = holding.drag;
    for (const ForceMargin& margin : holding.margins) {
        const double steady = margin.now - margin.amplitude;
        const bool ends = margin.slope < 0.0 || steady < -margin.rounding;
        const bool holds = steady - margin.vibration > margin.rounding;
        if (ends) {
            outlook.future = Future::releases;
            const double release =
                margin.slope < 0.0 ? time + std::max(0.0, margin.now) / -margin.slope : outlook.release;
            outlook.release = std::isnan(outlook.release) ? release : std::min(outlook.release, release);
        } else if (!holds && outlook.future == Future::sticks) {
            outlook.future = Future::unknown;
        }
    }
    return outlook;
}

}  // namespace

Outlook with_rest(Outlook outlook) {
    if (outlook.future != Future::releases) return outlook;
    const bool rises_evenly = !std::isnan(outlook.release) && !(outlook.drag.slope > 0.0);
    outlook.release = std::numeric_limits<double>::quiet_NaN();
    if (!rises_evenly) outlook.future = Future::unknown;
    return outlook;
}

Outlook outlook_of_stick(const model::Structure& structure, const parameters::VelocityProfile& profile,
                         const StuckState& now) {
    const model::ContactPoint& contact = model::only_contact(structure, "the outlook of a stick");
    if (!profile.times.empty()) return {};
    const Stick stick(structure, contact, now);
    if (!stick.is_dissipative()) return {};
    const Outlook known = profile.frequency > 0.0
                              ? judge(stick.under_sinusoidal_drive(base::two_pi * profile.frequency), now.time)
                              : judge(stick.under_constant_drive(), now.time);
    return grows(contact.rest) ? with_rest(known) : known;
}

}  // namespace stridor::integration
