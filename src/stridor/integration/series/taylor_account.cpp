// What a block adds to the sums of its span and to the energy balance, by quadrature over its series, what impacts add
// to them between blocks, and the samples that lie in it.

#include "stridor/integration/modal/modal_account.hpp"
#include "stridor/integration/rules/contact_mode_of.hpp"
#include "stridor/integration/series/taylor_run.hpp"
#include "stridor/model/sized_structure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace stridor::integration {

namespace {

// Gauss' quadrature on [0, 1], exact to degree 15. Abramowitz and Stegun (1964), 25.4.30
constexpr BlockPlaces node{0.5 - 0.5 * 0.9602898564975363, 0.5 - 0.5 * 0.7966664774136267,
                           0.5 - 0.5 * 0.5255324099163290, 0.5 - 0.5 * 0.1834346424956498,
                           0.5 + 0.5 * 0.1834346424956498, 0.5 + 0.5 * 0.5255324099163290,
                           0.5 + 0.5 * 0.7966664774136267, 0.5 + 0.5 * 0.9602898564975363};
constexpr BlockPlaces node_weight{0.5 * 0.1012285362903763, 0.5 * 0.2223810344533745, 0.5 * 0.3137066458778873,
                                  0.5 * 0.3626837833783620, 0.5 * 0.3626837833783620, 0.5 * 0.3137066458778873,
                                  0.5 * 0.2223810344533745, 0.5 * 0.1012285362903763};

// of a series from 0 to x, in units of x
double integral(const BlockSeries& c, double x) {
    double sum = 0.0;
    for (std::size_t m = c.size(); m-- > 0;)
        sum = sum * x + c[m] / static_cast<double>(m + 1);
    return sum * x;
}

}  // namespace

// what the block adds up to its end
void TaylorRun::account(double theta) {
    const bool is_judged = record::is_judged(spans()[span_].use);
    const std::size_t modes = structure_.modes();
    BlockPlaces x{};
    for (std::size_t i = 0; i < block_places; ++i)
        x[i] = theta * node[i];
    block_.velocities_at(x, velocities_);
    if (is_judged || is_measuring_) {
        const auto rows = static_cast<Eigen::Index>(registers_for(modes) * lanes);
        speeds_.noalias() =
            structure_.channels * Eigen::Map<const Eigen::MatrixXd>(velocities_.front().at, rows, block_places)
                                      .topRows(structure_.channels.cols());
    }
    const BlockPlaces V = values_of(surface_, x);
    for (std::size_t k = 0; k < state_.set.size(); ++k) {
        const ContactMode mode = state_.set[k];
        if (mode == ContactMode::open) continue;
        const bool is_expanded = block_.expands_friction(k);
        tangential_[k] = values_of(is_expanded ? block_.friction_force(k) : block_.normal_force(k), x);
        if (is_expanded) continue;
        for (double& each : tangential_[k])
            each = slip_ratio(structure_.contacts[k].friction, way_of(mode)) * each;
    }
    for (std::size_t i = 0; i < block_places; ++i) {
        const double duration = node_weight[i] * theta * block_.length();
        const double* v = velocities_[i * registers_for(modes)].at;
        work_.dashpot_loss += duration * dashpot_power(structure_, {v, modes});
        for (std::size_t k = 0; k < state_.set.size(); ++k) {
            const ContactMode mode = state_.set[k];
            if (mode == ContactMode::open) continue;
            const ModalContact& c = structure_.contacts[k];
            const double T = tangential_[k][i];
            work_.drive_work += duration * T * c.drive_share * V[i];
            if (!is_slip(mode)) continue;
            double w = -c.drive_share * V[i];
            for (std::size_t j = 0; j < modes; ++j)
                w += c.tangent[j] * v[j];
            const double loss = -duration * T * w;
            work_.friction_loss += loss;
            if (is_judged) sums_.load[structure_.number[k]].friction_loss += loss;
            if (is_measuring_) period_.load[structure_.number[k]].friction_loss += loss;
        }
        if (!is_judged && !is_measuring_) continue;
        const auto speed = speeds_.col(static_cast<Eigen::Index>(i));
        if (is_judged) add_vibration(whole_, speed, duration, sums_.vibration);
        if (is_measuring_) add_vibration(whole_, speed, duration, period_.vibration);
    }
    if (is_judged) add_normal_impulse(theta, sums_);
    if (is_measuring_) add_normal_impulse(theta, period_);
}

void TaylorRun::add_normal_impulse(double theta, Sums& sums) const {
    for (std::size_t k = 0; k < state_.set.size(); ++k) {
        if (state_.set[k] == ContactMode::open) continue;
        sums.load[structure_.number[k]].normal_impulse += block_.length() * integral(block_.normal_force(k), theta);
    }
}

// what the contacts carry where one of them changes its state, or a span ends
void TaylorRun::press(double theta) {
    for (std::size_t k = 0; k < state_.set.size(); ++k) {
        if (state_.set[k] == ContactMode::open) continue;
        const double normal_force = value_of(block_.normal_force(k), theta);
        for (Sums* sums : {&sums_, &period_}) {
            if (sums->load.empty()) continue;
            double& largest = sums->load[structure_.number[k]].largest_force;
            largest = std::max(largest, normal_force);
        }
    }
}

// impacts have no duration: what they carry lies in no block
void TaylorRun::add_impacts() {
    const std::vector<record::Load> impacts = settling_.take_impacts();
    const bool is_judged = record::is_judged(spans()[span_].use);
    for (std::size_t k = 0; k < impacts.size(); ++k) {
        if (is_judged) sums_.load[structure_.number[k]] += impacts[k];
        if (is_measuring_) period_.load[structure_.number[k]] += impacts[k];
    }
}

void TaylorRun::pass_samples(double theta) {
    const auto n = static_cast<Eigen::Index>(structure_.modes());
    Eigen::VectorXd q(n), v(n), a(n);
    for (; samples_.has_next(); ++samples_.next) {
        const double time = samples_.next_time();
        const double x = std::max(0.0, (time - time_) / block_.length());
        if (x > theta) return;
        block_.state_at(x, {q.data(), structure_.modes()}, {v.data(), structure_.modes()});
        block_.acceleration_at(x, {a.data(), structure_.modes()});
        std::vector<record::ContactSample> contacts(state_.set.size());
        for (std::size_t k = 0; k < state_.set.size(); ++k) {
            const ContactMode mode = state_.set[k];
            const ModalContact& c = structure_.contacts[k];
            record::ContactSample& sample = contacts[structure_.number[k]];
            sample.state = contact_of(mode);
            if (mode == ContactMode::open) {
                sample.gap = std::max(0.0, gap(c, {q.data(), structure_.modes()}));
                continue;
            }
            sample.normal_force = std::max(0.0, value_of(block_.normal_force(k), x));
            sample.friction_force = block_.expands_friction(k)
                                        ? value_of(block_.friction_force(k), x)
                                        : slip_ratio(c.friction, way_of(mode)) * sample.normal_force;
        }
        const Eigen::VectorXd u = structure_.shapes * q, speed = structure_.shapes * v,
                              acceleration = structure_.shapes * a;
        recorder_.sample({time, model::numbers(u), model::numbers(speed), model::numbers(acceleration),
                          value_of(std::span(surface_), x), contacts});
    }
}

EnergyBalance TaylorRun::energy() const {
    EnergyBalance balance = work_;
    const EnergyBalance& impacts = settling_.losses();
    balance.impact_loss += impacts.impact_loss;
    balance.friction_loss += impacts.friction_loss;
    balance.drive_work += impacts.drive_work;
    balance.stored = stored_energy(structure_, state_.q, state_.v) - initial_energy_;
    return closed_balance(balance, structure_, state_.q, travel_);
}

}  // namespace stridor::integration
