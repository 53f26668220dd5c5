#include "stridor/integration/steps/free_propagation.hpp"

#include <algorithm>
#include <cmath>

namespace stridor::integration {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr int most_terms = 20;      // of a series at |A h| <= 1/2: the last is 1e-24 of the first
constexpr double largest_at = 0.5;  // [1] |A h| from which the step is halved

// exp(A h) and the integral of exp(A s) over s from 0 to h, divided by h
struct Exponential {
    MatrixXd end;
    MatrixXd mean;
};

Exponential exponential(const MatrixXd& rate, double step) {
    int halvings = 0;
    const double size = rate.cwiseAbs().rowwise().sum().maxCoeff() * step;
    while (std::ldexp(size, -halvings) > largest_at)
        ++halvings;
    const MatrixXd part = rate * std::ldexp(step, -halvings);
    const MatrixXd one = MatrixXd::Identity(rate.rows(), rate.cols());
    MatrixXd term = one;
    Exponential e{one, one};
    for (int k = 1; k <= most_terms; ++k) {
        term = term * part / k;
        e.end += term;
        e.mean += term / (k + 1);
    }
    for (; halvings > 0; --halvings) {
        e.mean = 0.5 * (e.mean + e.end * e.mean);
        e.end = e.end * e.end;
    }
    return e;
}

// rates of (scale q, v): with the scale of a frequency all entries have the unit 1/s and like sizes
MatrixXd scaled_rate(const MatrixXd& stiffness, const MatrixXd& damping, double scale) {
    const Index n = stiffness.rows();
    MatrixXd rate = MatrixXd::Zero(2 * n, 2 * n);
    rate.topRightCorner(n, n) = scale * MatrixXd::Identity(n, n);
    rate.bottomLeftCorner(n, n) = -stiffness / scale;
    rate.bottomRightCorner(n, n) = -damping;
    return rate;
}

}  // namespace

FreePropagation::FreePropagation(const ModalStructure& structure, double step) : structure_(structure) {
    if (structure.is_damped_by_mode())
        prepare_modes(step);
    else
        prepare_whole(step);
}

void FreePropagation::prepare_modes(double step) {
    for (std::size_t j = 0; j < structure_.modes(); ++j) {
        const double square = structure_.square_frequency[j];
        const double size = std::max(std::sqrt(std::abs(square)), structure_.damping[j]);
        const double scale = size > 0.0 ? size : 1.0 / step;
        const Exponential e = exponential(
            scaled_rate(MatrixXd::Constant(1, 1, square), MatrixXd::Constant(1, 1, structure_.damping[j]), scale),
            step);
        qq_.push_back(e.end(0, 0));
        qv_.push_back(e.end(0, 1) / scale);
        vq_.push_back(e.end(1, 0) * scale);
        vv_.push_back(e.end(1, 1));
        q_push_.push_back(step * e.mean(0, 1) / scale);
        v_push_.push_back(step * e.mean(1, 1));
        q_load_.push_back(q_push_.back() * structure_.load[j]);
        v_load_.push_back(v_push_.back() * structure_.load[j]);
    }
}

void FreePropagation::prepare_whole(double step) {
    const auto n = static_cast<Index>(structure_.modes());
    const MatrixXd stiffness =
        Eigen::Map<const Eigen::VectorXd>(structure_.square_frequency.data(), n).asDiagonal().toDenseMatrix();
    const MatrixXd damping = Eigen::Map<const MatrixXd>(structure_.damping.data(), n, n);
    const double scale = structure_.fastest > 0.0 ? structure_.fastest : 1.0 / step;
    const Exponential e = exponential(scaled_rate(stiffness, damping, scale), step);
    state_ = e.end;
    state_.topRightCorner(n, n) /= scale;
    state_.bottomLeftCorner(n, n) *= scale;
    push_ = step * e.mean.rightCols(n);
    push_.topRows(n) /= scale;
    load_ = push_ * Eigen::Map<const Eigen::VectorXd>(structure_.load.data(), n);
    before_.resize(2 * n);
    after_.resize(2 * n);
}

void FreePropagation::advance(std::vector<double>& q, std::vector<double>& v) const {
    const std::size_t n = structure_.modes();
    if (state_.size() == 0) {
        for (std::size_t j = 0; j < n; ++j) {
            const double place = qq_[j] * q[j] + qv_[j] * v[j] + q_load_[j];
            v[j] = vq_[j] * q[j] + vv_[j] * v[j] + v_load_[j];
            q[j] = place;
        }
        return;
    }
    std::copy_n(q.begin(), n, before_.data());
    std::copy_n(v.begin(), n, before_.data() + n);
    after_.noalias() = state_ * before_;
    after_ += load_;
    std::copy_n(after_.data(), n, q.begin());
    std::copy_n(after_.data() + n, n, v.begin());
}

void FreePropagation::push(const std::vector<double>& r, std::vector<double>& q, std::vector<double>& v) const {
    const std::size_t n = structure_.modes();
    if (state_.size() == 0) {
        for (std::size_t j = 0; j < n; ++j) {
            q[j] += q_push_[j] * r[j];
            v[j] += v_push_[j] * r[j];
        }
        return;
    }
    after_.noalias() = push_ * Eigen::Map<const Eigen::VectorXd>(r.data(), static_cast<Index>(n));
    for (std::size_t j = 0; j < n; ++j) {
        q[j] += after_(static_cast<Index>(j));
        v[j] += after_(static_cast<Index>(n + j));
    }
}

Eigen::MatrixXd FreePropagation::response() const {
    const ContactRowPlan plan = row_plan(structure_.contacts);
    const auto rows = static_cast<Index>(plan.rows());
    const auto n = static_cast<Index>(structure_.modes());
    MatrixXd contact(rows, n);
    for (Index i = 0; i < rows; ++i)
        contact.row(i) = Eigen::Map<const Eigen::RowVectorXd>(
            row_of(structure_.contacts, plan, static_cast<std::size_t>(i)).data(), n);
    if (state_.size() == 0)
        return contact * Eigen::Map<const Eigen::VectorXd>(v_push_.data(), n).asDiagonal() * contact.transpose();
    return contact * push_.bottomRows(n) * contact.transpose();
}

}  // namespace stridor::integration
