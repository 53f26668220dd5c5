// From event to event. In each contact state s(t) = exp(A t) s(0); the state ends where one of its event functions, linear
// functionals of s, stops being positive:
//
//     slip    N -> separation                 sigma w -> stick if |T| <= mu_s N there, else slip the other way
//     stick   mu_s N -+ T -> slip with sign(w) = -sign(T)
//     open    g -> impact, then the contact goes on closed, or opens again at once if N < 0
//
// The function of the event that has just fired starts at a root of known order: w of a slip that begins 1 (2 where mu_s =
// mu_d), g after lift-off 3, after an impact with N < 0 2, after a rebound 1. It is divided out.
//
// Impact in contact coordinates: P_n = -m_g g' (1 + e), P_t within the friction cone; x' += P_t / m_x.

#include "stridor/integration/exact.hpp"

#include "stridor/integration/event_root.hpp"
#include "stridor/integration/exact_flow.hpp"
#include "stridor/integration/imposed_motion.hpp"
#include "stridor/model/contact_forces.hpp"
#include "stridor/model/energy.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

namespace stridor::integration {

namespace {

using model::ContactState;
using model::Structure;

constexpr double infinity = std::numeric_limits<double>::infinity();
// so many steps between two looks at the stop request: a millisecond
constexpr long steps_between_checks = 65536;
// so many events within this share of a step are a pile-up that double precision cannot resolve
constexpr int most_events = 1000;
constexpr double event_window = 1e-3;
// a rebound that flies for less than this ends in contact: the sum of all later flights is e/(1-e) of it
constexpr double shortest_flight = 1e-9;  // [s]

double dot(const Lanes& row, const Lanes& s) {
    double sum = 0.0;
    for (int i = 0; i < lanes; ++i)
        sum += row.at[i] * s.at[i];
    return sum;
}

// what rounding may make of a row of forces: a contact that rests at the limit of friction (mu_s = mu_d, and a plate that has
// come to a stop under a steady slip) must not leave it by rounding, nor come back by it. Usually 1e-13 of the forces.
double force_rounding(const Lanes& row, const Lanes& s) {
    double size = 0.0;
    for (int i = 0; i < lanes; ++i)
        size += std::abs(row.at[i] * s.at[i]);
    return 0x1p-43 * size;
}

ContactState contact_of(Mode mode) {
    return mode == Mode::open    ? ContactState::separation
           : mode == Mode::stick ? ContactState::stick
                                 : ContactState::slip;
}

// integral of a sum over nodes
double integral(const Lanes& full, const Lanes& weight, double step, const Lanes& part) {
    double sum = 0.0;
    for (int i = 0; i < lanes; ++i)
        sum += weight.at[i] * full.at[i];
    double rest = 0.0;
    for (const double p : part.at)
        rest += p;
    return sum * step + rest;
}

template <int dofs>
class Runner {
public:
    Runner(const Structure<dofs>& structure, const parameters::Drive& drive, const Start& start, const Exact& settings,
           record::Recorder& recorder);

    Outcome run(std::stop_token stop);
    EnergyBalance energy() const;

private:
    static constexpr int closed = dofs - 1;
    static constexpr int F = load_lane(closed);
    static constexpr int V = surface_lane(closed);
    static constexpr int G = gap_lane(closed);
    using Vector = typename Structure<dofs>::Vector;

    // what ended a step: an event function, or none
    struct Crossing {
        double tau = no_crossing;  // [1]
        int test = -1;
    };

    struct Position {
        Vector displacement;  // [m] u
        Vector velocity;      // [m/s] u'
    };

    const Flow& flow() const { return flows_.flow[static_cast<int>(mode_)]; }
    double time() const { return origin_ + static_cast<double>(count_) * flow().step; }
    Position position(const Lanes& s, Mode mode) const;

    void set_surface(Lanes& s, double time) const;
    void begin(double time);
    Crossing first_event() const;
    double next_stop() const;
    void step();
    void pass_boundaries(double& from, double& reach, Crossing& crossing);
    void sample(double tau, double time);
    void end_span();

    void cross(int test);
    void land();
    void strike(double impulse_ratio);
    void close_contact();
    void enter(Mode mode, int multiplicity, double closing_speed = 0.0);
    bool holds() const;
    void settle_closed(double w, double closing_speed);
    void report();
    bool is_finite() const;
    bool piles_up();

    const Structure<dofs>& structure_;
    ContactCoordinates<dofs> coordinates_;
    Flows flows_;
    const Kernel& kernel_;
    Exact settings_;
    parameters::DriveKind drive_kind_;
    double drive_rate_;  // [rad/s] of a sinusoidal drive
    ImposedMotion drive_;
    std::vector<double> knots_;  // [s] where a sampled drive changes its slope
    record::Recorder& recorder_;

    Mode mode_ = Mode::stick;  // a run begins closed
    Lanes s_{};
    double origin_ = 0.0;   // [s] when the steps were last counted from nought
    long count_ = 0;        // [1] steps since
    int multiplicity_ = 0;  // [1] of the root at which the last event function begins, 0 after the first step

    Sums full_[modes]{};  // whole steps, by mode
    Sums part_[modes]{};  // parts of steps
    EnergyBalance energy_;
    double initial_energy_ = 0.0;  // [J]
    Vector initial_displacement_;  // [m]

    std::size_t span_ = 0;
    double span_begin_ = 0.0;  // [s]
    std::size_t knot_ = 0;
    long sample_ = 0;  // number of the next sample
    long last_sample_ = -1;
    double end_ = 0.0;  // [s] of the run

    record::ContactInterval pending_;  // the state since the last event; told once time has gone on
    bool has_pending_ = false;
    bool has_told_ = false;
    ContactState told_ = ContactState::slip;
    double window_begin_ = 0.0;  // [s]
    int window_events_ = 0;
};

template <int dofs>
Runner<dofs>::Runner(const Structure<dofs>& structure, const parameters::Drive& drive, const Start& start,
                     const Exact& settings, record::Recorder& recorder)
    : structure_(structure),
      coordinates_(contact_coordinates(structure)),
      flows_(prepare_flows(coordinates_, structure.friction,
                           drive.kind == parameters::DriveKind::sinusoidal ? drive.frequency : 0.0)),
      kernel_(kernel(settings.instruction_set, dofs)),
      settings_(settings),
      drive_kind_(drive.kind),
      drive_rate_(drive.kind == parameters::DriveKind::sinusoidal ? 6.283185307179586476925 * drive.frequency : 0.0),
      drive_(drive, 1.0),
      recorder_(recorder) {
    if (drive.kind == parameters::DriveKind::sampled) knots_ = drive.times;
    const std::vector<record::Span>& spans = recorder_.schedule().spans;
    end_ = spans.empty() ? 0.0 : spans.back().to;
    const record::TraceRequest& trace = recorder_.request().trace;
    if (trace.interval > 0.0) {
        sample_ = static_cast<long>(std::ceil(trace.from / trace.interval - 1e-6));
        last_sample_ = static_cast<long>(std::floor(trace.to / trace.interval + 1e-6));
    }
    const InitialState<dofs> initial = initial_state(structure, start, drive_.at(0.0).velocity);
    const Vector z = coordinates_.basis.inverse() * initial.displacement;
    const Vector speed = coordinates_.basis.inverse() * initial.velocity;
    for (int i = 0; i < closed; ++i) {
        s_.at[i] = z(i);
        s_.at[velocity_lane(closed, i)] = speed(i);
    }
    s_.at[F] = coordinates_.load_scale;
    set_surface(s_, 0.0);
    if (start.kind == parameters::Initial::stuck) s_.at[velocity_lane(closed, 0)] = s_.at[V];
    settle_closed(s_.at[velocity_lane(closed, 0)] - s_.at[V], 0.0);
    const Position first = position(s_, mode_);
    initial_energy_ =
        model::kinetic_energy(structure_, first.velocity) + model::elastic_energy(structure_, first.displacement);
    initial_displacement_ = first.displacement;
}

template <int dofs>
typename Runner<dofs>::Position Runner<dofs>::position(const Lanes& s, Mode mode) const {
    Vector z = Vector::Zero(), speed = Vector::Zero();
    for (int i = 0; i < closed; ++i) {
        z(i) = s.at[i];
        speed(i) = s.at[velocity_lane(closed, i)];
    }
    if (mode == Mode::open) {
        z(closed) = s.at[G];
        speed(closed) = s.at[G + 1];
    }
    return {coordinates_.basis * z, coordinates_.basis * speed};
}

template <int dofs>
void Runner<dofs>::set_surface(Lanes& s, double time) const {
    const model::SurfaceMotion surface = drive_.at(time);
    s.at[V] = surface.velocity;
    s.at[V + 1] = drive_rate_ > 0.0 ? -surface.acceleration / drive_rate_ : surface.acceleration;
}

// --- the contact changes its state

template <int dofs>
void Runner<dofs>::enter(Mode mode, int multiplicity, double closing_speed) {
    const double now = time();
    const double w = (mode == Mode::open ? s_.at[velocity_lane(closed, 0)] - drive_.at(now).velocity
                                         : s_.at[velocity_lane(closed, 0)] - s_.at[V]);
    if (mode == Mode::open && mode_ != Mode::open) s_.at[G] = s_.at[G + 1] = 0.0;
    if (has_pending_ && now > pending_.from) report();
    pending_ = {contact_of(mode), now, 0.0, w, closing_speed};
    has_pending_ = true;
    origin_ = now;
    count_ = 0;
    mode_ = mode;
    multiplicity_ = multiplicity;
}

// states that lasted no time were never there
template <int dofs>
void Runner<dofs>::report() {
    if (!has_told_ || pending_.state != told_) recorder_.enter(pending_);
    has_told_ = true;
    told_ = pending_.state;
    has_pending_ = false;
}

// |T| <= mu_s N, half of what rounding may make of it allowed: the other half keeps the stick from ending at once
template <int dofs>
bool Runner<dofs>::holds() const {
    const Flow& stick = flows_.flow[static_cast<int>(Mode::stick)];
    return std::all_of(std::begin(stick.test), std::end(stick.test), [&](const EventFunction& test) {
        return dot(test.row, s_) >= -0.5 * force_rounding(test.row, s_);
    });
}

// a closed contact with slip velocity w finds its state; at w = 0 it sticks if it can
template <int dofs>
void Runner<dofs>::settle_closed(double w, double closing_speed) {
    if (w == 0.0) {
        const double N = dot(flows_.stick_normal, s_);
        if (N >= 0.0 && holds()) return enter(Mode::stick, 0, closing_speed);
        w = -dot(flows_.stick_force, s_);
        const Mode mode = w > 0.0 ? Mode::slip_forward : Mode::slip_backward;
        if (dot(flows_.flow[static_cast<int>(mode)].normal_force, s_) >= 0.0) return enter(mode, 1, closing_speed);
        return enter(Mode::open, 2);
    }
    const Mode mode = w > 0.0 ? Mode::slip_forward : Mode::slip_backward;
    if (dot(flows_.flow[static_cast<int>(mode)].normal_force, s_) >= 0.0) return enter(mode, 0, closing_speed);
    enter(Mode::open, 2);
}

template <int dofs>
void Runner<dofs>::land() {
    const double now = time();
    const double closing = s_.at[G + 1];  // [m/s] g' <= 0
    Lanes after = s_;
    set_surface(after, now);
    const double m_x = flows_.mass[0], m_g = flows_.mass[closed];
    const double surface = after.at[V];
    const double before = s_.at[velocity_lane(closed, 0)];
    const double w = before - surface;

    const double restitution = settings_.impact == parameters::ImpactLaw::restitution ? settings_.restitution : 0.0;
    double P_n = -m_g * closing * (1.0 + restitution);
    double P_t = 0.0;
    if (settings_.impact != parameters::ImpactLaw::normal_only) {
        const double coupling = flows_.tangent_on_gap;
        const double stopping = -m_x * w;  // the tangential impulse that ends the slip
        const double with_it = P_n - coupling * stopping;
        if (std::abs(stopping) <= flows_.static_friction * with_it) {
            P_t = stopping;
        } else {
            const double ratio = std::copysign(flows_.kinetic_friction, stopping);
            P_n /= 1.0 + ratio * coupling;
            P_t = ratio * P_n;
        }
    }
    const bool stops = P_t != 0.0 && P_t == -m_x * w;
    const double x_speed = stops ? surface : before + P_t / m_x;
    after.at[velocity_lane(closed, 0)] = x_speed;

    // kinetic energy goes into the normal impact, into friction, and over to the drive
    energy_.impact_loss += 0.5 * m_g * closing * closing * (1.0 - restitution * restitution);
    energy_.friction_loss -= 0.5 * P_t * (w + (x_speed - surface));
    energy_.drive_work += P_t * surface;

    const double rebound = -restitution * closing;
    if (rebound > 0.0) {
        const double N = dot(flows_.stick_normal, after);
        if (N <= 0.0 || 2.0 * rebound * m_g > shortest_flight * N) {
            s_.at[velocity_lane(closed, 0)] = x_speed;
            s_.at[G] = 0.0;
            s_.at[G + 1] = rebound;
            return enter(Mode::open, 1);
        }
        energy_.impact_loss += 0.5 * m_g * rebound * rebound;
    }
    s_ = after;
    mode_ = Mode::stick;  // closed, until the forces have been seen
    origin_ = now;
    count_ = 0;
    settle_closed(x_speed - surface, closing);
}

template <int dofs>
void Runner<dofs>::cross(int test) {
    double& x_speed = s_.at[velocity_lane(closed, 0)];
    switch (mode_) {
        case Mode::open:
            return land();
        case Mode::stick: {
            x_speed = s_.at[V];
            const int order = flows_.static_friction > flows_.kinetic_friction ? 1 : 2;
            return enter(test == 0 ? Mode::slip_backward : Mode::slip_forward, order);
        }
        case Mode::slip_forward:
        case Mode::slip_backward:
            if (test == 0) return enter(Mode::open, 3);
            x_speed = s_.at[V];
            return settle_closed(0.0, 0.0);
    }
}

// --- time goes on

template <int dofs>
typename Runner<dofs>::Crossing Runner<dofs>::first_event() const {
    const Flow& f = flow();
    Crossing first;
    for (int k = 0; k < f.test_count; ++k) {
        const bool begins_at_root = multiplicity_ > 0 && k == f.test_count - 1;
        const int order = begins_at_root ? multiplicity_ : 0;
        Lanes series[term_blocks];
        Lanes bernstein;
        kernel_.apply(begins_at_root ? &f.divided[order - 1] : &f.test[k].bernstein, 1, s_, &bernstein);
        kernel_.apply(f.test[k].series, term_blocks, s_, series);
        if (mode_ == Mode::stick) {
            const double rounding = force_rounding(f.test[k].row, s_);
            series[0].at[0] += rounding;
            for (double& coefficient : bernstein.at)
                coefficient += rounding;
        }
        const double tau = first_crossing(series, order, bernstein);
        if (tau < first.tau) first = {tau, k};
    }
    return first;
}

template <int dofs>
double Runner<dofs>::next_stop() const {
    double next = recorder_.schedule().spans[span_].to;
    if (sample_ <= last_sample_)
        next = std::min(next, static_cast<double>(sample_) * recorder_.request().trace.interval);
    if (knot_ < knots_.size()) next = std::min(next, knots_[knot_]);
    return next;
}

// what lies between here and the end of the step: samples, ends of spans, knots of the drive, the end
template <int dofs>
void Runner<dofs>::pass_boundaries(double& from, double& reach, Crossing& crossing) {
    const double now = time();
    const double h = flow().step;
    const std::vector<record::Span>& spans = recorder_.schedule().spans;
    while (span_ < spans.size()) {
        const double stop = next_stop();
        const double tau = std::max(0.0, (stop - now) / h);
        if (tau > reach) return;
        if (sample_ <= last_sample_ && static_cast<double>(sample_) * recorder_.request().trace.interval <= stop) {
            sample(tau, stop);
            ++sample_;
        } else if (knot_ < knots_.size() && knots_[knot_] <= stop) {
            reach = tau;
            crossing = {};
            return;
        } else {
            kernel_.add_part(flow(), s_, from, tau, part_[static_cast<int>(mode_)]);
            from = tau;
            end_span();
            if (span_ == spans.size()) {
                reach = tau;
                crossing = {};
            }
        }
    }
}

template <int dofs>
void Runner<dofs>::step() {
    Crossing crossing = first_event();
    double from = 0.0;
    double reach = std::min(crossing.tau, 1.0);
    pass_boundaries(from, reach, crossing);
    if (reach == 1.0 && crossing.test < 0) {
        Sums& whole = full_[static_cast<int>(mode_)];
        Sums elsewhere{};  // a step that a span's end parts is counted in parts
        if (from > 0.0) kernel_.add_part(flow(), s_, from, reach, part_[static_cast<int>(mode_)]);
        kernel_.leap(flow(), s_, from > 0.0 ? elsewhere : whole);
        ++count_;
        multiplicity_ = 0;
        return;
    }
    if (reach > from) kernel_.add_part(flow(), s_, from, reach, part_[static_cast<int>(mode_)]);
    Lanes moved;
    kernel_.move(flow(), s_, reach, moved);
    origin_ = time() + reach * flow().step;
    count_ = 0;
    s_ = moved;
    if (reach > 0.0) multiplicity_ = 0;
    if (crossing.test >= 0) return cross(crossing.test);
    if (knot_ >= knots_.size() || span_ == recorder_.schedule().spans.size()) return;
    // the drive changes its slope: the forces of a stuck contact jump
    if (mode_ != Mode::open) {
        double& x_speed = s_.at[velocity_lane(closed, 0)];
        const double pace = std::abs(x_speed) + std::abs(s_.at[V]) + std::abs(s_.at[V + 1]) * flow().step;  // [m/s]
        set_surface(s_, knots_[knot_]);
        // a slip whose plate comes to a stop just here ends, whatever rounding has left of its velocity
        if (mode_ == Mode::stick || std::abs(x_speed - s_.at[V]) <= 0x1p-43 * pace) {
            x_speed = s_.at[V];
            settle_closed(0.0, 0.0);
        }
    }
    ++knot_;
}

template <int dofs>
bool Runner<dofs>::is_finite() const {
    double sum = 0.0;
    for (const double number : s_.at)
        sum += number * 0.0;
    return sum == 0.0;
}

template <int dofs>
bool Runner<dofs>::piles_up() {
    const double now = time();
    const double window = event_window * flow().step;
    if (now - window_begin_ > window) {
        window_begin_ = now;
        window_events_ = 0;
    }
    return ++window_events_ > most_events;
}

template <int dofs>
Outcome Runner<dofs>::run(std::stop_token stop) {
    const std::vector<record::Span>& spans = recorder_.schedule().spans;
    while (knot_ < knots_.size() && knots_[knot_] <= 0.0)
        ++knot_;
    while (span_ < spans.size()) {
        if (!is_finite()) return {Reason::diverged, time()};
        if (stop.stop_requested()) return {Reason::cancelled, time()};
        if (multiplicity_ == 0) {
            const double whole = std::floor((next_stop() - time()) / flow().step);
            const long steps = static_cast<long>(std::min(whole, static_cast<double>(steps_between_checks)));
            if (steps > 0) {
                const long taken = kernel_.glide(flow(), s_, steps, full_[static_cast<int>(mode_)]);
                count_ += taken;
                if (taken == steps) continue;
                if (!is_finite()) return {Reason::diverged, time()};
            }
        }
        step();
        if (count_ == 0 && piles_up()) return {Reason::chattering, time()};
    }
    if (has_pending_ && end_ > pending_.from) report();
    // velocities may still be numbers where their squares no longer are
    return {std::isfinite(energy().residual) ? Reason::completed : Reason::diverged, end_};
}

// --- what is kept

template <int dofs>
void Runner<dofs>::sample(double tau, double time) {
    Lanes s;
    kernel_.move(flow(), s_, tau, s);
    Lanes rate;
    kernel_.apply(&flow().power[1], 1, s, &rate);
    for (double& number : rate.at)
        number /= flow().step;
    const Position here = position(s, mode_);
    const Vector acceleration = position(rate, mode_).velocity;
    record::Trace& trace = recorder_.trace();
    trace.time.push_back(time);
    for (int dof = 0; dof < dofs; ++dof) {
        const auto place = static_cast<std::size_t>(dof);
        trace.displacement[place].push_back(here.displacement(dof));
        trace.velocity[place].push_back(here.velocity(dof));
        trace.acceleration[place].push_back(acceleration(dof));
    }
    const bool is_open = mode_ == Mode::open;
    trace.surface_velocity.push_back(is_open ? drive_.at(time).velocity : s.at[V]);
    const double N = is_open ? 0.0 : std::max(0.0, dot(flow().normal_force, s));
    const double slip_friction = mode_ == Mode::slip_forward ? -flows_.kinetic_friction : flows_.kinetic_friction;
    trace.normal_force.push_back(N);
    trace.friction_force.push_back(mode_ == Mode::stick ? dot(flow().friction_force, s) : slip_friction * N);
    trace.gap.push_back(is_open ? std::max(0.0, s.at[G]) : 0.0);
    trace.state.push_back(contact_of(mode_));
}

// integrals over the span that ends here, to the record and to the balance
template <int dofs>
void Runner<dofs>::end_span() {
    std::array<record::Vibration, static_cast<std::size_t>(dofs)> vibration{};
    for (int m = 0; m < modes; ++m) {
        const Flow& f = flows_.flow[m];
        const auto total = [&](Lanes Sums::*member) {
            return integral(full_[m].*member, f.quadrature.weight, f.step, part_[m].*member);
        };
        int k = 0;
        for (int j = 0; j < f.velocity_count; ++j)
            for (int i = 0; i <= j; ++i, ++k) {
                const double both = (i == j ? 1.0 : 2.0) *
                                    integral(full_[m].product[k], f.quadrature.weight, f.step, part_[m].product[k]);
                energy_.dashpot_loss += flows_.damping[i][j] * both;
                for (int dof = 0; dof < dofs; ++dof)
                    vibration[static_cast<std::size_t>(dof)].square_time +=
                        flows_.basis[dof][i] * flows_.basis[dof][j] * both;
            }
        for (int dof = 0; dof < dofs; ++dof)
            for (int i = 0; i < lanes; ++i) {
                double& peak = vibration[static_cast<std::size_t>(dof)].peak_square;
                peak = std::max({peak, full_[m].peak[dof].at[i], part_[m].peak[dof].at[i]});
            }
        if (f.mode == Mode::stick) energy_.drive_work += total(&Sums::on_surface);
        if (is_slip(f.mode)) {
            const double friction = f.mode == Mode::slip_forward ? -flows_.kinetic_friction : flows_.kinetic_friction;
            energy_.drive_work += friction * total(&Sums::on_surface);
            energy_.friction_loss -= friction * total(&Sums::on_slip);
        }
        full_[m] = {};
        part_[m] = {};
    }
    for (record::Vibration& sum : vibration)
        sum.square_time = std::max(sum.square_time, 0.0);
    const record::Span& span = recorder_.schedule().spans[span_];
    recorder_.vibrate(span_, span.to - span.from, vibration);
    ++span_;
}

template <int dofs>
EnergyBalance Runner<dofs>::energy() const {
    const Position last = position(s_, mode_);
    EnergyBalance balance = energy_;
    balance.stored = model::kinetic_energy(structure_, last.velocity) +
                     model::elastic_energy(structure_, last.displacement) - initial_energy_;
    balance.preload_work = structure_.load.dot(last.displacement - initial_displacement_);
    balance.residual = balance.stored - balance.preload_work - balance.drive_work + balance.dashpot_loss +
                       balance.friction_loss + balance.impact_loss;
    return balance;
}

template <int dofs>
void require_valid_contact(const Structure<dofs>& structure) {
    const Eigen::Matrix<double, dofs, dofs> inverse_mass = structure.mass.inverse();
    const typename Structure<dofs>::Vector pushed = inverse_mass * structure.normal;
    model::require_no_painleve(structure.normal.dot(pushed), structure.tangent.dot(pushed),
                               structure.friction.kinetic_coefficient);
}

}  // namespace

template <int dofs>
Motion integrate_exact(const Structure<dofs>& structure, const parameters::Drive& drive, const Start& start,
                       const Exact& settings, record::Recorder recorder, std::stop_token stop) {
    require_valid_contact(structure);
    Runner<dofs> runner(structure, drive, start, settings, recorder);
    const Outcome outcome = runner.run(std::move(stop));
    return {outcome, runner.energy(), recorder.finish(outcome.time)};
}

template Motion integrate_exact<2>(const Structure<2>&, const parameters::Drive&, const Start&, const Exact&,
                                   record::Recorder, std::stop_token);
template Motion integrate_exact<3>(const Structure<3>&, const parameters::Drive&, const Start&, const Exact&,
                                   record::Recorder, std::stop_token);

}  // namespace stridor::integration
