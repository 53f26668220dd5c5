#include "stridor/integration/imposed_force.hpp"

#include "stridor/base/elementary.hpp"

namespace stridor::integration {

double imposed_force(const parameters::Drive& drive, double time) {
    if (!parameters::is_by_force(drive)) return 0.0;
    const double whole = drive.force * base::sine_cosine_of_turns(drive.frequency * time).cosine;
    if (time >= drive.ramp) return whole;
    return whole * 0.5 * (1.0 - base::sine_cosine_of_turns(0.5 * time / drive.ramp).cosine);
}

}  // namespace stridor::integration
