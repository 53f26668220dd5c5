#pragma once

#include "stridor/model/structure.hpp"

#include <cstddef>
#include <span>
#include <type_traits>

namespace stridor::model {

/// A structure with one contact for loops whose size the compiler may know; Eigen::Dynamic where it does not.
template <int dofs>
struct SizedStructure {
    using Vector = Eigen::Matrix<double, dofs, 1>;
    using Matrix = Eigen::Matrix<double, dofs, dofs>;

    Matrix mass;       // [kg]
    Matrix damping;    // [N*s/m]
    Matrix stiffness;  // [N/m]
    Vector load;       // [N]
    Vector normal;     // [1]
    Vector tangent;    // [1]

    /// Copies a structure, which must have `dofs` degrees of freedom.
    SizedStructure(const Structure& structure, const ContactPoint& contact)
        : mass(structure.mass),
          damping(structure.damping),
          stiffness(structure.stiffness),
          load(structure.load),
          normal(contact.normal),
          tangent(contact.tangent) {}
};

/// A size as a value whose type carries it.
template <int dofs>
using Size = std::integral_constant<int, dofs>;

/// Calls `work` with the number of degrees of freedom as a `Size`, which has its own type for two and three: small
/// systems are the usual ones, and unrolled sums add in another order.
template <typename Work>
auto with_size(int dofs, const Work& work) {
    if (dofs == 2) return work(Size<2>());
    if (dofs == 3) return work(Size<3>());
    return work(Size<Eigen::Dynamic>());
}

/// Returns the numbers of a vector of any size.
template <typename Vector>
std::span<const double> numbers(const Vector& vector) {
    return {vector.data(), static_cast<std::size_t>(vector.size())};
}

}  // namespace stridor::model
