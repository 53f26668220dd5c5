#include "stridor/model/built/joints_on_plate.hpp"

#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/model/linear/linearised.hpp"
#include "stridor/parameters/joints.hpp"

#include <cmath>
#include <string>
#include <utility>

namespace stridor::model {

namespace {

// an axial and a flexural element at the incidence angle, as a matrix along and across the plate
Eigen::Matrix2d rotated(double axial, double flexural, const base::SineCosine& angle) {
    const double c = angle.cosine;
    const double s = angle.sine;
    const double across = (axial - flexural) * s * c;
    return Eigen::Matrix2d{{axial * c * c + flexural * s * s, across}, {across, axial * s * s + flexural * c * c}};
}

SpringLaw axial_law(const parameters::Joint& joint) {
    if (joint.stiffening == parameters::Stiffening::cubic) return CubicSpring{joint.axial_cubic};
    return table_spring(joint.axial_force.deflections, joint.axial_force.forces, parameters::Interpolation::cubic);
}

// A joint leans on its springs: at rest they bear the preload, n = (0, 1), as far as it acts along them.
void add_stiffening(Structure& structure, Eigen::Index along, const parameters::PlateJoint& given) {
    const parameters::Joint& joint = given.joint;
    const double preload = given.contact.preload;
    const base::SineCosine angle = base::sine_cosine_of_degrees(joint.incidence_angle);
    const auto add = [&](parameters::JointSpring which, double stiffness, SpringLaw law, double x, double y) {
        Spring spring{Eigen::VectorXd::Zero(structure.load.size()), std::move(law)};
        spring.direction(along) = x;
        spring.direction(along + 1) = y;
        spring.rest = elongation_under(spring.law, stiffness, preload * y);
        if (!std::isfinite(spring.rest) || !(stiffness + stiffness_of(spring.law, spring.rest) > 0.0))
            base::refuse("the joint gives way: its " +
                             std::string(parameters::joint_spring_names[static_cast<std::size_t>(which)]) +
                             " spring never holds " + base::shortest(std::abs(preload * y)) + " N",
                         "that is its share of the preload at rest, and it softens too much",
                         "Lower contact.preload, or make it stiffer.");
        structure.springs.push_back(std::move(spring));
    };
    const double c = angle.cosine, s = angle.sine;
    for (const parameters::JointSpring which : parameters::stiffening_springs(joint))
        if (which == parameters::JointSpring::axial)
            add(which, joint.axial_stiffness, axial_law(joint), c, s);
        else
            add(which, joint.flexural_stiffness, CubicSpring{joint.flexural_cubic}, -s, c);
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
    for (int k = 0; k < count; ++k)
        add_stiffening(structure, 2 * k, joints[static_cast<std::size_t>(k)]);
    hold_springs(structure);
    return structure;
}

}  // namespace stridor::model
