#pragma once

#include "stridor/parameters/case.hpp"
#include "stridor/parameters/drive.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/parameters/system.hpp"

#include <algorithm>

/// Which cases have a field: the answers to Field::belongs. A field that means nothing for a case is not asked for.
namespace stridor::parameters {

inline bool always(CaseView) {
    return true;
}
inline bool has_joints(CaseView at) {
    return has_plate(at.c);
}
inline bool has_cubic(CaseView at) {
    return has_joints(at) && at.own().joint.stiffening == Stiffening::cubic;
}
inline bool has_axial_force(CaseView at) {
    return has_joints(at) && at.own().joint.stiffening == Stiffening::table;
}
inline bool follows_temperature(CaseView at) {
    return !at.c.temperature.at.empty() ||
           std::any_of(at.c.joints.begin(), at.c.joints.end(),
                       [](const PlateJoint& joint) { return !joint.contact.pair.temperature.empty(); });
}
inline bool has_pair(CaseView at) {
    return !at.own().contact.pair.source.empty();
}
inline bool follows_humidity(CaseView at) {
    return !at.own().contact.pair.humidity.empty();
}
inline bool has_own_structure(CaseView at) {
    return !has_plate(at.c);
}
inline bool has_springs(CaseView at) {
    return !has_plate(at.c) && !names_of_springs(at.c).empty();
}
inline bool has_preload(CaseView at) {
    return is_preloaded(at.c);
}
/// Says whether all contacts of an own structure say it themselves.
template <auto member>
inline bool all_say(CaseView at) {
    return at.c.own_structure && std::all_of(at.c.own_structure->contacts.begin(), at.c.own_structure->contacts.end(),
                                             [](const OwnContact& contact) { return (contact.*member).has_value(); });
}
inline bool has_friction_table(CaseView at) {
    return at.own().contact.friction == FrictionKind::table;
}
inline bool has_no_stick(CaseView at) {
    return is_regularised(at.own().contact.friction);
}
inline bool has_bristles(CaseView at) {
    return at.own().contact.friction == FrictionKind::lugre;
}
inline bool has_rate_and_state(CaseView at) {
    return has_friction_state(at.own().contact.friction) && !has_bristles(at);
}
inline bool has_creep(CaseView at) {
    return has_friction_state(at.own().contact.friction);
}
inline bool has_stick(CaseView at) {
    return !has_no_stick(at) && !has_friction_state(at.own().contact.friction);
}
inline bool has_rest(CaseView at) {
    return grows_with_rest(at.own().contact);
}
inline bool has_rest_exponent(CaseView at) {
    return has_rest(at) && at.own().contact.rest == RestKind::kato;
}
inline bool has_static_friction(CaseView at) {
    return !has_no_stick(at) && !has_rate_and_state(at) && !all_say<&OwnContact::static_friction>(at);
}
inline bool has_kinetic_friction(CaseView at) {
    return !has_friction_table(at) && !all_say<&OwnContact::kinetic_friction>(at);
}
inline bool is_sinusoidal(CaseView at) {
    return at.c.drive.kind == DriveKind::sinusoidal;
}
inline bool is_constant(CaseView at) {
    return at.c.drive.kind == DriveKind::constant;
}
inline bool is_sampled(CaseView at) {
    return at.c.drive.kind == DriveKind::sampled;
}
inline bool is_trapezoidal(CaseView at) {
    return at.c.drive.kind == DriveKind::trapezoidal;
}
inline bool is_driven_by_force(CaseView at) {
    return is_by_force(at.c.drive);
}
inline bool has_frequency(CaseView at) {
    return is_sinusoidal(at) || is_trapezoidal(at) || is_driven_by_force(at);
}
inline bool has_ramp(CaseView at) {
    return is_trapezoidal(at) || is_driven_by_force(at);
}
inline bool has_velocity(CaseView at) {
    return is_constant(at) || is_trapezoidal(at);
}
inline bool has_phases(CaseView at) {
    return !has_one_phase(at.c.drive);
}
inline bool has_no_phases(CaseView at) {
    return has_one_phase(at.c.drive);
}
inline bool has_friction_each_way(CaseView at) {
    return at.own().contact.friction == FrictionKind::directional;
}
inline bool has_friction_slope(CaseView at) {
    return at.own().contact.friction == FrictionKind::linear;
}
inline bool has_stribeck_curve(CaseView at) {
    const FrictionKind kind = at.own().contact.friction;
    return kind == FrictionKind::stribeck || kind == FrictionKind::stribeck_rational || kind == FrictionKind::lugre;
}
inline bool rebounds(CaseView at) {
    return at.own().contact.impact == ImpactKind::restitution;
}
// a choice that is left to the program may fall on steps
inline bool has_steps(CaseView at) {
    return at.c.run.engine != Engine::exact;
}
inline bool has_beta_2(CaseView at) {
    return at.c.run.engine == Engine::beta_2;
}
inline bool has_formulation(CaseView at) {
    return at.c.run.engine == Engine::moreau || at.c.run.engine == Engine::automatic;
}
inline bool is_massless(CaseView at) {
    return has_formulation(at) && at.c.run.formulation != Formulation::standard;
}
inline bool starts_where_given(CaseView at) {
    return at.c.run.initial == Initial::given;
}
inline bool has_given_joint(CaseView at) {
    return starts_where_given(at) && has_joints(at);
}
inline bool has_given_slip(CaseView at) {
    return has_given_joint(at) && at.own().start.contact != ContactStart::stick;
}
inline bool has_given_friction_state(CaseView at) {
    return has_given_joint(at) && has_friction_state(at.own().contact.friction);
}
inline bool has_given_phase(CaseView at) {
    return starts_where_given(at) && has_frequency(at);
}
inline bool starts_sliding(CaseView at) {
    return at.c.run.initial == Initial::sliding;
}

}  // namespace stridor::parameters
