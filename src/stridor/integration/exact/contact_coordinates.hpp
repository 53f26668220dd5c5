#pragma once

#include "stridor/model/sized_structure.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace stridor::integration {

/// A structure seen from its contact: u = B z with z = (x, y, g), tangential position, what moves along unseen, gap.
///
/// The columns of B are orthogonal under M, so that impulses at the contact act on one coordinate each:
///
///     g:  r = M⁻¹n / (n.M⁻¹n)                      n.r = 1; a plastic impact takes g' away and leaves x', y' alone
///     x:  n.b = 0, t.b = 1, b.M y = 0              a tangential impulse changes x' by P_t / m_x and nothing else
///     y:  n.b = t.b = 0                            (three degrees of freedom)
///
/// While the contact is closed g = 0 and the motion is that of (x, y). Loads are divided by their largest component,
/// the load scale, so that all but the scale is the same for every preload.
template <int dofs>
struct ContactCoordinates {
    using Vector = typename model::SizedStructure<dofs>::Vector;
    using Matrix = typename model::SizedStructure<dofs>::Matrix;

    Matrix basis = Matrix::Zero();      // [1] B, columns x, (y,) g
    Vector mass = Vector::Zero();       // [kg] diagonal of B.M B, all there is of it
    Matrix damping = Matrix::Zero();    // [N*s/m] B.C B
    Matrix stiffness = Matrix::Zero();  // [N/m] B.K B
    Vector load = Vector::Zero();       // [1] B.f0 / load_scale
    double load_scale = 0.0;            // [N]
    double tangent_on_gap = 0.0;        // [1] t.r: slip velocity per gap velocity
};

/// Returns these coordinates of a structure, which must have a regular mass matrix.
template <int dofs>
ContactCoordinates<dofs> contact_coordinates(const model::SizedStructure<dofs>& structure) {
    static_assert(dofs == 2 || dofs == 3);
    using Vector = typename model::SizedStructure<dofs>::Vector;
    const Vector& n = structure.normal;
    const Vector& t = structure.tangent;
    ContactCoordinates<dofs> c;

    const Vector pushed = structure.mass.inverse() * n;
    const Vector opening = pushed / n.dot(pushed);
    Vector along = t - n * (n.dot(t) / n.dot(n));
    if constexpr (dofs == 3) {
        Vector across = n.cross(t);
        Eigen::Index largest = 0;
        across.cwiseAbs().maxCoeff(&largest);
        across /= across(largest);
        const Vector heavy = structure.mass * across;
        along -= across * (heavy.dot(along) / heavy.dot(across));
        c.basis.col(1) = across;
    }
    c.basis.col(0) = along / t.dot(along);
    c.basis.col(dofs - 1) = opening;

    c.mass = (c.basis.transpose() * structure.mass * c.basis).diagonal();
    c.damping = c.basis.transpose() * structure.damping * c.basis;
    c.stiffness = c.basis.transpose() * structure.stiffness * c.basis;
    c.load_scale = structure.load.cwiseAbs().maxCoeff();
    const Vector direction = c.load_scale > 0.0 ? Vector(structure.load / c.load_scale) : Vector::Zero();
    c.load = c.basis.transpose() * direction;
    c.tangent_on_gap = t.dot(opening);
    return c;
}

}  // namespace stridor::integration
