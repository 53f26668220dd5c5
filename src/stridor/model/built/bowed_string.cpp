#include "stridor/model/built/bowed_string.hpp"

#include "stridor/base/elementary.hpp"

#include <cmath>

namespace stridor::model {

namespace {

constexpr double pi_of_modes = 3.14159265358979323846;
constexpr double bow_stiffness = 1e4;  // [N/m] of the bow across the string; it does not move

double mass_of(const BowedString& string) {
    return string.impedance / (2.0 * string.frequency);  // ρ L
}

}  // namespace

Structure bowed_string(const BowedString& string, int modes) {
    Structure structure = structure_of_size(modes + 1);
    ContactPoint& bow = structure.contacts.front();
    structure.mass.setIdentity();
    const double bridge_damping = 4.0 * string.frequency * string.impedance / string.bridge_resistance;  // [1/s]
    for (int k = 1; k <= modes; ++k) {
        const double omega = 2.0 * pi_of_modes * string.frequency * k;
        structure.stiffness(k - 1, k - 1) = omega * omega;
        structure.damping(k - 1, k - 1) = 2.0 * string.damping_ratio * omega + bridge_damping;
    }
    bow.tangent = string_shape(string, modes, string.bow_position);
    structure.stiffness(modes, modes) = bow_stiffness;
    structure.load(modes) = -string.bow_force;
    bow.normal(modes) = 1.0;
    bow.friction = string.friction;
    return structure;
}

Eigen::VectorXd string_shape(const BowedString& string, int modes, double place) {
    Eigen::VectorXd shape = Eigen::VectorXd::Zero(modes + 1);
    for (int k = 1; k <= modes; ++k)
        shape(k - 1) = std::sqrt(2.0 / mass_of(string)) * base::sine_cosine_of_turns(0.5 * k * place).sine;
    return shape;
}

Eigen::VectorXd helmholtz_motion(const BowedString& string, int modes, double bow_velocity) {
    Eigen::VectorXd velocity = Eigen::VectorXd::Zero(modes + 1);
    const double size = bow_velocity / string.bow_position * std::sqrt(2.0 * mass_of(string));
    for (int k = 1; k <= modes; ++k)
        velocity(k - 1) = (k % 2 == 1 ? size : -size) / (pi_of_modes * k);
    return velocity;
}

double least_bow_force(const BowedString& string, double bow_velocity) {
    const double b = string.bow_position;
    return string.impedance * string.impedance * bow_velocity /
           (2.0 * string.bridge_resistance * b * b *
            (string.friction.static_coefficient - string.friction.kinetic_coefficient));
}

double greatest_bow_force(const BowedString& string, double bow_velocity) {
    return 2.0 * string.impedance * bow_velocity /
           (string.bow_position * (string.friction.static_coefficient - string.friction.kinetic_coefficient));
}

}  // namespace stridor::model
