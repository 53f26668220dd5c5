#pragma once

#include "stridor/io/structure/field_scanner.hpp"
#include "stridor/reduction/part.hpp"

#include <Eigen/SparseCore>

#include <map>
#include <string>
#include <vector>

namespace stridor::io::structure {

/// The role of a matrix in a structure.
enum class MatrixRole { stiffness, mass, damping, structural_damping, other, untold };

/// Returns "stiffness", "mass" and so on.
std::string_view name_of(MatrixRole role);

/// Returns the role that Nastran's names tell: KAAX, MAAX, BAAX, K4AAX; any other matrix (PAX, GPXX) plays no part in a
/// vibration. Several names may begin alike: MXX is a mass, MUG1O is not. `chosen_matrices` distinguishes them.
MatrixRole role_of_name(std::string_view name);

/// The entries of a symmetric matrix that a file lists.
enum class Triangles {
    one,     // each pair of rows once, in any order
    both,    // each pair twice
    untold,  // both, if any pair stands twice
};

/// A matrix as a file lists it.
struct ListedMatrix {
    std::string file;    // for messages
    std::string name{};  // its own, if it has one: "KAAX"
    MatrixRole role = MatrixRole::untold;
    Triangles triangles = Triangles::untold;
    bool is_passed_over = false;    // rectangular, or complex: it has no entries
    bool is_named_by_user = false;  // the user gave its role
    Eigen::Index rows = 0;
    std::vector<Eigen::Triplet<double>> entries{};  // rows and columns from 0
    std::vector<reduction::RowLabel> labels{};      // shape [row]; empty if the file has none
};

/// Adds an entry with row and column from 1. Throws `Error` (input) at the place of the scanner for a place beyond 2^31
/// - 1 rows.
void add_entry(ListedMatrix& matrix, const FieldScanner& scanner, std::int64_t row, std::int64_t column, double value);

/// Gives rows to labels in the order in which they occur, and at the end in the order of node numbers.
class LabelOrder {
public:
    Eigen::Index row_of(const reduction::RowLabel& label);
    /// Sorts the labels by number and component (text that is not a number last), and the entries' rows with them.
    void finish(ListedMatrix& matrix) const;

private:
    std::map<reduction::RowLabel, Eigen::Index> rows_;
};

/// Returns both triangles of it. Throws `Error` (input) for an entry that stands twice, for a matrix that is not
/// symmetric to 1e-10 of its diagonal, and for far more rows than entries.
reduction::SparseMatrix symmetric_matrix(const ListedMatrix& matrix);

/// Returns stiffness, mass and damping (which may be absent) in the stiffness' rows. Labels, if matrices have them, say
/// which rows belong together. Throws `Error` (input) if a matrix has a row that the stiffness lacks: another model.
/// Rows that Abaqus holds by a penalty (1e30 and more on the diagonal) are removed.
reduction::ElasticPart joined_part(ListedMatrix stiffness, const ListedMatrix& mass, const ListedMatrix* damping);

}  // namespace stridor::io::structure
