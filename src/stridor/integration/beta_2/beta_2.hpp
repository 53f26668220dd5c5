#pragma once

#include "stridor/integration/run/imposed_motion.hpp"
#include "stridor/integration/run/initial_state.hpp"
#include "stridor/integration/run/motion.hpp"
#include "stridor/model/structure.hpp"
#include "stridor/record/recorder.hpp"

#include <stop_token>
#include <vector>

namespace stridor::integration {

/// Settings of the beta_2 scheme.
struct Beta2 {
    double step = 1e-6;   // [s] h
    double beta_2 = 0.5;  // [1] in [0.5, 1]
};

/// Returns largest stable time step [s] of the scheme for an angular frequency [rad/s]: h = sqrt(2 / beta_2) / omega.
double stable_step(double beta_2, double angular_frequency);

/// Integrates a structure with a contact by the explicit beta_2 scheme with kinematic contact.
///
/// Time advances by fixed steps; a contact state holds from one step to the next, so changes of state are known to one
/// step h only, and a stick trial captures any slip velocity below about mu_s N h / m: the weakness of the
/// method, see docs/methods/motion.md. Returns `step_limit` without running where the step is unstable, `diverged` with
/// the time where a number left double precision, `cancelled` within milliseconds of a stop request.
/// It solves structures of any size with one contact, any law of friction in `model`, and plastic impacts. Throws
/// `Error`: input for any other, by name; numerical for a Painleve configuration; what `initial_state` throws.
/// Source: Elmaian et al. 2012, references [9, 10]; explicit Newmark scheme with beta = 0, gamma = beta_2.
Motion integrate_beta_2(const model::Structure& structure, const parameters::Drive& drive, const Start& start,
                        const Beta2& settings, record::Recorder recorder, const std::stop_token& stop = {});

}  // namespace stridor::integration
