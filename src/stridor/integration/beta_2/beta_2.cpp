// The beta_2 scheme (explicit Newmark, beta = 0, gamma = beta_2) with the damping solved, not lagged:
//
//     pₙ = vₙ₋₁ + h (1 - β) aₙ₋₁
//     (M + β h C) aₙ = f - K uₙ - C pₙ + n N + t T
//     vₙ = pₙ + β h aₙ
//     uₙ₊₁ = uₙ + h pₙ + (β + 1/2) h² aₙ
//
// Eliminating v gives pₙ₊₁ = pₙ + h aₙ: the state is (u, p). With A = M + β h C and s = (β + 1/2) h² the contact forces
// move the end of the step by s A⁻¹ (n N + t T). Free predictor u*: gap n.u* > 0 is separation. Else the stick trial:
// n.uₙ₊₁ = 0 and t.(uₙ₊₁ - uₙ) = x2ₙ₊₁ - x2ₙ; if the law of friction holds it sticks,
// else T is its share of N and N closes the gap. Where that share changes with the slip velocity wₙ = t.vₙ - Vₙ,
// it is the one that is of the wₙ it leaves: by Newton's method, and the fastest such slip where there may be several.
// What rest adds to the limit is that of the time for which it has stuck by tₙ.
//
// Energy: ½ p.M p + ½ uₙ.K (uₙ - h pₙ) changes over a step by exactly h vₙ.(f0 + n N + t T - C vₙ) when β = 1/2.

#include "stridor/integration/beta_2/beta_2.hpp"

#include "stridor/integration/proofs/sticking.hpp"
#include "stridor/integration/rules/expect_solvable.hpp"
#include "stridor/integration/rules/fastest_slip.hpp"
#include "stridor/integration/run/end_state.hpp"
#include "stridor/integration/run/energy_held.hpp"
#include "stridor/integration/run/step_loop.hpp"
#include "stridor/model/contact/contact_forces.hpp"
#include "stridor/model/linear/frequencies.hpp"
#include "stridor/model/sized_structure.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace stridor::integration {

namespace {

using model::ContactState;
using model::SizedStructure;

// so often a run looks for a stop request and for numbers that left double precision: a tenth of a millisecond
constexpr long steps_between_stops = 4096;
// [1] of the turnover: 5e-10 in thousands of steps; a rounding error of the energy held in each of 1e9 steps makes 1e-7
constexpr double most_rounding_share = 1e-6;
// a state that has lasted fewer steps holds the forces of its impact
constexpr long steps_of_impact = 8;
// above 1/2 beta_2 damps by intent, of first order in the step: its residual is a figure to read, not a check
constexpr double any_share = 1.0;

// [1] of the size of the velocities: a slip velocity that is found
constexpr double slip_rounding = 1e-15;
constexpr int most_slip_turns = 40;  // Newton's steps; two are usual, as a step changes a velocity by little

// the law of friction for a contact that slips, or would, one way; of the slip that begins
struct SlipLaw {
    double limit;      // [1] of the stick
    double ratio;      // [1] T/N
    double stiffness;  // [N/m] of the gap
};

// what a step needs and never changes
template <int dofs>
struct Coefficients {
    using Vector = typename SizedStructure<dofs>::Vector;
    using Matrix = typename SizedStructure<dofs>::Matrix;

    double h;              // [s]
    double end_of_step;    // [s^2] s
    double half_velocity;  // [s] beta h: v = p + beta h a
    Matrix from_u;         // -A⁻¹ K
    Matrix from_p;         // -A⁻¹ C
    Vector from_load;      // A⁻¹ f0
    Vector from_normal;    // A⁻¹ n
    Vector from_tangent;   // A⁻¹ t
    Vector normal;         // n
    Vector tangent;        // t
    // inverse of the 2 by 2 compliance s [n t]ᵀ A⁻¹ [n t]
    double stick_nn, stick_nt, stick_tt;  // [N/m]
    double nn, nt, tt;                    // [1/kg] [n t]ᵀ A⁻¹ [n t]
    std::array<SlipLaw, 2> slip;          // shape [slip]
    model::FrictionLaw friction;
    bool is_state_wise;        // `slip` is of any slip velocity
    model::RestGrowth rest;    // of the limit
    model::SlopeRange slopes;  // [s/m] of the friction
    Matrix damping;            // C
    Vector load;               // f0
};

template <int dofs>
Coefficients<dofs> prepare(const SizedStructure<dofs>& structure, const model::ContactPoint& contact,
                           const Beta2& settings) {
    const model::FrictionLaw& friction = contact.friction;
    Coefficients<dofs> c;
    const double h = settings.step;
    c.h = h;
    c.end_of_step = (settings.beta_2 + 0.5) * h * h;
    c.half_velocity = settings.beta_2 * h;
    const typename SizedStructure<dofs>::Matrix effective_mass =
        structure.mass + settings.beta_2 * h * structure.damping;
    const typename SizedStructure<dofs>::Matrix inverse = effective_mass.inverse();
    c.from_u = -(inverse * structure.stiffness);
    c.from_p = -(inverse * structure.damping);
    c.from_load = inverse * structure.load;
    c.from_normal = inverse * structure.normal;
    c.from_tangent = inverse * structure.tangent;
    c.normal = structure.normal;
    c.tangent = structure.tangent;
    c.damping = structure.damping;
    c.load = structure.load;

    const double nn = c.nn = structure.normal.dot(c.from_normal);
    const double nt = c.nt = structure.normal.dot(c.from_tangent);
    const double tt = c.tt = structure.tangent.dot(c.from_tangent);
    c.friction = friction;
    c.is_state_wise = is_state_wise(friction);
    c.rest = contact.rest;
    c.slopes = slope_range(friction);
    model::require_no_painleve(nn, nt, friction);
    const double determinant = c.end_of_step * (nn * tt - nt * nt);
    c.stick_nn = tt / determinant;
    c.stick_nt = -nt / determinant;
    c.stick_tt = nn / determinant;
    for (const model::Slip way : model::slips) {
        const double ratio = slip_ratio(friction, way);
        c.slip[index_of(way)] = {stick_limit(friction, way), ratio, 1.0 / (c.end_of_step * (nn + ratio * nt))};
    }
    return c;
}

// the moving part of a run
template <int dofs>
struct State {
    typename SizedStructure<dofs>::Vector u;  // [m]
    typename SizedStructure<dofs>::Vector p;  // [m/s]
    double last_increment = 0.0;              // [m] of the plate, the step before
    double normal_force = 0.0;                // [N] of the step before
    ContactState contact = ContactState::slip;
    bool has_contact = false;  // false until the first step
    long contact_since = 0;    // number of its first step
    double grown = 0.0;        // [1] what rest has added to its limit
};

// what one step computed at its beginning, time n h
template <int dofs>
struct Step {
    typename SizedStructure<dofs>::Vector velocity;      // [m/s] vₙ
    typename SizedStructure<dofs>::Vector acceleration;  // [m/s^2] aₙ
    double normal_force = 0.0;                           // [N]
    double friction_force = 0.0;                         // [N]
    ContactState contact = ContactState::separation;
};

// [m/s] by how much a slip velocity changes per T/N, at most; N (Wnn + ratio Wnt) is `push`
template <int dofs>
double slip_reach(const Coefficients<dofs>& c, model::Slip way, double push) {
    const double giving = std::min(c.nn, c.nn + c.slip[index_of(way)].ratio * c.nt);
    return c.half_velocity * push * (c.tt * c.nn - c.nt * c.nt) / (giving * giving);
}

// N and T of a slip whose friction changes with its velocity, which is `free` [m/s] without them
template <int dofs>
void press_by_velocity(const Coefficients<dofs>& c, model::Slip way, double gap, double free, Step<dofs>& now) {
    const double push = -gap / c.end_of_step;
    if (const double reach = slip_reach(c, way, push); !is_gentle(c.slopes, reach)) {
        const auto velocity_at = [&](double ratio) {
            now.normal_force = push / (c.nn + ratio * c.nt);
            now.friction_force = ratio * now.normal_force;
            return free + c.half_velocity * (c.tt * now.friction_force + c.nt * now.normal_force);
        };
        velocity_at(ratio_of_fastest_slip(c.friction, way, reach, velocity_at).value_or(c.slip[index_of(way)].ratio));
        return;
    }
    double w = free;
    for (int turn = 0; turn < most_slip_turns; ++turn) {
        const double ratio = slip_ratio(c.friction, way, w);
        const double giving = c.nn + ratio * c.nt;
        now.normal_force = -gap / (c.end_of_step * giving);
        now.friction_force = ratio * now.normal_force;
        const double off = w - free - c.half_velocity * (c.tt * now.friction_force + c.nt * now.normal_force);
        if (!(std::abs(off) > slip_rounding * std::max(std::abs(w), std::abs(free)))) return;
        // dN/d(ratio) = -N nt / giving
        const double per_ratio = now.normal_force * (c.tt - (c.tt * ratio + c.nt) * c.nt / giving);
        w -= off / (1.0 - c.half_velocity * slip_ratio_slope(c.friction, way, w) * per_ratio);
    }
}

template <int dofs>
inline Step<dofs> step(const Coefficients<dofs>& c, State<dofs>& state, double increment) {
    using Vector = typename SizedStructure<dofs>::Vector;
    Step<dofs> now;
    const Vector free_acceleration = c.from_load + c.from_u * state.u + c.from_p * state.p;
    const Vector moved = state.u + c.h * state.p;
    const Vector predicted = moved + c.end_of_step * free_acceleration;
    const double gap = c.normal.dot(predicted);
    now.acceleration = free_acceleration;
    if (gap <= 0.0) {
        const double sliding = increment - c.tangent.dot(predicted - state.u);
        const double stick_normal = c.stick_nt * sliding - c.stick_nn * gap;
        const double stick_friction = c.stick_tt * sliding - c.stick_nt * gap;
        const SlipLaw& law = c.slip[index_of(model::slip_against(stick_friction))];
        if (std::abs(stick_friction) <= (law.limit + state.grown) * stick_normal) {
            now.contact = ContactState::stick;
            now.normal_force = stick_normal;
            now.friction_force = stick_friction;
        } else {
            now.contact = ContactState::slip;
            now.normal_force = -gap * law.stiffness;
            now.friction_force = law.ratio * now.normal_force;
            if (!c.is_state_wise) {
                const double surface_velocity = 0.5 * (increment + state.last_increment) / c.h;
                const double along = c.tangent.dot(state.p + c.half_velocity * free_acceleration);
                press_by_velocity(c, model::slip_against(stick_friction), gap, along - surface_velocity, now);
            }
        }
        now.acceleration += c.from_normal * now.normal_force + c.from_tangent * now.friction_force;
    }
    now.velocity = state.p + c.half_velocity * now.acceleration;
    state.u = moved + c.end_of_step * now.acceleration;
    state.p += c.h * now.acceleration;
    return now;
}

// sums over steps, in the order of time
template <int dofs>
struct WorkRates {
    double preload = 0.0, drive = 0.0, dashpot = 0.0, friction = 0.0, impact = 0.0;  // [J/s], times h at the end
};

template <int dofs>
double half_step_energy(const SizedStructure<dofs>& structure, const State<dofs>& state, double h) {
    return 0.5 * state.p.dot(structure.mass * state.p) +
           0.5 * state.u.dot(structure.stiffness * (state.u - h * state.p));
}

// one run: the loop over blocks of steps between which something outside the motion happens
template <int dofs>
class Stepping {
    using Vector = typename SizedStructure<dofs>::Vector;

public:
    Stepping(const model::Structure& structure, const model::ContactPoint& contact, const parameters::Drive& drive,
             const Start& start, const Beta2& settings, record::Recorder& recorder)
        : whole_(structure),
          structure_(structure, contact),
          coefficients_(prepare(structure_, contact, settings)),
          drive_(drive, settings.step, record::end_of(recorder.schedule())),
          recorder_(recorder),
          vibration_(static_cast<std::size_t>(structure_.load.size())),
          far_(Vector::Zero(structure_.load.size())),
          fast_(far_) {
        const model::SurfaceMotion surface = drive_.at(0.0);
        const InitialState initial = initial_state(structure, start, surface.velocity);
        const model::Instant first = model::instant(structure, initial.displacement, initial.velocity, surface);
        state_.u = initial.displacement;
        // v₀ = p₀ + β h a₀ must be the given velocity
        state_.p = initial.velocity - coefficients_.half_velocity * first.acceleration;
        state_.last_increment = surface.velocity * settings.step;
        initial_energy_ = half_step_energy(structure_, state_, settings.step);
        restore(start.handover, [this](Memory& memory) { pass(memory); });
        if (start.handover != nullptr && start.handover->from != nullptr) recorder_.enter(0, told_);
    }

    Outcome run(const std::stop_token& stop);
    EnergyBalance energy() const;
    void pass(Memory& pass);
    void hand_over(Handover& handover);

    // for `run_spans`
    long steps() const { return n_; }
    void begin_span();
    std::optional<Outcome> go_to(long end_of_span, StepSamples& samples, const std::stop_token& stop);
    void end_span(std::size_t span, long steps, double length);
    record::Outlook outlook(const Outcome& outcome) const;

private:
    void advance(long end);
    void sample();
    double rested(ContactState contact) const;
    void let_rest();
    void note(const Step<dofs>& now, double increment);
    void add_velocity(const typename SizedStructure<dofs>::Vector& velocity);
    void look();
    void widen_reach();
    void press();
    double held() const;

    const model::Structure& whole_;
    SizedStructure<dofs> structure_;  // the same
    Coefficients<dofs> coefficients_;
    ImposedMotion drive_;
    record::Recorder& recorder_;
    State<dofs> state_;
    WorkRates<dofs> work_;
    std::vector<record::Vibration> vibration_;  // shape [dof]
    record::Load load_;                         // of this span
    double initial_energy_ = 0.0;               // [J]
    // largest that displacements and velocities have been at changes of state and ends of blocks
    Vector far_;                    // [m]
    Vector fast_;                   // [m/s]
    long n_ = 0;                    // number of the next step
    record::ContactInterval told_;  // the present state, as the recorder knows it
};

template <int dofs>
void Stepping<dofs>::pass(Memory& pass) {
    pass(state_.u), pass(state_.p), pass(state_.last_increment), pass(state_.normal_force);
    pass.below(state_.contact, model::contact_states);
    pass(state_.has_contact), pass(state_.contact_since);
    pass(work_.preload), pass(work_.drive), pass(work_.dashpot), pass(work_.friction), pass(work_.impact);
    pass(initial_energy_), pass(far_), pass(fast_), pass(n_), pass(told_);
}

// the state at the next step's begin, as a step from a copy sees it
template <int dofs>
void Stepping<dofs>::hand_over(Handover& handover) {
    let_rest();
    State<dofs> copy = state_;
    const Step<dofs> now = step(coefficients_, copy, drive_.increment(n_));
    handover.to.displacement = list_of(state_.u);
    handover.to.velocity = list_of(now.velocity);
    handover.to.contacts = {now.contact};
    if (grows(coefficients_.rest)) handover.to.rested = {rested(now.contact)};
    keep(&handover, [this](Memory& memory) { pass(memory); });
}

// [s] for which the contact has stuck by the next step, the time before the start included; 0 if it slips or is open
template <int dofs>
double Stepping<dofs>::rested(ContactState contact) const {
    if (contact != ContactState::stick || (state_.has_contact && state_.contact != contact)) return 0.0;
    const double before = state_.contact_since == 0 ? coefficients_.rest.before : 0.0;
    return before + static_cast<double>(n_ - state_.contact_since) * coefficients_.h;
}

template <int dofs>
inline void Stepping<dofs>::let_rest() {
    if (!grows(coefficients_.rest)) return;
    state_.grown = model::grown(coefficients_.rest, rested(state_.has_contact ? state_.contact : ContactState::stick));
}

template <int dofs>
void Stepping<dofs>::note(const Step<dofs>& now, double increment) {
    const double h = coefficients_.h;
    const double surface_velocity = 0.5 * (increment + state_.last_increment) / h;
    press();
    told_ = {now.contact, static_cast<double>(n_) * h, 0.0, coefficients_.tangent.dot(now.velocity) - surface_velocity,
             coefficients_.normal.dot(now.velocity)};
    recorder_.enter(0, told_);
    state_.contact = now.contact;
    state_.has_contact = true;
    state_.contact_since = n_;
    widen_reach();
}

// what the contact carries where its state, or a span, ends
template <int dofs>
void Stepping<dofs>::press() {
    if (n_ - state_.contact_since >= steps_of_impact)
        load_.largest_force = std::max(load_.largest_force, state_.normal_force);
}

template <int dofs>
void Stepping<dofs>::widen_reach() {
    far_ = far_.cwiseMax(state_.u.cwiseAbs());
    fast_ = fast_.cwiseMax(state_.p.cwiseAbs());
}

// [J] as that of the exact engine: what rounding works on
template <int dofs>
double Stepping<dofs>::held() const {
    return energy_held<dofs>(structure_, far_, fast_);
}

template <int dofs>
inline void Stepping<dofs>::add_velocity(const typename SizedStructure<dofs>::Vector& velocity) {
    for (Eigen::Index dof = 0; dof < velocity.size(); ++dof) {
        record::Vibration& sum = vibration_[static_cast<std::size_t>(dof)];
        const double square = velocity(dof) * velocity(dof);
        sum.square_time += square;
        if (dof > 1) sum.peak_square = std::max(sum.peak_square, square);
    }
    // the rubbing body moves in two directions
    const double rubbing = velocity.template head<2>().squaredNorm();
    vibration_[0].peak_square = vibration_[1].peak_square = std::max(vibration_[0].peak_square, rubbing);
}

// the velocities at this instant, the run itself not touched
template <int dofs>
void Stepping<dofs>::look() {
    let_rest();
    State<dofs> copy = state_;
    add_velocity(step(coefficients_, copy, drive_.increment(n_)).velocity);
}

template <int dofs>
void Stepping<dofs>::advance(long end) {
    const Coefficients<dofs>& c = coefficients_;
    const double per_step = 0.5 / c.h;
    for (; n_ < end; ++n_) {
        const double increment = drive_.increment(n_);
        let_rest();
        const Step<dofs> now = step(c, state_, increment);
        if (now.contact != state_.contact || !state_.has_contact) note(now, increment);
        const double surface_velocity = per_step * (increment + state_.last_increment);
        const double along = c.tangent.dot(now.velocity);
        work_.preload += c.load.dot(now.velocity);
        work_.drive += now.friction_force * surface_velocity;
        work_.friction += now.friction_force * (surface_velocity - along);
        work_.impact -= now.normal_force * c.normal.dot(now.velocity);
        work_.dashpot += now.velocity.dot(c.damping * now.velocity);
        add_velocity(now.velocity);
        state_.last_increment = increment;
        state_.normal_force = now.normal_force;
    }
}

// the state at this instant as a step from a copy sees it; the run itself is not touched
template <int dofs>
void Stepping<dofs>::sample() {
    let_rest();
    State<dofs> copy = state_;
    const double time = static_cast<double>(n_) * coefficients_.h;
    const Step<dofs> now = step(coefficients_, copy, drive_.increment(n_));
    const record::ContactSample contact{now.normal_force, now.friction_force, coefficients_.normal.dot(state_.u),
                                        now.contact};
    recorder_.sample({time,
                      model::numbers(state_.u),
                      model::numbers(now.velocity),
                      model::numbers(now.acceleration),
                      drive_.at(time).velocity,
                      {&contact, 1}});
}

template <int dofs>
void Stepping<dofs>::begin_span() {
    std::fill(vibration_.begin(), vibration_.end(), record::Vibration());
}

// in blocks, so that a step has nothing else to ask
template <int dofs>
std::optional<Outcome> Stepping<dofs>::go_to(long end_of_span, StepSamples& samples, const std::stop_token& stop) {
    while (n_ < end_of_span) {
        long end = std::min(end_of_span, n_ + steps_between_stops);
        const bool is_sampled = samples.is_within(n_);
        if (samples.take(n_)) sample();
        if (is_sampled) end = std::min(end, samples.next);
        advance(end);
        widen_reach();
        const double time = static_cast<double>(n_) * coefficients_.h;
        if (!state_.u.allFinite() || !state_.p.allFinite()) return Outcome{Reason::diverged, time};
        if (stop.stop_requested()) return Outcome{Reason::cancelled, time};
    }
    return std::nullopt;
}

template <int dofs>
void Stepping<dofs>::end_span(std::size_t span, long steps, double length) {
    if (steps == 0) look();  // a span between two steps has the velocities of the next one
    for (record::Vibration& sum : vibration_)
        sum.square_time *= steps > 0 ? coefficients_.h : length;
    recorder_.vibrate(span, length, vibration_);
    press();
    recorder_.load(span, {&load_, 1});
    load_ = {};
}

template <int dofs>
Outcome Stepping<dofs>::run(const std::stop_token& stop) {
    const auto go = [&](long end, record::Use, StepSamples& samples) { return go_to(end, samples, stop); };
    const std::optional<Outcome> ended = run_spans(*this, recorder_, coefficients_.h, go);
    return ended ? *ended : Outcome{Reason::completed, static_cast<double>(n_) * coefficients_.h};
}

template <int dofs>
EnergyBalance Stepping<dofs>::energy() const {
    const double h = coefficients_.h;
    EnergyBalance balance;
    balance.stored = half_step_energy(structure_, state_, h) - initial_energy_;
    balance.preload_work = h * work_.preload;
    balance.drive_work = h * work_.drive;
    balance.dashpot_loss = h * work_.dashpot;
    balance.friction_loss = h * work_.friction;
    balance.impact_loss = h * work_.impact;
    balance.residual = unexplained(balance);
    balance.held = held();
    return balance;
}

template <int dofs>
record::Outlook Stepping<dofs>::outlook(const Outcome& outcome) const {
    if (outcome.reason != Reason::completed || state_.contact != ContactState::stick) return {};
    const model::SurfaceMotion surface = drive_.at(outcome.time);
    // p is the velocity half a step ago: what it misses of the vibration is far below any margin that proves something
    return outlook_of_stick(
        whole_, drive_.profile(),
        {state_.u, state_.p, surface.velocity, surface.acceleration, outcome.time, recorder_.since(0)});
}

}  // namespace

double stable_step(double beta_2, double angular_frequency) {
    return std::sqrt(2.0 / beta_2) / angular_frequency;
}

Motion integrate_beta_2(const model::Structure& structure, const parameters::Drive& drive, const Start& start,
                        const Beta2& settings, record::Recorder recorder, const std::stop_token& stop) {
    expect_solvable(structure, parameters::Method::beta_2);
    const model::ContactPoint& contact = model::only_contact(structure, "the beta_2 engine");
    const double fastest = model::natural_frequencies(structure, ContactState::separation).back();
    if (settings.step > stable_step(settings.beta_2, fastest))
        return {{Reason::step_limit, 0.0}, {}, recorder.finish(0.0)};
    return model::with_size(model::dofs_of(structure), [&](auto size) -> Motion {
        Stepping<size()> runner(structure, contact, drive, start, settings, recorder);
        const Outcome outcome = runner.run(stop);
        if (start.handover != nullptr && has_result(outcome)) runner.hand_over(*start.handover);
        const EnergyBalance balance = runner.energy();
        const double most = settings.beta_2 > 0.5 ? any_share : most_rounding_share;
        return {weighed(outcome, balance, most), balance, recorder.finish(outcome.time, {runner.outlook(outcome)})};
    });
}

}  // namespace stridor::integration
