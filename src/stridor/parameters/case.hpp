#pragma once

#include "stridor/parameters/drive.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What a user chooses: one rubbing system, how it is driven, how long it is watched and how it is judged.
///
/// Names are the field's; the symbols of Elmaian, Gautier, Pezerat, Duffal (2012), "Automotive friction-induced
/// noises", Table 1, stand in the comments. The defaults are that table's squeal case.
namespace stridor::parameters {

/// A force over the deflection as measured.
struct ForceTable {
    std::string file{};  // a CSV with the columns deflection and force; empty: the rows stand in the case
    std::vector<double> deflections{};  // [m] rising, shape [row]
    std::vector<double> forces{};       // [N] there, never falling; shape [row]
    bool operator==(const ForceTable&) const = default;
};

/// What a joint pushes with beside its stiffness, over how far it is pressed.
enum class Stiffening {
    none,
    cubic,  // k3 e³ along its axis and across it
    table,  // as measured, along its axis
};

/// Mass 1, the rubbed joint: a point mass on two springs and dashpots along and across its own axis.
struct Joint {
    double mass = 0.1;                // [kg] m1
    double axial_stiffness = 1e7;     // [N/m] k1i, traction-compression, along i = (cos a, sin a)
    double flexural_stiffness = 1e6;  // [N/m] k1j, bending, along j = (-sin a, cos a)
    double axial_damping = 1.0;       // [N*s/m] c1i
    double flexural_damping = 1.0;    // [N*s/m] c1j
    double incidence_angle = 70.0;    // [deg] a, from the plate's x axis to i, counter-clockwise
    Stiffening stiffening = Stiffening::none;
    double axial_cubic = 0.0;     // [N/m³] cubic: k3i; below 0 it softens
    double flexural_cubic = 0.0;  // [N/m³] cubic: k3j
    ForceTable axial_force{};     // table
};

/// Mass 2, the plate: it bends across the contact (y) and is moved along it (x) by the drive.
struct Plate {
    double mass = 0.4;       // [kg] m2
    double stiffness = 1e6;  // [N/m] k2y
    double damping = 1.0;    // [N*s/m] c2y
    // initial = given
    double initial_normal = 0.0;           // [m] y2 at the start, from the preloaded rest
    double initial_normal_velocity = 0.0;  // [m/s]
};

/// One property by table over the temperature.
struct TemperatureColumn {
    /// What the values are: the quantity, or a damping as a share of critical.
    enum class Holds { quantity, damping_ratio };
    std::string key;             // of its field: "joint.axial_stiffness"
    std::vector<double> values;  // at the nodes, in the field's unit or a share of critical [1], shape [node]
    Holds holds = Holds::quantity;
};

/// The temperature of the parts and the properties that follow it by table, linear between nodes. Who sets it through
/// its field sets them with it; their numbers stand in `Joint`, `Plate` and `Contact`, which alone decide the
/// motion.
struct Temperature {
    double value = 23.0;                       // [degC]
    std::vector<double> at{};                  // [degC] nodes, rising, shape [node]; none: nothing follows
    std::vector<TemperatureColumn> columns{};  // in the order of the field table
};

/// What happens when a separation ends.
enum class ImpactKind {
    plastic,      // no rebound; the tangential impulse obeys the same friction cone as the forces
    normal_only,  // no rebound and no tangential impulse
    restitution,  // rebound with a share of the closing velocity; the tangential impulse as in plastic
};

/// The law of friction.
enum class FrictionKind {
    coulomb,            // two coefficients, the same both ways
    directional,        // two coefficients each way: bristles, fibres, a grain
    linear,             // that of the slip falls linearly with the slip velocity
    stribeck,           // it falls from mu_s to mu_d by an exponential of the slip velocity
    stribeck_rational,  // it falls by a quotient
    table,              // it is measured over the slip velocity
    lugre,              // it is borne by bristles that bend: a state of the contact
    dieterich,          // rate and state: the age of the contacts, by the ageing law
    ruina,              // the same by the slip law
    tanh,               // no stick: a smooth step through zero, for comparison with other programs
    arctan,             // a slower one
};

/// How static friction grows with the time that a contact has stuck.
enum class RestKind {
    none,         // it does not
    logarithmic,  // by the logarithm of that time: rocks, metals, polymers
    kato,         // towards an end: lubricated slideways
};

/// Says whether coefficients of the law are the same as long as the contact sticks, or slips one way.
constexpr bool is_state_wise(FrictionKind kind) {
    return kind == FrictionKind::coulomb || kind == FrictionKind::directional;
}

/// Says whether the law puts a steep slope in the place of sticking. Such motions creep where they should stick.
constexpr bool is_regularised(FrictionKind kind) {
    return kind == FrictionKind::tanh || kind == FrictionKind::arctan;
}

/// Says whether the law has a friction state (model/laws/friction). Such a contact creeps, and never sticks.
constexpr bool has_friction_state(FrictionKind kind) {
    return kind == FrictionKind::lugre || kind == FrictionKind::dieterich || kind == FrictionKind::ruina;
}

/// How friction runs between the rows of a table over the slip velocity.
enum class Interpolation {
    cubic,   // monotone from row to row, with a continuous slope
    linear,  // straight from row to row
};
inline constexpr std::array<std::string_view, 2> interpolation_names{"cubic", "linear"};

/// Friction as measured over the slip velocity.
struct FrictionTable {
    std::string file;                  // a CSV with the columns speed and friction; empty: the rows stand in the case
    std::vector<double> speeds;        // [m/s] rising from 0, shape [row]
    std::vector<double> coefficients;  // [1] there, shape [row]
};

/// Friction coefficients of a pair of materials, and other numbers of its law, at the points of a grid over what they
/// depend on.
struct MaterialPair {
    std::string source;                      // "pairs.toml: EPDM on glass", or the table as text; empty: there is none
    std::vector<double> temperature{};       // [degC] nodes, rising; none: it does not depend on it
    std::vector<double> humidity{};          // [1] relative, the same
    std::vector<double> load{};              // [N] preload of the contact, the same
    std::vector<double> static_friction{};   // [1] mu_s, shape [temperature, humidity, load]; none: file not read
    std::vector<double> kinetic_friction{};  // [1] mu_d <= mu_s, the same shape
    // numbers of the case's law at the same points, as those of Contact; none: the case says them
    std::vector<double> friction_slope{};     // [s/m]
    std::vector<double> stribeck_velocity{};  // [m/s]
    std::vector<double> stribeck_exponent{};  // [1]
    std::vector<double> viscous_friction{};   // [s/m]
    std::vector<double> rest_growth{};        // [1]
};

/// The contact between joint and plate: Coulomb friction with two coefficients (Figure 3), or another law.
struct Contact {
    double preload = 20.0;  // [N] F, pressing force at rest
    FrictionKind friction = FrictionKind::coulomb;
    double static_friction = 0.8;     // [1] mu_s
    double kinetic_friction = 0.6;    // [1] mu_d, of a slip that begins, at most mu_s
    double friction_slope = 0.5;      // [s/m] linear: by how much mu_d falls per slip velocity, down to 0
    double stribeck_velocity = 0.05;  // [m/s] stribeck: v_s, a slip velocity over which mu_s falls to mu_d
    double stribeck_exponent = 1.0;   // [1] stribeck: delta, of the slip velocity over v_s, at least 1
    double viscous_friction = 0.0;    // [s/m] stribeck: k_v, by how much friction rises per slip velocity
    FrictionTable friction_table{};   // table
    Interpolation interpolation = Interpolation::cubic;  // table
    double regularisation = 1e-3;                        // [m/s] tanh, arctan: v_r, the width of the step through zero
    RestKind rest = RestKind::none;                      // of any law that sticks
    double rest_growth = 0.02;         // [1] logarithmic: A, for each factor e of the time of rest; kato: mu_inf - mu_s
    double rest_time = 1.0;            // [s] t_0, a time of rest after which mu_s has grown
    double rest_exponent = 0.5;        // [1] kato: m, of the time of rest over t_0
    double rested = 0.0;               // [s] for which it has stuck when a run begins
    double bristle_stiffness = 1e5;    // [1/m] lugre: sigma_0, of the bristles per normal force
    double bristle_damping = 0.0;      // [s/m] lugre: sigma_1, likewise
    double direct_effect = 0.01;       // [1] dieterich, ruina: a, of a change of the slip velocity at once
    double evolution_effect = 0.015;   // [1] dieterich, ruina: b, of the age that follows
    double slip_length = 1e-5;         // [m] dieterich, ruina: D_c, over which the age follows
    double reference_velocity = 1e-3;  // [m/s] dieterich, ruina: V_0, of a steady slip with mu_d
    double static_friction_coming = 0.8;   // [1] directional: mu_s where the plate drags the joint coming, T < 0
    double kinetic_friction_coming = 0.6;  // [1] directional: mu_d there
    ImpactKind impact = ImpactKind::plastic;
    double restitution = 0.5;  // [1] impact = restitution: velocity after over velocity before an impact
    MaterialPair pair{};       // whose coefficients and numbers of the law are, if there is one
    double humidity = 0.5;     // [1] pair: relative, of the air
};

/// Says whether static friction of the contact grows with the time of rest. Without a stick none does.
constexpr bool grows_with_rest(const Contact& contact) {
    return contact.rest != RestKind::none && !is_regularised(contact.friction) && !has_friction_state(contact.friction);
}

/// Where a motion begins.
enum class Initial {
    rest,     // the preloaded rest position, mass 1 not moving; the plate moves under it
    stuck,    // the preloaded rest position, mass 1 moving with the plate
    sliding,  // the steady-sliding equilibrium, with mass 1 pushed by `perturbation`
    given,    // where the user says
};

/// What a contact does at a start that is given.
enum class ContactStart {
    by_motion,   // what follows from gap and velocities
    stick,       // it moves with its surface
    slip,        // it is closed, and slips
    separation,  // it is open, or opens
};

/// Where a joint is at a start that is given, from the preloaded rest.
struct JointStart {
    double tangential = 0.0;           // [m] x1
    double normal = 0.0;               // [m] y1
    double tangential_velocity = 0.0;  // [m/s] means nothing to a contact that sticks
    double normal_velocity = 0.0;      // [m/s]
    ContactStart contact = ContactStart::by_motion;
    double friction_state = 0.0;  // [1] of a law that has one
};

/// What computes a motion.
enum class Engine {
    exact,      // from event to event, without time-discretisation error
    beta_2,     // the paper's time stepping
    moreau,     // time stepping for many contacts, compared with itself at twice the step
    automatic,  // exact where it can, else moreau (`engine_of`)
};
inline constexpr std::array<std::string_view, 4> engine_names{"exact", "beta_2", "moreau", "auto"};

/// What the moreau engine makes of the inertia at contacts.
enum class Formulation {
    standard,  // as the structure has it: surfaces that meet have an impact
    massless,  // contacts move without inertia, and have no impacts
    both,      // standard, and massless beside it to compare
};

/// May a run end before its time, with its record filled to the end?
enum class EarlyEnding {
    proven,  // exact engine, constant drive: once silence is proven or a limit cycle found
    never,
};

/// How long the system is watched and how its motion is computed.
struct Run {
    double duration = 1.0;  // [s] simulated time
    double window = 1.0;    // [s] the last part of it, from which figures are taken
    Initial initial = Initial::rest;
    double perturbation = 1e-3;  // [m/s] initial = sliding: tangential velocity added to mass 1
    Engine engine = Engine::exact;
    EarlyEnding early_ending = EarlyEnding::proven;
    double step = 1e-6;                               // [s] h, beta_2 and moreau: time step
    Formulation formulation = Formulation::standard;  // moreau
    double massless_above = 0.0;  // [Hz] massless: modes above move without inertia; 0: as few as contacts need
    double beta_2 = 0.5;          // [1] beta_2: 0.5 central difference, second order; above it damps, first order
};

/// What a contact comes to whose regularised friction lets it creep where it should stick.
enum class Creeping {
    undecided,  // its states are none of a rubbing contact
    judged,     // as any other, since a user asks for it
};

/// Where one category ends and the next begins. The paper chose its values by judgement and does not print them;
/// these are Stridor's, documented with their reasons in docs/methods/verdict.md.
struct Thresholds {
    double start = 0.5;               // [1] constant drive: share of the run cut at its start, while that dies out
    double settling = 0.45;           // [1] share of a going or coming phase cut at its start: the reversal's ringing
    double reversal = 0.15;           // [1] share cut at its end, where the drive slows down and every contact sticks
    double quiet_slip = 0.98;         // [1] slip share from which a motion is `none`
    double creak_stick = 0.7;         // [1] stick share from which a noisy motion is `creak`
    double least_releases = 3.0;      // [1] fewest ends of sticks that make a creak; fewer are no repetition
    double squeal_regularity = 0.8;   // [1] regularity from which a noisy motion is `squeal`, below it `squeak`
    double squeal_beats = 1.0;        // [1] most unequal beats per period of a squeal; 1: all beats alike
    double squeal_repetition = 0.95;  // [1] repetition from which a pattern of unequal beats is `squeal`, too, ...
    double squeal_frequency = 20.0;   // [Hz] ... if it comes again so often
    double least_intervals = 6.0;     // [1] fewest repeats that can be judged; fewer are `undecided`
    double lock_force = 10.0;         // [1] multiple of its preload from which a stuck contact locks
    double least_distance = 2.0;  // [1] errors of a figure; one that lies nearer to its threshold makes it `undecided`
    Creeping creeping = Creeping::undecided;
    double creep_speed = 0.0;  // [m/s] of a law with a state: a slip below it counts as a stick; 0: none does
};

/// A joint on the plate and its contact.
///
/// A damping may be known as a share of the critical damping of its own spring and mass, zeta = c / (2 sqrt(k m)). Who
/// sets a stiffness or mass through its field keeps that share and changes the damping with it; empty: the damping is a
/// number of its own. The N*s/m that follow stand in `Joint` and `Plate`, which alone decide the motion.
struct PlateJoint {
    Joint joint{};
    Contact contact{};
    JointStart start{};                   // initial = given
    std::string name{};                   // "lip2", by which keys call it: "joint.lip2.mass"; an only one may have none
    std::optional<double> axial_ratio{};  // [1] of joint.axial_damping: with m1 and k1i
    std::optional<double> flexural_ratio{};  // [1] of joint.flexural_damping: with m1 and k1j
};

struct OwnStructure;  // own_structure.hpp

/// What may be varied of a structure of the user's own.
struct StructureScales {
    double stiffness = 1.0;  // [1] of its stiffness matrix
    double damping = 1.0;    // [1] of all its damping
    double springs = 1.0;    // [1] of what its springs push beside that matrix, which `stiffness` is a factor of, too
};

/// One complete case: joints on a plate, or a structure of the user's own in their place.
struct Case {
    std::string title;
    std::vector<PlateJoint> joints{PlateJoint{}};  // one at least
    Plate plate{};
    std::optional<double> plate_damping_ratio{};  // [1] as those of `PlateJoint`, with m2 and k2y
    // where there is one, joints and plate mean nothing, but for the first contact: it is that of all which say nothing
    // else; shared, since it is large and never changed
    std::shared_ptr<const OwnStructure> own_structure{};
    StructureScales structure_scales{};
    Drive drive;
    Run run;
    Thresholds verdict;
    Temperature temperature{};

    /// Returns the first joint, and its contact.
    Joint& joint() { return joints.front().joint; }
    const Joint& joint() const { return joints.front().joint; }
    Contact& contact() { return joints.front().contact; }
    const Contact& contact() const { return joints.front().contact; }
};

/// Returns the drive of a case's run. Its phase belongs to a given start: every other run begins with the drive.
inline Drive drive_of_run(const Case& c) {
    Drive drive = c.drive;
    if (c.run.initial != Initial::given) drive.phase = 0.0;
    return drive;
}

/// Says whether each joint has its own keys, "joint.lip2.mass".
inline bool has_several_joints(const Case& c) {
    return c.joints.size() > 1;
}

/// A case as a joint of it is asked of fields; a case by itself stands for its first joint.
struct CaseView {
    CaseView(const Case& of, std::size_t number = 0) : c(of), joint(number) {}
    const PlateJoint& own() const { return c.joints[joint]; }

    const Case& c;
    std::size_t joint;
};

/// A joint of a case of which fields are changed; a case by itself stands for its first joint.
struct CaseToSet {
    CaseToSet(Case& of, std::size_t number = 0) : c(of), joint(number) {}
    operator CaseView() const { return {c, joint}; }
    PlateJoint& own() const { return c.joints[joint]; }

    Case& c;
    std::size_t joint;
};

}  // namespace stridor::parameters
