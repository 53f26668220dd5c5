#include "stridor/integration/energy_balance.hpp"

#include <cmath>

namespace stridor::integration {

double EnergyBalance::relative_residual() const {
    const double turnover = std::abs(stored) + std::abs(preload_work) + std::abs(drive_work) + std::abs(dashpot_loss) +
                            std::abs(friction_loss) + std::abs(impact_loss);
    return turnover > 0.0 ? residual / turnover : 0.0;
}

}  // namespace stridor::integration
