#pragma once

#include "stridor/model/sized_structure.hpp"

namespace stridor::integration {

/// Returns the energy that rounding works on [J]: with every displacement `far` and velocity `fast` at its largest,
/// signs left out,
///
///     1/2 far |K| far + 1/2 fast |M| fast + |f0| far + eps |f0|^2 / max |K|
///
/// The last term is of forces that cancel: the contact carries the preload, and both are known to their rounding only.
template <int dofs>
double energy_held(const model::SizedStructure<dofs>& structure,
                   const typename model::SizedStructure<dofs>::Vector& far,
                   const typename model::SizedStructure<dofs>::Vector& fast) {
    constexpr double rounding = 1.1e-16;
    return 0.5 * far.dot(structure.stiffness.cwiseAbs() * far) + 0.5 * fast.dot(structure.mass.cwiseAbs() * fast) +
           structure.load.cwiseAbs().dot(far) +
           rounding * structure.load.squaredNorm() / structure.stiffness.cwiseAbs().maxCoeff();
}

}  // namespace stridor::integration
