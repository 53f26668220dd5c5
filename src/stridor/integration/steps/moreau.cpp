// Moreau's time stepping with an exact free structure. A step from n to n+1:
//
//     q*, v*   the free structure's exact motion under the load (`FreePropagation`)
//     touching those closed before, and those open with g* = n.q* + g0 <= 0
//     N, T     constant in the step, so that (g', w) at its end = (n.v*, t.v* - V) + W_h (N, T) obey the laws
//     q, v     = q*, v* + what constant N, T do in a step
//
// A contact that closes has a gap of the size of the step's travel; it is set to zero, and so is every 64 steps what
// has gathered in closed gaps: q -= n W_nn⁻¹ g over all closed contacts, at right angles under the mass.
//
// For the energy balance and the sums of a span, forces are constant in a step, and rates are taken to change evenly in
// it: the residual of the balance falls with the square of the step where nothing changes its state, and says how well
// steps resolve the motion.

#include "stridor/integration/steps/moreau.hpp"

#include "stridor/integration/proofs/lasting_set.hpp"
#include "stridor/integration/rules/contact_mode_of.hpp"
#include "stridor/integration/rules/expect_solvable.hpp"
#include "stridor/integration/run/imposed_motion.hpp"
#include "stridor/integration/steps/exchange_tableau.hpp"
#include "stridor/integration/steps/step_state.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace stridor::integration {

namespace {

constexpr long steps_between_projections = 64;
constexpr double closed_rounding = 1e-9;  // [1] of a gap's terms: closed at the start
constexpr double still_rounding = 1e-12;
constexpr std::size_t modes_per_watched_step = 16;  // velocities of all degrees of freedom cost modes² operations

// what contacts do at the start, from their gaps and velocities
std::vector<ContactMode> first_set(const ModalStructure& structure, const std::vector<double>& q,
                                   const std::vector<double>& v, double surface_velocity) {
    std::vector<ContactMode> set;
    const std::size_t n = structure.modes();
    for (const ModalContact& c : structure.contacts) {
        // of a slip in a plane the first step finds the direction
        const double second = std::abs(c.second_tangent.empty() ? 0.0 : dot(c.second_tangent, {v.data(), n}));
        const double size = dot_of_sizes(c.normal, {q.data(), n}) + std::abs(c.initial_gap);
        const double w = slip_velocity(c, {v.data(), n}, surface_velocity);
        const double speed = dot_of_sizes(c.tangent, {v.data(), n}) + std::abs(c.drive_share * surface_velocity);
        if (gap(c, {q.data(), n}) > closed_rounding * size)
            set.push_back(ContactMode::open);
        else
            set.push_back(std::abs(w) + second > still_rounding * speed ? slip_mode(model::slip_of(w))
                                                                        : ContactMode::stick);
    }
    return set;
}

Eigen::MatrixXd normal_part(const Eigen::MatrixXd& compliance) {
    const Eigen::Index p = compliance.rows() / 2;
    Eigen::MatrixXd part(p, p);
    for (Eigen::Index a = 0; a < p; ++a)
        for (Eigen::Index b = 0; b < p; ++b)
            part(a, b) = compliance(2 * a, 2 * b);
    return part;
}

// Moreau's formulation of `run_steps`: a contact force moves velocities, against inertia.
class MoreauRun {
public:
    MoreauRun(const model::Structure& structure, ModalStructure modes, const parameters::Drive& drive,
              const InitialState& start, double step, record::Recorder& recorder);

    static constexpr bool samples_behind = true;  // the forces of a step are known then

    std::optional<Outcome> begin() { return std::nullopt; }
    bool advance();
    Reason without_forces();
    void press();
    void watch();
    void sample();
    long watch_every() const { return watch_every_; }
    double stored() const { return stored_energy(state.modal, state.q, state.v); }
    void pass(Memory& pass) {
        state.pass(pass), contacts_.pass(pass), closing_.pass(pass);
        pass(has_impact_), pass(touched_), pass(rates_), pass(surface_velocity_);
    }
    std::pair<std::vector<double>, std::vector<double>> place() const {
        const Eigen::VectorXd u = state.modal.shapes * state.modes_of(state.q);
        const Eigen::VectorXd speed = state.modal.shapes * state.modes_of(state.v);
        return {list_of(u), list_of(speed)};
    }

    // what is known of each contact that sticks, at the end of the run over a surface of constant velocity
    std::vector<record::Outlook> outlooks(const Outcome& outcome) const;

    StepState state;

private:
    void shake();
    void find_touching();
    void ask_for(std::size_t contact);
    void subtract_surface(double velocity, std::vector<double>& rates) const;
    void find_free_rates(double surface_velocity);
    void project();
    void note(double start_velocity, double end_velocity);
    void tell(std::size_t contact);
    double elastic() const;

    StepContacts contacts_;
    ExchangeTableau closing_;  // displacements along the normals that close gaps
    std::vector<double> q_before_, v_before_;
    std::vector<double> scratch_;             // shape [mode], filled up
    bool has_impact_ = false;                 // the step before closed a contact: its forces are impulses
    std::vector<char> touches_, touched_;     // in this step and the one before, shape [contact]
    std::vector<double> rates_, free_rates_;  // [m/s] g' and w at the step's begin, and its free end, shape [row]
    std::vector<double> products_;            // shape [row]
    std::vector<std::size_t> which_;          // rows
    double surface_velocity_ = 0.0;           // [m/s] at the step's begin
    long watch_every_;                        // steps
};

MoreauRun::MoreauRun(const model::Structure& structure, ModalStructure modes, const parameters::Drive& drive,
                     const InitialState& start, double step, record::Recorder& recorder)
    : state(structure, std::move(modes), drive, start, step, recorder),
      contacts_(state.modal, state.propagation.response(),
                first_set(state.modal, state.q, state.v, state.motion.at(0.0).velocity)),
      closing_(normal_part(state.modal.compliance)),
      q_before_(state.q),
      v_before_(state.v),
      scratch_(state.push),
      touches_(contacts_.set().size(), 0),
      touched_(touches_),
      rates_(state.forces),
      free_rates_(rates_),
      products_(rates_),
      surface_velocity_(state.motion.at(0.0).velocity),
      watch_every_(static_cast<long>(1 + state.modal.modes() / modes_per_watched_step)) {
    state.set = contacts_.set();
    state.dashpot_power = dashpot_power(state.modal, state.v);
    state.initial_energy = stored();
}

// who takes part: the closed ones, and the open ones whose gap would close
void MoreauRun::find_touching() {
    const std::vector<std::size_t>& first = state.plan().first;
    which_.clear();
    for (std::size_t k = 0; k < state.set.size(); ++k)
        if (state.set[k] == ContactMode::open) which_.push_back(first[k]);
    if (!which_.empty()) state.rows.multiply(which_, state.q, products_);
    for (std::size_t k = 0; k < state.set.size(); ++k)
        touches_[k] =
            state.set[k] != ContactMode::open || products_[first[k]] + state.modal.contacts[k].initial_gap <= 0.0 ? 1
                                                                                                                  : 0;
}

// puts the rows of a contact into those that are asked for
void MoreauRun::ask_for(std::size_t contact) {
    for (std::size_t row = state.plan().first[contact]; row < state.plan().first[contact + 1]; ++row)
        which_.push_back(row);
}

// takes the surface's velocity from the rates at tangents
void MoreauRun::subtract_surface(double velocity, std::vector<double>& rates) const {
    for (const std::size_t row : which_)
        if (!state.plan().is_normal(row)) rates[row] -= state.share[row] * velocity;
}

// rates of those that take part: at the free end, and where they are not known at the begin, too
void MoreauRun::find_free_rates(double surface_velocity) {
    which_.clear();
    for (std::size_t k = 0; k < state.set.size(); ++k)
        if (touches_[k] != 0 && touched_[k] == 0) ask_for(k);
    if (!which_.empty()) {
        state.rows.multiply(which_, v_before_, rates_);
        subtract_surface(surface_velocity_, rates_);
    }
    which_.clear();
    for (std::size_t k = 0; k < state.set.size(); ++k)
        if (touches_[k] != 0) ask_for(k);
    std::fill(free_rates_.begin(), free_rates_.end(), 0.0);
    if (!which_.empty()) state.rows.multiply(which_, state.v, free_rates_);
    subtract_surface(surface_velocity, free_rates_);
}

// sets the gaps of closed contacts to zero
void MoreauRun::project() {
    const std::vector<ContactMode>& set = contacts_.set();
    which_.clear();
    for (std::size_t k = 0; k < set.size(); ++k) {
        const bool is_closed = set[k] != ContactMode::open;
        if (is_closed) which_.push_back(state.plan().first[k]);
        if (closing_.is_exchanged(k) != is_closed) closing_.exchange(k);
    }
    if (which_.empty()) return;
    state.rows.multiply(which_, state.q, products_);
    std::vector<double> gaps(set.size(), 0.0), share(products_.size(), 0.0);
    for (const std::size_t row : which_)
        gaps[state.plan().contact[row]] = products_[row] + state.modal.contacts[state.plan().contact[row]].initial_gap;
    closing_.set(gaps);
    for (const std::size_t row : which_)
        share[row] = closing_.follows(state.plan().contact[row]);
    const double before = elastic();
    state.rows.combine(which_, share, scratch_);
    for (std::size_t j = 0; j < state.q.size(); ++j)
        state.q[j] += scratch_[j];
    state.work.impact_loss += before - elastic();
}

// the force in the middle of the step, as if it were that all the time
void MoreauRun::shake() {
    state.force = imposed_force(state.drive, (static_cast<double>(state.n) + 0.5) * state.step);
    for (std::size_t j = 0; j < state.shaken.size(); ++j)
        scratch_[j] = state.force * state.shaken[j];
    state.propagation.push(scratch_, state.q, state.v);
}

// one step; returns false if no contact forces obey the laws
bool MoreauRun::advance() {
    const double end_velocity = state.motion.at(static_cast<double>(state.n + 1) * state.step).velocity;
    q_before_ = state.q;
    v_before_ = state.v;
    state.propagation.advance(state.q, state.v);
    if (!state.shaken.empty()) shake();
    find_touching();
    find_free_rates(end_velocity);
    state.let_rest(contacts_);
    if (!contacts_.solve(free_rates_, touches_)) return false;
    const std::vector<ContactMode>& set = contacts_.set();
    if (set != state.set) press();
    which_.clear();
    bool has_closed = false;
    for (std::size_t k = 0; k < set.size(); ++k) {
        for (std::size_t row = state.plan().first[k]; row < state.plan().first[k + 1]; ++row)
            state.forces[row] = contacts_.force(row);
        if (set[k] == ContactMode::open) continue;
        ask_for(k);
        has_closed = has_closed || state.set[k] == ContactMode::open;
    }
    state.rows.combine(which_, state.forces, state.push);
    state.propagation.push(state.push, state.q, state.v);
    note(surface_velocity_, end_velocity);
    if (has_closed || state.n % steps_between_projections == 0) project();
    has_impact_ = has_closed;
    surface_velocity_ = end_velocity;
    touched_ = touches_;
    state.set = set;
    ++state.n;
    return true;
}

void MoreauRun::note(double start_velocity, double end_velocity) {
    const double mean_surface = 0.5 * (start_velocity + end_velocity);
    for (std::size_t k = 0; k < state.set.size(); ++k) {
        if (contact_of(contacts_.set()[k]) != contact_of(state.set[k]) || state.n == 0) tell(k);
        if (touches_[k] == 0) continue;
        const std::size_t normal = state.plan().first[k];
        record::Load& load = state.load[state.modal.number[k]];
        load.normal_impulse += state.step * state.forces[normal];
        state.work.impact_loss -= state.step * state.forces[normal] * 0.5 * (rates_[normal] + contacts_.rate(normal));
        rates_[normal] = contacts_.rate(normal);
        for (std::size_t row = normal + 1; row < state.plan().first[k + 1]; ++row) {
            const double T = state.forces[row];
            const double friction_loss = -state.step * T * 0.5 * (rates_[row] + contacts_.rate(row));
            state.work.friction_loss += friction_loss;
            load.friction_loss += friction_loss;
            state.work.drive_work += state.step * T * state.share[row] * mean_surface;
            rates_[row] = contacts_.rate(row);
        }
    }
    for (std::size_t j = 0; j < state.shaken.size(); ++j)
        state.work.drive_work += state.force * state.shaken[j] * (state.q[j] - q_before_[j]);
    state.note_dashpots();
}

// the forces of the step before
void MoreauRun::press() {
    if (!has_impact_) state.press(state.forces);
}

Reason MoreauRun::without_forces() {
    state.pressed = numbered(state.modal, contacts_.pressed(touches_));
    return state.pressed.empty() ? Reason::no_forces : Reason::painleve;
}

std::vector<record::Outlook> MoreauRun::outlooks(const Outcome& outcome) const {
    std::vector<record::Outlook> known(state.set.size());
    const bool is_linear = std::all_of(
        state.modal.contacts.begin(), state.modal.contacts.end(),
        [](const ModalContact& contact) { return contact.second_tangent.empty() && is_state_wise(contact.friction); });
    const bool may_know = outcome.reason == Reason::completed && state.is_steady() && is_linear &&
                          state.modal.modes() <= most_proven_modes;
    if (!may_know) return known;
    std::vector<double> since;
    for (const std::size_t contact : state.modal.number)
        since.push_back(state.recorder.since(contact));
    const std::size_t modes = state.modal.modes();
    const std::vector<record::Outlook> found =
        LastingSet(state.modal, state.set, surface_velocity_)
            .outlooks({state.q.data(), modes}, {state.v.data(), modes}, outcome.time, since);
    for (std::size_t k = 0; k < found.size(); ++k)
        if (state.set[k] == ContactMode::stick) known[state.modal.number[k]] = found[k];
    return known;
}

void MoreauRun::tell(std::size_t contact) {
    const std::size_t row = state.plan().first[contact];
    double slip_velocity = rates_[row + 1];
    if (state.plan().has_two_tangents(contact))
        slip_velocity = std::sqrt(rates_[row + 1] * rates_[row + 1] + rates_[row + 2] * rates_[row + 2]);
    state.tell(contact, contacts_.set()[contact], slip_velocity, rates_[row]);
}

void MoreauRun::watch() {
    state.watch(state.modal.channels * state.modes_of(state.v));
}

// the instant at which the step that is done began, with its forces
void MoreauRun::sample() {
    const Eigen::VectorXd a = state.acceleration(q_before_, v_before_);
    std::vector<double> gaps(state.set.size(), 0.0);
    for (std::size_t k = 0; k < gaps.size(); ++k)
        if (state.set[k] == ContactMode::open)
            gaps[k] = gap(state.modal.contacts[k], {q_before_.data(), state.modal.modes()});
    state.sample(static_cast<double>(state.n - 1) * state.step, state.modal.shapes * state.modes_of(q_before_),
                 state.modal.shapes * state.modes_of(v_before_), state.modal.shapes * a, gaps);
}

double MoreauRun::elastic() const {
    double energy = 0.0;
    for (std::size_t j = 0; j < state.modal.modes(); ++j)
        energy += (0.5 * state.modal.square_frequency[j] * state.q[j] - state.modal.load[j]) * state.q[j];
    return energy;
}

}  // namespace

double longest_step(const ModalStructure& structure) {
    const double square = structure.square_frequency.back();
    return square > 0.0 ? std::numbers::pi / std::sqrt(square) : std::numeric_limits<double>::infinity();
}

Motion integrate_moreau(const model::Structure& structure, const parameters::Drive& drive, const InitialState& start,
                        const Moreau& settings, record::Recorder recorder, const std::stop_token& stop) {
    expect_solvable(structure, parameters::Method::moreau);
    ModalStructure modal = modal_structure(structure);
    if (settings.step > longest_step(modal)) return {{Reason::step_limit, 0.0}, {}, recorder.finish(0.0)};
    MoreauRun run(structure, std::move(modal), drive, start, settings.step, recorder);
    return motion_of(run, stop);
}

}  // namespace stridor::integration
