#include "stridor/model/linear/linearised.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stridor::model {

Structure linearised_at(Structure structure, const Eigen::Ref<const Eigen::VectorXd>& displacement) {
    for (const Spring& spring : structure.springs) {
        const double moved = spring.direction.dot(displacement), e = spring.rest + moved;
        const double slope = stiffness_of(spring.law, e);
        structure.stiffness += slope * spring.direction * spring.direction.transpose();
        structure.load += (slope * moved - force_of(spring.law, e)) * spring.direction;
    }
    structure.springs.clear();
    return structure;
}

Structure linearised_at_rest(Structure structure) {
    const Eigen::VectorXd rest = Eigen::VectorXd::Zero(dofs_of(structure));
    return linearised_at(std::move(structure), rest);
}

void hold_springs(Structure& structure) {
    if (structure.springs.empty()) return;
    structure.load += spring_forces(structure, Eigen::VectorXd::Zero(structure.load.size()));
}

double displacement_scale(const Structure& structure) {
    const double stiffness = structure.stiffness.norm();
    double scale = stiffness > 0.0 ? structure.load.norm() / stiffness : 0.0;
    for (const Spring& spring : structure.springs)
        scale = std::max(scale, std::abs(spring.rest) / spring.direction.norm());
    return scale;
}

Eigen::VectorXd spring_forces(const Structure& structure, const Eigen::Ref<const Eigen::VectorXd>& displacement) {
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(dofs_of(structure));
    for (const Spring& spring : structure.springs)
        forces += force_of(spring.law, spring.rest + spring.direction.dot(displacement)) * spring.direction;
    return forces;
}

}  // namespace stridor::model
