#pragma once

#include "stridor/model/friction/law.hpp"

namespace stridor::model {

/// How a structure answers impulses at a contact, in coordinates orthogonal under M: P_n changes g' by (P_n + c P_t) /
/// m_g, P_t changes the tangential velocity by P_t / m_x.
struct ContactInertia {
    double normal = 0.0;      // [kg] m_g
    double tangential = 0.0;  // [kg] m_x
    double coupling = 0.0;    // [1] c, slip velocity per gap velocity
};

/// How the surfaces meet.
struct Approach {
    double gap_velocity = 0.0;   // [m/s] g' < 0
    double slip_velocity = 0.0;  // [m/s] w
};

/// What an impact does.
struct Impulses {
    double normal = 0.0;       // [N*s] P_n on the rubbed mass
    double tangential = 0.0;   // [N*s] P_t on the rubbed mass
    double restitution = 0.0;  // [1] e: g' is -e g' after it
    bool stops = false;        // the slip ends
};

/// Impulses that turn g' into -e g', with the tangential impulse in the friction cone: P_t ends the slip if the limit
/// of the stick allows it, else it is the slip's ratio of P_n. Derivation: docs/methods/physics.md.
Impulses impulses_with_friction(const ContactInertia& inertia, const FrictionLaw& friction, const Approach& approach,
                                double restitution);

}  // namespace stridor::model
