#include "stridor/parameters/fields/field.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/field_table.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/fields/field_belongs.hpp"
#include "stridor/parameters/fields/field_ranges.hpp"
#include "stridor/parameters/tables/damping_ratio.hpp"
#include "stridor/parameters/tables/force_table.hpp"
#include "stridor/parameters/tables/friction_table.hpp"
#include "stridor/parameters/tables/material_pair.hpp"
#include "stridor/parameters/tables/temperature_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace stridor::parameters {

namespace {

constexpr std::array<std::string_view, 11> friction_names{
    "coulomb",   "directional", "linear", "stribeck", "stribeck-rational", "table", "lugre",
    "dieterich", "ruina",       "tanh",   "arctan"};
constexpr std::array<std::string_view, 3> stiffening_names{"none", "cubic", "table"};
constexpr std::array<std::string_view, 3> rest_names{"none", "logarithmic", "kato"};
constexpr std::array<std::string_view, 2> creeping_names{"undecided", "judged"};
constexpr std::array<std::string_view, 3> impact_names{"plastic", "normal-only", "restitution"};
constexpr std::array<std::string_view, 4> initial_names{"rest", "stuck", "sliding", "given"};
constexpr std::array<std::string_view, 4> contact_start_names{"by-motion", "stick", "slip", "separation"};
constexpr std::array<std::string_view, 3> formulation_names{"standard", "massless", "both"};
constexpr std::array<std::string_view, 2> early_ending_names{"proven", "never"};

// what a case has once, or a joint of it
template <auto part>
auto& part_of(const auto& at) {
    if constexpr (requires { at.c.*part; })
        return at.c.*part;
    else
        return at.own().*part;
}

template <auto part, auto member>
Quantity quantity(std::string_view unit, Range range, std::optional<UsualRange> usual = {}) {
    return {unit, range, [](CaseView at) { return part_of<part>(at).*member; },
            [](CaseToSet at, double value) { part_of<part>(at).*member = value; }, usual};
}

template <auto part, auto member, typename Enumeration>
Choice choice(std::span<const std::string_view> names, Choice::Canonical canonical = Choice::Canonical::always) {
    return {names, [](CaseView at) { return static_cast<int>(part_of<part>(at).*member); },
            [](CaseToSet at, int index) { part_of<part>(at).*member = static_cast<Enumeration>(index); }, canonical};
}

// the name of a builder's key as an argument of templates
template <std::size_t size>
struct BuilderKeyName {
    char letters[size];
    constexpr BuilderKeyName(const char (&text)[size]) { std::copy_n(text, size, letters); }
    constexpr std::string_view view() const { return {letters, size - 1}; }
};

// a number from which a builder makes the structure: another one makes it anew
template <BuilderKeyName key>
Field builder_field(std::string_view unit, Range range, std::string_view sentence) {
    return {"structure",
            key.view(),
            "",
            sentence,
            Quantity{unit, range,
                     [](CaseView at) {
                         const double* number = recipe_number(at.c, key.view());
                         return number == nullptr ? std::numeric_limits<double>::quiet_NaN() : *number;
                     },
                     [](CaseToSet at, double value) { rebuild(at.c, key.view(), value); }},
            [](CaseView at) { return recipe_number(at.c, key.view()) != nullptr; }};
}

constexpr Text title{[](CaseView at) { return at.c.title; },
                     [](CaseToSet at, std::string_view text) { at.c.title = text; }};
constexpr Text drive_file{[](CaseView at) { return at.c.drive.file; },
                          [](CaseToSet at, std::string_view text) { at.c.drive.file = text; }, Text::Means::file,
                          "velocity.csv"};

constexpr Text friction_table{
    [](CaseView at) { return friction_table_text(at.own().contact.friction_table); },
    [](CaseToSet at, std::string_view text) { at.own().contact.friction_table = parse_friction_table(text); },
    Text::Means::numbers, "0: 0.8, 10 mm/s: 0.7, 100 mm/s: 0.6"};

constexpr Text axial_force{
    [](CaseView at) { return force_table_text(at.own().joint.axial_force); },
    [](CaseToSet at, std::string_view text) { at.own().joint.axial_force = parse_force_table(text); },
    Text::Means::numbers, "0: 0, 1 mm: 2 N, 2 mm: 6 N"};

// whoever names the pair again that is read already keeps what was read
constexpr Text material_pair{[](CaseView at) { return material_pair_text(at.own().contact.pair); },
                             [](CaseToSet at, std::string_view text) {
                                 MaterialPair& pair = at.own().contact.pair;
                                 if (pair.source != text) pair = parse_material_pair(text);
                                 keep_pairs(at.c);
                             },
                             Text::Means::numbers};

const std::array table{
    Field{"", "title", "", "what this case is, in a few words", title, always},

    Field{"joint", "mass", "m1", "mass of the joint",
          quantity<&PlateJoint::joint, &Joint::mass>("kg", positive, octaves(0.01, 1.0)), has_joints},
    Field{"joint", "axial_stiffness", "k1i", "traction-compression stiffness of the joint, along its axis",
          quantity<&PlateJoint::joint, &Joint::axial_stiffness>("N/m", positive, octaves(1e6, 1e8)), has_joints},
    Field{"joint", "flexural_stiffness", "k1j", "bending stiffness of the joint, across its axis",
          quantity<&PlateJoint::joint, &Joint::flexural_stiffness>("N/m", positive, octaves(1e5, 1e7)), has_joints},
    Field{"joint", "axial_damping", "c1i", "damping along the joint's axis",
          quantity<&PlateJoint::joint, &Joint::axial_damping>("N*s/m", not_negative, usual_damping), has_joints},
    Field{"joint", "flexural_damping", "c1j", "damping across the joint's axis",
          quantity<&PlateJoint::joint, &Joint::flexural_damping>("N*s/m", not_negative, usual_damping), has_joints},
    Field{"joint", "incidence_angle", "alpha", "angle from the plate's direction of motion to the joint's axis",
          quantity<&PlateJoint::joint, &Joint::incidence_angle>("deg", Range{-360.0, 360.0}, usual_angle), has_joints},
    Field{"joint", "stiffening", "", "what the joint pushes with beside its stiffness",
          choice<&PlateJoint::joint, &Joint::stiffening, Stiffening>(stiffening_names, Choice::Canonical::unless_first),
          has_joints},
    Field{"joint", "axial_cubic", "k3i",
          "growth of the axial force with the cube of the deflection; below 0 it softens",
          quantity<&PlateJoint::joint, &Joint::axial_cubic>("N/m^3", any, octaves(1e16, 1e19)), has_cubic},
    Field{"joint", "flexural_cubic", "k3j", "the same of the flexural force",
          quantity<&PlateJoint::joint, &Joint::flexural_cubic>("N/m^3", any, octaves(1e14, 1e17)), has_cubic},
    Field{"joint", "axial_force", "", "rows of deflection and axial force, \"0: 0, 1 mm: 2 N\", or their CSV file",
          axial_force, has_axial_force},
    Field{"joint", "initial_tangential", "x1_0", "displacement along the plate at the start, from the preloaded rest",
          quantity<&PlateJoint::start, &JointStart::tangential>("m", any), has_given_joint},
    Field{"joint", "initial_normal", "y1_0", "displacement across the plate at the start; above y2_0 the gap is open",
          quantity<&PlateJoint::start, &JointStart::normal>("m", any), has_given_joint},
    Field{"joint", "initial_tangential_velocity", "vx1_0", "velocity along the plate at the start",
          quantity<&PlateJoint::start, &JointStart::tangential_velocity>("m/s", any), has_given_slip},
    Field{"joint", "initial_normal_velocity", "vy1_0", "velocity across the plate at the start",
          quantity<&PlateJoint::start, &JointStart::normal_velocity>("m/s", any), has_given_joint},

    Field{"plate", "mass", "m2", "moving mass of the plate",
          quantity<&Case::plate, &Plate::mass>("kg", positive, octaves(0.04, 4.0)), has_joints},
    Field{"plate", "stiffness", "k2y", "bending stiffness of the plate",
          quantity<&Case::plate, &Plate::stiffness>("N/m", positive, octaves(1e5, 1e7)), has_joints},
    Field{"plate", "damping", "c2y", "bending damping of the plate",
          quantity<&Case::plate, &Plate::damping>("N*s/m", not_negative, usual_damping), has_joints},
    Field{"plate", "initial_normal", "y2_0", "displacement of the plate at the start, from the preloaded rest",
          quantity<&Case::plate, &Plate::initial_normal>("m", any), has_given_joint},
    Field{"plate", "initial_normal_velocity", "vy2_0", "velocity of the plate at the start",
          quantity<&Case::plate, &Plate::initial_normal_velocity>("m/s", any), has_given_joint},

    Field{"structure", "stiffness_scale", "", "factor of the stiffness of the user's own structure",
          quantity<&Case::structure_scales, &StructureScales::stiffness>("1", positive, octaves(0.1, 10.0)),
          has_own_structure},
    Field{"structure", "damping_scale", "", "factor of all damping of the user's own structure",
          quantity<&Case::structure_scales, &StructureScales::damping>("1", not_negative, octaves(0.1, 10.0)),
          has_own_structure},
    Field{"structure", "spring_scale", "", "factor of what its springs push beside the stiffness",
          quantity<&Case::structure_scales, &StructureScales::springs>("1", not_negative, octaves(0.1, 10.0)),
          has_springs},

    builder_field<"mass">("kg", positive, "of each block of a chain"),
    builder_field<"stiffness">("N/m", positive,
                               "of the spring that ties a block to the ground, along the belt and across it"),
    builder_field<"damping_ratio">("1", not_negative, "share of critical damping of each mode"),
    builder_field<"damping">("N*s/m", not_negative, "beside the spring of a block"),
    builder_field<"coupling">("N/m", not_negative, "stiffness of the springs between neighbours"),
    builder_field<"frequency">("Hz", positive, "of the string's first mode"),
    builder_field<"impedance">("kg/s", positive, "of waves on the string"),
    builder_field<"length">("m", positive, "of the string, or of the beam, which rubs with its tip"),
    builder_field<"bridge_resistance">("kg/s", positive, "of the string's end, where waves lose energy"),
    builder_field<"position">("1", Range{0.0, most_position, Range::Low::open},
                              "of the bow, as a share of the string's length from the near end"),
    builder_field<"mass_per_length">("kg/m", positive, "density of the beam times cross section"),
    builder_field<"bending_stiffness">("N*m^2", positive, "E I"),
    builder_field<"axial_stiffness">("N", positive, "E A"),
    builder_field<"incidence_angle">("deg", Range{-360.0, 360.0},
                                     "from the surface's direction of motion to the beam's axis"),

    Field{"contact", "preload", "F", "force that presses joint and plate together at rest",
          quantity<&PlateJoint::contact, &Contact::preload>("N", positive, usual_preload), has_preload},
    Field{
        "contact", "friction", "",
        "law of friction: the same both ways, other each way, changing with the slip velocity or a state of the "
        "contact",
        choice<&PlateJoint::contact, &Contact::friction, FrictionKind>(friction_names, Choice::Canonical::unless_first),
        always},
    Field{"contact", "static_friction", "mu_s", "friction coefficient while sticking",
          quantity<&PlateJoint::contact, &Contact::static_friction>("1", not_negative, usual_static_friction),
          has_static_friction},
    Field{"contact", "kinetic_friction", "mu_d", "friction coefficient while slipping, at most mu_s",
          quantity<&PlateJoint::contact, &Contact::kinetic_friction>("1", not_negative, usual_kinetic_friction),
          has_kinetic_friction},
    Field{"contact", "friction_slope", "s_mu", "by how much mu_d falls per slip velocity, down to 0",
          quantity<&PlateJoint::contact, &Contact::friction_slope>("s/m", not_negative, octaves(0.05, 5.0)),
          has_friction_slope},
    Field{"contact", "stribeck_velocity", "v_s", "slip velocity over which mu_s falls towards mu_d",
          quantity<&PlateJoint::contact, &Contact::stribeck_velocity>("m/s", positive, octaves(0.005, 0.5)),
          has_stribeck_curve},
    Field{"contact", "stribeck_exponent", "delta", "power of the slip velocity over v_s, 1 or 2 as a rule",
          quantity<&PlateJoint::contact, &Contact::stribeck_exponent>("1", Range{1.0, 20.0}, between(1.0, 2.0)),
          has_stribeck_curve},
    Field{"contact", "viscous_friction", "k_v", "by how much friction rises per slip velocity",
          quantity<&PlateJoint::contact, &Contact::viscous_friction>("s/m", not_negative, between(0.0, 1.0)),
          has_stribeck_curve},
    Field{"contact", "bristle_stiffness", "sigma_0", "stiffness of the bristles that bear friction, per normal force",
          quantity<&PlateJoint::contact, &Contact::bristle_stiffness>("1/m", positive, octaves(1e3, 1e6)),
          has_bristles},
    Field{"contact", "bristle_damping", "sigma_1", "damping of the bristles, per normal force",
          quantity<&PlateJoint::contact, &Contact::bristle_damping>("s/m", not_negative, between(0.0, 100.0)),
          has_bristles},
    Field{"contact", "direct_effect", "a", "by how much friction rises at once with the logarithm of the slip velocity",
          quantity<&PlateJoint::contact, &Contact::direct_effect>("1", positive, octaves(1e-3, 0.1)),
          has_rate_and_state},
    Field{"contact", "evolution_effect", "b", "by how much it falls again as the age of the contacts follows",
          quantity<&PlateJoint::contact, &Contact::evolution_effect>("1", not_negative, octaves(1e-3, 0.1)),
          has_rate_and_state},
    Field{"contact", "slip_length", "D_c", "way of slip over which the age of the contacts follows",
          quantity<&PlateJoint::contact, &Contact::slip_length>("m", positive, octaves(1e-6, 1e-4)),
          has_rate_and_state},
    Field{"contact", "reference_velocity", "V_0", "slip velocity at which steady friction is mu_d",
          quantity<&PlateJoint::contact, &Contact::reference_velocity>("m/s", positive, octaves(1e-6, 0.1)),
          has_rate_and_state},
    Field{"contact", "friction_table", "", "rows of speed and friction, \"0: 0.8, 10 mm/s: 0.6\", or their CSV file",
          friction_table, has_friction_table},
    Field{"contact", "interpolation", "", "between the rows: monotone cubic or linear",
          choice<&PlateJoint::contact, &Contact::interpolation, Interpolation>(interpolation_names),
          has_friction_table},
    Field{"contact", "static_friction_coming", "mu_sc",
          "mu_s of the other way, in which a coming plate drags the joint",
          quantity<&PlateJoint::contact, &Contact::static_friction_coming>("1", not_negative, usual_static_friction),
          has_friction_each_way},
    Field{"contact", "kinetic_friction_coming", "mu_dc", "mu_d of the other way, at most mu_sc",
          quantity<&PlateJoint::contact, &Contact::kinetic_friction_coming>("1", not_negative, usual_kinetic_friction),
          has_friction_each_way},
    Field{"contact", "regularisation", "v_r", "slip velocity over which regularised friction rises",
          quantity<&PlateJoint::contact, &Contact::regularisation>("m/s", positive, octaves(1e-4, 1e-2)), has_no_stick},
    Field{"contact", "rest", "", "how mu_s grows with the time of rest",
          choice<&PlateJoint::contact, &Contact::rest, RestKind>(rest_names, Choice::Canonical::unless_first),
          has_stick},
    Field{"contact", "rest_growth", "A_r", "growth of mu_s for each factor e of the time of rest; kato: in all",
          quantity<&PlateJoint::contact, &Contact::rest_growth>("1", not_negative, between(0.0, 0.2)), has_rest},
    Field{"contact", "rest_time", "t_0", "time of rest after which mu_s has grown",
          quantity<&PlateJoint::contact, &Contact::rest_time>("s", positive, octaves(0.1, 10.0)), has_rest},
    Field{"contact", "rest_exponent", "m_r", "power of the time of rest over t_0",
          quantity<&PlateJoint::contact, &Contact::rest_exponent>("1", Range{0.0, 1.0, Range::Low::open},
                                                                  between(0.2, 1.0)),
          has_rest_exponent},
    Field{"contact", "initial_rest", "t_r", "time for which the contact has stuck when the run begins",
          quantity<&PlateJoint::contact, &Contact::rested>("s", not_negative), has_rest},
    Field{"contact", "pair", "", "pair of materials with its coefficients, \"pairs.toml: EPDM on glass\"",
          material_pair, has_pair},
    Field{"contact", "humidity", "", "relative humidity of the air, at which the pair is read",
          quantity<&PlateJoint::contact, &Contact::humidity>("1", share, between(0.0, 1.0)), follows_humidity},
    Field{"contact", "impact", "", "what happens when a separation ends",
          choice<&PlateJoint::contact, &Contact::impact, ImpactKind>(impact_names), always},
    Field{"contact", "restitution", "e", "velocity after an impact over that before it, impact = restitution",
          quantity<&PlateJoint::contact, &Contact::restitution>("1", share, between(0.0, 1.0)), rebounds},
    Field{"contact", "initial_state", "",
          "what the contact does at the start: what follows from gap and velocities, or as said",
          choice<&PlateJoint::start, &JointStart::contact, ContactStart>(contact_start_names,
                                                                         Choice::Canonical::unless_first),
          has_given_joint},
    Field{"contact", "initial_friction_state", "s_0", "friction state at the start: what bristles bear, or psi",
          quantity<&PlateJoint::start, &JointStart::friction_state>("1", any), has_given_friction_state},

    Field{"temperature", "value", "theta", "temperature of the parts, at which the table below is read",
          quantity<&Case::temperature, &Temperature::value>("degC", temperatures), follows_temperature},

    Field{"drive", "kind", "", "how the plate is moved", choice<&Case::drive, &Drive::kind, DriveKind>(drive_names),
          always},
    Field{"drive", "amplitude", "A_exc", "displacement amplitude of the plate",
          quantity<&Case::drive, &Drive::amplitude>("m", positive, octaves(4e-4, 4e-2)), is_sinusoidal},
    Field{"drive", "frequency", "f_exc", "frequency of the plate's motion, or of the force",
          quantity<&Case::drive, &Drive::frequency>("Hz", positive, usual_frequency), has_frequency},
    Field{"drive", "velocity", "V", "velocity of the plate; going if positive, coming if negative",
          quantity<&Case::drive, &Drive::velocity>("m/s", not_zero, usual_velocity), has_velocity},
    Field{"drive", "force", "F_exc", "amplitude of the force that shakes the structure, in the shape structure.force",
          quantity<&Case::drive, &Drive::force>("N", positive, octaves(0.1, 10.0)), is_driven_by_force},
    Field{"drive", "ramp", "", "time to full velocity, at most a quarter of the period, or to full force",
          quantity<&Case::drive, &Drive::ramp>("s", positive, octaves(2e-3, 0.05)), has_ramp},
    Field{"drive", "phase", "", "how far the drive is in its period when the run begins",
          quantity<&Case::drive, &Drive::phase>("deg", Range{-360.0, 360.0}), has_given_phase},
    Field{"drive", "file", "", "CSV file with the columns time and velocity", drive_file, is_sampled},

    Field{"run", "duration", "", "simulated time", quantity<&Case::run, &Run::duration>("s", positive), always},
    Field{"run", "window", "", "last part of the simulated time, from which all figures are taken",
          quantity<&Case::run, &Run::window>("s", positive), always},
    Field{"run", "initial", "", "how the motion starts", choice<&Case::run, &Run::initial, Initial>(initial_names),
          always},
    Field{"run", "perturbation", "", "tangential velocity added to the steady sliding joint at the start",
          quantity<&Case::run, &Run::perturbation>("m/s", any), starts_sliding},
    Field{"run", "engine", "", "how the motion is computed", choice<&Case::run, &Run::engine, Engine>(engine_names),
          always},
    Field{"run", "early_ending", "", "exact engine, constant drive: stop once silence is proven or a limit cycle found",
          choice<&Case::run, &Run::early_ending, EarlyEnding>(early_ending_names), always},
    Field{"run", "step", "h", "time step of the beta_2 and moreau engines",
          quantity<&Case::run, &Run::step>("s", positive), has_steps},
    Field{"run", "formulation", "", "contacts with their inertia, without, or both to compare",
          choice<&Case::run, &Run::formulation, Formulation>(formulation_names, Choice::Canonical::unless_first),
          has_formulation},
    Field{"run", "massless_above", "",
          "natural frequency above which modes move without inertia; 0: as few modes as the contacts need",
          quantity<&Case::run, &Run::massless_above>("Hz", not_negative), is_massless},
    Field{"run", "beta_2", "beta_2", "0.5: central difference, second order; above it numerical damping, first order",
          quantity<&Case::run, &Run::beta_2>("1", Range{0.5, 1.0}), has_beta_2},

    Field{"verdict", "start", "", "share of the run that is not judged, at its start, while the start dies out",
          quantity<&Case::verdict, &Thresholds::start>("1", before_the_end), has_no_phases},
    Field{"verdict", "settling", "",
          "share of each going or coming phase cut at its start, while the reversal rings down",
          quantity<&Case::verdict, &Thresholds::settling>("1", share), has_phases},
    Field{"verdict", "reversal", "", "share of each going or coming phase cut at its end, where the drive slows down",
          quantity<&Case::verdict, &Thresholds::reversal>("1", share), has_phases},
    Field{"verdict", "quiet_slip", "", "slip share from which a motion makes no noise",
          quantity<&Case::verdict, &Thresholds::quiet_slip>("1", share), always},
    Field{"verdict", "creak_stick", "", "stick share from which a noisy motion is creak",
          quantity<&Case::verdict, &Thresholds::creak_stick>("1", share), always},
    Field{"verdict", "least_releases", "", "fewest ends of sticks that make a creak; fewer are undecided",
          quantity<&Case::verdict, &Thresholds::least_releases>("1", Range{2.0, 1000.0}), always},
    Field{"verdict", "squeal_regularity", "", "regularity from which a noisy motion is squeal, below it squeak",
          quantity<&Case::verdict, &Thresholds::squeal_regularity>("1", share), always},
    Field{"verdict", "squeal_beats", "", "most unequal beats per period of a squeal; 1: all beats alike",
          quantity<&Case::verdict, &Thresholds::squeal_beats>("1", Range{1.0, 12.0}), always},
    Field{"verdict", "squeal_repetition", "",
          "repetition from which a pattern of unequal beats is squeal, too, if it comes again squeal_frequency times",
          quantity<&Case::verdict, &Thresholds::squeal_repetition>("1", share), always},
    Field{"verdict", "squeal_frequency", "", "how often a pattern of unequal beats must come again to be squeal",
          quantity<&Case::verdict, &Thresholds::squeal_frequency>("Hz", Range{0.0, 20000.0}), always},
    Field{"verdict", "least_intervals", "", "fewest repeated intervals that can be judged; fewer are undecided",
          quantity<&Case::verdict, &Thresholds::least_intervals>("1", Range{2.0, 1000.0}), always},
    Field{"verdict", "lock_force", "", "multiple of its preload from which a stuck contact's normal force is locking",
          quantity<&Case::verdict, &Thresholds::lock_force>("1", Range{1.0, 1e9}), always},
    Field{"verdict", "least_distance", "",
          "errors of a figure that it must lie from its threshold; nearer is undecided",
          quantity<&Case::verdict, &Thresholds::least_distance>("1", Range{0.0, 1000.0}), always},
    Field{"verdict", "creeping", "", "verdict of a contact that creeps where it should stick",
          choice<&Case::verdict, &Thresholds::creeping, Creeping>(creeping_names), has_no_stick},
    Field{"verdict", "creep_speed", "w_c", "slip velocity below which a contact that creeps counts as stuck; 0: never",
          quantity<&Case::verdict, &Thresholds::creep_speed>("m/s", not_negative), has_creep},
};

bool contains(const Range& range, double value) {
    const bool above = range.low_end == Range::Low::open ? value > range.low : value >= range.low;
    return above && value <= range.high;
}

std::string range_text(const Range& range, std::string_view unit) {
    const bool is_open = range.low_end == Range::Low::open;
    return base::limits_text(range.low, range.high, unit, is_open ? base::LowEnd::open : base::LowEnd::closed);
}

}  // namespace

std::span<const Field> fields() {
    return table;
}

std::string key_of(const Field& field) {
    return field.section.empty() ? std::string(field.name) : std::string(field.section) + "." + std::string(field.name);
}

namespace {

// key_of(field) == key, without putting it together: this is asked for each line of a file and each field
bool has_key(const Field& field, std::string_view key) {
    if (field.section.empty()) return key == field.name;
    return key.size() == field.section.size() + 1 + field.name.size() && key.starts_with(field.section) &&
           key[field.section.size()] == '.' && key.ends_with(field.name);
}

}  // namespace

bool is_of_builder(const Field& field) {
    return field.section == "structure" && !field.name.ends_with("_scale");
}

bool is_of_start(const Field& field) {
    return field.name.starts_with("initial_") || (field.section == "drive" && field.name == "phase");
}

const Field* find_field(std::string_view key) {
    const auto found =
        std::find_if(table.begin(), table.end(), [&](const Field& field) { return has_key(field, key); });
    return found == table.end() ? nullptr : &*found;
}

namespace {

std::vector<std::string> keys_where(bool (*wanted)(const Field&)) {
    std::vector<std::string> keys;
    for (const Field& field : table)
        if (wanted(field)) keys.push_back(key_of(field));
    return keys;
}

}  // namespace

std::vector<std::string> quantity_keys() {
    return keys_where([](const Field& field) { return std::holds_alternative<Quantity>(field.kind); });
}

std::string nearest_key(std::string_view key) {
    const std::vector<std::string> keys = keys_where([](const Field&) { return true; });
    const std::vector<std::string_view> views(keys.begin(), keys.end());
    return std::string(base::nearest_name(key, views));
}

std::string_view unit_of(const Field& field) {
    const auto* quantity = std::get_if<Quantity>(&field.kind);
    return quantity == nullptr ? std::string_view("1") : quantity->unit;
}

std::string_view unit_of(std::string_view key) {
    const Field* field = field_of(key);
    return field == nullptr ? std::string_view("1") : unit_of(*field);
}

std::vector<Home> homes_of(CaseView at, const Field& field) {
    std::vector<Home> homes;
    for (const Field& other : table) {
        const auto* choice = std::get_if<Choice>(&other.kind);
        if (choice == nullptr) continue;
        for (std::size_t index = 0; index < choice->names.size(); ++index) {
            Case changed = at.c;
            choice->set({changed, at.joint}, static_cast<int>(index));
            if (field.belongs({changed, at.joint})) homes.push_back({&other, choice->names[index]});
        }
    }
    return homes;
}

std::string home_of(CaseView at, const Field& field) {
    const std::vector<Home> homes = homes_of(at, field);
    std::string text;
    for (std::size_t i = 0; i < homes.size(); ++i) {
        const bool goes_on = i > 0 && homes[i].choice == homes[i - 1].choice;
        const bool is_last = i + 1 == homes.size() || homes[i + 1].choice != homes[i].choice;
        if (i > 0) text += goes_on && !is_last ? ", " : " or ";
        if (!goes_on) text += key_of(*homes[i].choice) + " = ";
        text += "\"" + std::string(homes[i].name) + "\"";
    }
    return text;
}

bool names_file(const Field& field) {
    const auto* text = std::get_if<Text>(&field.kind);
    return text != nullptr && text->means == Text::Means::file;
}

double get_quantity(CaseView at, const Field& field) {
    return std::get<Quantity>(field.kind).get(at);
}

namespace {

bool is_temperature_of_table(CaseView at, const Field& field) {
    return has_temperature_table(at.c) && field.section == "temperature";
}

void refuse_follower(CaseView at, const Field& field) {
    if (temperature_column(at, field) != nullptr)
        throw Error(ErrorKind::input, {key_of(field) + " cannot be set", "it follows the temperature by a table",
                                       "Set temperature.value instead, or take it out of [temperature]."});
    if (follows_pair(at, field))
        base::refuse(key_of(field) + " cannot be set", "it follows from contact.pair",
                     "Remove it, or remove contact.pair.");
}

// where the pairs that depend on it end; of the temperature, those of all joints
Range within_pairs(CaseView at, const Field& field, Range range) {
    const bool is_shared = field.section == "temperature";
    for (std::size_t joint = 0; joint < at.c.joints.size(); ++joint) {
        if (!is_shared && joint != at.joint) continue;
        const std::span<const double> nodes = pair_nodes(at.c.joints[joint].contact.pair, field);
        if (!nodes.empty())
            range = {std::max(range.low, nodes.front()), std::min(range.high, nodes.back()), Range::Low::closed};
    }
    return range;
}

bool is_within_pairs(CaseView at, const Field& field) {
    const Range range = within_pairs(at, field, {});
    return std::isfinite(range.low) || std::isfinite(range.high);
}

}  // namespace

Range range_of(CaseView at, const Field& field) {
    const bool has_table = is_temperature_of_table(at, field);
    const Range range = has_table ? Range{at.c.temperature.at.front(), at.c.temperature.at.back()}
                                  : std::get<Quantity>(field.kind).range;
    return within_pairs(at, field, range);
}

void expect_in_range(CaseView at, const Field& field, double value) {
    const auto& quantity = std::get<Quantity>(field.kind);
    const Range range = range_of(at, field);
    if (std::isfinite(value) && contains(range, value)) return;
    const bool is_of_table = is_temperature_of_table(at, field);
    const bool is_of_pair = !is_of_table && is_within_pairs(at, field);
    throw Error(ErrorKind::input,
                {key_of(field) + " = " + base::shortest(value) + " is out of range",
                 "it must be " + (std::isfinite(value) ? range_text(range, quantity.unit) : std::string("finite")) +
                     (is_of_table  ? ", where the table ends"
                      : is_of_pair ? ", where the rows of contact.pair end"
                                   : ""),
                 is_of_table  ? "Extend the table in [temperature]."
                 : is_of_pair ? "Add rows to the pair, or stay within them."
                              : ""});
}

void set_quantity(CaseToSet at, const Field& field, double value) {
    refuse_follower(at, field);
    expect_in_range(at, field, value);
    std::get<Quantity>(field.kind).set(at, value);
    if (std::optional<double>* ratio = damping_ratio_of(at, key_of(field))) ratio->reset();
    keep_temperature_table(at.c);
    keep_pairs(at.c);
    keep_damping_ratios(at.c);
}

void set_from_text(CaseToSet at, const Field& field, std::string_view text) {
    refuse_follower(at, field);
    std::optional<double>* known = damping_ratio_of(at, key_of(field));
    if (const std::optional<double> ratio = known == nullptr ? std::nullopt : parse_damping_ratio(text)) {
        if (!(*ratio >= 0.0 && *ratio <= most_damping_ratio))
            throw Error(ErrorKind::input,
                        {key_of(field) + " = \"" + std::string(text) + "\" is out of range",
                         "a damping ratio must be between 0 and " + base::shortest(most_damping_ratio), ""});
        *known = ratio;
        keep_damping_ratios(at.c);
    } else if (const auto* quantity = std::get_if<Quantity>(&field.kind)) {
        set_quantity(at, field, base::parse_quantity(text, quantity->unit));
    } else if (const auto* choice = std::get_if<Choice>(&field.kind)) {
        choice->set(at, static_cast<int>(base::place_of_choice(key_of(field), base::trimmed(text), choice->names)));
    } else {
        std::get<Text>(field.kind).set(at, text);
    }
}

std::optional<double> damping_ratio(CaseView at, const Field& field) {
    const std::optional<double>* ratio = damping_ratio_of(at, key_of(field));
    return ratio == nullptr ? std::nullopt : *ratio;
}

std::string value_text(CaseView at, const Field& field) {
    if (const std::optional<double> ratio = damping_ratio(at, field)) return damping_ratio_text(*ratio);
    if (std::holds_alternative<Quantity>(field.kind))
        return base::quantity_text(get_quantity(at, field), unit_of(field));
    if (const auto* choice = std::get_if<Choice>(&field.kind))
        return std::string(choice->names[static_cast<std::size_t>(choice->get(at))]);
    return std::get<Text>(field.kind).get(at);
}

bool goes_without_saying(CaseView at, const Field& field) {
    const auto* choice = std::get_if<Choice>(&field.kind);
    return choice != nullptr && choice->canonical == Choice::Canonical::unless_first && choice->get(at) == 0;
}

}  // namespace stridor::parameters
