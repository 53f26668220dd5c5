// What a step adds to the energy balance and to the sums of its span, and samples. Forces are taken to change evenly
// in a step, and what has no inertia to move evenly from one instant to the next.

#include "stridor/integration/modal/modal_account.hpp"
#include "stridor/integration/rules/contact_mode_of.hpp"
#include "stridor/integration/steps/massless_run.hpp"
#include "stridor/model/sized_structure.hpp"

#include <algorithm>
#include <cmath>

namespace stridor::integration {

namespace {

Eigen::Map<const Eigen::VectorXd> numbers_at(const std::vector<double>& numbers) {
    return {numbers.data(), static_cast<Eigen::Index>(numbers.size())};
}

}  // namespace

// what the contacts carry where one of them changes its state or a span ends
void MasslessRun::press(const std::vector<double>& forces) {
    for (std::size_t k = 0; k < set_.size(); ++k) {
        double& largest = load_[massless_.modal.number[k]].largest_force;
        largest = std::max(largest, forces[massless_.plan.first[k]]);
    }
}

void MasslessRun::note(double surface_travel) {
    if (contacts_.set() != set_) press(before_);
    for (std::size_t k = 0; k < set_.size(); ++k) {
        if (contact_of(contacts_.set()[k]) != contact_of(set_[k]) || n_ == 0) tell(k);
        record::Load& load = load_[massless_.modal.number[k]];
        const std::size_t normal = massless_.plan.first[k];
        const double mean = 0.5 * (before_[normal] + forces_[normal]);
        const double gap = step_ * contacts_.rate(normal);
        load.normal_impulse += step_ * mean;
        work_.impact_loss -= mean * (gap - place_[normal]);
        place_[normal] = gap;
        for (std::size_t row = normal + 1; row < massless_.plan.first[k + 1]; ++row) {
            const double T = 0.5 * (before_[row] + forces_[row]);
            // an open contact has left its place on the surface: it begins anew where it comes back
            const double slip = step_ * contacts_.rate(row);
            const double friction_loss = -T * slip;
            work_.friction_loss += friction_loss;
            load.friction_loss += friction_loss;
            work_.drive_work += T * share_[row] * surface_travel;
            place_[row] += slip + share_[row] * surface_travel;
        }
    }
    const double by_load = load_place();
    work_.preload_work += by_load - loads_place_;
    loads_place_ = by_load;
    const double shaker = shaken_place();
    work_.drive_work += 0.5 * (force_before_ + force_) * (shaker - shakers_place_);
    shakers_place_ = shaker;
    const double power = dashpot_power(massless_.modal, v_);
    work_.dashpot_loss += step_ * 0.5 * (dashpot_power_ + power);
    dashpot_power_ = power;
}

// the recorder of a contact's new state, which it has from the step's begin on
void MasslessRun::tell(std::size_t contact) {
    const std::size_t row = massless_.plan.first[contact];
    double slip_velocity = contacts_.rate(row + 1);
    if (massless_.plan.has_two_tangents(contact)) slip_velocity = contacts_.slip_velocity(contact);
    recorder_.enter(massless_.modal.number[contact],
                    {contact_of(contacts_.set()[contact]), time(), 0.0, slip_velocity, 0.0});
}

// velocities at this instant stand for the step from here
void MasslessRun::watch() {
    const auto n = static_cast<Eigen::Index>(massless_.modal.modes());
    const Eigen::VectorXd changed = (numbers_at(forces_) - numbers_at(before_)) / step_;
    const Eigen::VectorXd speed = massless_.modal.channels * Eigen::Map<const Eigen::VectorXd>(v_.data(), n) +
                                  channels_moved_ * changed + (force_ - force_before_) / step_ * channels_shaken_;
    add_vibration(whole_, speed, 1.0, vibration_);
    ++watched_;
}

void MasslessRun::sample() {
    const auto n = static_cast<Eigen::Index>(massless_.modal.modes());
    const ModalStructure& modes = massless_.modal;
    const Eigen::Map<const Eigen::VectorXd> q(q_.data(), n), v(v_.data(), n), square(modes.square_frequency.data(), n),
        load(modes.load.data(), n);
    rows_.combine(all_, forces_, push_);
    Eigen::VectorXd a = load + Eigen::Map<const Eigen::VectorXd>(push_.data(), n) - square.cwiseProduct(q);
    if (!shaken_.empty()) a += force_ * Eigen::Map<const Eigen::VectorXd>(shaken_.data(), n);
    if (modes.is_damped_by_mode())
        a -= Eigen::Map<const Eigen::VectorXd>(modes.damping.data(), n).cwiseProduct(v);
    else
        a -= Eigen::Map<const Eigen::MatrixXd>(modes.damping.data(), n, n) * v;
    std::vector<record::ContactSample> contacts(set_.size());
    for (std::size_t k = 0; k < set_.size(); ++k) {
        record::ContactSample& sample = contacts[modes.number[k]];
        sample.state = contact_of(set_[k]);
        sample.normal_force = forces_[massless_.plan.first[k]];
        sample.friction_force = forces_[massless_.plan.first[k] + 1];
        sample.gap = std::max(0.0, place_[massless_.plan.first[k]]);
    }
    const Eigen::VectorXd changed = (numbers_at(forces_) - numbers_at(before_)) / step_;
    const Eigen::VectorXd u = modes.shapes * q + massless_.moved * numbers_at(forces_) + massless_.load_moved +
                              force_ * massless_.shaken_moved;
    const Eigen::VectorXd speed =
        modes.shapes * v + massless_.moved * changed + (force_ - force_before_) / step_ * massless_.shaken_moved;
    const Eigen::VectorXd acceleration = modes.shapes * a;
    recorder_.sample({time(), model::numbers(u), model::numbers(speed), model::numbers(acceleration),
                      motion_.at(time()).velocity, contacts});
}

// [J] work that the constant load has done on what has no inertia, from where nothing pushes it
double MasslessRun::load_place() const {
    return massless_.load_place.dot(numbers_at(forces_)) + massless_.load_by_load + massless_.load_by_shaken * force_;
}

// [m] where the imposed force's point is, without inertia
double MasslessRun::shaken_place() const {
    return massless_.shaken_place.dot(numbers_at(forces_)) + massless_.load_by_shaken +
           massless_.shaken_by_shaken * force_;
}

// [J] half of what all forces do on the flexibility is held in it
double MasslessRun::stored() const {
    const auto lambda = numbers_at(forces_);
    const double by_contacts =
        lambda.dot(massless_.flexibility * lambda + massless_.load_place + force_ * massless_.shaken_place);
    return stored_energy(massless_.modal, q_, v_) + 0.5 * (by_contacts + load_place() + force_ * shaken_place());
}

EnergyBalance MasslessRun::energy() const {
    EnergyBalance balance = work_;
    balance.stored = stored() - initial_energy_;
    return closed_balance(balance, massless_.modal, q_, travel_);
}

}  // namespace stridor::integration
