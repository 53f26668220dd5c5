#include "stridor/model/mass_on_belt.hpp"

namespace stridor::model {

Structure<mass_on_belt_dofs> mass_on_belt(const Belt& belt) {
    Structure<mass_on_belt_dofs> structure;
    structure.mass.diagonal() << belt.mass, belt.mass;
    structure.damping(0, 0) = belt.damping;
    structure.stiffness(0, 0) = belt.stiffness;
    structure.load << 0.0, -belt.preload;
    structure.normal << 0.0, 1.0;
    structure.tangent << 1.0, 0.0;
    structure.friction = belt.friction;
    return structure;
}

}  // namespace stridor::model
