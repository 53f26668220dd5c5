#include "stridor/model/built/mass_on_belt.hpp"

namespace stridor::model {

Structure mass_on_belt(const Belt& belt) {
    Structure structure = structure_of_size(2);
    ContactPoint& contact = structure.contacts.front();
    structure.mass.diagonal() << belt.mass, belt.mass;
    structure.damping(0, 0) = belt.damping;
    structure.stiffness(0, 0) = belt.stiffness;
    structure.load << 0.0, -belt.preload;
    contact.normal << 0.0, 1.0;
    contact.tangent << 1.0, 0.0;
    contact.friction = belt.friction;
    return structure;
}

}  // namespace stridor::model
