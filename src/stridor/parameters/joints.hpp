#pragma once

#include "stridor/parameters/fields/field.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Cases with several joints on one plate. Each joint has a name, and the keys of `[joint]` and `[contact]` below it:
/// "joint.lip2.mass", "joint.lip2.contact.preload".
namespace stridor::parameters {

/// Most joints of a case: with ten the event-driven engine is at its limit.
inline constexpr std::size_t most_joints = 16;

/// Returns the name of a joint; "joint" where there is only one.
std::string joint_name(const Case& c, std::size_t joint);

/// Says whether it is a field of [joint] or [contact], of which each of several joints has its own.
bool is_of_joint(const Field& field);

/// Returns the case of two lips of a seal on one pane: Table 1's joint twice, leaning differently, on a plate that
/// moves evenly.
Case two_lips();

/// A spring of a joint that is not linear.
enum class JointSpring { axial, flexural };
inline constexpr std::array<std::string_view, 2> joint_spring_names{"axial", "flexural"};

/// Returns the springs of a joint that are not linear: those that push with more than their stiffness.
std::vector<JointSpring> stiffening_springs(const Joint& joint);

/// A key of one joint: its name, and the key that it is for a case with one joint.
struct JointKey {
    std::string joint;  // "lip2"
    std::string key;    // "joint.mass", "contact.preload"
};

/// Takes "joint.lip2.contact.preload" apart; nothing for a key of any other form.
std::optional<JointKey> joint_key(std::string_view key);

/// Returns the key again: "joint.lip2.contact.preload".
std::string key_of_joint(const JointKey& key);

/// Returns the key of a joint's field, which is one of [joint] or [contact].
std::string key_of_joint(const Field& field, std::string_view joint);

/// Says whether each joint of the case has a value and a key of its own for a field: "joint.lip2.mass".
bool has_key_of_joint(const Case& c, const Field& field);

/// Returns the key of a field at a joint of a case: "joint.lip2.mass" where each has its own, "joint.mass" or
/// "drive.velocity" elsewhere.
std::string key_at(CaseView at, const Field& field);

/// Returns a word that may name a joint: letters, digits, "_" and "-", and no key of `[joint]`.
bool names_a_joint(std::string_view name);

}  // namespace stridor::parameters
