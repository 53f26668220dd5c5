// From event to event. In each contact state s(t) = exp(A t) s(0); the state ends where one of its event functions,
// linear functionals of s, stops being positive:
//
//     slip    N -> separation                 sigma w -> stick if |T| <= mu_s N there, else slip the other way
//     stick   mu_s N -+ T -> slip with sign(w) = -sign(T)
//     open    g -> impact, then the contact goes on closed, or opens again at once if N < 0
//
// Whole steps are taken as long as bounds of the event functions stay clear of zero; where they do not, the first root
// is isolated and polished, the state moved there, and `follow` says how the contact goes on. What lies inside a step
// (samples, ends of spans) is evaluated from the step's beginning and never changes the steps.

#include "stridor/integration/exact/exact.hpp"

#include "stridor/base/error.hpp"
#include "stridor/integration/exact/event_root.hpp"
#include "stridor/integration/exact/run.hpp"
#include "stridor/integration/proofs/sticking.hpp"
#include "stridor/integration/rules/expect_solvable.hpp"
#include "stridor/model/contact/contact_forces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace stridor::integration {

namespace {

// so many steps, or samples within a step, between two looks at the stop request: some milliseconds
constexpr long steps_between_checks = 65536;
constexpr long samples_between_checks = 4096;
// so many between two attempts to prove silence: a try costs as much as two steps
constexpr long steps_between_proofs = 16;

}  // namespace

template <int dofs>
ExactRun<dofs>::ExactRun(const model::Structure& structure, const model::ContactPoint& contact,
                         const parameters::Drive& drive, const Start& start, const Exact& settings,
                         SizedFlows<dofs>& shared, record::Recorder& recorder, std::stop_token stop)
    : whole_(structure),
      contact_(contact),
      structure_(structure, contact),
      coordinates_(contact_coordinates(structure_)),
      kernel_(kernel(settings.instruction_set, dofs)),
      drive_(drive, 1.0, record::end_of(recorder.schedule())),
      flows_(shared.of(coordinates_, contact.friction, drive_.profile().frequency, kernel_)),
      settings_(settings),
      recorder_(recorder),
      stop_(std::move(stop)),
      book_(recorder, flows_, drive_.profile().times),
      watch_(drive_.profile().velocity, 1.0 / flows_.flow[static_cast<int>(ContactMode::stick)].step, closed) {
    may_end_early_ = settings.early_ending == parameters::EarlyEnding::proven && !book_.has_samples() &&
                     parameters::is_steady(drive) && drive_.profile().velocity != 0.0;
    sliding_mode_ = drive_.profile().velocity > 0.0 ? ContactMode::slip_backward : ContactMode::slip_forward;
    begin(start);
    handover_ = start.handover;
    if (handover_ != nullptr) may_end_early_ = false;
    restore(handover_, [this](Memory& memory) { pass(memory); });
}

// the state at the beginning of a step: how far the run goes beyond is nothing that it depends on
template <int dofs>
void ExactRun<dofs>::pass(Memory& pass) {
    pass.below(mode_, contact_modes);
    pass(s_), pass(origin_), pass(count_);
    pass.below(multiplicity_, most_multiplicity + 1);
    pass(initial_energy_), pass(initial_displacement_), pass(closed_reach_), pass(open_reach_);
    pile_up_.pass(pass);
    book_.pass(pass);
}

template <int dofs>
void ExactRun<dofs>::hand_over() {
    if (handover_ == nullptr) return;
    const Position last = position(s_, mode_);
    handover_->to.displacement = list_of(last.displacement);
    handover_->to.velocity = list_of(last.velocity);
    handover_->to.contacts = {contact_of(mode_)};
    handover_->to.memory.push_back(std::move(last_step_));
}

template <int dofs>
void ExactRun<dofs>::begin(const Start& start) {
    const InitialState initial = initial_state(whole_, start, drive_.at(0.0).velocity);
    const auto inverse = coordinates_.basis.inverse().eval();
    const Vector z = inverse * initial.displacement;
    const Vector speed = inverse * initial.velocity;
    for (int i = 0; i < closed; ++i) {
        s_.at[i] = z(i);
        s_.at[velocity_lane(closed, i)] = speed(i);
    }
    s_.at[F] = coordinates_.load_scale;
    s_.at[V] = surface(0.0).velocity;
    s_.at[V + 1] = surface(0.0).partner;
    const bool is_said_to_stick =
        !initial.contacts.empty() && initial.contacts.front() == parameters::ContactStart::stick;
    if (start.kind == parameters::Initial::stuck || is_said_to_stick) s_.at[x_speed] = s_.at[V];
    if (begins_open(initial, 0)) {
        Transition apart{ContactMode::open, 0, s_};
        apart.slip_velocity = structure_.tangent.dot(Vector(initial.velocity)) - s_.at[V];
        apart.state.at[G] = std::max(0.0, z(closed));
        apart.state.at[G + 1] = speed(closed);
        if (!(z(closed) > 0.0)) apart.multiplicity = 1;  // the gap is zero, and opens
        enter(apart);
    } else {
        enter(close_contact(flows_, s_, s_.at[x_speed] - s_.at[V]));
    }
    const Position first = position(s_, mode_);
    initial_energy_ = stored(first);
    initial_displacement_ = first.displacement;
}

template <int dofs>
SurfaceNumbers ExactRun<dofs>::surface(double time) const {
    const model::SurfaceMotion motion = drive_.at(time);
    const double omega = flow().surface_rate;
    return {motion.velocity, omega > 0.0 ? -motion.acceleration / omega : motion.acceleration};
}

// --- the contact changes its state

template <int dofs>
void ExactRun<dofs>::enter(const Transition& next) {
    const double now = time();
    if (now > 0.0) press(0.0);
    book_.enter(next, now);
    origin_ = now;
    count_ = 0;
    mode_ = next.mode;
    multiplicity_ = next.multiplicity;
    s_ = next.state;
    widen_reach();
}

// --- time goes on

template <int dofs>
typename ExactRun<dofs>::Crossing ExactRun<dofs>::first_event() const {
    const Flow& f = flow();
    Lanes bernstein[most_tests];
    const unsigned near = kernel_.look(f, s_, multiplicity_, bernstein);
    Crossing first;
    for (int k = 0; k < f.test_count; ++k) {
        if ((near >> static_cast<unsigned>(k) & 1U) == 0) continue;
        Lanes series[term_blocks];
        kernel_.apply(f.test[k].series, term_blocks, s_, series);
        if (mode_ == ContactMode::stick) {
            const double rounding = force_rounding(f.test[k].row, s_);
            series[0].at[0] += rounding;
            for (double& coefficient : bernstein[k].at)
                coefficient += rounding;
        }
        const double tau = first_crossing(series, k == f.test_count - 1 ? multiplicity_ : 0, bernstein[k], kernel_);
        if (tau < first.tau) first = {tau, k};
    }
    return first;
}

// what lies between here and the end of the step: samples, ends of spans, knots of the drive, the end
template <int dofs>
typename ExactRun<dofs>::Boundary ExactRun<dofs>::pass_boundaries(double& from, double& reach, Crossing& crossing) {
    const double now = time();
    for (long passed = 1; !book_.is_full(); ++passed) {
        if (passed % samples_between_checks == 0 && stop_.stop_requested()) return Boundary::stop_request;
        const double stop = book_.next_stop_time();
        const double tau = std::max(0.0, (stop - now) / flow().step);
        if (tau > reach) return Boundary::none;
        const Logbook::Stop kind = book_.next_stop();
        if (kind == Logbook::Stop::sample) {
            sample(tau, stop);
            book_.pass_sample();
            continue;
        }
        if (kind == Logbook::Stop::end_of_span) {
            kernel_.add_part(flow(), s_, from, tau, book_.part(mode_));
            from = tau;
            press(tau);
            book_.end_span();
            widen_reach();  // a stuck joint is farthest where the drive turns back
            has_returned_ = false;
        }
        if (kind == Logbook::Stop::knot || book_.is_full()) {
            reach = tau;
            crossing = {};
            return kind == Logbook::Stop::knot ? Boundary::knot : Boundary::none;
        }
    }
    return Boundary::none;
}

// whole steps far from events
template <int dofs>
void ExactRun<dofs>::glide() {
    const bool proves = may_end_early_ && mode_ == sliding_mode_;
    const double whole = std::floor((book_.next_stop_time() - time()) / flow().step);
    const long most = proves ? steps_between_proofs : steps_between_checks;
    const long steps = static_cast<long>(std::min(whole, static_cast<double>(most)));
    if (steps <= 0) return step();
    const long taken = kernel_.glide(flow(), s_, steps, book_.full(mode_));
    count_ += taken;
    if (taken < steps) return step();
    if (proves) watch_for_silence();
}

// one step with whatever happens in it
template <int dofs>
void ExactRun<dofs>::step() {
    if (handover_ != nullptr && book_.end() <= time() + flow().step) {
        last_step_.clear();
        Memory memory(last_step_, Memory::Way::keep);
        pass(memory);
    }
    Crossing crossing = first_event();
    if (crossing.tau < 0.0) {
        lost_ = crossing.tau == no_number ? Reason::diverged : Reason::chattering;
        return;
    }
    double from = 0.0;
    double reach = std::min(crossing.tau, 1.0);
    const Boundary boundary = pass_boundaries(from, reach, crossing);
    if (boundary == Boundary::stop_request) return;
    Sums& part = book_.part(mode_);
    if (reach == 1.0 && crossing.test < 0) {
        Sums elsewhere{};  // a step that a span's end parts is counted in parts
        if (from > 0.0) kernel_.add_part(flow(), s_, from, reach, part);
        kernel_.leap(flow(), s_, from > 0.0 ? elsewhere : book_.full(mode_));
        ++count_;
        multiplicity_ = 0;
        return;
    }
    if (reach > from) kernel_.add_part(flow(), s_, from, reach, part);
    Lanes moved;
    kernel_.move(flow(), s_, reach, moved);
    origin_ = time() + reach * flow().step;
    count_ = 0;
    s_ = moved;
    if (reach > 0.0) multiplicity_ = 0;
    if (crossing.test >= 0) {
        const SurfaceNumbers drive = mode_ == ContactMode::open ? surface(origin_) : SurfaceNumbers{};
        enter(follow(flows_, contact_, mode_, crossing.test, s_, drive));
        if (may_end_early_) watch_for_cycle();
    } else if (boundary == Boundary::knot) {
        turn_knot(book_.next_stop_time());  // not the sum of steps, which may fall short of it by rounding
        book_.pass_knot();
    }
}

// the drive changes its slope, and the force of a stuck contact jumps
template <int dofs>
void ExactRun<dofs>::turn_knot(double time) {
    if (mode_ != ContactMode::open) {
        const double pace =
            std::abs(s_.at[x_speed]) + std::abs(s_.at[V]) + std::abs(s_.at[V + 1]) * flow().step;  // [m/s]
        const SurfaceNumbers drive = surface(time);
        s_.at[V] = drive.velocity;
        s_.at[V + 1] = drive.partner;
        // a slip whose plate comes to a stop just here ends, whatever rounding has left of its velocity
        if (mode_ == ContactMode::stick || std::abs(s_.at[x_speed] - drive.velocity) <= 0x1p-43 * pace) {
            s_.at[x_speed] = drive.velocity;
            enter(close_contact(flows_, s_, 0.0));
        }
    }
}

template <int dofs>
bool ExactRun<dofs>::is_finite() const {
    double sum = 0.0;
    for (const double number : s_.at)
        sum += number * 0.0;
    return sum == 0.0;
}

template <int dofs>
Outcome ExactRun<dofs>::advance() {
    while (!book_.is_full()) {
        if (!is_finite()) return {Reason::diverged, time()};
        if (stop_.stop_requested()) return {Reason::cancelled, time()};
        if (multiplicity_ == 0)
            glide();
        else
            step();
        if (lost_) return {*lost_, time()};
        if (silence_) return {Reason::settled, silence_->time};
        if (cycle_) return {stop_.stop_requested() ? Reason::cancelled : Reason::settled, cycle_->time};
        if (count_ == 0 && pile_up_.note(time(), flow().step)) return {Reason::chattering, time()};
    }
    book_.close(book_.end());
    return {Reason::completed, book_.end()};
}

template <int dofs>
Motion ExactRun<dofs>::run() {
    const Outcome outcome = advance();
    hand_over();
    const bool is_filled = outcome.reason == Reason::settled;
    const EnergyBalance balance = is_filled ? balance_ : energy();
    return {weighed(outcome, balance, most_unexplained), balance,
            recorder_.finish(is_filled ? book_.end() : outcome.time, {outlook(outcome)}), silence_, cycle_};
}

template <int dofs>
record::Outlook ExactRun<dofs>::outlook(const Outcome& outcome) const {
    if (silence_ || cycle_) return proven_outlook(silence_, cycle_);
    if (outcome.reason != Reason::completed || mode_ != ContactMode::stick) return {};
    const Position last = position(s_, mode_);
    const model::SurfaceMotion motion = drive_.at(outcome.time);
    return outlook_of_stick(
        whole_, drive_.profile(),
        {last.displacement, last.velocity, motion.velocity, motion.acceleration, outcome.time, recorder_.since(0)});
}

// --- early endings

template <int dofs>
void ExactRun<dofs>::watch_for_silence() {
    if (!sliding_) sliding_.emplace(flow(), coordinates_.load_scale, s_.at[V]);
    silence_ = sliding_->silence(s_, time());
    if (!silence_) return;
    balance_ = energy();
    book_.fill_with_silence(*sliding_, kernel_, s_, time());
}

template <int dofs>
void ExactRun<dofs>::watch_for_cycle() {
    const CycleWatch::Finding finding = watch_.note(time(), mode_, s_);
    if (finding == CycleWatch::Finding::nothing) return;
    if (finding == CycleWatch::Finding::first_return) {
        book_.bank();
        has_returned_ = true;
    } else if (has_returned_) {
        cycle_ = watch_.cycle();
        balance_ = energy();
        book_.fill_with_cycle(book_.since_banked(), watch_.period_begin(), time(), stop_);
    }
}

// --- what is kept

// tells the book what the contact carries so far into the step
template <int dofs>
void ExactRun<dofs>::press(double tau) {
    if (mode_ == ContactMode::open) return;
    Lanes s = s_;
    if (tau > 0.0) kernel_.move(flow(), s_, tau, s);
    book_.press(dot(flow().normal_force, s));
}

template <int dofs>
void ExactRun<dofs>::sample(double tau, double time) {
    Lanes s;
    kernel_.move(flow(), s_, tau, s);
    Lanes rate;
    kernel_.apply(&flow().power[1], 1, s, &rate);
    for (double& number : rate.at)
        number /= flow().step;
    const Position here = position(s, mode_);
    const Vector acceleration = position(rate, mode_).velocity;
    const bool is_open = mode_ == ContactMode::open;
    const double N = is_open ? 0.0 : std::max(0.0, dot(flow().normal_force, s));
    const double T =
        mode_ == ContactMode::stick ? dot(flow().friction_force, s) : flows_.slip_ratio[static_cast<int>(mode_)] * N;
    const record::ContactSample contact{N, T, is_open ? std::max(0.0, s.at[G]) : 0.0, contact_of(mode_)};
    recorder_.sample({time,
                      model::numbers(here.displacement),
                      model::numbers(here.velocity),
                      model::numbers(acceleration),
                      is_open ? drive_.at(time).velocity : s.at[V],
                      {&contact, 1}});
}

namespace {

template <int dofs>
void require_valid_contact(const model::SizedStructure<dofs>& structure, const model::FrictionLaw& friction) {
    const typename model::SizedStructure<dofs>::Vector pushed = structure.mass.inverse() * structure.normal;
    model::require_no_painleve(structure.normal.dot(pushed), structure.tangent.dot(pushed), friction);
}

}  // namespace

Motion integrate_exact(const model::Structure& structure, const parameters::Drive& drive, const Start& start,
                       const Exact& settings, record::Recorder recorder, std::stop_token stop, SharedFlows& shared) {
    expect_solvable(structure, parameters::Method::exact);
    const model::ContactPoint& contact = model::only_contact(structure, "the exact engine");
    const auto run = [&](auto size) {
        require_valid_contact<size()>({structure, contact}, contact.friction);
        ExactRun<size()> runner(structure, contact, drive, start, settings, shared.of_size<size()>(), recorder,
                                std::move(stop));
        return runner.run();
    };
    return model::dofs_of(structure) == 2 ? run(model::Size<2>()) : run(model::Size<3>());
}

Motion integrate_exact(const model::Structure& structure, const parameters::Drive& drive, const Start& start,
                       const Exact& settings, record::Recorder recorder, std::stop_token stop) {
    SharedFlows own;
    return integrate_exact(structure, drive, start, settings, std::move(recorder), std::move(stop), own);
}

}  // namespace stridor::integration
