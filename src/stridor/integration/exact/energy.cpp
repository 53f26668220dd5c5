// The balance of a run: stored energies from the state, losses and the drive's work from the logbook. What it is held
// against where next to nothing is turned over is the energy held, of the largest numbers that events, ends of spans
// and the end have shown: in between a motion is made of vibrations about these.

#include "stridor/model/energy.hpp"

#include "stridor/integration/exact/run.hpp"
#include "stridor/integration/run/energy_held.hpp"

#include <algorithm>
#include <cmath>

namespace stridor::integration {

template <int dofs>
typename ExactRun<dofs>::Position ExactRun<dofs>::position(const Lanes& s, ContactMode mode) const {
    return seen(s, mode, coordinates_.basis);
}

template <int dofs>
typename ExactRun<dofs>::Position ExactRun<dofs>::seen(const Lanes& s, ContactMode mode, const Matrix& basis) const {
    Vector z = Vector::Zero(), speed = Vector::Zero();
    for (int i = 0; i < closed; ++i) {
        z(i) = s.at[i];
        speed(i) = s.at[velocity_lane(closed, i)];
    }
    if (mode == ContactMode::open) {
        z(closed) = s.at[G];
        speed(closed) = s.at[G + 1];
    }
    return {basis * z, basis * speed};
}

template <int dofs>
double ExactRun<dofs>::stored(const Position& here) const {
    return model::kinetic_energy(structure_.mass, here.velocity) +
           model::elastic_energy(structure_.stiffness, here.displacement);
}

template <int dofs>
double ExactRun<dofs>::held() const {
    const Matrix basis = coordinates_.basis.cwiseAbs();
    const Position in_contact = seen(closed_reach_, ContactMode::stick, basis);
    const Position apart = seen(open_reach_, ContactMode::open, basis);
    const Position last = position(s_, mode_);
    const Vector far = in_contact.displacement.cwiseMax(apart.displacement).cwiseMax(last.displacement.cwiseAbs());
    // a joint that begins to stick is given the plate's velocity
    const Vector fast = in_contact.velocity.cwiseMax(apart.velocity).cwiseMax(last.velocity.cwiseAbs()) +
                        structure_.tangent.cwiseAbs() * closed_reach_.at[V];
    return energy_held<dofs>(structure_, far, fast);
}

template <int dofs>
EnergyBalance ExactRun<dofs>::energy() const {
    const Position last = position(s_, mode_);
    EnergyBalance balance = book_.losses();
    balance.stored = stored(last) - initial_energy_;
    balance.preload_work = structure_.load.dot(last.displacement - initial_displacement_);
    balance.residual = unexplained(balance);
    balance.held = held();
    return balance;
}

template class ExactRun<2>;
template class ExactRun<3>;

}  // namespace stridor::integration
