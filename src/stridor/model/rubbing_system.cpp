#include "stridor/model/rubbing_system.hpp"

#include "stridor/base/elementary.hpp"

namespace stridor::model {

namespace {

// an axial and a flexural element at the incidence angle, as a matrix on (x1, y1)
Eigen::Matrix2d rotated(double axial, double flexural, const base::SineCosine& angle) {
    const double c = angle.cosine;
    const double s = angle.sine;
    const double across = (axial - flexural) * s * c;
    return Eigen::Matrix2d{{axial * c * c + flexural * s * s, across}, {across, axial * s * s + flexural * c * c}};
}

}  // namespace

Structure rubbing_system(const parameters::Case& c) {
    const base::SineCosine angle = base::sine_cosine_of_degrees(c.joint.incidence_angle);
    Structure structure = structure_of_size(rubbing_system_dofs);
    ContactPoint& contact = structure.contacts.front();
    structure.mass.diagonal() << c.joint.mass, c.joint.mass, c.plate.mass;
    structure.damping.topLeftCorner<2, 2>() = rotated(c.joint.axial_damping, c.joint.flexural_damping, angle);
    structure.damping(2, 2) = c.plate.damping;
    structure.stiffness.topLeftCorner<2, 2>() = rotated(c.joint.axial_stiffness, c.joint.flexural_stiffness, angle);
    structure.stiffness(2, 2) = c.plate.stiffness;
    structure.load << 0.0, -c.contact.preload, c.contact.preload;
    contact.normal << 0.0, 1.0, -1.0;
    contact.tangent << 1.0, 0.0, 0.0;
    contact.friction = friction_law(c.contact);
    contact.impact = impact_law(c.contact);
    return structure;
}

}  // namespace stridor::model
