// The step from n to n+1, with lambda_n of the instant n:
//
//     v  += h/2 R'lambda_n                                   half a push
//     q,v = the free structure's exact motion of h           (`FreePropagation`)
//     gap      = n.q + g0 + G lambda >= 0                    lambda at n+1: StepContacts, in velocities of the step
//     slip     = t.q + G lambda - place_n - share dx2
//     v  += h/2 R'lambda                                     the other half
//
// So contacts answer places at once, as springs do; what moves with inertia leaps over them (leapfrog).

#include "stridor/integration/steps/massless.hpp"

#include "stridor/integration/rules/contact_mode_of.hpp"
#include "stridor/integration/rules/expect_solvable.hpp"
#include "stridor/integration/run/imposed_motion.hpp"
#include "stridor/integration/run/step_loop.hpp"
#include "stridor/integration/steps/massless_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace stridor::integration {

MasslessRun::MasslessRun(const model::Structure& structure, MasslessStructure massless, const parameters::Drive& drive,
                         const InitialState& start, double step, record::Recorder& recorder)
    : whole_(structure),
      massless_(std::move(massless)),
      step_(step),
      motion_(drive, step, record::end_of(recorder.schedule())),
      drive_(drive),
      recorder_(recorder),
      propagation_(massless_.modal, step),
      rows_(massless_.modal),
      contacts_(massless_.modal, massless_.flexibility / step,
                std::vector<ContactMode>(structure.contacts.size(), ContactMode::stick)),
      q_(padded(modal(massless_.modal, structure, start.displacement), rows_.padded_modes())),
      v_(padded(modal(massless_.modal, structure, start.velocity), rows_.padded_modes())),
      push_(q_.size(), 0.0),
      all_(massless_.plan.rows()),
      touches_(structure.contacts.size(), 1),
      set_(contacts_.set()),
      place_(all_.size(), 0.0),
      free_(place_),
      free_rates_(place_),
      forces_(place_),
      before_(place_),
      vibration_(static_cast<std::size_t>(model::channels_of(structure))),
      load_(structure.contacts.size()),
      travel_{q_, std::vector<double>(massless_.modal.modes(), 0.0),
              std::vector<double>(massless_.modal.modes(), 0.0)} {
    std::iota(all_.begin(), all_.end(), std::size_t{0});
    const bool has_channels = structure.measured.size() != 0;
    channels_moved_ = has_channels ? Eigen::MatrixXd(structure.measured * massless_.moved) : massless_.moved;
    channels_shaken_ =
        has_channels ? Eigen::VectorXd(structure.measured * massless_.shaken_moved) : massless_.shaken_moved;
    if (structure.shaken.size() != 0)
        shaken_ = padded(massless_.modal.shapes.transpose() * structure.shaken, rows_.padded_modes());
    for (const std::size_t row : all_) {
        share_.push_back(drive_share_of(massless_.modal.contacts, massless_.plan, row));
        const std::size_t contact = massless_.plan.contact[row];
        const model::ContactPoint& point = structure.contacts[massless_.modal.number[contact]];
        const std::size_t which = row - massless_.plan.first[contact];
        const Eigen::VectorXd& direction = which == 0   ? point.normal
                                           : which == 1 ? point.tangent
                                                        : point.second_tangent;
        place_[row] = direction.dot(start.displacement) + (which == 0 ? point.initial_gap : 0.0);
    }
}

// half a step's push of the contact forces
void MasslessRun::push_by_half() {
    rows_.combine(all_, forces_, push_);
    for (std::size_t j = 0; j < v_.size(); ++j)
        v_[j] += 0.5 * step_ * push_[j];
}

// forces at this instant: those that take the contacts from their places before to where the laws are obeyed, while the
// surface has moved by `surface_travel` [m]; returns false if none do
bool MasslessRun::settle(double surface_travel) {
    rows_.multiply(all_, q_, free_);
    for (const std::size_t row : all_) {
        const auto at = static_cast<Eigen::Index>(row);
        free_[row] += massless_.load_place(at) + force_ * massless_.shaken_place(at);
        if (massless_.plan.is_normal(row)) {
            free_[row] += massless_.modal.contacts[massless_.plan.contact[row]].initial_gap;
            free_rates_[row] = free_[row] / step_;
        } else {
            free_rates_[row] = (free_[row] - place_[row] - share_[row] * surface_travel) / step_;
        }
    }
    if (!contacts_.solve(free_rates_, touches_)) return false;
    before_ = forces_;
    for (const std::size_t row : all_)
        forces_[row] = contacts_.force(row);
    return true;
}

// the force in the middle of the step, as if it were that all the time
void MasslessRun::shake() {
    const double force = imposed_force(drive_, (static_cast<double>(n_) + 0.5) * step_);
    double travel = 0.0;
    for (std::size_t j = 0; j < shaken_.size(); ++j) {
        push_[j] = force * shaken_[j];
        travel -= shaken_[j] * q_[j];
    }
    propagation_.advance(q_, v_);
    propagation_.push(push_, q_, v_);
    for (std::size_t j = 0; j < shaken_.size(); ++j)
        travel += shaken_[j] * q_[j];
    work_.drive_work += force * travel;
}

// one step; returns false if no contact forces obey the laws
bool MasslessRun::advance() {
    push_by_half();
    if (shaken_.empty())
        propagation_.advance(q_, v_);
    else
        shake();
    const double travel = motion_.increment(n_);
    force_before_ = force_;
    force_ = imposed_force(drive_, static_cast<double>(n_ + 1) * step_);
    if (!settle(travel)) return false;
    push_by_half();
    note(travel);
    set_ = contacts_.set();
    ++n_;
    return true;
}

void MasslessRun::begin_span() {
    std::fill(vibration_.begin(), vibration_.end(), record::Vibration());
    std::fill(load_.begin(), load_.end(), record::Load());
    press(forces_);
    watched_ = 0;
}

void MasslessRun::end_span(std::size_t span, long, double length) {
    if (watched_ == 0) watch();  // a span between two steps has the velocities of the next one
    for (record::Vibration& sum : vibration_)
        sum.square_time *= length / static_cast<double>(watched_);
    recorder_.vibrate(span, length, vibration_);
    press(forces_);
    recorder_.load(span, load_);
}

Outcome MasslessRun::run(const std::stop_token& stop) {
    force_ = force_before_ = imposed_force(drive_, 0.0);
    if (!settle(0.0)) return {Reason::no_forces, 0.0};
    before_ = forces_;
    set_ = contacts_.set();
    loads_place_ = load_place();
    shakers_place_ = shaken_place();
    dashpot_power_ = dashpot_power(massless_.modal, v_);
    initial_energy_ = stored();
    const auto go = [&](long end, record::Use use, StepSamples& samples) {
        return step_to(*this, end, use, samples, stop);
    };
    if (const auto ended = run_spans(*this, recorder_, step_, go)) return *ended;
    return is_finite() ? Outcome{Reason::completed, time()} : Outcome{Reason::diverged, time()};
}

Motion integrate_massless(const model::Structure& structure, const parameters::Drive& drive, const InitialState& start,
                          const Massless& settings, record::Recorder recorder, const std::stop_token& stop) {
    expect_solvable(structure, parameters::Method::massless);
    MasslessStructure massless = massless_structure(structure, settings.above);
    if (settings.step >= longest_step(massless)) return {{Reason::step_limit, 0.0}, {}, recorder.finish(0.0)};
    MasslessRun runner(structure, std::move(massless), drive, start, settings.step, recorder);
    const Outcome ended = runner.run(stop);
    const EnergyBalance balance = runner.energy();
    const Outcome outcome = weighed(ended, balance, std::numeric_limits<double>::infinity());
    return {outcome, balance, recorder.finish(outcome.time)};
}

}  // namespace stridor::integration
