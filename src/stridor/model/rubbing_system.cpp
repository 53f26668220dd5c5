#include "stridor/model/rubbing_system.hpp"

#include "stridor/model/joints_on_plate.hpp"

#include <vector>

namespace stridor::model {

int dofs_of_system(const parameters::Case& c) {
    return rubbing_system_dofs + 2 * static_cast<int>(c.further_joints.size());
}

Structure rubbing_system(const parameters::Case& c) {
    std::vector<PlateJoint> joints{{c.joint, c.contact}};
    for (const parameters::FurtherJoint& further : c.further_joints)
        joints.push_back({further.joint, further.contact});
    return joints_on_plate(joints, c.plate);
}

}  // namespace stridor::model
