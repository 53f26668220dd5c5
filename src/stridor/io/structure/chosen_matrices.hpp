#pragma once

#include "stridor/io/structure/listed_matrix.hpp"

namespace stridor::io::structure {

/// What a part vibrates by, and a sentence about each matrix that it does not.
struct PartMatrices {
    const ListedMatrix* stiffness = nullptr;
    const ListedMatrix* mass = nullptr;
    const ListedMatrix* damping = nullptr;  // may be absent
    std::vector<std::string> notes{};
};

/// Chooses among all matrices of the files, which the result points into. Of several of one role that one counts whose
/// whole name belongs to another's (KXX, MXX and not MUG1O), then that one which has as many rows as the stiffness.
/// Place holders without entries never count.
///
/// Throws `Error` (input) where stiffness or mass is missing, or several are left.
PartMatrices chosen_matrices(const std::vector<ListedMatrix>& matrices);

}  // namespace stridor::io::structure
