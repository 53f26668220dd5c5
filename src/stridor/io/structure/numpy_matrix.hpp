#pragma once

#include "stridor/io/structure/field_scanner.hpp"
#include "stridor/io/structure/listed_matrix.hpp"

#include <map>
#include <string>

namespace stridor::io::structure {

/// Says whether a file begins as a zip archive does.
bool is_zip(std::string_view beginning);

/// Returns the files of a zip archive by name, stored or deflated, read by libarchive.
///
/// Throws `Error` (input) for a damaged archive, two files of one name, more than 100 files, other compressions,
/// passwords, and files that together grow beyond 2 GiB.
std::map<std::string, std::string> read_zip(const StructureInput& input);

/// Reads the matrices of a .npz: the sparse one that `scipy.sparse.save_npz` wrote (CSR, CSC or COO; entries of one
/// place are summed, as SciPy does), or the dense ones of `numpy.savez`, with role by name (K, M, C or B, stiffness,
/// mass, damping). They have no labels. Loads (P...) are left out. Throws `Error` (input).
std::vector<ListedMatrix> read_npz(const StructureInput& input);

/// Reads these matrices from the files of the archive, by name. Throws `Error` (input).
std::vector<ListedMatrix> numpy_matrices(const std::map<std::string, std::string>& members, const std::string& file);

/// Reads the dense matrix of a .npy. Throws `Error` (input).
ListedMatrix read_npy(const StructureInput& input);

}  // namespace stridor::io::structure
