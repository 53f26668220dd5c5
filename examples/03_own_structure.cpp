// Your own structure: a mass on a belt, started stuck, through the engine that the paper's system uses.
//
// The engine sees M u'' + C u' + K u = f0 + n N + t T with gap n.u and tangential position t.u. Fill a Structure, say
// which stretches of time count, and read the rates. The exact engine takes two or three degrees of freedom,
// beta_2 any number.
//
// Closed form: D = (mu_s - mu_d) F / k, lambda = w0 D / V, stick share lambda / (lambda + pi - atan lambda).

#include "stridor/analysis/rates.hpp"
#include "stridor/integration/exact/exact.hpp"
#include "stridor/model/structure.hpp"
#include "stridor/record/recorder.hpp"

#include <cmath>
#include <iostream>
#include <numbers>

using namespace stridor;

int main() {
    constexpr int dofs = 2;            // u = (x, y): along and across the belt
    constexpr double mass = 1.0;       // [kg]
    constexpr double stiffness = 1e4;  // [N/m]
    constexpr double preload = 10.0;   // [N]
    constexpr double velocity = 0.04;  // [m/s] of the belt
    const model::Coulomb friction{0.6, 0.2};

    model::Structure structure = model::structure_of_size(dofs);
    structure.mass.diagonal() << mass, mass;
    structure.stiffness(0, 0) = stiffness;
    structure.load << 0.0, -preload;
    model::ContactPoint& contact = structure.contacts.front();
    contact.normal << 0.0, 1.0;
    contact.tangent << 1.0, 0.0;
    contact.friction = friction;

    parameters::Drive belt;
    belt.kind = parameters::DriveKind::constant;
    belt.velocity = velocity;

    const double w0 = std::sqrt(stiffness / mass);  // [rad/s]
    const double excess = (friction.static_coefficient - friction.kinetic_coefficient) * preload / stiffness;
    const double lambda = w0 * excess / velocity;
    const double period = 2.0 * (lambda + std::numbers::pi - std::atan(lambda)) / w0;  // [s]

    // two periods to settle, then ten that count
    record::Schedule schedule;
    schedule.spans = {{0.0, 2.0 * period, record::Phase::all, record::Use::unused},
                      {2.0 * period, 12.0 * period, record::Phase::all, record::Use::judged}};
    schedule.phases = {record::Phase::all};

    const integration::Motion motion = integration::integrate_exact(structure, belt, {parameters::Initial::stuck, 0.0},
                                                                    {}, record::Recorder(schedule, {}, dofs));
    const double computed = analysis::rates(motion.record.phases.front().contacts.front().time).stick;
    const double exact = lambda / (lambda + std::numbers::pi - std::atan(lambda));
    std::cout << "stick share " << computed << ", closed form " << exact << '\n';
    return std::abs(computed - exact) < 1e-12 ? 0 : 1;
}
