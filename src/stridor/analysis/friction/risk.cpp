#include "stridor/analysis/friction/risk.hpp"

#include <algorithm>
#include <cmath>

namespace stridor::analysis {

double risk_rank(double figure, const RiskScale& scale) {
    if (std::isnan(figure)) return figure;
    if (figure <= scale.low) return 1.0;
    return std::min(10.0, 1.0 + 9.0 * std::log(figure / scale.low) / std::log(scale.high / scale.low));
}

RiskNumber risk_number(const FrictionTrace& trace, const RiskRig& rig, const RiskScales& scales) {
    RiskNumber risk;
    const double largest = trace.all.drops > 0 ? trace.all.largest_drop : 0.0;
    double energy = 0.0;
    for (const ForceDrop& drop : trace.drops)
        energy += 0.5 * (drop.from * drop.from - drop.to * drop.to) / rig.stiffness;
    if (trace.drops.empty()) energy = 0.0;
    risk.figures = {trace.all.drops > 0 ? 0.5 * largest / rig.mass : 0.0, trace.all.drop_rate,
                    trace.all.moving_time > 0.0 ? energy / trace.all.moving_time : 0.0};
    double highest = 1.0;
    for (std::size_t k = 0; k < risk_figures; ++k) {
        risk.ranks[k] = risk_rank(risk.figures[k], scales[k]);
        if (risk.ranks[k] > highest) highest = risk.ranks[k];
    }
    // a rank on a whole number must not be lifted by rounding
    risk.number = static_cast<int>(std::ceil(highest - 1e-9));
    return risk;
}

std::string_view risk_word(int number) {
    return number <= 3 ? "quiet" : number <= 5 ? "may be heard" : "noise";
}

}  // namespace stridor::analysis
