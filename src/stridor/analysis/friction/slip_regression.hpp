#pragma once

#include "stridor/analysis/friction/slips.hpp"
#include "stridor/base/decompositions.hpp"
#include "stridor/parameters/case.hpp"

#include <limits>
#include <vector>

/// The least squares behind `fit_of_slips`.
namespace stridor::analysis {

/// The numbers of a law's shape and of the rig; the last three by their logarithm.
enum class ShapeNumber { ratio, slope, velocity, stiffness, mass };

/// A law to be fitted, and on which rig.
struct SlipModel {
    parameters::FrictionKind kind = parameters::FrictionKind::coulomb;
    double exponent = 1.0;  // [1] delta
    MeasuringRig rig{};     // what is to be fitted of it has its first guess
    std::vector<ShapeNumber> numbers{};
};

/// The numbers of a law's shape, and each slip's own.
struct SlipFit {
    std::vector<double> shape{};                               // shape [number]
    std::vector<double> onset{};                               // [s] shape [slip]
    std::vector<double> limit{};                               // [N] shape [slip]
    double squares = std::numeric_limits<double>::infinity();  // [N^2]
};

/// How much each slip pulls at the numbers, and what the law leaves of it.
struct SlipDeviations {
    Eigen::VectorXd ratios;                      // [1] F_i/N_i, shape [slip]
    Eigen::VectorXd limits;                      // [1] influence on mu_s, shape [slip]
    Eigen::MatrixXd shape;                       // and on the shape, shape [slip][number]
    std::vector<std::vector<double>> residuals;  // [N] shape [slip][sample]
};

/// Returns a fit with this shape in which each slip lets go where it suits it best.
SlipFit released(const std::vector<RecordedSlip>& slips, const SlipModel& model, std::vector<double> shape);

/// Returns the fit after steps until the sum of squares falls no more, or after so many.
SlipFit refined(const std::vector<RecordedSlip>& slips, const SlipModel& model, SlipFit fit, int most_steps);

/// Returns the influences at a fit.
SlipDeviations deviations_of(const std::vector<RecordedSlip>& slips, const SlipModel& model, const SlipFit& fit);

}  // namespace stridor::analysis
