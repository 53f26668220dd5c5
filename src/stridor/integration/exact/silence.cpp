#include "stridor/integration/exact/silence.hpp"

#include "stridor/integration/exact/contact_transition.hpp"
#include "stridor/integration/run/event_loop.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace stridor::integration {

Sliding::Sliding(const Flow& flow, double load_scale, double velocity)
    : flow_(flow),
      slip_velocity_(std::abs(velocity)) {
    const int closed = flow.velocity_count;
    const int size = 2 * closed;
    generator_.resize(size, size);
    Vector load(size), normal(size), speed = Vector::Zero(size);
    for (int i = 0; i < size; ++i) {
        for (int j = 0; j < size; ++j)
            generator_(i, j) = flow.power[1].column[j].at[i] / flow.step;
        load(i) = flow.power[1].column[load_lane(closed)].at[i] / flow.step * load_scale;
        normal(i) = flow.normal_force.at[i];
    }
    speed(velocity_lane(closed, 0)) = 1.0;
    equilibrium_ = -generator_.partialPivLu().solve(load);
    normal_force_ = normal.dot(equilibrium_) + flow.normal_force.at[load_lane(closed)] * load_scale;

    // positions and velocities of the same energy count alike
    Matrix weight = Matrix::Identity(size, size);
    const double rate = 1.0 / flow.step;
    for (int i = 0; i < closed; ++i)
        weight(i, i) = rate * rate;
    bound_ = LastingBound<Matrix>(lyapunov_of_few(generator_, weight));
    if (!bound_.is_definite()) return;
    normal_gain_ = bound_.gain(normal);
    velocity_gain_ = bound_.gain(speed);
}

Sliding::Vector Sliding::distance(const Lanes& s) const {
    Vector e(equilibrium_.size());
    for (Eigen::Index i = 0; i < e.size(); ++i)
        e(i) = s.at[i] - equilibrium_(i);
    return e;
}

std::optional<Silence> Sliding::silence(const Lanes& s, double time) const {
    if (!bound_.is_definite()) return std::nullopt;
    const double size = bound_.size(distance(s));
    const double N = normal_force_ - normal_gain_ * size;
    const double w = slip_velocity_ - velocity_gain_ * size;
    if (!(N > 0.0 && w > 0.0)) return std::nullopt;
    return Silence{time, N, w};
}

void Sliding::pass(const Kernel& kernel, double duration, record::Use use, Lanes& s, Account& account) const {
    const int closed = flow_.velocity_count;
    const Vector before = distance(s);

    Sums peaks{};
    Lanes sampled = s;
    const bool is_kept = record::is_judged(use);
    const double sampled_length = is_kept ? std::min<double>(steps_sampled_for_peaks, duration / flow_.step) : 0.0;
    const double sampled_whole = std::floor(sampled_length);
    for (long k = 0; k < static_cast<long>(sampled_whole); ++k)
        kernel.leap(flow_, sampled, peaks);
    // a window may be shorter than a step
    if (is_kept) kernel.add_part(flow_, sampled, 0.0, sampled_length - sampled_whole, peaks);
    Sums& part = account.part[static_cast<int>(flow_.mode)];
    for (int body = 0; body < most_bodies; ++body)
        for (int i = 0; i < lanes; ++i)
            part.peak[body].at[i] = std::max(part.peak[body].at[i], peaks.peak[body].at[i]);

    // exp(A duration): whole steps by repeated squaring, the rest by the series
    const auto size = before.size();
    Matrix step(size, size), whole = Matrix::Identity(size, size);
    for (Eigen::Index j = 0; j < size; ++j)
        for (Eigen::Index i = 0; i < size; ++i)
            step(i, j) = flow_.advance.column[j].at[i];
    const double count = std::floor(duration / flow_.step);
    for (auto n = static_cast<unsigned long long>(count); n > 0; n >>= 1U) {
        if ((n & 1U) != 0) whole = step * whole;
        step = step * step;
    }
    Lanes moved = s;
    const Vector there = equilibrium_ + whole * before;
    for (Eigen::Index i = 0; i < size; ++i)
        moved.at[i] = there(i);
    kernel.move(flow_, moved, duration / flow_.step - count, s);
    account.largest_force = std::max(account.largest_force, dot(flow_.normal_force, s));
    const Vector after = distance(s);

    if (!is_kept) return;
    // the integral of v_i v_j over the time between is e.X e at its beginning less that at its end
    int k = 0;
    for (int j = 0; j < closed; ++j)
        for (int i = 0; i <= j; ++i, ++k) {
            Matrix product = Matrix::Zero(size, size);
            product(closed + i, closed + j) += 0.5;
            product(closed + j, closed + i) += 0.5;
            const Matrix x = lyapunov_of_few(generator_, product);
            part.product[k].at[0] += before.dot(x * before) - after.dot(x * after);
        }
}

}  // namespace stridor::integration
