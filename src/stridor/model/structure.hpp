#pragma once

#include "stridor/model/coulomb.hpp"

#include <Eigen/Core>

namespace stridor::model {

/// A linear structure with one unilateral frictional contact, what every engine sees:
///
///     M u'' + C u' + K u = f0 + n N + t T,    gap g = n.u >= 0,    slip velocity w = t.u' - V,    N >= 0
///
/// V(t) is the imposed tangential velocity of the other surface. Displacements are measured from the preloaded rest
/// position. The paper's joint on a plate is one builder (`rubbing_system`), the mass on a belt another
/// (`mass_on_belt`). The number of degrees of freedom is known to the compiler.
template <int dofs>
struct Structure {
    using Vector = Eigen::Matrix<double, dofs, 1>;
    using Matrix = Eigen::Matrix<double, dofs, dofs>;

    Matrix mass = Matrix::Zero();       // [kg] M, symmetric, positive definite
    Matrix damping = Matrix::Zero();    // [N*s/m] C, symmetric
    Matrix stiffness = Matrix::Zero();  // [N/m] K, symmetric
    Vector load = Vector::Zero();       // [N] f0, constant
    Vector normal = Vector::Zero();     // [1] n: gap = n.u
    Vector tangent = Vector::Zero();    // [1] t: tangential position = t.u
    Coulomb friction;
};

}  // namespace stridor::model
