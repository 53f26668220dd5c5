#pragma once

#include "stridor/integration/modal/modal_structure.hpp"
#include "stridor/integration/run/motion.hpp"
#include "stridor/model/structure.hpp"
#include "stridor/record/tally.hpp"

#include <Eigen/Core>

#include <span>
#include <vector>

/// Energies of a structure in the coordinates of its free modes, for every engine that works in them.
namespace stridor::integration {

/// Returns kinetic and elastic energy [J].
double stored_energy(const ModalStructure& structure, std::span<const double> q, std::span<const double> v);

/// Returns the power [W] that the dashpots take.
double dashpot_power(const ModalStructure& structure, std::span<const double> v);

/// How far a run has moved its modes; shape [mode].
struct ModalTravel {
    std::vector<double> initial_q{};
    std::vector<double> most_q{}, most_v{};  // largest that they have been
};

/// Widens it to a state of the run.
void widen(ModalTravel& travel, std::span<const double> q, std::span<const double> v);

/// Adds the load's work and the energy held on the way to q, and says what the balance leaves unexplained.
EnergyBalance closed_balance(EnergyBalance balance, const ModalStructure& structure, std::span<const double> q,
                             const ModalTravel& travel);

/// Adds velocities [m/s], shape [channel], that stand for a stretch of time [s]. Peaks are of whole bodies, whose
/// channels stand one after the other.
void add_vibration(const model::Structure& structure, const Eigen::Ref<const Eigen::VectorXd>& speed, double duration,
                   std::vector<record::Vibration>& vibration);

}  // namespace stridor::integration
