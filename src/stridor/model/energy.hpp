#pragma once

#include "stridor/model/structure.hpp"

namespace stridor::model {

/// Kinetic energy, v.M v / 2 [J].
template <int dofs>
double kinetic_energy(const Structure<dofs>& structure, const typename Structure<dofs>::Vector& v) {
    return 0.5 * v.dot(structure.mass * v);
}

/// Elastic energy, u.K u / 2 [J]; the work of the constant load is counted apart.
template <int dofs>
double elastic_energy(const Structure<dofs>& structure, const typename Structure<dofs>::Vector& u) {
    return 0.5 * u.dot(structure.stiffness * u);
}

}  // namespace stridor::model
