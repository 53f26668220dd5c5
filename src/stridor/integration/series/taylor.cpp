// From event to event with several contacts. A block of h = 2/Omega is a power series of the motion and of every event
// function:
//
//     open    g -> impact with all that touches
//     slip    N -> separation                 sigma w -> stick if |T| <= mu_s N there, else slip the other way
//     stick   N -> separation                 mu_s N -+ T -> slip with sign(w) = -sign(T)
//
// with what rest has added to mu_s. A contact whose friction has a state does not stick: where sigma w is zero it slips
// the other way.
//
// The first zero of all functions ends the block; `Settling` says how the contacts go on. What lies within a block
// (samples) is evaluated from its beginning and never changes it; ends of spans and corners of the drive end it.

#include "stridor/integration/series/taylor.hpp"

#include "stridor/base/elementary.hpp"
#include "stridor/integration/rules/contact_mode_of.hpp"
#include "stridor/integration/rules/expect_solvable.hpp"
#include "stridor/integration/run/imposed_motion.hpp"
#include "stridor/integration/series/event_polynomial.hpp"
#include "stridor/integration/series/taylor_run.hpp"
#include "stridor/model/sized_structure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace stridor::integration {

namespace {

constexpr long blocks_between_checks = 256;
constexpr long blocks_between_projections = 8;
// flights and slips that would end within this share of a block have ended; a longer one each time that a crowd of
// events came within one block, so that contacts which throw each other off come to an end
constexpr std::array ended_share{1e-6, 1e-5, 1e-4, 1e-3};
constexpr std::size_t crowd = 200;   // events
constexpr int longest_period = 512;  // events
// a friction state makes the motion stiff where its contact creeps: so many blocks that together are shorter than a few
// usual ones come to no end; a million takes seconds
constexpr long blocks_of_creep = 1L << 20;
constexpr double least_creep = 16.0;        // blocks
constexpr double least_creep_share = 1e-6;  // of a block, between two changes of what is told of a contact that creeps

}  // namespace

TaylorRun::TaylorRun(const model::Structure& structure, const parameters::Drive& drive, const InitialState& start,
                     const Taylor& settings, record::Recorder& recorder)
    : whole_(structure),
      drive_(drive, 1.0, record::end_of(recorder.schedule())),
      recorder_(recorder),
      structure_(modal_structure(structure)),
      // a structure without springs and dashpots has no rate of its own: the run is its block
      step_(std::min(2.0 / std::max(structure_.fastest, base::two_pi * drive_.profile().frequency),
                     record::end_of(recorder.schedule()))),
      block_(structure_, step_, settings.order),
      settling_(structure_, step_),
      sums_{std::vector<record::Vibration>(static_cast<std::size_t>(model::channels_of(structure))),
            std::vector<record::Load>(structure.contacts.size())},
      watch_(longest_period),
      scratch_(structure_.modes()),
      tangential_(structure_.contacts.size()) {
    const Eigen::VectorXd q = modal(structure_, structure, start.displacement);
    const Eigen::VectorXd v = modal(structure_, structure, start.velocity);
    state_.q.assign(q.data(), q.data() + q.size());
    state_.v.assign(v.data(), v.data() + v.size());
    state_.set.assign(structure_.contacts.size(), ContactMode::stick);
    for (std::size_t k = 0; k < structure_.contacts.size(); ++k)
        if (start.contacts.empty() ? whole_.contacts[structure_.number[k]].initial_gap > 0.0
                                   : begins_open(start, structure_.number[k]))
            state_.set[k] = ContactMode::open;
    state_.dropped.resize(structure_.contacts.size());
    const auto does_grow = [](const ModalContact& contact) { return grows(contact.rest); };
    if (std::any_of(structure_.contacts.begin(), structure_.contacts.end(), does_grow)) {
        for (const ModalContact& contact : structure_.contacts)
            stuck_since_.push_back(-contact.rest.before);
        let_rest();
    }
    state_.friction_states.resize(structure_.contacts.size());
    for (std::size_t k = 0; k < start.friction_states.size(); ++k)
        state_.friction_states[k] = start.friction_states[structure_.number[k]];
    told_ = state_.set;
    intervals_.resize(structure_.contacts.size());
    handover_ = start.handover;
    travel_ = {state_.q, std::vector<double>(structure_.modes(), 0.0), std::vector<double>(structure_.modes(), 0.0)};
    is_steady_ = parameters::is_steady(drive);
    // nothing is proven of friction states
    may_end_early_ = handover_ == nullptr && !has_friction_states() &&
                     settings.early_ending == parameters::EarlyEnding::proven &&
                     !(recorder_.request().trace.interval > 0.0) && is_steady_ && drive_.profile().velocity != 0.0;
    samples_ = sample_times(recorder_.request().trace);
}

bool TaylorRun::has_friction_states() const {
    return std::any_of(structure_.contacts.begin(), structure_.contacts.end(),
                       [](const ModalContact& contact) { return has_friction_state(contact.friction); });
}

bool TaylorRun::counts_creep() const {
    return std::any_of(structure_.contacts.begin(), structure_.contacts.end(),
                       [](const ModalContact& contact) { return contact.creep_speed > 0.0; });
}

SurfaceSeries TaylorRun::surface(double time) const {
    const model::SurfaceMotion now = drive_.at(time);
    SurfaceSeries series{};
    series[0] = now.velocity;
    series[1] = now.acceleration * step_;
    const double omega = base::two_pi * drive_.profile().frequency;
    if (!(omega > 0.0)) return series;
    // V(t + x) = V cos(omega x) + V'/omega sin(omega x)
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
    const std::vector<double>& corners = drive_.profile().times;
    if (corner_ < corners.size()) end = std::min(end, corners[corner_]);
    return end;
}

// how long each contact has stuck by now
void TaylorRun::let_rest() {
    state_.rested.resize(stuck_since_.size());
    for (std::size_t k = 0; k < stuck_since_.size(); ++k)
        state_.rested[k] = state_.set[k] == ContactMode::stick ? time_ - stuck_since_[k] : 0.0;
}

// The first zero of (mu_s + g) N -+ T, whose g grows with rest: none lies before that of a chord of g. The chord from
// there on lies nearer, and so on; the last billionth of the block is bracketed and halved.
double TaylorRun::growing_limit(std::size_t contact, std::size_t function, int dropped, double reach) const {
    constexpr double near = 1e-9;    // [1]
    constexpr int most_chords = 64;  // each leaves a small share of the distance, unless the limit grows as T does
    const ModalContact& law = structure_.contacts[contact];
    const BlockSeries& N = block_.normal_force(contact);
    const BlockSeries at_once = event_series(structure_, block_, contact, ContactMode::stick, function);
    const auto value = [&](double theta) {
        const double rested = state_.rested[contact] + theta * block_.length();
        return value_of(at_once, theta) + model::grown(law.rest, rested) * value_of(N, theta);
    };
    double from = 0.0;
    for (int chord = 0; chord < most_chords && reach - from > near; ++chord) {
        BlockSeries c = at_once;
        add_growth(law, block_, N, state_.rested[contact], {from, reach}, c);
        const double zero = first_zero(c, dropped, reach);
        if (zero == no_zero || zero == no_polynomial) return zero;
        const bool is_near = zero - from <= near;
        from = std::max(from, zero);
        if (is_near) break;
    }
    double to = from, width = near;
    for (; value(to) > 0.0 || (dropped > 0 && to == 0.0); width *= 2.0) {
        if (to >= reach) return no_zero;
        from = to;
        to = std::min(reach, to + width);
    }
    while (to - from > std::max(1e-17, 0x1p-52 * to)) {
        const double middle = 0.5 * (from + to);
        (value(middle) > 0.0 ? from : to) = middle;
    }
    return to;
}

TaylorRun::Firing TaylorRun::first_firing(double reach) {
    Firing first;
    for (std::size_t k = 0; k < state_.set.size(); ++k) {
        const ContactMode mode = state_.set[k];
        const bool grows = mode == ContactMode::stick && !state_.rested.empty();
        for (std::size_t f = 0; f < event_functions(mode); ++f) {
            BlockSeries c = event_series(structure_, block_, k, mode, f);
            const int dropped = is_fresh_ ? state_.dropped[k][f] : 0;
            const double within = std::min(reach, first.theta);
            double theta = no_zero;
            if (grows && f > 0 && dropped <= most_dropped) {
                theta = growing_limit(k, f, dropped, within);
            } else if (dropped > most_dropped) {
                if (grows && f > 0)
                    add_growth(structure_.contacts[k], block_, block_.normal_force(k), state_.rested[k], {}, c);
                theta = late_zero(c, settling_.zero_of(block_, state_, k, f, c).later, within);
            } else {
                theta = first_zero(c, dropped, within);
            }
            if (theta == no_polynomial) return {0.0, k, f, true};
            if (theta < first.theta) first = {theta, k, f, false};
        }
        if (const double theta = creep_ends(k, std::min(reach, first.theta)); theta < first.theta)
            first = {theta, k, creep_function, false};
    }
    return first;
}

// a contact that slips slowly is told as one that sticks
bool TaylorRun::is_creeping(std::size_t contact) const {
    return is_slip(state_.set[contact]) && told_[contact] == ContactMode::stick;
}

// where its speed passes that of creep, either way; nothing changes there but what is told
double TaylorRun::creep_ends(std::size_t contact, double reach) const {
    const double speed = structure_.contacts[contact].creep_speed;
    if (!(speed > 0.0) || !is_slip(state_.set[contact])) return no_zero;
    const double way = is_creeping(contact) ? -1.0 : 1.0;
    BlockSeries c = block_.slip_velocity(contact);
    for (double& each : c)
        each *= way * sign_of(state_.set[contact]);
    c[0] -= way * speed;
    const double zero = first_zero(c, crossed_ == contact ? 1 : 0, reach);
    // a speed that only touches it turns round at once: time must go on
    return crossed_ == contact && zero == 0.0 ? std::min(reach, least_creep_share) : zero;
}

void TaylorRun::move(double theta) {
    if (!(theta > 0.0)) return;
    block_.state_at(theta, state_.q, state_.v);
    block_.move_friction_states(theta, state_.friction_states);
    widen(travel_, state_.q, state_.v);
    is_fresh_ = false;
    crossed_ = no_contact;
}

// what is told of a contact; that of the one whose speed has passed that of creep is turned
ContactMode TaylorRun::shown_mode(std::size_t contact) const {
    const ContactMode mode = state_.set[contact];
    const ModalContact& c = structure_.contacts[contact];
    if (!(c.creep_speed > 0.0) || !is_slip(mode)) return mode;
    const bool creeps =
        contact == crossed_ ? !is_creeping(contact) : std::abs(slip_velocity(c, state_.v, surface_[0])) < c.creep_speed;
    return creeps ? ContactMode::stick : mode;
}

// tells the recorder what has changed
void TaylorRun::tell() {
    for (std::size_t k = 0; k < state_.set.size(); ++k) {
        const ContactMode former = std::exchange(told_[k], shown_mode(k));
        if (contact_of(told_[k]) == contact_of(former) && time_ > 0.0) continue;
        if (!stuck_since_.empty() && time_ > 0.0) stuck_since_[k] = time_;
        const ModalContact& c = structure_.contacts[k];
        double w = -c.drive_share * surface_[0], rate = 0.0;
        for (std::size_t j = 0; j < c.tangent.size(); ++j) {
            w += c.tangent[j] * state_.v[j];
            rate += c.normal[j] * state_.v[j];
        }
        const record::ContactInterval interval{contact_of(told_[k]), time_, 0.0, w, rate};
        recorder_.enter(structure_.number[k], interval);
        intervals_[k] = interval;
        if (is_measuring_) period_changes_.push_back({structure_.number[k], interval});
    }
    let_rest();
}

Outcome TaylorRun::without_forces(Settled how) const {
    return {how == Settled::pressed ? Reason::painleve : Reason::no_forces, time_};
}

std::optional<Outcome> TaylorRun::fire(const Firing& firing) {
    if (time_ - crowd_begin_ > step_) {
        crowd_begin_ = time_;
        crowd_events_ = 0;
    }
    settling_.end_within(ended_share[std::min(crowd_events_++ / crowd, ended_share.size() - 1)]);
    surface_ = surface(time_);
    const Settled settled = settling_.fire(state_, surface_, firing.contact, firing.function);
    add_impacts();
    if (settled != Settled::done) return without_forces(settled);
    is_fresh_ = true;
    blocks_since_event_ = 0;
    tell();
    if (pile_up_.note(time_, step_)) return Outcome{Reason::chattering, time_};
    return std::nullopt;
}

void TaylorRun::end_span() {
    recorder_.vibrate(span_, spans()[span_].to - sums_from_, sums_.vibration);
    recorder_.load(span_, sums_.load);
    std::fill(sums_.vibration.begin(), sums_.vibration.end(), record::Vibration());
    std::fill(sums_.load.begin(), sums_.load.end(), record::Load());
    sums_from_ = spans()[span_].to;
    ++span_;
}

// returns whether the run goes on
bool TaylorRun::pass_boundary() {
    if (time_ >= spans()[span_].to) end_span();
    const std::vector<double>& corners = drive_.profile().times;
    while (corner_ < corners.size() && corners[corner_] <= time_)
        ++corner_;
    return span_ < spans().size();
}

// the state at the beginning of a block
void TaylorRun::pass(Memory& pass) {
    pass(state_.q), pass(state_.v), pass(state_.set);
    if (has_friction_states()) pass(state_.friction_states);
    for (auto& functions : state_.dropped)
        for (int& dropped : functions)
            pass.below(dropped, block_order + 1);
    pass(is_fresh_), pass(time_), pass(sums_from_);
    pass.below(span_, spans().size());
    pass.below(corner_, drive_.profile().times.size() + 1);
    pass(told_), pass(intervals_), pass(blocks_), pass(blocks_since_event_), pass(work_), pass(initial_energy_);
    pass(travel_.initial_q), pass(travel_.most_q), pass(travel_.most_v), pass(stuck_since_), pass(state_.rested);
    pile_up_.pass(pass);
    pass(crowd_begin_), pass(crowd_events_);
    if (counts_creep()) pass(crossed_);
    settling_.pass(pass);
}

void TaylorRun::hand_over() {
    const auto modes = static_cast<Eigen::Index>(structure_.modes());
    EndState& to = handover_->to;
    const Eigen::VectorXd u = structure_.shapes * Eigen::Map<const Eigen::VectorXd>(state_.q.data(), modes);
    const Eigen::VectorXd speed = structure_.shapes * Eigen::Map<const Eigen::VectorXd>(state_.v.data(), modes);
    to.displacement = list_of(u);
    to.velocity = list_of(speed);
    to.contacts.resize(state_.set.size());
    for (std::size_t k = 0; k < state_.set.size(); ++k)
        to.contacts[structure_.number[k]] = contact_of(state_.set[k]);
    let_rest();
    to.rested.resize(state_.rested.size());
    for (std::size_t k = 0; k < state_.rested.size(); ++k)
        to.rested[structure_.number[k]] = state_.rested[k];
    if (!has_friction_states()) return;
    to.friction_states.resize(state_.set.size());
    for (std::size_t k = 0; k < state_.set.size(); ++k)
        to.friction_states[structure_.number[k]] = state_.friction_states[k];
}

Outcome TaylorRun::advance(const std::stop_token& stop) {
    if (handover_ != nullptr && handover_->from != nullptr) {
        restore(handover_, [this](Memory& memory) { pass(memory); });
        for (std::size_t k = 0; k < intervals_.size(); ++k)
            recorder_.enter(structure_.number[k], intervals_[k]);
        return go_on(stop);
    }
    surface_ = surface(0.0);
    initial_energy_ = stored_energy(structure_, state_.q, state_.v);
    const Settled settled = settling_.settle(state_, surface_);
    add_impacts();
    if (settled != Settled::done) return without_forces(settled);
    tell();
    pass_boundary();
    return go_on(stop);
}

Outcome TaylorRun::go_on(const std::stop_token& stop) {
    double entered = -1.0;     // [s] end of the span whose beginning has been looked at
    double crept_from = -1.0;  // [s] where the counted blocks began
    for (; span_ < spans().size(); ++blocks_) {
        if (blocks_ % blocks_between_checks == 0 && stop.stop_requested()) return {Reason::cancelled, time_};
        if (!is_finite(state_.q, state_.v)) return {Reason::diverged, time_};
        if (has_friction_states() && blocks_ % blocks_of_creep == 0) {
            if (crept_from >= 0.0 && time_ - crept_from < least_creep * step_) return {Reason::chattering, time_};
            crept_from = time_;
        }
        if (!block_.choose(state_.set)) return {Reason::no_forces, time_};
        surface_ = surface(time_);
        block_.expand(state_.q, state_.v, state_.friction_states, surface_);
        const double length = block_.length();
        if (length != step_) surface_ = block_.surface();
        const double boundary = next_boundary();
        if (std::exchange(entered, boundary) != boundary) press(0.0);
        const double reach =
            block_.stretch_end(std::min({1.0, block_.reach(), std::max(0.0, (boundary - time_) / length)}));
        const Firing firing = first_firing(reach);
        if (firing.is_lost) return {Reason::diverged, time_};
        const bool fires = firing.theta <= reach;
        const double theta = fires ? firing.theta : reach;
        const bool ends_at_boundary = !fires && reach * length + time_ >= boundary;
        if (ends_at_boundary && boundary >= spans().back().to)
            keep(handover_, [this](Memory& memory) { pass(memory); });
        account(theta);
        pass_samples(theta);
        if (fires || ends_at_boundary) press(theta);
        move(theta);
        time_ = ends_at_boundary ? boundary : time_ + theta * length;
        let_rest();
        if (fires && firing.function == creep_function) {
            crossed_ = firing.contact;
            surface_ = surface(time_);
            tell();
            continue;
        }
        crossed_ = no_contact;
        if (fires) {
            if (const auto outcome = fire(firing)) return *outcome;
            if (watch_for_cycle(stop))
                return {stop.stop_requested() ? Reason::cancelled : Reason::settled, cycle_->time};
            continue;
        }
        if (time_ < boundary) {
            if (blocks_ % blocks_between_projections == 0) settling_.project(state_, surface(time_));
            if (watch_for_silence()) return {Reason::settled, silence_->time};
            continue;
        }
        const bool has_corners = !drive_.profile().times.empty();
        if (!pass_boundary()) break;
        if (!has_corners) continue;
        surface_ = surface(time_);
        // what rounding has moved a stuck contact by is no slip
        settling_.project(state_, surface_);
        const Settled at_corner = settling_.settle(state_, surface_);
        add_impacts();
        if (at_corner != Settled::done) return without_forces(at_corner);
        is_fresh_ = true;
        tell();
    }
    return {Reason::completed, time_};
}

Motion TaylorRun::run(const std::stop_token& stop) {
    const Outcome outcome = advance(stop);
    if (handover_ != nullptr) hand_over();
    // what has gathered in closed gaps since the last time would be work of the load
    if (outcome.reason == Reason::completed) settling_.project(state_, surface(outcome.time));
    const bool is_filled = outcome.reason == Reason::settled;
    const EnergyBalance balance = is_filled ? final_balance_ : energy();
    record::Record record = recorder_.finish(is_filled ? spans().back().to : outcome.time, outlooks(outcome));
    Motion motion{weighed(outcome, balance, most_unexplained), balance, std::move(record), silence_, cycle_};
    if (has_result(motion.outcome)) return motion;
    motion.last_set.resize(state_.set.size());
    for (std::size_t k = 0; k < state_.set.size(); ++k)
        motion.last_set[structure_.number[k]] = contact_of(state_.set[k]);
    if (outcome.reason == Reason::painleve) motion.pressed = numbered(structure_, settling_.pressed());
    return motion;
}

Motion integrate_taylor(const model::Structure& structure, const parameters::Drive& drive, const InitialState& start,
                        const Taylor& settings, record::Recorder recorder, const std::stop_token& stop) {
    expect_solvable(structure, parameters::Method::taylor);
    return TaylorRun(structure, drive, start, settings, recorder).run(stop);
}

}  // namespace stridor::integration
