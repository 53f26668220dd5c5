#include "stridor/integration/energy_balance.hpp"

#include <cmath>

namespace stridor::integration {

double EnergyBalance::relative_residual() const {
    const double turnover = std::abs(stored) + std::abs(preload_work) + std::abs(drive_work) + std::abs(dashpot_loss) +
                            std::abs(friction_loss) + std::abs(impact_loss);
    return turnover > 0.0 ? residual / turnover : 0.0;
}

double unexplained(const EnergyBalance& balance) {
    return balance.stored - balance.preload_work - balance.drive_work + balance.dashpot_loss + balance.friction_loss +
           balance.impact_loss;
}

}  // namespace stridor::integration
