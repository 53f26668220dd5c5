#include "stridor/integration/run/motion.hpp"

#include <algorithm>
#include <cmath>

namespace stridor::integration {

namespace {

// [1] a turnover below this share of the energy held is as good as none
constexpr double least_turnover = 1e-3;

}  // namespace

double EnergyBalance::relative_residual() const {
    const double turnover = std::abs(stored) + std::abs(preload_work) + std::abs(drive_work) + std::abs(dashpot_loss) +
                            std::abs(friction_loss) + std::abs(impact_loss);
    const double scale = std::max({turnover, least_turnover * held, least_turnover * carried});
    return scale > 0.0 ? residual / scale : 0.0;
}

double unexplained(const EnergyBalance& balance) {
    return balance.stored - balance.preload_work - balance.drive_work + balance.dashpot_loss + balance.friction_loss +
           balance.impact_loss;
}

Outcome weighed(const Outcome& outcome, const EnergyBalance& balance, double most_unexplained) {
    if (!has_result(outcome)) return outcome;
    const double share = balance.relative_residual();
    if (!std::isfinite(balance.residual) || !std::isfinite(share)) return {Reason::diverged, outcome.time};
    const bool is_balanced = std::abs(share) <= most_unexplained;
    return is_balanced ? outcome : Outcome{Reason::unbalanced, outcome.time};
}

}  // namespace stridor::integration
