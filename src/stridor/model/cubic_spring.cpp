#include "stridor/model/cubic_spring.hpp"

namespace stridor::model {

Structure linearised_at(Structure structure, const Eigen::Ref<const Eigen::VectorXd>& displacement) {
    for (const CubicSpring& spring : structure.springs) {
        const double e = spring.direction.dot(displacement);
        structure.stiffness += 3.0 * spring.cubic * e * e * spring.direction * spring.direction.transpose();
        structure.load += 2.0 * force_of(spring, e) * spring.direction;
    }
    structure.springs.clear();
    return structure;
}

}  // namespace stridor::model
