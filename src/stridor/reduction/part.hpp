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

/// Which degree of freedom a row of a matrix is.
struct RowLabel {
    std::string node{};  // as the file has it, or what stands in its place: "mode 3"
    int component = 0;   // 1 to 3: displacement along x, y, z; 4 to 6: rotation about them; 0: none of these

    friend bool operator==(const RowLabel&, const RowLabel&) = default;
    // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 takes the 0 of its own comparison for a pointer
    friend auto operator<=>(const RowLabel&, const RowLabel&) = default;
};

/// "1000.3"; the node alone where there is no component.
std::string describe(const RowLabel& label);

/// Nodes under a name.
struct NodeSet {
    std::string name;
    std::vector<std::string> nodes;
};

/// A linear elastic part as a finite-element program hands it over: matrices, and what each of their rows is.
///
///     M u'' + C u' + K u = f
///
/// Both triangles of each matrix are stored. Rows that a support holds are absent. Units are those of the file until
/// `in_si` has been called; everything behind it is SI.
struct ElasticPart {
    SparseMatrix stiffness;                            // [N/m, N, N*m] K, symmetric, shape [row][row]
    SparseMatrix mass;                                 // [kg, kg*m, kg*m^2] M, symmetric, shape [row][row]
    SparseMatrix damping;                              // [N*s/m ...] C; without rows where the file has none
    std::vector<RowLabel> labels;                      // shape [row]
    std::map<std::string, Eigen::Vector3d> positions;  // [m] of nodes, as far as they are known
    std::vector<NodeSet> sets;
    std::vector<std::string> notes;  // what its reader says of it, a sentence each
};

/// Number of rows.
Eigen::Index rows_of(const ElasticPart& part);

/// Refuses a part that is no structure: throws `Error` (input) for matrices of different sizes, a row without label, a
/// label twice, a number that is not finite, a matrix that is not symmetric to 1e-10 of its diagonal, a mass that is
/// negative for some motion (by the signs of its pivots), and a row with neither stiffness nor mass.
void expect_sound(const ElasticPart& part, LinearSolver by = LinearSolver::eigen);

/// Refuses a part without an entry of its stiffness above `least` [N/m]; squares of less than the usual one leave
/// double precision. Throws `Error` (input).
void expect_stiff(const ElasticPart& part, double least = 1e-150);

/// The same matrix without entries that are zero: of a mass two thirds, where an element's motions along x, y and z do
/// not meet, and nearly all the work of its factors.
SparseMatrix without_zeros(const SparseMatrix& matrix);

/// A system of units that finite-element models are made in; K, M and positions belong together in each.
struct UnitSystem {
    std::string_view name;  // "mm-t-s"
    double length = 1.0;    // [m] one of its lengths
    double mass = 1.0;      // [kg] one of its masses
    double time = 1.0;      // [s] one of its times
};

/// m-kg-s, mm-t-s, mm-kg-ms, mm-kg-s, cm-g-s.
const std::vector<UnitSystem>& unit_systems();

/// The system of this name; throws `Error` (input) for any other.
const UnitSystem& unit_system(std::string_view name);

/// The same part in SI. A row of rotations keeps its radians; one without component keeps its own unit, so that
/// energies stay right.
ElasticPart in_si(ElasticPart part, const UnitSystem& from);

/// Finds the node set of this name, letters of any size; `nullptr` where there is none.
const NodeSet* find_set(const ElasticPart& part, std::string_view name);

/// The names of its node sets for a message: "FOOT, NALL", and how many more there are.
std::string set_names(const ElasticPart& part);

/// Rows that a user names: a set ("FOOT"), some of its components ("FOOT:13"), a node ("1000", "1000:3") or one row
/// ("1000.3"). All components that each node has, unless some are named.
///
/// Throws `Error` (input) where there is no such set, node or row: a support, a constraint or a rigid body removed it.
std::vector<Eigen::Index> named_rows(const ElasticPart& part, std::string_view name);

/// The rows under several names, each once: a node in two sets is one row all the same.
std::vector<Eigen::Index> named_rows(const ElasticPart& part, const std::vector<std::string>& names);

}  // namespace stridor::reduction
