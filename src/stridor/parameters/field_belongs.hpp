#pragma once

#include "stridor/parameters/case.hpp"
#include "stridor/parameters/drive.hpp"
#include "stridor/parameters/own_structure.hpp"

#include <algorithm>

/// Which cases have a field: the answers to Field::belongs. A field that means nothing for a case is not asked for.
namespace stridor::parameters {

inline bool always(const Case&) {
    return true;
}
inline bool has_joints(const Case& c) {
    return !c.own_structure;
}
inline bool has_own_structure(const Case& c) {
    return c.own_structure != nullptr;
}
inline bool has_preload(const Case& c) {
    return !c.own_structure || is_preloaded(*c.own_structure);
}
/// Do all contacts of an own structure say it themselves?
template <auto member>
inline bool all_say(const Case& c) {
    return c.own_structure && std::all_of(c.own_structure->contacts.begin(), c.own_structure->contacts.end(),
                                          [](const OwnContact& contact) { return (contact.*member).has_value(); });
}
inline bool has_static_friction(const Case& c) {
    return !all_say<&OwnContact::static_friction>(c);
}
inline bool has_kinetic_friction(const Case& c) {
    return !all_say<&OwnContact::kinetic_friction>(c);
}
inline bool is_sinusoidal(const Case& c) {
    return c.drive.kind == DriveKind::sinusoidal;
}
inline bool is_constant(const Case& c) {
    return c.drive.kind == DriveKind::constant;
}
inline bool is_sampled(const Case& c) {
    return c.drive.kind == DriveKind::sampled;
}
inline bool is_trapezoidal(const Case& c) {
    return c.drive.kind == DriveKind::trapezoidal;
}
inline bool is_driven_by_force(const Case& c) {
    return is_by_force(c.drive);
}
inline bool has_frequency(const Case& c) {
    return is_sinusoidal(c) || is_trapezoidal(c) || is_driven_by_force(c);
}
inline bool has_ramp(const Case& c) {
    return is_trapezoidal(c) || is_driven_by_force(c);
}
inline bool has_velocity(const Case& c) {
    return is_constant(c) || is_trapezoidal(c);
}
inline bool has_phases(const Case& c) {
    return !has_one_phase(c.drive);
}
inline bool has_no_phases(const Case& c) {
    return has_one_phase(c.drive);
}
inline bool has_friction_each_way(const Case& c) {
    return c.contact.friction == FrictionKind::directional;
}
inline bool has_friction_slope(const Case& c) {
    return c.contact.friction == FrictionKind::linear;
}
inline bool rebounds(const Case& c) {
    return c.contact.impact == ImpactKind::restitution;
}
inline bool has_steps(const Case& c) {
    return c.run.engine != Engine::exact;
}
inline bool has_beta_2(const Case& c) {
    return c.run.engine == Engine::beta_2;
}
inline bool has_formulation(const Case& c) {
    return c.run.engine == Engine::moreau;
}
inline bool is_massless(const Case& c) {
    return has_formulation(c) && c.run.formulation != Formulation::standard;
}
inline bool starts_sliding(const Case& c) {
    return c.run.initial == Initial::sliding;
}

}  // namespace stridor::parameters
