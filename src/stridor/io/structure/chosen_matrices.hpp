#pragma once

#include "stridor/io/structure/listed_matrix.hpp"

namespace stridor::io::structure {

/// The matrices of a part, and a sentence about each matrix left out.
struct PartMatrices {
    const ListedMatrix* stiffness = nullptr;
    const ListedMatrix* mass = nullptr;
    const ListedMatrix* damping = nullptr;  // may be absent
    std::vector<std::string> notes{};
};

/// Chooses among all matrices of the files; the result points into them. If a role has several, the one counts whose
/// whole name belongs to another's (KXX, MXX and not MUG1O), then the one with as many rows as the stiffness. Place
/// holders without entries never count.
///
/// Throws `Error` (input) if stiffness or mass is missing, or if several are left.
PartMatrices chosen_matrices(const std::vector<ListedMatrix>& matrices);

}  // namespace stridor::io::structure
