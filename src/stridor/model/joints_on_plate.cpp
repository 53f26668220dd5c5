#include "stridor/model/joints_on_plate.hpp"

#include "stridor/base/elementary.hpp"

namespace stridor::model {

namespace {

// an axial and a flexural element at the incidence angle, as a matrix along and across the plate
Eigen::Matrix2d rotated(double axial, double flexural, const base::SineCosine& angle) {
    const double c = angle.cosine;
    const double s = angle.sine;
    const double across = (axial - flexural) * s * c;
    return Eigen::Matrix2d{{axial * c * c + flexural * s * s, across}, {across, axial * s * s + flexural * c * c}};
}

}  // namespace

Structure joints_on_plate(std::span<const PlateJoint> joints, const parameters::Plate& plate) {
    const auto count = static_cast<int>(joints.size());
    const int last = 2 * count;
    Structure structure = structure_of_size(last + 1, count);
    for (int k = 0; k < count; ++k) {
        const parameters::Joint& joint = joints[static_cast<std::size_t>(k)].joint;
        const parameters::Contact& rubbed = joints[static_cast<std::size_t>(k)].contact;
        ContactPoint& contact = structure.contacts[static_cast<std::size_t>(k)];
        const base::SineCosine angle = base::sine_cosine_of_degrees(joint.incidence_angle);
        const int along = 2 * k;
        const int across = along + 1;
        structure.mass(along, along) = structure.mass(across, across) = joint.mass;
        structure.damping.block<2, 2>(along, along) = rotated(joint.axial_damping, joint.flexural_damping, angle);
        structure.stiffness.block<2, 2>(along, along) = rotated(joint.axial_stiffness, joint.flexural_stiffness, angle);
        structure.load(across) = -rubbed.preload;
        structure.load(last) += rubbed.preload;
        contact.normal(across) = 1.0;
        contact.normal(last) = -1.0;
        contact.tangent(along) = 1.0;
        contact.friction = friction_law(rubbed);
        contact.rest = rest_growth(rubbed);
        contact.impact = impact_law(rubbed);
        contact.preload = rubbed.preload;
        structure.body.insert(structure.body.end(), {k, k});
    }
    structure.body.push_back(count);
    structure.mass(last, last) = plate.mass;
    structure.damping(last, last) = plate.damping;
    structure.stiffness(last, last) = plate.stiffness;
    return structure;
}

}  // namespace stridor::model
