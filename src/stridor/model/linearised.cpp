#include "stridor/model/linearised.hpp"

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

Eigen::VectorXd spring_forces(const Structure& structure, const Eigen::Ref<const Eigen::VectorXd>& displacement) {
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(dofs_of(structure));
    for (const Spring& spring : structure.springs)
        forces += force_of(spring.law, spring.rest + spring.direction.dot(displacement)) * spring.direction;
    return forces;
}

}  // namespace stridor::model
