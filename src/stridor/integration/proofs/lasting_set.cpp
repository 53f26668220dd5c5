// Within a set, R'q' and the forces follow from the motion (Z: R'Z = 0, Y: Y'B = 0):
//
//     Y'(q'' + C q' + ω² q - f) = 0,   normals: n.q = -g0,   stuck: t.q' = V
//
// The forced part q0 + s t solves it with a constant velocity s: Y'ω² s = 0, n.s = 0, t.s = V, and
// Y'(ω² q0 + C s - f) = 0. What is left, q - q0 = Z x, obeys M̂ x'' + Ĉ x' + K̂ x = 0 with M̂ = Y'Z, Ĉ = Y'C Z,
// K̂ = Y'ω² Z: e = (rate x; x'). Where nothing slips Y = Z, and the energy of e serves as e.P e; else P solves
// Lyapunov's equation. Forces are λ = (R'B)⁻¹ R'(ω² q + C q' - f).

#include "stridor/integration/proofs/lasting_set.hpp"

#include "stridor/base/decompositions.hpp"
#include "stridor/integration/proofs/sticking.hpp"
#include "stridor/integration/rules/contact_mode_of.hpp"
#include "stridor/model/linear/complement.hpp"

#include <unsupported/Eigen/MatrixFunctions>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace stridor::integration {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;
using record::Future;

// what rounding may make of a sum, as a share of the sizes of its terms
constexpr double sum_rounding = 0x1p-40;

VectorXd vector_of(std::span<const double> numbers) {
    return Eigen::Map<const VectorXd>(numbers.data(), static_cast<Index>(numbers.size()));
}

}  // namespace

LastingSet::LastingSet(const ModalStructure& structure, std::vector<ContactMode> set, double velocity)
    : structure_(structure),
      set_(std::move(set)),
      square_(vector_of(structure.square_frequency)),
      load_(vector_of(structure.load)),
      velocity_(velocity),
      rate_(structure.fastest) {
    const auto n = static_cast<Index>(structure.modes());
    damping_ = structure.is_damped_by_mode() ? MatrixXd(vector_of(structure.damping).asDiagonal())
                                             : MatrixXd(Eigen::Map<const MatrixXd>(structure.damping.data(), n, n));
    Index count = 0;
    for (const ContactMode mode : set_)
        count += mode == ContactMode::open ? 0 : mode == ContactMode::stick ? 2 : 1;
    if (count > n) return;
    MatrixXd pushes(n, count);
    VectorXd row_rates = VectorXd::Zero(count);
    rows_.resize(count, n);
    row_values_ = VectorXd::Zero(count);
    Index row = 0;
    for (std::size_t k = 0; k < set_.size(); ++k) {
        if (set_[k] == ContactMode::open) continue;
        const ModalContact& c = structure.contacts[k];
        const VectorXd normal = vector_of(c.normal), tangent = vector_of(c.tangent);
        rows_.row(row) = normal.transpose();
        row_values_(row) = -c.initial_gap;
        pushes.col(row) = normal;
        if (is_slip(set_[k])) pushes.col(row) += slip_ratio(c.friction, way_of(set_[k])) * tangent;
        ++row;
        if (set_[k] != ContactMode::stick) continue;
        rows_.row(row) = tangent.transpose();
        row_rates(row) = c.drive_share * velocity;
        pushes.col(row) = tangent;
        ++row;
    }
    MatrixXd force_rows(0, n);  // (R'B)⁻¹ R'
    free_ = forceless_ = MatrixXd::Identity(n, n);
    if (count > 0) {
        const Eigen::FullPivLU<MatrixXd> coupling(rows_ * pushes);
        if (!coupling.isInvertible()) return;
        force_rows = coupling.solve(rows_);
        free_ = model::orthogonal_complement(rows_.transpose());
        forceless_ = model::orthogonal_complement(pushes);
    }

    MatrixXd system(n, n);
    system << forceless_.transpose() * square_.asDiagonal(), rows_;
    forced_.compute(system);
    if (!forced_.isInvertible()) return;
    VectorXd right = VectorXd::Zero(n);
    right.tail(count) = row_rates;
    drift_ = forced_.solve(right);
    bound_vibration();
    if (!is_bounded_) return;
    add_margins(force_rows, velocity);
}

void LastingSet::bound_vibration() {
    const Index m = free_.cols();
    is_bounded_ = m == 0;  // contacts hold all of it: there is nothing that vibrates
    if (is_bounded_) return;
    const MatrixXd mass = forceless_.transpose() * free_;
    const MatrixXd damping = forceless_.transpose() * damping_ * free_;
    const MatrixXd stiffness = forceless_.transpose() * square_.asDiagonal() * free_;
    const Eigen::FullPivLU<MatrixXd> inertia(mass);
    if (!inertia.isInvertible()) return;
    generator_ = MatrixXd::Zero(2 * m, 2 * m);
    generator_.topRightCorner(m, m).diagonal().setConstant(rate_);
    generator_.bottomLeftCorner(m, m) = -inertia.solve(stiffness) / rate_;
    generator_.bottomRightCorner(m, m) = -inertia.solve(damping);
    if (std::none_of(set_.begin(), set_.end(), is_slip)) {
        // the energy: it grows by no motion, as the dashpots only take
        MatrixXd energy = MatrixXd::Zero(2 * m, 2 * m);
        energy.topLeftCorner(m, m) = stiffness / (rate_ * rate_);
        energy.bottomRightCorner(m, m).setIdentity();
        bound_ = LastingBound(energy);
        is_bounded_ = bound_.is_definite() && damping.ldlt().isPositive();
        return;
    }
    const MatrixXd loss = rate_ * MatrixXd::Identity(2 * m, 2 * m);
    const MatrixXd p = Lyapunov(generator_).solve(loss);
    bound_ = LastingBound(p);
    // a certificate of its own: whatever the solver did
    const MatrixXd falls = -(generator_.transpose() * p + p * generator_);
    is_bounded_ = bound_.is_definite() && LastingBound(MatrixXd(0.5 * (falls + falls.transpose()))).is_definite();
}

void LastingSet::add_margin(std::size_t contact, const RowVectorXd& of_q, const RowVectorXd& of_v, double constant) {
    Margin margin;
    margin.contact = contact;
    margin.of_q0 = of_q;
    margin.constant = of_v.dot(drift_.transpose()) + constant;
    margin.slope = of_q.dot(drift_.transpose());
    margin.slope_zero = sum_rounding * of_q.cwiseAbs().dot(drift_.transpose().cwiseAbs());
    margin.deviation.resize(2 * free_.cols());
    margin.deviation << (of_q * free_).transpose() / rate_, (of_v * free_).transpose();
    if (margin.deviation.size() > 0) margin.gain = bound_.gain(margin.deviation);
    margins_.push_back(std::move(margin));
}

// the event functions of taylor.cpp
void LastingSet::add_margins(const MatrixXd& force_rows, double velocity) {
    const MatrixXd of_q = force_rows * square_.asDiagonal(), of_v = force_rows * damping_;
    const VectorXd constant = -(force_rows * load_);
    const Index n = square_.size();
    Index row = 0;
    for (std::size_t k = 0; k < set_.size(); ++k) {
        const ModalContact& c = structure_.contacts[k];
        if (set_[k] == ContactMode::open) {
            add_margin(k, vector_of(c.normal).transpose(), RowVectorXd::Zero(n), c.initial_gap);
            continue;
        }
        const Index N = row++;
        add_margin(k, of_q.row(N), of_v.row(N), constant(N));
        margins_.back().is_normal_force = true;
        if (is_slip(set_[k])) {
            const double sign = way_of(set_[k]) == model::Slip::forward ? 1.0 : -1.0;
            add_margin(k, RowVectorXd::Zero(n), sign * vector_of(c.tangent).transpose(),
                       -sign * c.drive_share * velocity);
            margins_.back().is_slip_velocity = true;
            continue;
        }
        const Index T = row++;
        for (const model::Slip way : {model::Slip::backward, model::Slip::forward}) {
            const double limit = stick_limit(c.friction, way), sign = way == model::Slip::backward ? -1.0 : 1.0;
            add_margin(k, limit * of_q.row(N) + sign * of_q.row(T), limit * of_v.row(N) + sign * of_v.row(T),
                       limit * constant(N) + sign * constant(T));
        }
    }
}

LastingSet::Now LastingSet::now(std::span<const double> q, std::span<const double> v) const {
    const Index n = square_.size();
    Now here;
    VectorXd right(n);
    VectorXd held = rows_ * vector_of(q);  // of a stuck contact where it stands
    for (Index row = 0, k = 0; k < static_cast<Index>(set_.size()); ++k) {
        const ContactMode mode = set_[static_cast<std::size_t>(k)];
        if (mode == ContactMode::open) continue;
        held(row) = row_values_(row);
        row += mode == ContactMode::stick ? 2 : 1;
    }
    right << forceless_.transpose() * (load_ - damping_ * drift_), held;
    here.q0 = forced_.solve(right);
    here.e.resize(2 * free_.cols());
    here.e << rate_ * (free_.transpose() * (vector_of(q) - here.q0)), free_.transpose() * (vector_of(v) - drift_);
    if (here.e.size() > 0) here.size = bound_.size(here.e);
    return here;
}

double LastingSet::value(const Margin& margin, const Now& now) const {
    return margin.of_q0.dot(now.q0.transpose()) + margin.constant;
}

bool LastingSet::lasts(const Now& now) const {
    return std::all_of(margins_.begin(), margins_.end(), [&](const Margin& margin) {
        return value(margin, now) - margin.gain * now.size > 0.0 && margin.slope >= -margin.slope_zero;
    });
}

// of a contact that has been stuck for so long [s]
record::Drag LastingSet::drag(const Margin& normal_force, const Now& now, double lasted) const {
    const double N = value(normal_force, now);
    const double speed = std::abs(structure_.contacts[normal_force.contact].drive_share * velocity_);
    const double slope = std::abs(normal_force.slope) > normal_force.slope_zero ? normal_force.slope : 0.0;
    return {N - slope * lasted, N, speed * lasted, speed > 0.0 ? slope / speed : 0.0};
}

std::vector<record::Outlook> LastingSet::outlooks(std::span<const double> q, std::span<const double> v, double time,
                                                  std::span<const double> since) const {
    std::vector<record::Outlook> known(set_.size());
    if (!is_bounded_) return known;
    const Now here = now(q, v);
    // before the last change of any contact the forces rose along another line
    const double changed = *std::max_element(since.begin(), since.end());
    for (const Margin& margin : margins_)
        if (margin.is_normal_force && set_[margin.contact] == ContactMode::stick)
            known[margin.contact].drag = drag(margin, here, time - changed);
    if (lasts(here)) {
        for (std::size_t k = 0; k < set_.size(); ++k) {
            if (is_slip(set_[k])) known[k] = {Future::slides, time};
            if (set_[k] == ContactMode::stick) known[k].future = Future::sticks;
        }
        return known;
    }
    for (const Margin& margin : margins_) {
        if (set_[margin.contact] != ContactMode::stick || margin.slope >= -margin.slope_zero) continue;
        record::Outlook& outlook = known[margin.contact];
        const double release = time - std::max(0.0, value(margin, here)) / margin.slope;
        if (outlook.future != Future::releases || release < outlook.release) outlook.release = release;
        outlook.future = Future::releases;
    }
    for (std::size_t k = 0; k < set_.size(); ++k)
        if (grows(structure_.contacts[k].rest)) known[k] = with_rest(known[k]);
    return known;
}

std::optional<Silence> LastingSet::silence(std::span<const double> q, std::span<const double> v, double time) const {
    if (!is_bounded_ || free_.cols() == 0 || !std::all_of(set_.begin(), set_.end(), is_slip)) return std::nullopt;
    const Now here = now(q, v);
    if (!lasts(here)) return std::nullopt;
    Silence silence{time, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for (const Margin& margin : margins_) {
        double& least = margin.is_normal_force ? silence.normal_force : silence.slip_velocity;
        least = std::min(least, value(margin, here) - margin.gain * here.size);
    }
    return silence;
}

// the integral of (c.e)² from now on is e.X e, A'X + X A = -c c'
const MatrixXd& LastingSet::gramian(std::size_t channel) {
    if (gramians_.empty()) {
        const Lyapunov lyapunov(generator_);
        for (Index row = 0; row < structure_.channels.rows(); ++row) {
            VectorXd c = VectorXd::Zero(generator_.rows());
            c.tail(free_.cols()) = (structure_.channels.row(row) * free_).transpose();
            gramians_.push_back(lyapunov.solve(c * c.transpose()));
        }
    }
    return gramians_[channel];
}

LastingSet::Passed LastingSet::pass(std::span<const double> q, std::span<const double> v, double duration) {
    const Now before = now(q, v);
    const MatrixXd advance = (generator_ * duration).exp();
    const VectorXd after = advance * before.e;
    const Index m = free_.cols();
    Passed passed;
    passed.q = before.q0 + free_ * after.head(m) / rate_;
    passed.v = free_ * after.tail(m);
    passed.square_time.resize(structure_.channels.rows());
    for (Index channel = 0; channel < passed.square_time.size(); ++channel) {
        const MatrixXd& x = gramian(static_cast<std::size_t>(channel));
        passed.square_time(channel) = std::max(0.0, before.e.dot(x * before.e) - after.dot(x * after));
    }
    const VectorXd lasting = generator_.partialPivLu().solve(after - before.e);  // integral of e
    passed.loads.resize(set_.size());
    std::vector<double> slip(set_.size(), 0.0);
    for (const Margin& margin : margins_) {
        record::Load& load = passed.loads[margin.contact];
        const double integral = value(margin, before) * duration + margin.deviation.dot(lasting);
        (margin.is_normal_force ? load.normal_impulse : slip[margin.contact]) = integral;
        if (margin.is_normal_force) load.largest_force = value(margin, before) + margin.deviation.dot(after);
    }
    for (std::size_t k = 0; k < set_.size(); ++k)
        passed.loads[k].friction_loss = std::abs(slip_ratio(structure_.contacts[k].friction, way_of(set_[k]))) *
                                        passed.loads[k].normal_impulse * slip[k] / duration;
    return passed;
}

}  // namespace stridor::integration
