#pragma once

#include "stridor/model/laws/friction.hpp"
#include "stridor/parameters/case.hpp"

#include <variant>

/// The end of a separation. A law is a struct of its numbers and its answer; the engines hold an `ImpactLaw`, call
/// `impulses` and know no law. A new law is a struct here and its name in the list; tests/contract/impact_contract.cpp
/// says what it must keep.
namespace stridor::model {

/// How a structure answers impulses at a contact, in coordinates orthogonal under M: P_n changes g' by (P_n + c P_t) /
/// m_g, P_t changes the tangential velocity by P_t / m_x.
struct ContactInertia {
    double normal = 0.0;      // [kg] m_g
    double tangential = 0.0;  // [kg] m_x
    double coupling = 0.0;    // [1] c, slip velocity per gap velocity
};

/// The velocities with which the surfaces meet.
struct Approach {
    double gap_velocity = 0.0;   // [m/s] g' < 0
    double slip_velocity = 0.0;  // [m/s] w
};

/// The impulses of an impact, and how it leaves the contact.
struct Impulses {
    double normal = 0.0;       // [N*s] P_n on the rubbed mass
    double tangential = 0.0;   // [N*s] P_t on the rubbed mass
    double restitution = 0.0;  // [1] e: g' is -e g' after it
    bool stops = false;        // the slip ends
};

/// No rebound; the tangential impulse obeys the same friction cone as the forces. The limit of the beta_2 scheme as h
/// -> 0.
struct Plastic {
    bool operator==(const Plastic&) const = default;
};

/// No rebound and no tangential impulse.
struct NormalOnly {
    bool operator==(const NormalOnly&) const = default;
};

/// Newton's law: the surfaces part with a share of the velocity at which they met. The tangential impulse is that of
/// `Plastic`.
struct Restitution {
    double coefficient = 0.0;  // [1] e, in [0, 1)

    bool operator==(const Restitution&) const = default;
};

using ImpactLaw = std::variant<Plastic, NormalOnly, Restitution>;

/// Returns the impulses of one impact. They never add kinetic energy beyond the work of the moving surface.
///
/// With friction they turn g' into -e g', with the tangential impulse in the cone of friction: P_t ends the slip if the
/// limit of the stick allows it, else it is the slip's ratio of P_n. Derivation: docs/methods/physics.md.
Impulses impulses(const ImpactLaw& law, const ContactInertia& inertia, const FrictionLaw& friction,
                  const Approach& approach);

/// Returns the impact law of a case's contact.
ImpactLaw impact_law(const parameters::Contact& contact);

}  // namespace stridor::model
