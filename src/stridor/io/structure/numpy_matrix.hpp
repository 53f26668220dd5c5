#pragma once

#include "stridor/io/structure/field_scanner.hpp"
#include "stridor/io/structure/listed_matrix.hpp"

#include <map>
#include <string>

namespace stridor::io::structure {

/// Reads the matrices of a .npz: the sparse one that `scipy.sparse.save_npz` wrote (CSR, CSC or COO; entries of one
/// place are summed, as SciPy does), or the dense ones of `numpy.savez`, with role by name (K, M, C or B, stiffness,
/// mass, damping). They have no labels. Loads (P...) are left out. Throws `Error` (input).
std::vector<ListedMatrix> read_npz(const StructureInput& input);

/// Reads these matrices from the files of the archive, by name. Throws `Error` (input).
std::vector<ListedMatrix> numpy_matrices(const std::map<std::string, std::string>& members, const std::string& file);

/// Reads the dense matrix of a .npy. Throws `Error` (input).
ListedMatrix read_npy(const StructureInput& input);

}  // namespace stridor::io::structure
