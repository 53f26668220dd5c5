#include "stridor/integration/rules/fastest_slip.hpp"

#include <algorithm>
#include <cmath>

namespace stridor::integration {

namespace {

constexpr double lawful_rounding = 4e-16;  // [1] of mu, or of 1 where it is smaller
constexpr int most_safe_turns = 100;       // towards the least root; few near a unique one
constexpr int most_bracket_turns = 200;    // halving alone needs some 60
constexpr int most_widenings = 60;         // doublings of the end of the bracket

}  // namespace

std::optional<double> ratio_of_fastest_slip(const model::FrictionLaw& law, model::Slip way, double reach,
                                            const std::function<double(double)>& velocity_at) {
    const double sign = way == model::Slip::forward ? -1.0 : 1.0;  // of T/N
    double velocity = 0.0;                                         // [m/s] of the mu tried last
    const auto psi = [&](double mu) {
        velocity = velocity_at(sign * mu);
        return mu - std::abs(slip_ratio(law, way, velocity));
    };
    const auto tolerance = [](double mu) { return lawful_rounding * std::max(1.0, mu); };
    const double steepest = 1.0 + reach * slope_range(law).most;
    double low = 0.0;
    for (int turn = 0; turn < most_safe_turns; ++turn) {
        const double off = psi(low);
        if (std::abs(off) <= tolerance(low)) return sign * low;
        if (!(off < 0.0)) break;
        low -= off / steepest;
    }
    double high = std::max(2.0 * low, std::abs(slip_ratio(law, way)));
    for (int turn = 0; !(psi(high) >= 0.0); ++turn, high *= 2.0)
        if (turn == most_widenings) return std::nullopt;
    double mu = low;
    for (int turn = 0; turn < most_bracket_turns; ++turn) {
        const double off = psi(mu);
        if (std::abs(off) <= tolerance(mu) || high - low <= tolerance(high)) return sign * mu;
        (off < 0.0 ? low : high) = mu;
        // Newton's step; halving where that leads out of the bracket, and now and then, so that both its ends close in
        const double next = mu - off / (1.0 - reach * slip_ratio_slope(law, way, velocity));
        mu = next > low && next < high && turn % 3 != 2 ? next : 0.5 * (low + high);
    }
    return sign * mu;
}

}  // namespace stridor::integration
