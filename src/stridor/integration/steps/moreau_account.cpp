// What a step adds to the energy balance and to the sums of its span, and samples. Forces are constant in a step, and
// rates are taken to change evenly in it: the residual of the balance falls with the square of the step where nothing
// changes its state, and says how well steps resolve the motion.

#include "stridor/integration/modal/modal_account.hpp"
#include "stridor/integration/proofs/lasting_set.hpp"
#include "stridor/integration/rules/contact_mode_of.hpp"
#include "stridor/integration/steps/moreau_run.hpp"
#include "stridor/model/sized_structure.hpp"

#include <algorithm>
#include <cmath>

namespace stridor::integration {

void MoreauRun::note(double start_velocity, double end_velocity) {
    const double mean_surface = 0.5 * (start_velocity + end_velocity);
    for (std::size_t k = 0; k < set_.size(); ++k) {
        if (contact_of(contacts_.set()[k]) != contact_of(set_[k]) || n_ == 0) tell(k);
        if (touches_[k] == 0) continue;
        const std::size_t normal = rows_.plan().first[k];
        record::Load& load = load_[structure_.number[k]];
        load.normal_impulse += step_ * forces_[normal];
        work_.impact_loss -= step_ * forces_[normal] * 0.5 * (rates_[normal] + contacts_.rate(normal));
        rates_[normal] = contacts_.rate(normal);
        for (std::size_t row = normal + 1; row < rows_.plan().first[k + 1]; ++row) {
            const double T = forces_[row];
            const double friction_loss = -step_ * T * 0.5 * (rates_[row] + contacts_.rate(row));
            work_.friction_loss += friction_loss;
            load.friction_loss += friction_loss;
            work_.drive_work += step_ * T * share_[row] * mean_surface;
            rates_[row] = contacts_.rate(row);
        }
    }
    for (std::size_t j = 0; j < shaken_.size(); ++j)
        work_.drive_work += force_ * shaken_[j] * (q_[j] - q_before_[j]);
    const double power = dashpot_power(structure_, v_);
    work_.dashpot_loss += step_ * 0.5 * (dashpot_power_ + power);
    dashpot_power_ = power;
}

// what the contacts carry, forces of the step before, where one of them changes its state or a span ends
void MoreauRun::press() {
    if (has_impact_) return;
    for (std::size_t k = 0; k < set_.size(); ++k) {
        double& largest = load_[structure_.number[k]].largest_force;
        largest = std::max(largest, forces_[rows_.plan().first[k]]);
    }
}

std::vector<record::Outlook> MoreauRun::outlooks(const Outcome& outcome) const {
    std::vector<record::Outlook> known(set_.size());
    const bool is_linear = std::all_of(
        structure_.contacts.begin(), structure_.contacts.end(),
        [](const ModalContact& contact) { return contact.second_tangent.empty() && is_state_wise(contact.friction); });
    const bool may_know = outcome.reason == Reason::completed && parameters::is_steady(drive_) && is_linear &&
                          structure_.modes() <= most_proven_modes;
    if (!may_know) return known;
    std::vector<double> since;
    for (const std::size_t contact : structure_.number)
        since.push_back(recorder_.since(contact));
    const std::size_t modes = structure_.modes();
    const std::vector<record::Outlook> found =
        LastingSet(structure_, set_, surface_velocity_)
            .outlooks({q_.data(), modes}, {v_.data(), modes}, outcome.time, since);
    for (std::size_t k = 0; k < found.size(); ++k)
        if (set_[k] == ContactMode::stick) known[structure_.number[k]] = found[k];
    return known;
}

// the recorder of a contact's new state, which it has from the step's begin on
void MoreauRun::tell(std::size_t contact) {
    const std::size_t row = rows_.plan().first[contact];
    double slip_velocity = rates_[row + 1];
    if (rows_.plan().has_two_tangents(contact))
        slip_velocity = std::sqrt(rates_[row + 1] * rates_[row + 1] + rates_[row + 2] * rates_[row + 2]);
    recorder_.enter(structure_.number[contact],
                    {contact_of(contacts_.set()[contact]), time(), 0.0, slip_velocity, rates_[row]});
}

// velocities at this instant stand for the steps until the next ones
void MoreauRun::watch() {
    const auto n = static_cast<Eigen::Index>(structure_.modes());
    const Eigen::VectorXd speed = structure_.channels * Eigen::Map<const Eigen::VectorXd>(v_.data(), n);
    add_vibration(whole_, speed, 1.0, vibration_);
    ++watched_;
}

// the instant at which the step that is done began, with its forces
void MoreauRun::sample() {
    const auto n = static_cast<Eigen::Index>(structure_.modes());
    const Eigen::Map<const Eigen::VectorXd> q(q_before_.data(), n), v(v_before_.data(), n), r(push_.data(), n),
        square(structure_.square_frequency.data(), n), load(structure_.load.data(), n);
    Eigen::VectorXd a = load + r - square.cwiseProduct(q);
    if (!shaken_.empty()) a += force_ * Eigen::Map<const Eigen::VectorXd>(shaken_.data(), n);
    if (structure_.is_damped_by_mode())
        a -= Eigen::Map<const Eigen::VectorXd>(structure_.damping.data(), n).cwiseProduct(v);
    else
        a -= Eigen::Map<const Eigen::MatrixXd>(structure_.damping.data(), n, n) * v;
    std::vector<record::ContactSample> contacts(set_.size());
    for (std::size_t k = 0; k < set_.size(); ++k) {
        record::ContactSample& sample = contacts[structure_.number[k]];
        sample.state = contact_of(set_[k]);
        sample.normal_force = forces_[rows_.plan().first[k]];
        sample.friction_force = forces_[rows_.plan().first[k] + 1];
        if (set_[k] == ContactMode::open)
            sample.gap = std::max(0.0, gap(structure_.contacts[k], {q_before_.data(), structure_.modes()}));
    }
    const double time = static_cast<double>(n_ - 1) * step_;
    const Eigen::VectorXd u = structure_.shapes * q, speed = structure_.shapes * v,
                          acceleration = structure_.shapes * a;
    recorder_.sample({time, model::numbers(u), model::numbers(speed), model::numbers(acceleration),
                      motion_.at(time).velocity, contacts});
}

double MoreauRun::elastic() const {
    double energy = 0.0;
    for (std::size_t j = 0; j < structure_.modes(); ++j)
        energy += (0.5 * structure_.square_frequency[j] * q_[j] - structure_.load[j]) * q_[j];
    return energy;
}

EnergyBalance MoreauRun::energy() const {
    EnergyBalance balance = work_;
    balance.stored = stored_energy(structure_, q_, v_) - initial_energy_;
    return closed_balance(balance, structure_, q_, travel_);
}

}  // namespace stridor::integration
