#pragma once

#include "stridor/base/error.hpp"
#include "stridor/parameters/fields/contact_field.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/reduction/craig_bampton.hpp"
#include "stridor/reduction/part.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace stridor::io {

/// A direction as a user gives it. At a node it is of x, y, z, and is made of length one: "z", "-x", "0 0.6 0.8" or
/// three numbers. Without a node it is of the rows: "y1 -y2" or a number for each.
using NamedDirection = std::variant<std::string, std::vector<double>>;

/// Returns what may stand in a table of a contact, and as a column of a CSV: where it is, and its fields
/// (`parameters::contact_fields`).
std::span<const std::string_view> contact_keys();

/// What a file says of a contact, or of one at each node of a set.
struct NamedContact {
    parameters::OwnContact said{};  // without directions; no name: that of its node; its share is of all nodes together
    std::string node{};             // one node, or
    std::string set{};              // all of a set; both empty: directions are of rows
    std::string against{};          // node or set of the other part; empty: a surface that moves
    std::map<std::string_view, NamedDirection> directions{};  // by key of their fields
    std::vector<std::string_view> keys{};                     // of the fields that it says
    base::Place place{};                                      // where it stands

    bool has(std::string_view key) const { return std::find(keys.begin(), keys.end(), key) != keys.end(); }
};

/// Reads a contact field by field. A source has for each kind of value a function that takes the field and gives the
/// value, or `std::nullopt` if the source has none: `text`, `number`, `direction`, `position`.
template <typename Source>
NamedContact named_contact(const Source& source, const base::Place& place) {
    NamedContact named{.node = source.text("node").value_or(""),
                       .set = source.text("set").value_or(""),
                       .against = source.text("against").value_or(""),
                       .place = place};
    for (const parameters::ContactField& field : parameters::contact_fields()) {
        const auto take = [&](auto& into, auto value) {
            if (!value) return;
            named.keys.push_back(field.key);
            into = std::move(*value);
        };
        const auto read = [&](auto& into) {
            using Value = std::decay_t<decltype(into)>;
            if constexpr (std::is_same_v<Value, std::string>)
                take(into, source.text(field.key));
            else if constexpr (std::is_same_v<Value, std::vector<double>>)
                take(named.directions[field.key], source.direction(field));
            else if constexpr (std::is_same_v<Value, std::optional<std::array<double, 3>>>)
                take(into, source.position(field));
            else
                take(into, source.number(field));
        };
        std::visit([&](auto member) { read(named.said.*member); }, field.member);
    }
    return named;
}

/// Returns contacts at the rows of a part. Those of a set stand in the order of their places along its longest side,
/// and are paired with the nearest node of the set `against`.
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

/// Returns the rows along which such a point moves, at a node or of the rows themselves [1]; shape [row]. Throws
/// `Error` (input) at the place as `outputs_at`.
std::vector<double> rows_along(const reduction::ElasticPart& part, const NamedOutput& named);

/// Returns the name of an output, or of what has a node and a direction alike: its own, else made of these, else
/// `fallback`.
std::string name_of(const NamedOutput& named, const std::string& fallback);

/// Returns outputs at the rows of a part, or at further rows whose motion is `recovery` * u (`reduction::Reduction`),
/// shape [recovered][row].
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
