#pragma once

#include "stridor/base/error.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/reduction/craig_bampton.hpp"
#include "stridor/reduction/part.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace stridor::io {

/// A direction as a user gives it. At a node it is of x, y, z, and is made of length one: "z", "-x", "0 0.6 0.8" or
/// three numbers. Without a node it is of the rows: "y1 -y2" or a number for each.
using NamedDirection = std::variant<std::string, std::vector<double>>;

/// What may stand in a table of a contact, and as a column of a CSV.
inline constexpr std::array<std::string_view, 15> contact_keys{"name",
                                                               "node",
                                                               "set",
                                                               "against",
                                                               "interface",
                                                               "normal",
                                                               "tangent",
                                                               "second_tangent",
                                                               "initial_gap",
                                                               "static_friction",
                                                               "kinetic_friction",
                                                               "preload_share",
                                                               "drive_share",
                                                               "second_drive_share",
                                                               "position"};

/// What a file says of a contact, or of one at each node of a set.
struct NamedContact {
    std::string name{};     // empty: that of its node
    std::string node{};     // one node, or
    std::string set{};      // all of a set; both empty: directions are of rows
    std::string against{};  // node or set of the other part; empty: a surface that moves
    std::string interface {};
    NamedDirection normal{};
    NamedDirection tangent{};
    std::optional<NamedDirection> second_tangent{};   // of a contact that slips in a plane
    double initial_gap = 0.0;                         // [m]
    std::optional<double> static_friction{};          // [1]
    std::optional<double> kinetic_friction{};         // [1]
    std::optional<double> preload_share{};            // [1] of all its nodes together
    double drive_share = 1.0;                         // [1]
    double second_drive_share = 0.0;                  // [1] along the second tangent
    std::optional<std::array<double, 3>> position{};  // [m] of one without a node; else its node's
    base::Place place{};                              // where it stands
};

/// Contacts at the rows of a part. Those of a set stand in the order of their places along its longest side, and are
/// paired with the nearest node of the set `against`.
///
/// Throws `Error` (input) at the place for a node, set or row that is not there, a direction that is zero or has
/// another number of components, a tangent that is not at right angles to the normal, two contacts of one name or at
/// one place, and more than `parameters::most_contacts`.
std::vector<parameters::OwnContact> contacts_at(const reduction::ElasticPart& part,
                                                const std::vector<NamedContact>& named);

/// What a file says of a point whose motion is wanted.
struct NamedOutput {
    std::string name{};  // empty: made of node and direction
    std::string node{};  // empty: the direction is of rows
    NamedDirection direction{};
    base::Place place{};  // where it stands
};

/// Outputs at the rows of a part, or at further rows whose motion is `recovery` * u (`reduction::Reduction`), shape
/// [recovered][row].
///
/// Throws `Error` (input) at the place for a node or row that is not there, a direction that is zero or has another
/// number of components, and a name that another output, a contact or a row has.
std::vector<parameters::OwnOutput> outputs_at(const reduction::Reduction& reduction,
                                              const std::vector<NamedOutput>& named,
                                              const std::vector<parameters::OwnContact>& contacts);

/// Shares of the preload where nobody gave one: equal, of all that are not open. Throws `Error` (input) at `place` for
/// shares beside a load or negative gaps, for contacts that touch without load, and where all are open and the
/// structure does not move at the start.
void share_preload(parameters::OwnStructure& own, const std::vector<NamedContact>& named, const base::Place& place);

}  // namespace stridor::io
