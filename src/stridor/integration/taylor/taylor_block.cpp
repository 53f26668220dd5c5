#include "stridor/integration/taylor/taylor_block.hpp"

#include "stridor/integration/contact_mode_of.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace stridor::integration {

namespace {

constexpr std::size_t most_prepared = 4096;  // sets: beyond it they are prepared anew
constexpr double least_pivot_share = 1e-13;  // of the largest: rows with less depend on each other
constexpr double exact_pivot_share = 1e-4;   // likewise: with less the inverse alone is not exact enough
// a last term above this share of the first is not rounding
constexpr double series_rounding = 1e-17;

}  // namespace

TaylorBlock::TaylorBlock(const ModalStructure& structure, double step)
    : structure_(structure),
      step_(step),
      modes_(structure.modes()),
      q_((block_order + 2) * modes_),
      v_((block_order + 2) * modes_),
      acceleration_(modes_),
      right_(2 * structure.contacts.size()),
      force_(2 * structure.contacts.size()),
      left_over_(2 * structure.contacts.size()),
      normal_(structure.contacts.size()),
      friction_(structure.contacts.size()) {}

TaylorBlock::Rows TaylorBlock::prepare(const ContactSet& set) const {
    Rows rows;
    const auto add = [&](std::vector<double>& list, const std::vector<double>& row) {
        list.insert(list.end(), row.begin(), row.end());
    };
    for (std::size_t k = 0; k < set.size(); ++k) {
        if (set[k] == ContactMode::open) continue;
        const ModalContact& contact = structure_.contacts[k];
        rows.normal.push_back(k);
        add(rows.constraint, contact.normal);
        add(rows.push, contact.normal);
        if (!is_slip(set[k])) continue;
        const double ratio = contact.ratio[index_of(way_of(set[k]))];
        double* push = rows.push.data() + (rows.normal.size() - 1) * modes_;
        for (std::size_t j = 0; j < modes_; ++j)
            push[j] += ratio * contact.tangent[j];
    }
    for (std::size_t k = 0; k < set.size(); ++k) {
        if (set[k] != ContactMode::stick) continue;
        rows.tangent.push_back(k);
        add(rows.constraint, structure_.contacts[k].tangent);
        add(rows.push, structure_.contacts[k].tangent);
    }
    const auto size = static_cast<Eigen::Index>(rows.normal.size() + rows.tangent.size());
    if (size == 0) return rows;
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const Eigen::Map<const RowMajor> R(rows.constraint.data(), size, static_cast<Eigen::Index>(modes_));
    const Eigen::Map<const RowMajor> B(rows.push.data(), size, static_cast<Eigen::Index>(modes_));
    const Eigen::MatrixXd seen = R * B.transpose();
    Eigen::FullPivLU<Eigen::MatrixXd> factor(seen);
    factor.setThreshold(least_pivot_share);
    rows.is_singular = !factor.isInvertible();
    if (rows.is_singular) return rows;
    const RowMajor inverse = factor.inverse();
    rows.inverse.assign(inverse.data(), inverse.data() + inverse.size());
    const Eigen::VectorXd pivots = factor.matrixLU().diagonal().cwiseAbs();
    if (pivots.minCoeff() > exact_pivot_share * pivots.maxCoeff()) return rows;
    const RowMajor exact = seen;
    rows.seen.assign(exact.data(), exact.data() + exact.size());
    return rows;
}

bool TaylorBlock::choose(const ContactSet& set) {
    auto found = prepared_.find(set);
    if (found == prepared_.end()) {
        if (prepared_.size() >= most_prepared) prepared_.clear();
        found = prepared_.emplace(set, prepare(set)).first;
    }
    rows_ = &found->second;
    return !rows_->is_singular;
}

// without contact forces, coefficient m
template <typename Count>
void TaylorBlock::free_acceleration(int m, Count modes) {
    const double* q = coefficient(q_, m).data();
    const double* v = coefficient(v_, m).data();
    const double* square = structure_.square_frequency.data();
    const double* damping = structure_.damping.data();
    double* a = acceleration_.data();
    for (std::size_t j = 0; j < modes; ++j)
        a[j] = -square[j] * q[j];
    if (structure_.is_damped_by_mode()) {
        for (std::size_t j = 0; j < modes; ++j)
            a[j] -= damping[j] * v[j];
    } else {
        for (std::size_t k = 0; k < modes; ++k)
            for (std::size_t j = 0; j < modes; ++j)
                a[j] -= damping[k * modes + j] * v[k];
    }
    if (m == 0)
        for (std::size_t j = 0; j < modes; ++j)
            a[j] += structure_.load[j];
}

// one step of iterative refinement: the forces leave no more than rounding of their own
void TaylorBlock::refine_forces() {
    const std::size_t rows = rows_->normal.size() + rows_->tangent.size();
    for (std::size_t r = 0; r < rows; ++r)
        left_over_[r] = right_[r] - dot({rows_->seen.data() + r * rows, rows}, force_);
    for (std::size_t r = 0; r < rows; ++r)
        force_[r] += dot({rows_->inverse.data() + r * rows, rows}, left_over_);
}

// `modes` is their number, known when this is compiled or not: loops over a few modes are unrolled then. The operations
// and their order are the same.
template <typename Count>
void TaylorBlock::expand_modes(const SurfaceSeries& surface, Count modes) {
    const std::size_t closed = rows_->normal.size();
    const std::size_t rows = closed + rows_->tangent.size();
    for (int m = 0; m <= order_; ++m) {
        free_acceleration(m, modes);
        const double per_step = static_cast<double>(m + 1) / step_;
        double* a = acceleration_.data();
        for (std::size_t r = 0; r < rows; ++r) {
            const double* constraint = rows_->constraint.data() + r * modes;
            double sum = 0.0;
            for (std::size_t j = 0; j < modes; ++j)
                sum += constraint[j] * a[j];
            right_[r] = -sum;
        }
        for (std::size_t r = closed; r < rows; ++r)
            right_[r] += structure_.contacts[rows_->tangent[r - closed]].drive_share * per_step *
                         surface[static_cast<std::size_t>(m) + 1];
        for (std::size_t r = 0; r < rows; ++r)
            force_[r] = dot({rows_->inverse.data() + r * rows, rows}, right_);
        if (!rows_->seen.empty()) refine_forces();
        for (std::size_t r = 0; r < rows; ++r) {
            const double* push = rows_->push.data() + r * modes;
            const double force = force_[r];
            for (std::size_t j = 0; j < modes; ++j)
                a[j] += push[j] * force;
        }
        for (std::size_t r = 0; r < closed; ++r)
            normal_[rows_->normal[r]][static_cast<std::size_t>(m)] = force_[r];
        for (std::size_t r = closed; r < rows; ++r)
            friction_[rows_->tangent[r - closed]][static_cast<std::size_t>(m)] = force_[r];
        const double* rate = v_.data() + static_cast<std::size_t>(m) * modes;
        double* next_q = q_.data() + static_cast<std::size_t>(m + 1) * modes;
        double* next_v = v_.data() + static_cast<std::size_t>(m + 1) * modes;
        const double scale = 1.0 / per_step;
        for (std::size_t j = 0; j < modes; ++j) {
            next_q[j] = scale * rate[j];
            next_v[j] = scale * a[j];
        }
    }
}

void TaylorBlock::expand(std::span<const double> q, std::span<const double> v, const SurfaceSeries& surface,
                         int order) {
    order_ = order;
    surface_ = surface;
    acceleration_sizes_.clear();
    constraint_sizes_.clear();
    std::copy(q.begin(), q.end(), q_.begin());
    std::copy(v.begin(), v.end(), v_.begin());
    for (std::size_t k = 0; k < normal_.size(); ++k) {
        normal_[k].fill(0.0);
        friction_[k].fill(0.0);
    }
    // one joint on a plate has 3, each further one 2 more
    switch (modes_) {
        case 3:
            return expand_modes(surface, std::integral_constant<std::size_t, 3>());
        case 5:
            return expand_modes(surface, std::integral_constant<std::size_t, 5>());
        case 7:
            return expand_modes(surface, std::integral_constant<std::size_t, 7>());
        default:
            return expand_modes(surface, modes_);
    }
}

// a row times each coefficient: five sums side by side, which do not wait for each other
BlockSeries TaylorBlock::row_series(std::span<const double> row, const std::vector<double>& series) const {
    constexpr std::size_t side_by_side = 5;
    static_assert((block_order + 1) % side_by_side == 0);
    BlockSeries result{};
    const auto count = static_cast<std::size_t>(order_) + 1;
    for (std::size_t m = 0; m < count; m += side_by_side) {
        std::array<double, side_by_side> sum{};
        const double* c = series.data() + m * modes_;
        for (std::size_t j = 0; j < row.size(); ++j)
            for (std::size_t i = 0; i < side_by_side; ++i)
                sum[i] += row[j] * c[i * modes_ + j];
        for (std::size_t i = 0; i < std::min(side_by_side, count - m); ++i)
            result[m + i] = sum[i];
    }
    return result;
}

BlockSeries TaylorBlock::gap(std::size_t contact) const {
    const ModalContact& c = structure_.contacts[contact];
    BlockSeries series = row_series(c.normal, q_);
    series[0] += c.initial_gap;
    return series;
}

BlockSeries TaylorBlock::slip_velocity(std::size_t contact) const {
    const ModalContact& c = structure_.contacts[contact];
    BlockSeries series = row_series(c.tangent, v_);
    for (std::size_t m = 0; m <= static_cast<std::size_t>(order_); ++m)
        series[m] -= c.drive_share * surface_[m];
    return series;
}

double TaylorBlock::velocity_scale(std::size_t contact) const {
    const ModalContact& c = structure_.contacts[contact];
    return dot_of_sizes(c.tangent, v_) + std::abs(c.drive_share * surface_[0]);
}

// a with all signs left out, at the block's beginning
const std::vector<double>& TaylorBlock::acceleration_sizes() const {
    std::vector<double>& size = acceleration_sizes_;
    if (!size.empty()) return size;
    size.resize(modes_);
    for (std::size_t j = 0; j < modes_; ++j)
        size[j] = std::abs(structure_.square_frequency[j] * q_[j]) + std::abs(structure_.load[j]);
    if (structure_.is_damped_by_mode())
        for (std::size_t j = 0; j < modes_; ++j)
            size[j] += std::abs(structure_.damping[j] * v_[j]);
    else
        for (std::size_t k = 0; k < modes_; ++k)
            for (std::size_t j = 0; j < modes_; ++j)
                size[j] += std::abs(structure_.damping[k * modes_ + j] * v_[k]);
    return size;
}

// R' a likewise, of each row
const std::vector<double>& TaylorBlock::constraint_sizes() const {
    if (!constraint_sizes_.empty()) return constraint_sizes_;
    const std::vector<double>& size = acceleration_sizes();
    for (std::size_t k = 0; k < rows_->normal.size() + rows_->tangent.size(); ++k)
        constraint_sizes_.push_back(dot_of_sizes({rows_->constraint.data() + k * modes_, modes_}, size));
    return constraint_sizes_;
}

double TaylorBlock::velocity_change_scale(std::size_t contact) const {
    const auto own = static_cast<Eigen::Index>(2 * contact + 1);
    return step_ * (dot_of_sizes(structure_.contacts[contact].tangent, acceleration_sizes()) +
                    structure_.compliance(own, own) * force_scale(contact));
}

double TaylorBlock::gap_change_scale(std::size_t contact) const {
    std::vector<double> size = acceleration_sizes();
    const std::size_t closed = rows_->normal.size();
    for (std::size_t r = 0; r < closed + rows_->tangent.size(); ++r) {
        const BlockSeries& series = r < closed ? normal_[rows_->normal[r]] : friction_[rows_->tangent[r - closed]];
        double force = 0.0;
        for (int m = 0; m <= order_; ++m)
            force = std::max(force, std::abs(series[static_cast<std::size_t>(m)]));
        for (std::size_t j = 0; j < modes_; ++j)
            size[j] += force * std::abs(rows_->push[r * modes_ + j]);
    }
    return step_ * step_ * dot_of_sizes(structure_.contacts[contact].normal, size);
}

// (R'B)^-1 R' a likewise
double TaylorBlock::force_scale(std::size_t contact) const {
    const std::size_t closed = rows_->normal.size();
    const std::size_t rows = closed + rows_->tangent.size();
    const std::vector<double>& size = constraint_sizes();
    double scale = 0.0;
    for (std::size_t r = 0; r < closed; ++r) {
        if (rows_->normal[r] != contact) continue;
        for (std::size_t k = 0; k < rows; ++k)
            scale += std::abs(rows_->inverse[r * rows + k]) * size[k];
    }
    return scale;
}

void TaylorBlock::at(const std::vector<double>& series, double theta, std::span<double> result) const {
    std::fill(result.begin(), result.end(), 0.0);
    for (int m = order_ + 1; m >= 0; --m) {
        const std::span<const double> c = coefficient(series, m);
        for (std::size_t j = 0; j < modes_; ++j)
            result[j] = result[j] * theta + c[j];
    }
}

BlockPlaces values_of(std::span<const double> c, const BlockPlaces& x) {
    BlockPlaces value{};
    for (std::size_t k = c.size(); k-- > 0;)
        for (std::size_t i = 0; i < block_places; ++i)
            value[i] = value[i] * x[i] + c[k];
    return value;
}

void TaylorBlock::velocities_at(const BlockPlaces& theta, std::span<double> v) const {
    for (std::size_t j = 0; j < modes_; ++j) {
        BlockPlaces value{};
        for (std::size_t m = static_cast<std::size_t>(order_) + 2; m-- > 0;)
            for (std::size_t i = 0; i < block_places; ++i)
                value[i] = value[i] * theta[i] + v_[m * modes_ + j];
        for (std::size_t i = 0; i < block_places; ++i)
            v[i * modes_ + j] = value[i];
    }
}

void TaylorBlock::displacement_at(double theta, std::span<double> q) const {
    at(q_, theta, q);
}

void TaylorBlock::velocity_at(double theta, std::span<double> v) const {
    at(v_, theta, v);
}

void TaylorBlock::acceleration_at(double theta, std::span<double> a) const {
    std::fill(a.begin(), a.end(), 0.0);
    for (int m = order_ + 1; m >= 1; --m) {
        const std::span<const double> c = coefficient(v_, m);
        for (std::size_t j = 0; j < modes_; ++j)
            a[j] = a[j] * theta + static_cast<double>(m) / step_ * c[j];
    }
}

double TaylorBlock::reach() const {
    double last = 0.0, largest = 0.0;
    const std::span<const double> end = coefficient(v_, order_ + 1);
    for (std::size_t j = 0; j < modes_; ++j)
        last = std::max(last, std::abs(end[j]));
    for (int m = 0; m < 4; ++m)
        for (const double each : coefficient(v_, m))
            largest = std::max(largest, std::abs(each));
    if (!(last > series_rounding * largest)) return 1.0;
    // the last term shrinks with theta^25; roots of two are enough to stay below it
    double theta = 1.0, share = last / (series_rounding * largest);
    while (share > 1.0 && theta > 0x1p-20) {
        theta *= 0.5;
        share *= 0x1p-25;
    }
    return theta;
}

}  // namespace stridor::integration
