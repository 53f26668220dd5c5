#pragma once

#include "stridor/analysis/friction/trace.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <string_view>

/// A number from 1 to 10 for the noise that a run of a rig lets expect, in the style of the risk priority numbers that
/// laboratories report with VDA 230-206.
///
/// The tables behind those are not public, and this is not that number. The rule here is open: three figures, each on a
/// scale of its own, and the worst one counts.
namespace stridor::analysis {

/// A figure of a run, and the scale on which it is ranked.
struct RiskScale {
    std::string_view key;
    std::string_view unit;
    std::string_view sentence;
    double low = 0.0;   // [unit] rank 1 up to here
    double high = 1.0;  // [unit] rank 10 from here on; by the logarithm between them
};

inline constexpr std::size_t risk_figures = 3;
using RiskScales = std::array<RiskScale, risk_figures>;

/// The scales unless others are asked for: from what is hardly felt to what is surely heard, chosen for soft parts of a
/// car at 1 to 4 mm/s. They are round numbers, not measured ones.
inline constexpr RiskScales usual_risk_scales{
    {{"acceleration", "m/s^2", "half the largest drop over the rig's mass", 0.1, 10.0},
     {"impulse_rate", "1/s", "drops per moving time", 0.1, 100.0},
     {"energy_rate", "W", "energy that the rig's spring loses in drops per moving time", 1e-6, 1e-3}}};

/// The rig's numbers; NaN where they are not known, and the figures that need them neither.
struct RiskRig {
    double mass = std::numeric_limits<double>::quiet_NaN();       // [kg]
    double stiffness = std::numeric_limits<double>::quiet_NaN();  // [N/m]
};

/// Figures of a run and their ranks.
struct RiskNumber {
    std::array<double, risk_figures> figures{};  // [unit of the scale] NaN where not known
    std::array<double, risk_figures> ranks{};    // [1] 1 to 10; NaN where not known
    int number = 1;                              // the highest rank, rounded up
};

/// Returns the rank of a figure: 1 + 9 log(x/low)/log(high/low), from 1 to 10.
double risk_rank(double figure, const RiskScale& scale);

/// Returns figures, ranks and number of a run.
///
/// The acceleration is that of a contact that lets go: the spring still pulls with mu_s N while friction is mu_d N. A
/// drop measured through a spring that is little damped is twice their difference.
RiskNumber risk_number(const FrictionTrace& trace, const RiskRig& rig, const RiskScales& scales = usual_risk_scales);

/// Returns what a number means: 1 to 3 "quiet", 4 and 5 "may be heard", from 6 on "noise".
std::string_view risk_word(int number);

}  // namespace stridor::analysis
