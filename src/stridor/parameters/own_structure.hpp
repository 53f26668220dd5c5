#pragma once

#include "stridor/parameters/case.hpp"
#include "stridor/parameters/own_spring.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// A structure of the user's own, linear but for its springs, with the points where it rubs: a chain, a string, a part
/// of a finite-element program. It takes the place of joint and plate in a case; contact, drive, run and thresholds
/// stay.
namespace stridor::parameters {

/// Most rows: its matrices are dense, and a motion costs their number with each step.
inline constexpr std::size_t most_rows = 2000;
/// Most contacts: each event solves for all that touch.
inline constexpr std::size_t most_contacts = 300;

/// A point where an own structure rubs on a surface that moves, or two parts of it on each other.
struct OwnContact {
    std::string name{};             // "lip 1"
    std::vector<double> normal{};   // [1] n, shape [row]: gap g = g0 + n.u
    std::vector<double> tangent{};  // [1] t, shape [row]: tangential position t.u
    // [1] the other direction of slip, at right angles to both; shape [row]; empty: slip is along t alone
    std::vector<double> second_tangent{};
    double initial_gap = 0.0;  // [m] g0, of the structure without load; negative: pressed together so far
    std::string interface {};  // contacts of one name are judged as a whole; empty: with all others of no name
    std::optional<double> static_friction{};          // [1] mu_s in the place of the case's
    std::optional<double> kinetic_friction{};         // [1] mu_d likewise
    double preload_share = 0.0;                       // [1] of contact.preload, all shares being one together
    double drive_share = 1.0;                         // [1] of V(t) that the surface has here
    double second_drive_share = 0.0;                  // [1] of V(t) along the second tangent
    double initial_friction_state = 0.0;              // [1] at the start, of a law that has one
    std::optional<std::array<double, 3>> position{};  // [m] where it is, for pictures; it changes no result
    std::optional<double> rested{};                   // [s] for which it has stuck at the start, in the case's place
};

/// A point of the line as which an own structure is drawn, be it a string or a beam. It changes no result.
struct OutlinePoint {
    std::array<double, 3> position{};  // [m] at rest: along the sliding direction, along the normal, across both
    std::vector<double> along{};       // [1] it moves along.u along the sliding direction; shape [row]
    std::vector<double> across{};      // [1] and across.u along the normal; shape [row]
};

/// A point of an own structure whose motion is wanted: it is heard and stands in traces, and changes no result.
struct OwnOutput {
    std::string name{};             // "glass"
    std::vector<double> weights{};  // [1] its motion is weights.u; shape [row]
};

/// Dampings of an own structure that follow its mass and stiffness; they add up.
struct FollowingDamping {
    double ratio = 0.0;               // [1] zeta, of each mode of the structure without contacts
    double loss_factor = 0.0;         // [1] eta, structural: taken as zeta = eta/2 of each mode, at its own frequency
    double rayleigh_mass = 0.0;       // [1/s] alpha of C = alpha M + beta K
    double rayleigh_stiffness = 0.0;  // [s] beta
};

struct OwnStructure;

/// From what a builder makes a structure: kept, so that it can make it anew with another value.
struct Recipe {
    std::string builder{};                                 // "string"
    std::map<std::string, double, std::less<>> numbers{};  // by key: quantities in their field's unit, and counts
    std::map<std::string, std::string, std::less<>> words{};
    OwnStructure (*build)(const Recipe&) = nullptr;  // of the model, which stands after this
};

/// Matrices, row by row, with what is at their rows. Units are SI; a modal coordinate has one of its own.
struct OwnStructure {
    std::string origin{};             // what it was made from: "chain of 2 blocks", "block.nc"
    std::vector<std::string> row{};   // name of each, shape [row]
    std::vector<double> mass{};       // [kg] shape [row][row], symmetric, positive definite
    std::vector<double> stiffness{};  // [N/m] shape [row][row], symmetric
    std::vector<double> damping{};    // [N*s/m] shape [row][row], symmetric; empty: none but what follows
    FollowingDamping following{};
    std::vector<double> load{};                  // [N] constant, beside the preload; shape [row] or empty
    std::vector<double> force{};                 // [1] of a drive by force, per its newtons; shape [row] or empty
    std::vector<double> initial_displacement{};  // [m] added to the start; shape [row] or empty
    // [1] added to the start, per imposed velocity; [m/s] where run.initial is given; shape [row] or empty
    std::vector<double> initial_velocity{};
    double left_out_above = 0.0;  // [Hz] modes above it were left out, and their flexibility kept; 0: none were
    std::vector<OwnContact> contacts{};
    std::vector<OwnOutput> outputs{};
    std::vector<OwnSpring> springs{};     // beside the stiffness
    std::vector<OutlinePoint> outline{};  // in their order along it; empty: unknown
    std::optional<Recipe> recipe{};       // what a builder made it from; nothing: it was none
};

/// Returns a row without mass; `std::nullopt` if all have one.
std::optional<std::size_t> massless_row(const OwnStructure& structure);

/// Returns the number for `key` in the recipe of a case's structure; null if no builder made it, or not from this
/// number.
const double* recipe_number(const Case& c, std::string_view key);

/// Says whether a structure that a builder made starts with other velocities than the builder's.
bool has_given_velocity(const OwnStructure& own);

/// Builds the structure of a case again with another number for `key` in its recipe. Does nothing if the recipe lacks
/// the key.
void rebuild(Case& c, std::string_view key, double value);

/// Returns what changes a result, as a hash: the same for equal numbers, whatever file they came from.
std::string content_hash(const OwnStructure& structure);

/// Returns number of each contact's interface, from 0 in the order of their contacts; shape [contact].
std::vector<int> interface_numbers(const OwnStructure& structure);

/// Returns where each contact is along the line of contacts [m], from the first end of it: its position along the
/// longest side of the box around all. Empty where a position is not known, or all are one; shape [contact].
std::vector<double> places_along_line(const OwnStructure& structure);

/// Says whether a case has a structure that no builder makes. Its matrices cannot be changed by keys.
bool has_given_structure(const Case& c);

}  // namespace stridor::parameters
