// From event to event with several contacts. A block of h = 2/Omega is a power series of the motion and of every event
// function:
//
//     open    g -> impact with all that touches
//     slip    N -> separation                 sigma w -> stick if |T| <= mu_s N there, else slip the other way
//     stick   N -> separation                 mu_s N -+ T -> slip with sign(w) = -sign(T)
//
// The first zero of all functions ends the block; `Settling` says how the contacts go on. What lies within a block
// (samples) is evaluated from its beginning and never changes it; ends of spans and corners of the drive end it.

#include "stridor/integration/taylor/taylor.hpp"

#include "stridor/base/error.hpp"
#include "stridor/integration/contact_mode_of.hpp"
#include "stridor/integration/imposed_motion.hpp"
#include "stridor/integration/taylor/event_polynomial.hpp"
#include "stridor/integration/taylor/settling.hpp"
#include "stridor/model/sized_structure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace stridor::integration {

namespace {

constexpr long blocks_between_checks = 256;
constexpr long blocks_between_projections = 64;
// so many events within this share of a block are a pile-up that double precision cannot resolve
constexpr int most_events_at_once = 1000;
constexpr double pile_up_window = 1e-3;
constexpr double most_unexplained_share = 1e-9;

// Gauss' quadrature on [0, 1], exact to degree 15. Abramowitz and Stegun (1964), 25.4.30
constexpr std::size_t nodes = 8;
constexpr std::array<double, nodes> node{0.5 - 0.5 * 0.9602898564975363, 0.5 - 0.5 * 0.7966664774136267,
                                         0.5 - 0.5 * 0.5255324099163290, 0.5 - 0.5 * 0.1834346424956498,
                                         0.5 + 0.5 * 0.1834346424956498, 0.5 + 0.5 * 0.5255324099163290,
                                         0.5 + 0.5 * 0.7966664774136267, 0.5 + 0.5 * 0.9602898564975363};
constexpr std::array<double, nodes> node_weight{
    0.5 * 0.1012285362903763, 0.5 * 0.2223810344533745, 0.5 * 0.3137066458778873, 0.5 * 0.3626837833783620,
    0.5 * 0.3626837833783620, 0.5 * 0.3137066458778873, 0.5 * 0.2223810344533745, 0.5 * 0.1012285362903763};

// a function of a contact that becomes zero
struct Firing {
    double theta = no_zero;  // [1]
    std::size_t contact = 0;
    std::size_t function = 0;
    bool is_lost = false;  // a coefficient left double precision
};

class TaylorRun {
public:
    TaylorRun(const model::Structure& structure, const parameters::Drive& drive, const InitialState& start,
              record::Recorder& recorder);

    Outcome run(const std::stop_token& stop);
    EnergyBalance energy() const;

private:
    const std::vector<record::Span>& spans() const { return recorder_.schedule().spans; }
    SurfaceSeries surface(double time) const;
    double next_boundary() const;
    Firing first_firing(double reach);
    void account(double theta);
    void add_vibration(const Eigen::VectorXd& speed, double duration);
    void pass_samples(double theta);
    void move(double theta);
    std::optional<Outcome> fire(const Firing& firing);
    bool pass_boundary();
    void tell();
    double stored() const;
    bool is_finite() const;

    const model::Structure& whole_;
    parameters::Drive drive_;
    ImposedMotion motion_;
    record::Recorder& recorder_;
    ModalStructure structure_;
    double step_;
    TaylorBlock block_;
    Settling settling_;
    TaylorState state_;
    SurfaceSeries surface_{};
    bool is_fresh_ = true;  // the block begins at an event
    double time_ = 0.0;     // [s]
    std::size_t span_ = 0;
    std::size_t knot_ = 0;
    long sample_ = 0;
    long last_sample_ = -1;
    std::vector<ContactMode> told_;
    std::vector<record::Vibration> vibration_;
    double vibrated_from_ = 0.0;  // [s]
    EnergyBalance work_;          // dashpots, friction, drive
    double initial_energy_ = 0.0;
    std::vector<double> initial_q_;
    std::vector<double> most_q_, most_v_;  // largest that they have been
    double window_begin_ = 0.0;            // [s] of the search for pile-ups
    int window_events_ = 0;
    std::vector<double> scratch_;
    std::vector<Settled> lost_;
};

TaylorRun::TaylorRun(const model::Structure& structure, const parameters::Drive& drive, const InitialState& start,
                     record::Recorder& recorder)
    : whole_(structure),
      drive_(drive),
      motion_(drive, 1.0),
      recorder_(recorder),
      structure_(modal_structure(structure)),
      step_(2.0 / std::max(structure_.fastest, drive.kind == parameters::DriveKind::sinusoidal
                                                   ? 2.0 * std::numbers::pi * drive.frequency
                                                   : 0.0)),
      block_(structure_, step_),
      settling_(structure_, step_),
      vibration_(static_cast<std::size_t>(model::dofs_of(structure))),
      scratch_(structure_.modes()) {
    const Eigen::VectorXd q = modal(structure_, structure, start.displacement);
    const Eigen::VectorXd v = modal(structure_, structure, start.velocity);
    state_.q.assign(q.data(), q.data() + q.size());
    state_.v.assign(v.data(), v.data() + v.size());
    state_.set.assign(structure_.contacts.size(), ContactMode::stick);
    for (std::size_t k = 0; k < structure_.contacts.size(); ++k)
        if (whole_.contacts[structure_.number[k]].initial_gap > 0.0) state_.set[k] = ContactMode::open;
    state_.dropped.resize(structure_.contacts.size());
    told_ = state_.set;
    most_q_.assign(structure_.modes(), 0.0);
    most_v_ = most_q_;
    const record::TraceRequest& trace = recorder_.request().trace;
    if (trace.interval > 0.0) {
        sample_ = static_cast<long>(std::ceil(trace.from / trace.interval - 1e-6));
        last_sample_ = static_cast<long>(std::floor(trace.to / trace.interval + 1e-6));
    }
}

SurfaceSeries TaylorRun::surface(double time) const {
    const model::SurfaceMotion now = motion_.at(time);
    SurfaceSeries series{};
    series[0] = now.velocity;
    if (drive_.kind == parameters::DriveKind::sampled) series[1] = now.acceleration * step_;
    if (drive_.kind != parameters::DriveKind::sinusoidal) return series;
    // V(t + x) = V cos(omega x) + V'/omega sin(omega x)
    const double omega = 2.0 * std::numbers::pi * drive_.frequency;
    const double turn = omega * step_;
    double power = 1.0;
    for (std::size_t m = 0; m < series.size(); ++m) {
        const double sign = m % 4 < 2 ? 1.0 : -1.0;
        series[m] = sign * power * (m % 2 == 0 ? now.velocity : now.acceleration / omega);
        power *= turn / static_cast<double>(m + 1);
    }
    return series;
}

double TaylorRun::next_boundary() const {
    double end = spans()[span_].to;
    if (drive_.kind == parameters::DriveKind::sampled && knot_ < drive_.times.size())
        end = std::min(end, drive_.times[knot_]);
    return end;
}

Firing TaylorRun::first_firing(double reach) {
    Firing first;
    for (std::size_t k = 0; k < state_.set.size(); ++k) {
        const ContactMode mode = state_.set[k];
        for (std::size_t f = 0; f < event_functions(mode); ++f) {
            const BlockSeries c = event_series(structure_, block_, k, mode, f);
            const int dropped = is_fresh_ ? state_.dropped[k][f] : 0;
            if (dropped > 4) continue;
            const double theta = first_zero(c, dropped, std::min(reach, first.theta));
            if (theta == no_polynomial) return {0.0, k, f, true};
            if (theta < first.theta) first = {theta, k, f, false};
        }
    }
    return first;
}

// what the block adds up to its end
void TaylorRun::account(double theta) {
    const bool is_judged = record::is_judged(spans()[span_].use);
    for (std::size_t i = 0; i < nodes; ++i) {
        const double x = theta * node[i];
        const double duration = node_weight[i] * theta * step_;
        block_.velocity_at(x, scratch_);
        const double* v = scratch_.data();
        double dashpots = 0.0;
        if (structure_.is_damped_by_mode()) {
            for (std::size_t j = 0; j < scratch_.size(); ++j)
                dashpots += structure_.damping[j] * v[j] * v[j];
        } else {
            for (std::size_t a = 0; a < scratch_.size(); ++a)
                for (std::size_t b = 0; b < scratch_.size(); ++b)
                    dashpots += structure_.damping[a * scratch_.size() + b] * v[a] * v[b];
        }
        work_.dashpot_loss += duration * dashpots;
        const double V = value_of(std::span(surface_), x);
        for (std::size_t k = 0; k < state_.set.size(); ++k) {
            const ContactMode mode = state_.set[k];
            if (mode == ContactMode::open) continue;
            const ModalContact& c = structure_.contacts[k];
            const double T = mode == ContactMode::stick
                                 ? value_of(block_.friction_force(k), x)
                                 : c.ratio[index_of(way_of(mode))] * value_of(block_.normal_force(k), x);
            work_.drive_work += duration * T * c.drive_share * V;
            if (!is_slip(mode)) continue;
            double w = -c.drive_share * V;
            for (std::size_t j = 0; j < scratch_.size(); ++j)
                w += c.tangent[j] * v[j];
            work_.friction_loss -= duration * T * w;
        }
        if (!is_judged) continue;
        const Eigen::VectorXd speed =
            structure_.shapes * Eigen::Map<const Eigen::VectorXd>(v, static_cast<Eigen::Index>(scratch_.size()));
        add_vibration(speed, duration);
    }
}

// peaks are of whole bodies: their degrees of freedom stand one after the other
void TaylorRun::add_vibration(const Eigen::VectorXd& speed, double duration) {
    const auto body = [this](std::size_t dof) {
        return whole_.body.empty() ? static_cast<int>(dof) : whole_.body[dof];
    };
    for (std::size_t first = 0, end = 0; first < vibration_.size(); first = end) {
        double whole = 0.0;
        for (end = first; end < vibration_.size() && body(end) == body(first); ++end) {
            const double square = speed(static_cast<Eigen::Index>(end)) * speed(static_cast<Eigen::Index>(end));
            vibration_[end].square_time += duration * square;
            whole += square;
        }
        for (std::size_t dof = first; dof < end; ++dof)
            vibration_[dof].peak_square = std::max(vibration_[dof].peak_square, whole);
    }
}

void TaylorRun::pass_samples(double theta) {
    const double interval = recorder_.request().trace.interval;
    const auto n = static_cast<Eigen::Index>(structure_.modes());
    Eigen::VectorXd q(n), v(n), a(n);
    for (; sample_ <= last_sample_; ++sample_) {
        const double time = static_cast<double>(sample_) * interval;
        const double x = std::max(0.0, (time - time_) / step_);
        if (x > theta) return;
        block_.displacement_at(x, {q.data(), structure_.modes()});
        block_.velocity_at(x, {v.data(), structure_.modes()});
        block_.acceleration_at(x, {a.data(), structure_.modes()});
        std::vector<record::ContactSample> contacts(state_.set.size());
        for (std::size_t k = 0; k < state_.set.size(); ++k) {
            const ContactMode mode = state_.set[k];
            const ModalContact& c = structure_.contacts[k];
            record::ContactSample& sample = contacts[structure_.number[k]];
            sample.state = contact_of(mode);
            if (mode == ContactMode::open) {
                sample.gap = c.initial_gap;
                for (std::size_t j = 0; j < c.normal.size(); ++j)
                    sample.gap += c.normal[j] * q(static_cast<Eigen::Index>(j));
                sample.gap = std::max(0.0, sample.gap);
                continue;
            }
            sample.normal_force = std::max(0.0, value_of(block_.normal_force(k), x));
            sample.friction_force = mode == ContactMode::stick ? value_of(block_.friction_force(k), x)
                                                               : c.ratio[index_of(way_of(mode))] * sample.normal_force;
        }
        const Eigen::VectorXd u = structure_.shapes * q, speed = structure_.shapes * v,
                              acceleration = structure_.shapes * a;
        recorder_.sample({time, model::numbers(u), model::numbers(speed), model::numbers(acceleration),
                          value_of(std::span(surface_), x), contacts});
    }
}

void TaylorRun::move(double theta) {
    if (!(theta > 0.0)) return;
    block_.displacement_at(theta, scratch_);
    state_.q = scratch_;
    block_.velocity_at(theta, scratch_);
    state_.v = scratch_;
    for (std::size_t j = 0; j < scratch_.size(); ++j) {
        most_q_[j] = std::max(most_q_[j], std::abs(state_.q[j]));
        most_v_[j] = std::max(most_v_[j], std::abs(state_.v[j]));
    }
    is_fresh_ = false;
}

// tells the recorder what has changed
void TaylorRun::tell() {
    for (std::size_t k = 0; k < state_.set.size(); ++k) {
        if (contact_of(state_.set[k]) == contact_of(told_[k]) && time_ > 0.0) continue;
        const ModalContact& c = structure_.contacts[k];
        double w = -c.drive_share * surface_[0], rate = 0.0;
        for (std::size_t j = 0; j < c.tangent.size(); ++j) {
            w += c.tangent[j] * state_.v[j];
            rate += c.normal[j] * state_.v[j];
        }
        recorder_.enter(structure_.number[k], {contact_of(state_.set[k]), time_, 0.0, w, rate});
    }
    told_ = state_.set;
}

std::optional<Outcome> TaylorRun::fire(const Firing& firing) {
    surface_ = surface(time_);
    if (settling_.fire(state_, surface_, firing.contact, firing.function) != Settled::done)
        return Outcome{Reason::no_forces, time_};
    is_fresh_ = true;
    tell();
    if (time_ - window_begin_ > pile_up_window * step_) {
        window_begin_ = time_;
        window_events_ = 0;
    }
    if (++window_events_ > most_events_at_once) return Outcome{Reason::chattering, time_};
    return std::nullopt;
}

// returns whether the run goes on
bool TaylorRun::pass_boundary() {
    const double end = spans()[span_].to;
    if (time_ >= end) {
        recorder_.vibrate(span_, spans()[span_].to - vibrated_from_, vibration_);
        std::fill(vibration_.begin(), vibration_.end(), record::Vibration());
        vibrated_from_ = end;
        ++span_;
    }
    if (drive_.kind == parameters::DriveKind::sampled)
        while (knot_ < drive_.times.size() && drive_.times[knot_] <= time_)
            ++knot_;
    return span_ < spans().size();
}

bool TaylorRun::is_finite() const {
    double sum = 0.0;
    for (std::size_t j = 0; j < state_.q.size(); ++j)
        sum += state_.q[j] * 0.0 + state_.v[j] * 0.0;
    return sum == 0.0;
}

Outcome TaylorRun::run(const std::stop_token& stop) {
    surface_ = surface(0.0);
    initial_energy_ = stored();
    initial_q_ = state_.q;
    if (settling_.settle(state_, surface_) != Settled::done) return {Reason::no_forces, 0.0};
    tell();
    pass_boundary();
    for (long blocks = 1; span_ < spans().size(); ++blocks) {
        if (blocks % blocks_between_checks == 0 && stop.stop_requested()) return {Reason::cancelled, time_};
        if (!is_finite()) return {Reason::diverged, time_};
        if (!block_.choose(state_.set)) return {Reason::no_forces, time_};
        surface_ = surface(time_);
        block_.expand(state_.q, state_.v, surface_);
        const double boundary = next_boundary();
        const double reach = std::min({1.0, block_.reach(), std::max(0.0, (boundary - time_) / step_)});
        const Firing firing = first_firing(reach);
        if (firing.is_lost) return {Reason::diverged, time_};
        const bool fires = firing.theta <= reach;
        const double theta = fires ? firing.theta : reach;
        account(theta);
        pass_samples(theta);
        move(theta);
        time_ = fires || reach * step_ + time_ < boundary ? time_ + theta * step_ : boundary;
        if (fires) {
            if (const auto outcome = fire(firing)) return *outcome;
            continue;
        }
        if (time_ < boundary) {
            if (blocks % blocks_between_projections == 0) settling_.project(state_, surface(time_));
            continue;
        }
        const bool is_corner = drive_.kind == parameters::DriveKind::sampled;
        if (!pass_boundary()) break;
        if (!is_corner) continue;
        surface_ = surface(time_);
        if (settling_.settle(state_, surface_) != Settled::done) return {Reason::no_forces, time_};
        is_fresh_ = true;
        tell();
    }
    return {Reason::completed, time_};
}

double TaylorRun::stored() const {
    double energy = 0.0;
    for (std::size_t j = 0; j < state_.q.size(); ++j)
        energy += 0.5 * state_.v[j] * state_.v[j] + 0.5 * structure_.square_frequency[j] * state_.q[j] * state_.q[j];
    return energy;
}

EnergyBalance TaylorRun::energy() const {
    EnergyBalance balance = work_;
    const EnergyBalance& impacts = settling_.losses();
    balance.impact_loss += impacts.impact_loss;
    balance.friction_loss += impacts.friction_loss;
    balance.drive_work += impacts.drive_work;
    balance.stored = stored() - initial_energy_;
    for (std::size_t j = 0; j < state_.q.size(); ++j) {
        balance.preload_work += structure_.load[j] * (state_.q[j] - initial_q_[j]);
        balance.held += 0.5 * std::abs(structure_.square_frequency[j]) * most_q_[j] * most_q_[j] +
                        0.5 * most_v_[j] * most_v_[j] + std::abs(structure_.load[j]) * most_q_[j];
    }
    balance.residual = unexplained(balance);
    return balance;
}

}  // namespace

Motion integrate_taylor(const model::Structure& structure, const parameters::Drive& drive, const InitialState& start,
                        const Taylor&, record::Recorder recorder, std::stop_token stop) {
    for (const model::ContactPoint& contact : structure.contacts)
        if (!std::holds_alternative<model::Plastic>(contact.impact))
            throw Error(ErrorKind::input, {"the Taylor engine cannot solve this structure",
                                           "it knows plastic impacts only", "Use impact = \"plastic\"."});
    TaylorRun runner(structure, drive, start, recorder);
    const Outcome outcome = runner.run(stop);
    const EnergyBalance balance = runner.energy();
    return {weighed(outcome, balance, most_unexplained_share), balance, recorder.finish(outcome.time)};
}

}  // namespace stridor::integration
