#pragma once

#include "stridor/base/error.hpp"
#include "stridor/io/structure/listed_matrix.hpp"
#include "stridor/reduction/part.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace stridor::io::structure {

// Node sets as a file names them, one node after the other.

/// Collects the node sets of one file in the order of their first mention. Their total size is bounded: a line of a
/// deck can ask for two million nodes.
class SetTable {
public:
    /// Finds the set of this name, or begins it: `key` distinguishes names, `name` is its own spelling.
    std::size_t place_of(const std::string& key, const std::string& name);

    /// Finds the set of this key; returns `std::nullopt` if there is none.
    std::optional<std::size_t> find(const std::string& key) const;

    /// Returns the nodes of a set so far.
    const std::vector<std::string>& nodes_of(std::size_t place) const { return sets_[place].nodes; }

    /// Returns the problem if `nodes` more nodes would be too many, or if there are too many names.
    std::optional<base::Problem> excess(std::size_t nodes) const;

    /// Adds a node to a set; there must be room for it (`excess`).
    void add(std::size_t place, std::string node);

    /// Returns all sets and keeps none.
    std::vector<reduction::NodeSet> take() { return std::move(sets_); }

private:
    std::vector<reduction::NodeSet> sets_;
    std::unordered_map<std::string, std::size_t> places_;
    std::size_t nodes_ = 0;  // [1] of all sets
};

/// A table about the rows of matrices that have no labels of their own.
struct RowTable {
    std::vector<reduction::RowLabel> labels;
    std::map<std::string, Eigen::Vector3d> positions;  // in the units of the table, or in m where its names have units
    std::vector<reduction::NodeSet> sets;
};

/// Returns a component by name: 1 to 6, UX, UY, UZ, ROTX, ROTY, ROTZ, x, y, z; 0 for "", "0" and "none"; else
/// `std::nullopt`.
std::optional<int> component_in(std::string_view text);

/// Says whether a text begins with the names of such a table.
bool is_row_table(std::string_view first_line);

/// Reads a CSV whose lines are the rows of the matrices, in their order: `node`, `component`, and, if they are there,
/// `x`, `y`, `z` and `set` (several with blanks between). Separated by commas, semicolons or tabs. Throws `Error`
/// (input).
RowTable read_row_table(const StructureInput& input);

}  // namespace stridor::io::structure
