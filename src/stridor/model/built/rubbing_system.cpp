#include "stridor/model/built/rubbing_system.hpp"

#include "stridor/model/built/joints_on_plate.hpp"

namespace stridor::model {

Structure rubbing_system(const parameters::Case& c) {
    return joints_on_plate(c.joints, c.plate);
}

}  // namespace stridor::model
