#include "stridor/analysis/sliding_stability.hpp"

#include "stridor/model/complement.hpp"
#include "stridor/model/equilibrium.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace stridor::analysis {

namespace {

constexpr double two_pi = 6.283185307179586476925;
// an undamped mode's real part comes out as rounding: growth below this share of the largest eigenvalue is none
constexpr double rounding = 1e-9;

bool slower(const Eigenmode& a, const Eigenmode& b) {
    return a.frequency != b.frequency ? a.frequency < b.frequency : a.growth < b.growth;
}

}  // namespace

std::vector<std::complex<double>> eigenvalues(const SlidingMotion& motion) {
    using Eigen::MatrixXd;
    const Eigen::Index free = motion.mass.rows() - 1;
    const MatrixXd right = model::orthogonal_complement(motion.normal);
    const MatrixXd left = right - motion.normal * (motion.force.transpose() * right) / motion.normal.dot(motion.force);
    const auto reduced = [&](const MatrixXd& matrix) { return model::reduced(left, matrix, right); };
    const MatrixXd negative_inverse_mass = -reduced(motion.mass).inverse();
    MatrixXd first_order = MatrixXd::Zero(2 * free, 2 * free);
    first_order.topRightCorner(free, free) = MatrixXd::Identity(free, free);
    first_order.bottomLeftCorner(free, free) = negative_inverse_mass.lazyProduct(reduced(motion.stiffness));
    first_order.bottomRightCorner(free, free) = negative_inverse_mass.lazyProduct(reduced(motion.damping));
    const Eigen::EigenSolver<MatrixXd> solver(first_order, false);
    return {solver.eigenvalues().begin(), solver.eigenvalues().end()};
}

SlidingStability classify_modes(const std::vector<std::complex<double>>& eigenvalues, double normal_force) {
    SlidingStability result;
    result.normal_force = normal_force;
    for (const std::complex<double>& value : eigenvalues)
        if (value.imag() >= 0.0) result.modes.push_back({value.real(), value.imag() / two_pi});
    std::sort(result.modes.begin(), result.modes.end(), slower);
    const auto fastest = std::max_element(result.modes.begin(), result.modes.end(),
                                          [](const Eigenmode& a, const Eigenmode& b) { return a.growth < b.growth; });
    if (fastest == result.modes.end()) return result;
    result.growth = fastest->growth;
    result.frequency = fastest->frequency;
    double largest = 0.0;
    for (const std::complex<double>& value : eigenvalues)
        largest = std::max(largest, std::abs(value));
    if (!(normal_force > 0.0))
        result.kind = StabilityKind::locked;
    else if (fastest->growth > rounding * largest)
        result.kind = fastest->frequency > 0.0 ? StabilityKind::flutter : StabilityKind::divergence;
    return result;
}

SlidingStability sliding_stability(const model::Structure& structure, parameters::Direction direction) {
    const model::ContactPoint& contact = model::only_contact(structure, "stability of sliding");
    const std::vector<double> ratios =
        model::sliding_ratios(structure, direction == parameters::Direction::going ? 1.0 : -1.0);
    const SlidingMotion motion{structure.mass, structure.damping, structure.stiffness, contact.normal,
                               contact.normal + ratios.front() * contact.tangent};
    return classify_modes(eigenvalues(motion), model::equilibrium(structure, ratios).normal_forces(0));
}

}  // namespace stridor::analysis
