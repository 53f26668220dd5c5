#include "stridor/integration/series/taylor_block.hpp"

#include "stridor/base/decompositions.hpp"
#include "stridor/integration/rules/contact_mode_of.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace stridor::integration {

namespace {

constexpr std::size_t most_prepared = 4096;  // sets: beyond it they are prepared anew
constexpr double least_pivot_share = 1e-13;  // of the largest: rows with less depend on each other

// rows of so many numbers, each filled up with zeros
std::vector<Lanes> in_registers(std::span<const double> numbers, std::size_t row) {
    const std::size_t registers = registers_for(row);
    std::vector<Lanes> filled(numbers.size() / row * registers);
    for (std::size_t k = 0; k < numbers.size(); ++k)
        number_in(&filled[k / row * registers], k % row) = numbers[k];
    return filled;
}

}  // namespace

TaylorBlock::TaylorBlock(const ModalStructure& structure, double step, int highest)
    : structure_(structure),
      step_(step),
      length_(step),
      kernel_(series_kernel()),
      modes_(structure.modes()),
      registers_(registers_for(modes_)),
      highest_(highest),
      stretching_(structure.springs.size()),
      friction_states_(structure.contacts.size()),
      square_(in_registers(structure.square_frequency, modes_)),
      damping_(in_registers(structure.damping, modes_)),
      load_(in_registers(structure.load, modes_)),
      q_((block_order + 2) * registers_),
      v_(q_.size()),
      force_((block_order + 1) * registers_for(2 * structure.contacts.size())),
      acceleration_(registers_),
      right_(2 * registers_for(2 * structure.contacts.size())),
      state_(2 * registers_),
      normal_(structure.contacts.size()),
      friction_(structure.contacts.size()) {}

// the rows R and B, without what follows from them
TaylorBlock::Rows TaylorBlock::listed(const ContactSet& set) const {
    Rows rows;
    for (std::size_t k = 0; k < set.size(); ++k) {
        if (set[k] != ContactMode::open) rows.normal.push_back(k);
        if (set[k] == ContactMode::stick) rows.tangent.push_back(k);
    }
    rows.constraint.resize(rows.count() * registers_);
    rows.push.resize(rows.constraint.size());
    rows.drive.resize(rows.count());
    for (std::size_t r = 0; r < rows.count(); ++r) {
        const bool is_normal = r < rows.normal.size();
        const std::size_t k = is_normal ? rows.normal[r] : rows.tangent[r - rows.normal.size()];
        const ModalContact& contact = structure_.contacts[k];
        const std::vector<double>& row = is_normal ? contact.normal : contact.tangent;
        const double ratio = is_normal && is_slip(set[k]) ? ratio_at(k, way_of(set[k])) : 0.0;
        if (!is_normal) rows.drive[r] = contact.drive_share;
        if (is_normal && is_slip(set[k]) && !is_state_wise(contact.friction)) rows.rubbed.push_back(r);
        for (std::size_t j = 0; j < modes_; ++j) {
            number_in(&rows.constraint[r * registers_], j) = row[j];
            number_in(&rows.push[r * registers_], j) = ratio == 0.0 ? row[j] : row[j] + ratio * contact.tangent[j];
        }
    }
    return rows;
}

// R'B, from what the rows of all contacts give with each other
Eigen::MatrixXd TaylorBlock::products(const ContactSet& set, const Rows& rows) const {
    const std::size_t closed = rows.normal.size();
    const auto number = [&](std::size_t r) {
        return static_cast<Eigen::Index>(r < closed ? 2 * rows.normal[r] : 2 * rows.tangent[r - closed] + 1);
    };
    const auto size = static_cast<Eigen::Index>(rows.count());
    Eigen::MatrixXd seen(size, size);
    for (std::size_t c = 0; c < rows.count(); ++c) {
        const Eigen::Index column = number(c);
        const bool slips = c < closed && is_slip(set[rows.normal[c]]);
        const double ratio = slips ? ratio_at(rows.normal[c], way_of(set[rows.normal[c]])) : 0.0;
        for (std::size_t r = 0; r < rows.count(); ++r)
            seen(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) =
                structure_.compliance(number(r), column) +
                (slips ? ratio * structure_.compliance(number(r), column + 1) : 0.0);
    }
    return seen;
}

// lam = F (-Omega² q - C q' + f) + (R'B)^-1 r with F = -(R'B)^-1 R', put into q'' = -Omega² q - C q' + f + B lam
std::vector<Lanes> TaylorBlock::eliminated(const Rows& rows, const Eigen::MatrixXd& inverse) const {
    const auto n = static_cast<Eigen::Index>(modes_), r = static_cast<Eigen::Index>(rows.count());
    Eigen::MatrixXd constraint(r, n), push(n, r), terms(n, 2 * n + 2);
    for (Eigen::Index row = 0; row < r; ++row)
        for (Eigen::Index j = 0; j < n; ++j) {
            constraint(row, j) = rows.constraint[static_cast<std::size_t>(row)].at[j];
            push(j, row) = rows.push[static_cast<std::size_t>(row)].at[j];
        }
    // columns: each number of q, each of v, the surface, the load
    terms.setZero();
    for (Eigen::Index j = 0; j < n; ++j) {
        terms(j, j) = -structure_.square_frequency[static_cast<std::size_t>(j)];
        terms(j, 2 * n + 1) = structure_.load[static_cast<std::size_t>(j)];
        if (structure_.is_damped_by_mode()) terms(j, n + j) = -structure_.damping[static_cast<std::size_t>(j)];
    }
    if (!structure_.is_damped_by_mode())
        for (Eigen::Index k = 0; k < n; ++k)
            for (Eigen::Index j = 0; j < n; ++j)
                terms(j, n + k) = -structure_.damping[static_cast<std::size_t>(k * n + j)];
    Eigen::MatrixXd forces = -inverse * constraint.lazyProduct(terms);
    forces.col(2 * n) = inverse * Eigen::Map<const Eigen::VectorXd>(rows.drive.data(), r);
    terms += push.lazyProduct(forces);
    std::vector<Lanes> columns(static_cast<std::size_t>(2 * (2 * n + 2)));
    for (Eigen::Index c = 0; c < 2 * n + 2; ++c) {
        for (Eigen::Index j = 0; j < n; ++j)
            columns[static_cast<std::size_t>(2 * c)].at[j] = terms(j, c);
        for (Eigen::Index row = 0; row < r; ++row)
            columns[static_cast<std::size_t>(2 * c + 1)].at[row] = forces(row, c);
    }
    return columns;
}

// T/N of a slip: at the block's beginning, where it changes
double TaylorBlock::ratio_at(std::size_t contact, model::Slip way) const {
    for (const Rubbing& slip : rubbing_)
        if (slip.contact == contact) return slip.ratio[0];
    return slip_ratio(structure_.contacts[contact].friction, way);
}

// (R'B)^-1
Eigen::MatrixXd TaylorBlock::inverted(const ContactSet& set, Rows& rows) const {
    Eigen::FullPivLU<Eigen::MatrixXd> factor(products(set, rows));
    factor.setThreshold(least_pivot_share);
    rows.is_singular = !factor.isInvertible();
    if (rows.is_singular) return {};
    Eigen::MatrixXd inverse = factor.inverse();
    rows.inverse = in_registers({inverse.data(), static_cast<std::size_t>(inverse.size())}, rows.count());
    return inverse;
}

TaylorBlock::Rows TaylorBlock::prepare(const ContactSet& set) const {
    Rows rows = listed(set);
    if (rows.count() == 0) return rows;
    const Eigen::MatrixXd inverse = inverted(set, rows);
    if (rows.is_singular || is_expanded_stepwise(rows)) return rows;
    if (registers_ == 1 && rows.count() <= lanes) rows.eliminated = eliminated(rows, inverse);
    return rows;
}

bool TaylorBlock::choose(const ContactSet& set) {
    rubbing_.clear();
    auto found = prepared_.find(set);
    if (found == prepared_.end()) {
        if (prepared_.size() >= most_prepared) prepared_.clear();
        found = prepared_.emplace(set, prepare(set)).first;
    }
    rows_ = chosen_ = &found->second;
    set_ = &found->first;
    return !rows_->is_singular;
}

SeriesRoom TaylorBlock::room() {
    return {q_.data(), v_.data(), force_.data(), acceleration_.data(), right_.data()};
}

SeriesProblem TaylorBlock::problem() {
    return {.modes = registers_,
            .rows = rows_->count(),
            .square = square_.data(),
            .damping = damping_.data(),
            .damped_modes = structure_.is_damped_by_mode() ? 0 : modes_,
            .load = load_.data(),
            .constraint = rows_->constraint.data(),
            .push = rows_->push.data(),
            .inverse = rows_->inverse.data(),
            .drive = rows_->drive.data(),
            .surface = surface_.data(),
            .step = length_,
            .eliminated = rows_->eliminated.empty() ? nullptr : rows_->eliminated.data(),
            .numbers = modes_};
}

void TaylorBlock::expand(std::span<const double> q, std::span<const double> v, std::span<const double> friction_states,
                         const SurfaceSeries& surface, int order) {
    rows_ = chosen_;
    rubbing_.clear();
    order_ = std::min(order, highest_);
    surface_ = surface;
    length_ = step_;
    acceleration_sizes_.clear();
    constraint_sizes_.clear();
    std::copy(q.begin(), q.end(), q_.front().at);
    std::copy(v.begin(), v.end(), v_.front().at);
    std::copy(friction_states.begin(), friction_states.end(), friction_states_.begin());
    if (is_expanded_stepwise(*rows_)) return expand_rubbing();
    kernel_.expand(problem(), order_, room());
    store_forces();
}

void TaylorBlock::store_forces() {
    for (std::size_t k = 0; k < normal_.size(); ++k) {
        normal_[k].fill(0.0);
        friction_[k].fill(0.0);
    }
    const std::size_t closed = rows_->normal.size();
    const std::size_t registers = registers_for(rows_->count());
    for (std::size_t m = 0; m <= static_cast<std::size_t>(order_); ++m)
        for (std::size_t r = 0; r < rows_->count(); ++r)
            (r < closed ? normal_[rows_->normal[r]] : friction_[rows_->tangent[r - closed]])[m] =
                number_in(&force_[m * registers], r);
}

// a row times each coefficient: five sums side by side, which do not wait for each other
BlockSeries TaylorBlock::row_series(std::span<const double> row, const std::vector<Lanes>& series) const {
    constexpr std::size_t side_by_side = 5;
    static_assert((block_order + 1) % side_by_side == 0);
    BlockSeries result{};
    const auto count = static_cast<std::size_t>(order_) + 1;
    const std::size_t stride = registers_ * lanes;
    for (std::size_t m = 0; m < count; m += side_by_side) {
        std::array<double, side_by_side> sum{};
        const double* c = series[m * registers_].at;
        for (std::size_t j = 0; j < row.size(); ++j)
            for (std::size_t i = 0; i < side_by_side; ++i)
                sum[i] += row[j] * c[i * stride + j];
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
    return dot_of_sizes(c.tangent, coefficient(v_, 0)) + std::abs(c.drive_share * surface_[0]);
}

// a with all signs left out, at the block's beginning
const std::vector<double>& TaylorBlock::acceleration_sizes() const {
    std::vector<double>& size = acceleration_sizes_;
    if (!size.empty()) return size;
    const std::span<const double> q = coefficient(q_, 0), v = coefficient(v_, 0);
    size.resize(modes_);
    for (std::size_t j = 0; j < modes_; ++j)
        size[j] = std::abs(structure_.square_frequency[j] * q[j]) + std::abs(structure_.load[j]);
    if (structure_.is_damped_by_mode())
        for (std::size_t j = 0; j < modes_; ++j)
            size[j] += std::abs(structure_.damping[j] * v[j]);
    else
        for (std::size_t k = 0; k < modes_; ++k)
            for (std::size_t j = 0; j < modes_; ++j)
                size[j] += std::abs(structure_.damping[k * modes_ + j] * v[k]);
    for (const ModalSpring& spring : structure_.springs) {
        // sum of the force's terms, and what rounding of e makes of it
        const double e = elongation(spring, q);
        const double force =
            std::abs(force_of(spring.law, e)) + std::abs(stiffness_of(spring.law, e)) * elongation_size(spring, q);
        for (std::size_t j = 0; j < modes_; ++j)
            size[j] += force * std::abs(spring.row[j]);
    }
    return size;
}

// R' a likewise, of each row
const std::vector<double>& TaylorBlock::constraint_sizes() const {
    if (!constraint_sizes_.empty()) return constraint_sizes_;
    const std::vector<double>& size = acceleration_sizes();
    for (const std::size_t k : rows_->normal)
        constraint_sizes_.push_back(dot_of_sizes(structure_.contacts[k].normal, size));
    for (const std::size_t k : rows_->tangent)
        constraint_sizes_.push_back(dot_of_sizes(structure_.contacts[k].tangent, size));
    return constraint_sizes_;
}

double TaylorBlock::free_change_scale(std::size_t contact) const {
    return length_ * dot_of_sizes(structure_.contacts[contact].tangent, acceleration_sizes());
}

double TaylorBlock::velocity_change_scale(std::size_t contact) const {
    const auto own = static_cast<Eigen::Index>(2 * contact + 1);
    return free_change_scale(contact) + length_ * structure_.compliance(own, own) * force_scale(contact);
}

double TaylorBlock::gap_change_scale(std::size_t contact) const {
    std::vector<double> size = acceleration_sizes();
    const std::size_t closed = rows_->normal.size();
    for (std::size_t r = 0; r < rows_->count(); ++r) {
        const BlockSeries& series = r < closed ? normal_[rows_->normal[r]] : friction_[rows_->tangent[r - closed]];
        double force = 0.0;
        for (int m = 0; m <= order_; ++m)
            force = std::max(force, std::abs(series[static_cast<std::size_t>(m)]));
        for (std::size_t j = 0; j < modes_; ++j)
            size[j] += force * std::abs(number_in(&rows_->push[r * registers_], j));
    }
    return length_ * length_ * dot_of_sizes(structure_.contacts[contact].normal, size);
}

// (R'B)^-1 R' a likewise
double TaylorBlock::force_scale(std::size_t contact) const {
    const std::size_t closed = rows_->normal.size();
    const std::vector<double>& size = constraint_sizes();
    double scale = 0.0;
    for (std::size_t r = 0; r < closed; ++r) {
        if (rows_->normal[r] != contact) continue;
        for (std::size_t k = 0; k < rows_->count(); ++k)
            scale += std::abs(number_in(&rows_->inverse[k * registers_for(rows_->count())], r)) * size[k];
    }
    return scale;
}

BlockPlaces values_of(std::span<const double> c, const BlockPlaces& x) {
    BlockPlaces value{};
    for (std::size_t k = c.size(); k-- > 0;)
        for (std::size_t i = 0; i < block_places; ++i)
            value[i] = value[i] * x[i] + c[k];
    return value;
}

void TaylorBlock::velocities_at(const BlockPlaces& theta, std::vector<Lanes>& v) const {
    v.resize(block_places * registers_);
    kernel_.evaluate(v_.data(), static_cast<std::size_t>(order_) + 2, registers_, theta, v.data());
}

void TaylorBlock::state_at(double theta, std::span<double> q, std::span<double> v) const {
    kernel_.evaluate_state(q_.data(), v_.data(), static_cast<std::size_t>(order_) + 2, registers_, theta, state_.data(),
                           state_.data() + registers_);
    std::copy_n(state_.front().at, modes_, q.begin());
    std::copy_n(state_[registers_].at, modes_, v.begin());
}

void TaylorBlock::acceleration_at(double theta, std::span<double> a) const {
    std::fill(a.begin(), a.end(), 0.0);
    for (int m = order_ + 1; m >= 1; --m) {
        const std::span<const double> c = coefficient(v_, m);
        for (std::size_t j = 0; j < modes_; ++j)
            a[j] = a[j] * theta + static_cast<double>(m) / length_ * c[j];
    }
}

double TaylorBlock::reach() const {
    if (is_expanded_stepwise(*rows_)) return 1.0;  // the block was shortened to it
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
        share = std::ldexp(share, -(order_ + 1));
    }
    return theta;
}

}  // namespace stridor::integration
