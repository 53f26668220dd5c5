// The step from n to n+1, with lambda_n of the instant n:
//
//     v  += h/2 R'lambda_n                                   half a push
//     q,v = the free structure's exact motion of h           (`FreePropagation`)
//     gap      = n.q + g0 + G lambda >= 0                    lambda at n+1: StepContacts, in velocities of the step
//     slip     = t.q + G lambda - place_n - share dx2
//     v  += h/2 R'lambda                                     the other half
//
// So contacts answer places at once, as springs do; what moves with inertia leaps over them (leapfrog).
//
// For the energy balance and the sums of a span, forces are taken to change evenly in a step, and what has no inertia
// to move evenly from one instant to the next.

#include "stridor/integration/steps/massless.hpp"

#include "stridor/integration/rules/contact_mode_of.hpp"
#include "stridor/integration/rules/expect_solvable.hpp"
#include "stridor/integration/run/imposed_motion.hpp"
#include "stridor/integration/steps/step_state.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace stridor::integration {

namespace {

Eigen::Map<const Eigen::VectorXd> numbers_at(const std::vector<double>& numbers) {
    return {numbers.data(), static_cast<Eigen::Index>(numbers.size())};
}

// The formulation of `run_steps` whose contacts have no inertia: a contact force moves places, against flexibility.
class MasslessRun {
public:
    MasslessRun(const model::Structure& structure, MasslessStructure massless, const parameters::Drive& drive,
                const InitialState& start, double step, record::Recorder& recorder);

    static constexpr bool samples_behind = false;

    std::optional<Outcome> begin();
    bool advance();
    static Reason without_forces() { return Reason::no_forces; }
    void press() { state.press(state.forces); }
    void watch();
    void sample();
    static long watch_every() { return 1; }
    double stored() const;
    void pass(Memory& pass) {
        state.pass(pass), contacts_.pass(pass);
        pass(place_), pass(before_), pass(force_before_), pass(loads_place_), pass(shakers_place_);
    }
    std::pair<std::vector<double>, std::vector<double>> place() const {
        const auto [u, speed] = moving();
        return {list_of(u), list_of(speed)};
    }
    static std::vector<record::Outlook> outlooks(const Outcome&) { return {}; }

    StepState state;

private:
    bool settle(double surface_travel);
    void shake();
    void push_by_half();
    void note(double surface_travel);
    void tell(std::size_t contact);
    double load_place() const;
    double shaken_place() const;
    std::pair<Eigen::VectorXd, Eigen::VectorXd> moving() const;

    MasslessStructure massless_;  // its modes are those of the state
    StepContacts contacts_;
    Eigen::MatrixXd channels_moved_;    // [m/N] shape [channel][row]
    Eigen::VectorXd channels_shaken_;   // [m/N] shape [channel]
    std::vector<std::size_t> all_;      // rows
    std::vector<char> touches_;         // all of them, shape [contact]
    std::vector<double> place_, free_;  // [m] gaps and tangential places, shape [row]
    std::vector<double> free_rates_;    // [m/s] of the step without contact forces, likewise
    std::vector<double> before_;        // [N] forces of the instant before, likewise
    double force_before_ = 0.0;         // [N] imposed at the instant before
    double loads_place_ = 0.0;          // [J] work of the load on what has no inertia, up to now
    double shakers_place_ = 0.0;        // [m] of the imposed force's point, without inertia
};

MasslessRun::MasslessRun(const model::Structure& structure, MasslessStructure massless, const parameters::Drive& drive,
                         const InitialState& start, double step, record::Recorder& recorder)
    : state(structure, std::move(massless.modal), drive, start, step, recorder),
      massless_(std::move(massless)),
      contacts_(state.modal, massless_.flexibility / step,
                std::vector<ContactMode>(structure.contacts.size(), ContactMode::stick)),
      all_(state.plan().rows()),
      touches_(structure.contacts.size(), 1),
      place_(state.forces),
      free_(place_),
      free_rates_(place_),
      before_(place_) {
    state.set = contacts_.set();
    std::iota(all_.begin(), all_.end(), std::size_t{0});
    const bool has_channels = structure.measured.size() != 0;
    channels_moved_ = has_channels ? Eigen::MatrixXd(structure.measured * massless_.moved) : massless_.moved;
    channels_shaken_ =
        has_channels ? Eigen::VectorXd(structure.measured * massless_.shaken_moved) : massless_.shaken_moved;
    for (const std::size_t row : all_) {
        const std::size_t contact = state.plan().contact[row];
        const model::ContactPoint& point = structure.contacts[state.modal.number[contact]];
        const std::size_t which = row - state.plan().first[contact];
        const Eigen::VectorXd& direction = which == 0   ? point.normal
                                           : which == 1 ? point.tangent
                                                        : point.second_tangent;
        place_[row] = direction.dot(start.displacement) + (which == 0 ? point.initial_gap : 0.0);
    }
}

// half a step's push of the contact forces
void MasslessRun::push_by_half() {
    state.rows.combine(all_, state.forces, state.push);
    for (std::size_t j = 0; j < state.v.size(); ++j)
        state.v[j] += 0.5 * state.step * state.push[j];
}

// forces at this instant: those that take the contacts from their places before to where the laws are obeyed, while the
// surface has moved by `surface_travel` [m]; returns false if none do
bool MasslessRun::settle(double surface_travel) {
    state.rows.multiply(all_, state.q, free_);
    for (const std::size_t row : all_) {
        const auto at = static_cast<Eigen::Index>(row);
        free_[row] += massless_.load_place(at) + state.force * massless_.shaken_place(at);
        if (state.plan().is_normal(row)) {
            free_[row] += state.modal.contacts[state.plan().contact[row]].initial_gap;
            free_rates_[row] = free_[row] / state.step;
        } else {
            free_rates_[row] = (free_[row] - place_[row] - state.share[row] * surface_travel) / state.step;
        }
    }
    state.let_rest(contacts_);
    if (!contacts_.solve(free_rates_, touches_)) return false;
    before_ = state.forces;
    for (const std::size_t row : all_)
        state.forces[row] = contacts_.force(row);
    return true;
}

// the force in the middle of the step, as if it were that all the time
void MasslessRun::shake() {
    const double force = imposed_force(state.drive, (static_cast<double>(state.n) + 0.5) * state.step);
    double travel = 0.0;
    for (std::size_t j = 0; j < state.shaken.size(); ++j) {
        state.push[j] = force * state.shaken[j];
        travel -= state.shaken[j] * state.q[j];
    }
    state.propagation.advance(state.q, state.v);
    state.propagation.push(state.push, state.q, state.v);
    for (std::size_t j = 0; j < state.shaken.size(); ++j)
        travel += state.shaken[j] * state.q[j];
    state.work.drive_work += force * travel;
}

// one step; returns false if no contact forces obey the laws
bool MasslessRun::advance() {
    push_by_half();
    if (state.shaken.empty())
        state.propagation.advance(state.q, state.v);
    else
        shake();
    const double travel = state.motion.increment(state.n);
    force_before_ = state.force;
    state.force = imposed_force(state.drive, static_cast<double>(state.n + 1) * state.step);
    if (!settle(travel)) return false;
    push_by_half();
    note(travel);
    state.set = contacts_.set();
    ++state.n;
    return true;
}

std::optional<Outcome> MasslessRun::begin() {
    state.force = force_before_ = imposed_force(state.drive, 0.0);
    if (!settle(0.0)) return Outcome{Reason::no_forces, 0.0};
    before_ = state.forces;
    state.set = contacts_.set();
    loads_place_ = load_place();
    shakers_place_ = shaken_place();
    state.dashpot_power = dashpot_power(state.modal, state.v);
    state.initial_energy = stored();
    return std::nullopt;
}

void MasslessRun::note(double surface_travel) {
    if (contacts_.set() != state.set) state.press(before_);
    for (std::size_t k = 0; k < state.set.size(); ++k) {
        if (contact_of(contacts_.set()[k]) != contact_of(state.set[k]) || state.n == 0) tell(k);
        record::Load& load = state.load[state.modal.number[k]];
        const std::size_t normal = state.plan().first[k];
        const double mean = 0.5 * (before_[normal] + state.forces[normal]);
        const double gap = state.step * contacts_.rate(normal);
        load.normal_impulse += state.step * mean;
        state.work.impact_loss -= mean * (gap - place_[normal]);
        place_[normal] = gap;
        for (std::size_t row = normal + 1; row < state.plan().first[k + 1]; ++row) {
            const double T = 0.5 * (before_[row] + state.forces[row]);
            // an open contact has left its place on the surface: it begins anew where it comes back
            const double slip = state.step * contacts_.rate(row);
            const double friction_loss = -T * slip;
            state.work.friction_loss += friction_loss;
            load.friction_loss += friction_loss;
            state.work.drive_work += T * state.share[row] * surface_travel;
            place_[row] += slip + state.share[row] * surface_travel;
        }
    }
    const double by_load = load_place();
    state.work.preload_work += by_load - loads_place_;
    loads_place_ = by_load;
    const double shaker = shaken_place();
    state.work.drive_work += 0.5 * (force_before_ + state.force) * (shaker - shakers_place_);
    shakers_place_ = shaker;
    state.note_dashpots();
}

void MasslessRun::tell(std::size_t contact) {
    const std::size_t row = state.plan().first[contact];
    const bool is_plane = state.plan().has_two_tangents(contact);
    state.tell(contact, contacts_.set()[contact], is_plane ? contacts_.slip_velocity(contact) : contacts_.rate(row + 1),
               0.0);
}

// velocities at this instant stand for the step from here
void MasslessRun::watch() {
    const Eigen::VectorXd changed = (numbers_at(state.forces) - numbers_at(before_)) / state.step;
    state.watch(state.modal.channels * state.modes_of(state.v) + channels_moved_ * changed +
                (state.force - force_before_) / state.step * channels_shaken_);
}

// displacements [m] and velocities [m/s] of all degrees of freedom at this instant
std::pair<Eigen::VectorXd, Eigen::VectorXd> MasslessRun::moving() const {
    const ModalStructure& modes = state.modal;
    const Eigen::VectorXd changed = (numbers_at(state.forces) - numbers_at(before_)) / state.step;
    return {modes.shapes * state.modes_of(state.q) + massless_.moved * numbers_at(state.forces) + massless_.load_moved +
                state.force * massless_.shaken_moved,
            modes.shapes * state.modes_of(state.v) + massless_.moved * changed +
                (state.force - force_before_) / state.step * massless_.shaken_moved};
}

void MasslessRun::sample() {
    const ModalStructure& modes = state.modal;
    state.rows.combine(all_, state.forces, state.push);
    const Eigen::VectorXd a = state.acceleration(state.q, state.v);
    const auto [u, speed] = moving();
    std::vector<double> gaps;
    for (std::size_t k = 0; k < state.set.size(); ++k)
        gaps.push_back(place_[state.plan().first[k]]);
    state.sample(state.time(), u, speed, modes.shapes * a, gaps);
}

// [J] work that the constant load has done on what has no inertia, from where nothing pushes it
double MasslessRun::load_place() const {
    return massless_.load_place.dot(numbers_at(state.forces)) + massless_.load_by_load +
           massless_.load_by_shaken * state.force;
}

// [m] where the imposed force's point is, without inertia
double MasslessRun::shaken_place() const {
    return massless_.shaken_place.dot(numbers_at(state.forces)) + massless_.load_by_shaken +
           massless_.shaken_by_shaken * state.force;
}

// [J] half of what all forces do on the flexibility is held in it
double MasslessRun::stored() const {
    const auto lambda = numbers_at(state.forces);
    const double by_contacts =
        lambda.dot(massless_.flexibility * lambda + massless_.load_place + state.force * massless_.shaken_place);
    return stored_energy(state.modal, state.q, state.v) +
           0.5 * (by_contacts + load_place() + state.force * shaken_place());
}

}  // namespace

Motion integrate_massless(const model::Structure& structure, const parameters::Drive& drive, const InitialState& start,
                          const Massless& settings, record::Recorder recorder, const std::stop_token& stop) {
    expect_solvable(structure, parameters::Method::massless);
    MasslessStructure massless = massless_structure(structure, settings.above);
    if (settings.step >= longest_step(massless)) return {{Reason::step_limit, 0.0}, {}, recorder.finish(0.0)};
    MasslessRun run(structure, std::move(massless), drive, start, settings.step, recorder);
    return motion_of(run, stop);
}

}  // namespace stridor::integration
