#pragma once

#include "stridor/analysis/friction/risk.hpp"
#include "stridor/io/simulation/fitted_friction.hpp"

#include <functional>
#include <string>
#include <vector>

/// The risk number of a rig's runs, beside the verdict that the model gives on them.
namespace stridor::io {

/// One run.
struct RunRisk {
    FrictionTest test{};
    analysis::RiskNumber risk{};
    std::string
        category{};  // of the model with the measured coefficients on this rig; empty: what it needs is not known
};

/// Several runs.
struct RigRisk {
    analysis::RiskScales scales = analysis::usual_risk_scales;
    std::vector<RunRisk> runs{};
    int number = 1;  // of the worst run
};

/// Reads recordings and ranks each, where a range is "acceleration=0.1:10 m/s^2"; `note` is told what is noteworthy.
///
/// Where mass, stiffness and velocity are known, the model's slider on this spring is dragged at the run's preload and
/// velocity with its two coefficients for ten seconds, and judged by its contact states. Throws `Error` (input) for a
/// range of no figure, a range that does not rise, and what reading and measuring throw.
RigRisk rig_risk(const FrictionFitTexts& texts, const std::vector<std::string>& ranges,
                 const std::function<void(const std::string&)>& note);

/// Returns "stridor.friction-risk/1": figures, ranks and number of each run, the scales, the model's category.
std::string rig_risk_json(const RigRisk& risk);

}  // namespace stridor::io
