#include "stridor/model/rubbing_system.hpp"

#include "stridor/model/joints_on_plate.hpp"

#include <array>

namespace stridor::model {

Structure rubbing_system(const parameters::Case& c) {
    return joints_on_plate(std::array{PlateJoint{c.joint, c.contact}}, c.plate);
}

}  // namespace stridor::model
