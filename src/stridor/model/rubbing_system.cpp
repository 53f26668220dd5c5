#include "stridor/model/rubbing_system.hpp"

#include "stridor/model/joints_on_plate.hpp"

namespace stridor::model {

int dofs_of_system(const parameters::Case& c) {
    return 2 * static_cast<int>(c.joints.size()) + 1;
}

Structure rubbing_system(const parameters::Case& c) {
    return joints_on_plate(c.joints, c.plate);
}

}  // namespace stridor::model
