#include "stridor/integration/modal/modal_account.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace stridor::integration {

double stored_energy(const ModalStructure& structure, std::span<const double> q, std::span<const double> v) {
    double energy = 0.0;
    for (std::size_t j = 0; j < structure.modes(); ++j)
        energy += 0.5 * v[j] * v[j] + 0.5 * structure.square_frequency[j] * q[j] * q[j];
    for (const ModalSpring& spring : structure.springs)
        energy += energy_of(spring.law, elongation(spring, q));
    return energy;
}

double dashpot_power(const ModalStructure& structure, std::span<const double> v) {
    const std::size_t modes = structure.modes();
    double power = 0.0;
    if (structure.is_damped_by_mode()) {
        for (std::size_t j = 0; j < modes; ++j)
            power += structure.damping[j] * v[j] * v[j];
        return power;
    }
    for (std::size_t a = 0; a < modes; ++a)
        for (std::size_t b = 0; b < modes; ++b)
            power += structure.damping[a * modes + b] * v[a] * v[b];
    return power;
}

void widen(ModalTravel& travel, std::span<const double> q, std::span<const double> v) {
    for (std::size_t j = 0; j < travel.most_q.size(); ++j) {
        travel.most_q[j] = std::max(travel.most_q[j], std::abs(q[j]));
        travel.most_v[j] = std::max(travel.most_v[j], std::abs(v[j]));
    }
}

EnergyBalance closed_balance(EnergyBalance balance, const ModalStructure& structure, std::span<const double> q,
                             const ModalTravel& travel) {
    for (std::size_t j = 0; j < structure.modes(); ++j) {
        const double most_q = travel.most_q[j], most_v = travel.most_v[j];
        balance.preload_work += structure.load[j] * (q[j] - travel.initial_q[j]);
        balance.held += 0.5 * std::abs(structure.square_frequency[j]) * most_q * most_q + 0.5 * most_v * most_v +
                        std::abs(structure.load[j]) * most_q;
    }
    for (const ModalSpring& spring : structure.springs) {
        const double e = elongation_size(spring, travel.most_q);
        balance.held += std::max(std::abs(energy_of(spring.law, e)), std::abs(energy_of(spring.law, -e)));
    }
    if (structure.fastest > 0.0)
        balance.carried = dot(structure.load, structure.load) / (structure.fastest * structure.fastest);
    balance.residual = unexplained(balance);
    return balance;
}

void add_vibration(const model::Structure& structure, const Eigen::Ref<const Eigen::VectorXd>& speed, double duration,
                   std::vector<record::Vibration>& vibration) {
    const auto body = [&](std::size_t channel) {
        return structure.body.empty() ? static_cast<int>(channel) : structure.body[channel];
    };
    for (std::size_t first = 0, end = 0; first < vibration.size(); first = end) {
        double whole = 0.0;
        for (end = first; end < vibration.size() && body(end) == body(first); ++end) {
            const double square = speed(static_cast<Eigen::Index>(end)) * speed(static_cast<Eigen::Index>(end));
            vibration[end].square_time += duration * square;
            whole += square;
        }
        for (std::size_t channel = first; channel < end; ++channel)
            vibration[channel].peak_square = std::max(vibration[channel].peak_square, whole);
    }
}

}  // namespace stridor::integration
