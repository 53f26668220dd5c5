#pragma once

#include "stridor/parameters/own_structure.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

/// What rubs in any case, asked alike of a joint, of joints on a plate and of a structure of the user's own.
///
/// Who needs to know something of a case asks here what it has, not of which kind it is: only what reads and writes
/// cases, their fields and the builders of their structure (model/built) look at the kind.
namespace stridor::parameters {

/// Says whether it is joints on a plate that rub.
bool has_plate(const Case& c);

/// Says whether it is a joint alone on its plate, which needs no name.
bool has_one_joint(const Case& c);

/// Returns the names of the coordinates in which a case moves, as files have them: x1, y1, y2 of a joint on its plate;
/// of several joints x and y with their names, then y_plate; of a structure its rows.
std::vector<std::string> coordinate_names(const Case& c);

/// Returns the number of coordinates in which a case moves.
std::size_t coordinate_count(const Case& c);

/// Returns the number of velocities that are recorded as its vibration: of joints and plate each coordinate's, of a
/// structure two at each contact.
std::size_t channel_count(const Case& c);

/// Along what a point moves.
enum class PointAxis {
    sliding,  // the tangent of its contact
    normal,   // across the surface
};

/// Returns the weights of the coordinates in the motion of the rubbing point at a contact: of a joint's own point, not
/// of the gap to its plate; shape [coordinate].
std::vector<double> point_weights(const Case& c, std::size_t contact, PointAxis axis);

/// Returns the weight 1 of one coordinate, and 0 of all others; shape [coordinate].
std::vector<double> weight_of_one(const Case& c, std::size_t coordinate);

/// Returns the share of the drive's velocity that the surface has at a contact [1].
double drive_share_at(const Case& c, std::size_t contact);

/// Says whether a case is pressed by contact.preload. Else its structure is, by a load or by gaps that are negative.
bool is_preloaded(const Case& c);

/// Returns the number of contacts of a case.
std::size_t contact_count(const Case& c);

/// Says whether its contacts are told by name. The one of a joint alone on its plate is not.
bool has_named_contacts(const Case& c);

/// Returns the name of a contact: its joint's, or its own.
std::string contact_name(const Case& c, std::size_t contact);

/// Returns the name by which a message calls a contact; empty where it is the only one of a joint.
std::string told_name(const Case& c, std::size_t contact);

/// Returns the laws at a contact: its joint's; of a structure those of the case, with the coefficients that the contact
/// has itself, and its share of the preload.
Contact contact_of(const Case& c, std::size_t contact);

/// Returns the places of the contacts along their line [m], from its first end; empty where they are not known, or are
/// one; shape [contact].
std::vector<double> contact_places(const Case& c);

/// Takes away the friction coefficients that contacts of a structure have themselves: all have those of the case.
void share_friction(Case& c);

/// Returns the names of the springs of a case that are not linear, in the order of `model::Structure::springs`,
/// whatever scales them: of a structure those that it gives, of a joint "axial" and "flexural", of several
/// "lip2.axial".
std::vector<std::string> names_of_springs(const Case& c);

/// Returns the points whose motion is wanted beside that of the contacts; joints have none.
std::span<const OwnOutput> outputs_of(const Case& c);

/// Returns the weights of all outputs; shape [output][coordinate].
std::vector<std::vector<double>> output_weights(const Case& c);

/// Returns the line as which a case is drawn; empty where none is known, as of joints.
std::span<const OutlinePoint> outline_of(const Case& c);

/// Returns what a case is, for people: "joint on a plate", "3 joints on a plate", or what its structure was made from.
std::string origin_of(const Case& c);

}  // namespace stridor::parameters
