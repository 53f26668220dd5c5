// Blocks with springs, and those in which contacts slip whose ratio T/N changes with the slip velocity
// (taylor_block.hpp).

#include "stridor/integration/rules/contact_mode_of.hpp"
#include "stridor/integration/series/event_polynomial.hpp"
#include "stridor/integration/series/taylor_block.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace stridor::integration {

namespace {

constexpr double stretch_rounding = 1e-13;    // [1] of a speed's terms: it stands on a corner of its law
constexpr double corner_width = 4.0;          // of that rounding: a spring within it stands on a corner of its force
constexpr double first_shortening = 0x1p-12;  // of a block in which a coefficient left double precision
constexpr double least_share = 0x1p-120;      // of the longest block: shorter ones come to no end
constexpr double least_advance = 0x1p-20;     // of a block that a corner ends: motion goes on

// sum of a_j b_(m-j), j = 1..m
double product_without_first(const BlockSeries& a, const BlockSeries& b, std::size_t m) {
    double sum = 0.0;
    for (std::size_t j = 1; j <= m; ++j)
        sum += a[j] * b[m - j];
    return sum;
}

// [m/s] bound of the change of a speed up to a share of the block
double change_within(const BlockSeries& speed, double share) {
    double change = 0.0;
    for (std::size_t m = speed.size(); m-- > 1;)
        change = (change + std::abs(speed[m])) * share;
    return change;
}

// c_m share^m
template <typename Series>
void scale_powers(Series& c, double share) {
    double power = 1.0;
    for (double& each : c) {
        each *= power;
        power *= share;
    }
}

}  // namespace

// B and (R'B)^-1 with the ratios of the block's beginning
void TaylorBlock::begin_rubbing() {
    const std::span<const double> v = coefficient(v_, 0);
    rubbing_.clear();
    for (const std::size_t r : chosen_->rubbed) {
        const std::size_t k = chosen_->normal[r];
        const ModalContact& contact = structure_.contacts[k];
        const model::Slip way = way_of((*set_)[k]);
        const double state_sign = model::state_sign(contact.friction, way);
        Rubbing slip{.row = r,
                     .contact = k,
                     .way = way,
                     .sign = way == model::Slip::forward ? 1.0 : -1.0,
                     .state_sign = state_sign,
                     .jet = {contact.friction, way, state_sign * friction_states_[k], length_},
                     .corner_rounding = stretch_rounding * velocity_scale(k)};
        slip.speed[0] = slip.sign * (dot(contact.tangent, v) - contact.drive_share * surface_[0]);
        slip.told_change = told_change(contact.friction, slip.speed[0]);
        slip.ratio[0] = -slip.sign * slip.jet.next({slip.speed.data(), 1});
        slip.state[0] = slip.jet.state();
        rubbing_.push_back(slip);
    }
    if (rubbing_.empty()) return;
    at_ratios_ = *chosen_;
    for (const Rubbing& slip : rubbing_) {
        const ModalContact& contact = structure_.contacts[slip.contact];
        for (std::size_t j = 0; j < modes_; ++j)
            number_in(&at_ratios_.push[slip.row * registers_], j) =
                contact.normal[j] + slip.ratio[0] * contact.tangent[j];
    }
    rows_ = &at_ratios_;
    if (at_ratios_.count() > 1) {
        inverted(*set_, at_ratios_);
        return;
    }
    // one contact alone has one number
    const auto normal = static_cast<Eigen::Index>(2 * rubbing_.front().contact);
    const Eigen::MatrixXd& W = structure_.compliance;
    number_in(at_ratios_.inverse.data(), 0) =
        1.0 / (W(normal, normal) + rubbing_.front().ratio[0] * W(normal, normal + 1));
}

// the stretch of each spring around its elongation; on a corner the one into which it moves
void TaylorBlock::begin_stretching() {
    const std::span<const double> q = coefficient(q_, 0), v = coefficient(v_, 0);
    for (std::size_t k = 0; k < stretching_.size(); ++k) {
        const ModalSpring& spring = structure_.springs[k];
        Stretching& at = stretching_[k];
        at.corner_rounding = stretch_rounding * elongation_size(spring, q);
        const model::CornerSide side = dot(spring.row, v) > 0.0 ? model::CornerSide::above : model::CornerSide::below;
        at.terms.stretch = elongation_stretch(spring.law, elongation(spring, q), at.corner_rounding, side);
    }
}

// what the springs push in this coefficient
void TaylorBlock::stretch(std::size_t m, Lanes* acceleration) {
    const std::span<const double> q = coefficient(q_, static_cast<int>(m));
    for (std::size_t k = 0; k < stretching_.size(); ++k) {
        const ModalSpring& spring = structure_.springs[k];
        Stretching& at = stretching_[k];
        at.elongation[m] = m == 0 ? elongation(spring, q) : dot(spring.row, q);
        at.terms.elongation = {at.elongation.data(), m + 1};
        const double force = at.force[m] = next_force(spring.law, at.terms);
        for (std::size_t j = 0; j < modes_; ++j)
            number_in(acceleration, j) -= force * spring.row[j];
    }
}

// what lower coefficients make of friction in this one
void TaylorBlock::rub(std::size_t m, Lanes* acceleration) {
    if (m == 0) return;
    const std::size_t registers = registers_for(rows_->count());
    const std::span<const double> v = coefficient(v_, static_cast<int>(m));
    for (Rubbing& slip : rubbing_) {
        const ModalContact& contact = structure_.contacts[slip.contact];
        BlockSeries& N = normal_[slip.contact];
        N[m - 1] = number_in(&force_[(m - 1) * registers], slip.row);
        slip.speed[m] = slip.sign * (dot(contact.tangent, v) - contact.drive_share * surface_[m]);
        if (m == 1) {
            const model::CornerSide side = slip.speed[1] > 0.0 ? model::CornerSide::above : model::CornerSide::below;
            slip.stretch = speed_stretch(contact.friction, slip.way, slip.speed[0], slip.corner_rounding, side);
            slip.jet.choose(slip.stretch);
        }
        slip.ratio[m] = -slip.sign * slip.jet.next({slip.speed.data(), m + 1});
        slip.state[m] = slip.jet.state();
        slip.known[m] = product_without_first(slip.ratio, N, m);
        for (std::size_t j = 0; j < modes_; ++j)
            number_in(acceleration, j) += slip.known[m] * contact.tangent[j];
    }
}

// the part of the block that the series reaches to rounding, in quarters of a power of two
double TaylorBlock::reached_share() const {
    using First = std::array<double, 4>;
    const auto largest = [&](int m) {
        double most = 0.0;
        for (const double each : coefficient(v_, m))
            most = std::max(most, std::abs(each));
        return most;
    };
    const auto whole_of = [](const First& first, double share) {
        double whole = 0.0, power = 1.0;
        for (const double each : first) {
            whole = std::max(whole, each * power);
            power *= share;
        }
        return whole;
    };
    const First first{largest(0), largest(1), largest(2), largest(3)};
    const double end = largest(order_), behind = largest(order_ + 1);
    const auto is_reached = [&](double share) {
        double power = 1.0;
        for (std::size_t m = 0; m < static_cast<std::size_t>(order_); ++m)
            power *= share;
        if (!(power * std::max(end, behind * share) <= series_rounding * whole_of(first, share))) return false;
        const auto is_rounding = [&](const BlockSeries& s) {
            const First begin{std::abs(s[0]), std::abs(s[1]), std::abs(s[2]), std::abs(s[3])};
            return power * std::abs(s[static_cast<std::size_t>(order_)]) <= series_rounding * whole_of(begin, share);
        };
        const auto is_told = [&](const Rubbing& slip) {
            return is_rounding(slip.state) && change_within(slip.speed, share) <= slip.told_change;
        };
        // where a contact sticks its velocity tells nothing of the force that springs need
        return std::all_of(rubbing_.begin(), rubbing_.end(), is_told) &&
               std::all_of(stretching_.begin(), stretching_.end(),
                           [&](const Stretching& at) { return is_rounding(at.force); });
    };
    double share = 1.0;
    while (!is_reached(share) && share > least_share)
        share *= 0.5;
    if (share == 1.0) return share;
    for (const double times : {1.75, 1.5, 1.25})
        if (is_reached(times * share)) return times * share;
    return share;
}

// scales all series to a shorter block
void TaylorBlock::shorten(double share) {
    length_ *= share;
    scale_powers(surface_, share);
    double power = 1.0;
    const std::size_t forces = registers_for(rows_->count());
    for (std::size_t m = 0; m < static_cast<std::size_t>(order_) + 2; ++m) {
        for (std::vector<Lanes>* series : {&q_, &v_})
            for (std::size_t r = 0; r < registers_; ++r)
                for (double& each : (*series)[m * registers_ + r].at)
                    each *= power;
        for (std::size_t r = 0; r < forces && m <= static_cast<std::size_t>(order_); ++r)
            for (double& each : force_[m * forces + r].at)
                each *= power;
        power *= share;
    }
    for (Rubbing& slip : rubbing_)
        for (BlockSeries* series : {&slip.speed, &slip.ratio, &slip.state, &slip.known})
            scale_powers(*series, share);
    for (Stretching& at : stretching_)
        scale_powers(at.elongation, share);
}

// up to the highest order: the last coefficients tell how far the series reaches
void TaylorBlock::expand_rubbing() {
    order_ = highest_;
    for (bool is_number = false; !is_number && length_ > least_share * step_;) {
        begin_rubbing();
        begin_stretching();
        SeriesProblem rubbed = problem();
        rubbed.rub = [](void* block, std::size_t m, Lanes* acceleration) {
            static_cast<TaylorBlock*>(block)->stretch(m, acceleration);
            static_cast<TaylorBlock*>(block)->rub(m, acceleration);
        };
        rubbed.friction = this;
        kernel_.expand(rubbed, order_, room());
        is_number = is_finite(coefficient(v_, order_), coefficient(v_, order_ + 1));
        if (is_number) break;
        length_ *= first_shortening;
        scale_powers(surface_, first_shortening);
    }
    const double share = reached_share();
    if (share < 1.0) shorten(share);
    store_forces();
    for (const Rubbing& slip : rubbing_) {
        const BlockSeries& N = normal_[slip.contact];
        for (std::size_t m = 0; m < N.size(); ++m)
            friction_[slip.contact][m] = slip.ratio[0] * N[m] + slip.known[m];
    }
}

void TaylorBlock::move_friction_states(double theta, std::span<double> friction_states) const {
    for (const Rubbing& slip : rubbing_)
        friction_states[slip.contact] = slip.state_sign * value_of(slip.state, theta);
}

double TaylorBlock::stretch_end(double reach) const {
    double end = reach;
    // first place at which sign times the series reaches that of the corner
    const auto place_at = [&](const BlockSeries& series, double corner, double sign, double rounding) {
        BlockSeries left;
        for (std::size_t m = 0; m < left.size(); ++m)
            left[m] = -sign * series[m];
        left[0] += sign * corner;
        return first_zero(left, std::abs(left[0]) <= rounding ? 1 : 0, end);
    };
    const auto leave = [&](const Rubbing& slip, double corner, double sign) {
        if (!std::isfinite(corner)) return;
        const double place = place_at(slip.speed, corner, sign, slip.corner_rounding);
        if (place < end) end = std::max(place, std::min(least_advance, end));
    };
    for (const Rubbing& slip : rubbing_) {
        leave(slip, slip.stretch.to, 1.0);
        leave(slip, slip.stretch.from, -1.0);
    }
    // a spring may rest on a corner: it has left it when it is beyond rounding
    const auto leave_corner = [&](const Stretching& at, double corner, double sign) {
        if (!std::isfinite(corner)) return;
        const double beyond = corner + sign * corner_width * at.corner_rounding;
        const double place = place_at(at.elongation, beyond, sign, 0.0);
        if (place < end) end = std::max(place, std::min(least_advance, end));
    };
    for (const Stretching& at : stretching_) {
        leave_corner(at, at.terms.stretch.to, 1.0);
        leave_corner(at, at.terms.stretch.from, -1.0);
    }
    return end;
}

}  // namespace stridor::integration
