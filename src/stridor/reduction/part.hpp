#pragma once

#include "stridor/reduction/linear_solver.hpp"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::reduction {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// The degree of freedom of a matrix row.
struct RowLabel {
    std::string node{};  // as the file has it, or a name for it: "mode 3"
    int component = 0;   // 1 to 3: displacement along x, y, z; 4 to 6: rotation about them; 0: none of these

    friend bool operator==(const RowLabel&, const RowLabel&) = default;
    // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 takes the 0 of its own comparison for a pointer
    friend auto operator<=>(const RowLabel&, const RowLabel&) = default;
};

/// Returns "1000.3", or the node alone if there is no component.
std::string describe(const RowLabel& label);

/// Nodes under a name.
struct NodeSet {
    std::string name;
    std::vector<std::string> nodes;
};

/// A linear elastic part from a finite-element program: matrices, and the labels of their rows.
///
///     M u'' + C u' + K u = f
///
/// Both triangles of each matrix are stored. Rows that a support holds are absent. Units are those of the file until
/// `in_si` has been called; everything behind it is SI.
struct ElasticPart {
    SparseMatrix stiffness;                            // [N/m, N, N*m] K, symmetric, shape [row][row]
    SparseMatrix mass;                                 // [kg, kg*m, kg*m^2] M, symmetric, shape [row][row]
    SparseMatrix damping;                              // [N*s/m ...] C; without rows if the file has none
    std::vector<RowLabel> labels;                      // shape [row]
    std::map<std::string, Eigen::Vector3d> positions;  // [m] of nodes, as far as they are known
    std::vector<NodeSet> sets;
    std::vector<std::string> notes;  // notes of its reader, a sentence each
};

/// Returns the number of rows.
Eigen::Index rows_of(const ElasticPart& part);

/// Refuses a part that is not a structure: throws `Error` (input) for matrices of different sizes, a row without label,
/// a label twice, a number that is not finite, a matrix that is not symmetric to 1e-10 of its diagonal, a mass that is
/// negative for some motion (by the signs of its pivots), and a row with neither stiffness nor mass.
void expect_sound(const ElasticPart& part, LinearSolver by = LinearSolver::eigen);

/// Throws `Error` (input) for a part without an entry of its stiffness above `least` [N/m]; the squares of entries
/// below the usual value leave double precision.
void expect_stiff(const ElasticPart& part, double least = 1e-150);

/// Returns a matrix without its zero entries. In a mass these are two thirds, since an element's motions along x, y and
/// z are not coupled; they cost nearly all the work of its factors.
SparseMatrix without_zeros(const SparseMatrix& matrix);

/// A system of units for finite-element models; K, M and positions belong together in each.
struct UnitSystem {
    std::string_view name;  // "mm-t-s"
    double length = 1.0;    // [m] one of its lengths
    double mass = 1.0;      // [kg] one of its masses
    double time = 1.0;      // [s] one of its times
};

/// Returns m-kg-s, mm-t-s, mm-kg-ms, mm-kg-s, cm-g-s.
const std::vector<UnitSystem>& unit_systems();

/// Returns the system of this name; throws `Error` (input) for any other.
const UnitSystem& unit_system(std::string_view name);

/// Returns a part in SI. A row of rotations keeps its radians; a row without component keeps its own unit, so that
/// energies stay right.
ElasticPart in_si(ElasticPart part, const UnitSystem& from);

/// Returns the node set of this name, in any case of its letters, or null if there is none.
const NodeSet* find_set(const ElasticPart& part, std::string_view name);

/// Returns the names of its node sets for a message, "FOOT, NALL", and how many more there are.
std::string set_names(const ElasticPart& part);

/// Returns the rows that a user names: a set ("FOOT"), some of its components ("FOOT:13"), a node ("1000", "1000:3") or
/// one row ("1000.3"). Without named components it returns all that each node has.
///
/// Throws `Error` (input) if there is no such set, node or row: a support, a constraint or a rigid body removed it.
std::vector<Eigen::Index> named_rows(const ElasticPart& part, std::string_view name);

/// Returns the rows under several names, each once: a node in two sets counts once. Throws `Error`
/// (input) if a name leads to no set, node or row.
std::vector<Eigen::Index> named_rows(const ElasticPart& part, const std::vector<std::string>& names);

}  // namespace stridor::reduction
