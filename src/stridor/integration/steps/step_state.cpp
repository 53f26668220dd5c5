// What a formulation of time steps writes down: sums of a span, samples, the energy balance.

#include "stridor/integration/steps/step_state.hpp"

#include "stridor/integration/rules/contact_mode_of.hpp"
#include "stridor/model/sized_structure.hpp"

#include <algorithm>
#include <utility>

namespace stridor::integration {

StepState::StepState(const model::Structure& structure, ModalStructure modes, const parameters::Drive& by,
                     const InitialState& start, double h, record::Recorder& taker)
    : whole(structure),
      modal(std::move(modes)),
      step(h),
      motion(by, h, record::end_of(taker.schedule())),
      drive(by),
      recorder(taker),
      propagation(modal, h),
      rows(modal),
      q(padded(integration::modal(modal, structure, start.displacement), rows.padded_modes())),
      v(padded(integration::modal(modal, structure, start.velocity), rows.padded_modes())),
      push(q.size(), 0.0),
      forces(plan().rows(), 0.0),
      vibration(static_cast<std::size_t>(model::channels_of(structure))),
      load(structure.contacts.size()),
      told(structure.contacts.size()),
      handover(start.handover),
      travel{q, std::vector<double>(modal.modes(), 0.0), std::vector<double>(modal.modes(), 0.0)} {
    if (structure.shaken.size() != 0) shaken = padded(modal.shapes.transpose() * structure.shaken, rows.padded_modes());
    for (const ModalContact& contact : modal.contacts)
        grows = grows || model::grows(contact.rest);
    for (std::size_t row = 0; row < forces.size(); ++row)
        share.push_back(drive_share_of(modal.contacts, plan(), row));
}

void StepState::pass(Memory& pass) {
    pass(q), pass(v), pass(push), pass(forces), pass(set), pass(force), pass(dashpot_power), pass(n), pass(work);
    pass(initial_energy), pass(travel.initial_q), pass(travel.most_q), pass(travel.most_v), pass(told);
}

void StepState::press(const std::vector<double>& carried) {
    for (std::size_t k = 0; k < set.size(); ++k) {
        double& largest = load[modal.number[k]].largest_force;
        largest = std::max(largest, carried[plan().first[k]]);
    }
}

void StepState::watch(const Eigen::VectorXd& speed) {
    add_vibration(whole, speed, 1.0, vibration);
    ++watched;
}

void StepState::note_dashpots() {
    const double power = integration::dashpot_power(modal, v);
    work.dashpot_loss += step * 0.5 * (dashpot_power + power);
    dashpot_power = power;
}

void StepState::tell(std::size_t contact, ContactMode mode, double slip_velocity, double gap_velocity) {
    told[contact] = {contact_of(mode), time(), 0.0, slip_velocity, gap_velocity};
    recorder.enter(modal.number[contact], told[contact]);
}

double StepState::rested(std::size_t contact) const {
    if (set[contact] != ContactMode::stick) return 0.0;
    // until the first step nothing has been told: what sticks has stuck before
    const double since = n == 0 ? 0.0 : told[contact].from;
    return time() - since + (since == 0.0 ? modal.contacts[contact].rest.before : 0.0);
}

Eigen::VectorXd StepState::acceleration(const std::vector<double>& at_q, const std::vector<double>& at_v) const {
    const auto n_modes = static_cast<Eigen::Index>(modal.modes());
    const auto v_there = modes_of(at_v);
    Eigen::VectorXd a =
        modes_of(modal.load) + modes_of(push) - modes_of(modal.square_frequency).cwiseProduct(modes_of(at_q));
    if (!shaken.empty()) a += force * modes_of(shaken);
    if (modal.is_damped_by_mode())
        a -= modes_of(modal.damping).cwiseProduct(v_there);
    else
        a -= Eigen::Map<const Eigen::MatrixXd>(modal.damping.data(), n_modes, n_modes) * v_there;
    return a;
}

void StepState::sample(double at, const Eigen::VectorXd& u, const Eigen::VectorXd& speed, const Eigen::VectorXd& rate,
                       const std::vector<double>& gaps) {
    std::vector<record::ContactSample> contacts(set.size());
    for (std::size_t k = 0; k < set.size(); ++k) {
        const std::size_t normal = plan().first[k];
        contacts[modal.number[k]] = {forces[normal], forces[normal + 1], std::max(0.0, gaps[k]), contact_of(set[k])};
    }
    recorder.sample(
        {at, model::numbers(u), model::numbers(speed), model::numbers(rate), motion.at(at).velocity, contacts});
}

EnergyBalance StepState::balance(double stored) const {
    EnergyBalance terms = work;
    terms.stored = stored - initial_energy;
    return closed_balance(terms, modal, q, travel);
}

}  // namespace stridor::integration
