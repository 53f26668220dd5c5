#include "stridor/analysis/sliding_stability.hpp"

#include "stridor/base/decompositions.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/model/complement.hpp"
#include "stridor/model/equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace stridor::analysis {

namespace {

// an undamped mode's real part comes out as rounding: growth below this share of the largest eigenvalue is none
constexpr double rounding = 1e-9;
// [1/s] where nothing has any stiffness
constexpr double smallest_rate = 1.0;

using Eigen::MatrixXd;

bool slower(const Eigenmode& a, const Eigenmode& b) {
    return a.frequency != b.frequency ? a.frequency < b.frequency : a.growth < b.growth;
}

// columns that no contact force moves
MatrixXd forceless(const SlidingMotion& motion, const MatrixXd& right) {
    const MatrixXd coupling = motion.forces.transpose().lazyProduct(motion.normals);
    const MatrixXd pushed = motion.forces.transpose().lazyProduct(right);
    return right - motion.normals.lazyProduct(coupling.partialPivLu().solve(pushed).eval());
}

}  // namespace

FirstOrderMotion first_order(const SlidingMotion& motion) {
    const Eigen::Index free = motion.mass.rows() - motion.normals.cols();
    if (free == 0) return {MatrixXd(0, 0), MatrixXd(motion.mass.rows(), 0)};
    const MatrixXd right =
        motion.normals.cols() == 0 ? MatrixXd::Identity(free, free) : model::orthogonal_complement(motion.normals);
    const MatrixXd left = motion.normals.cols() == 0 ? right : forceless(motion, right);
    const auto reduced = [&](const MatrixXd& matrix) { return model::reduced(left, matrix, right); };
    const Eigen::PartialPivLU<MatrixXd> mass(reduced(motion.mass));
    const MatrixXd stiffness = mass.solve(reduced(motion.stiffness));
    // positions in units of velocity: the solver's error is a share of the largest entry
    const double rate = std::max(std::sqrt(stiffness.cwiseAbs().rowwise().sum().maxCoeff()), smallest_rate);
    MatrixXd matrix = MatrixXd::Zero(2 * free, 2 * free);
    matrix.topRightCorner(free, free) = rate * MatrixXd::Identity(free, free);
    matrix.bottomLeftCorner(free, free) = -stiffness / rate;
    matrix.bottomRightCorner(free, free) = -mass.solve(reduced(motion.damping));
    return {std::move(matrix), right};
}

std::vector<std::complex<double>> eigenvalues(const SlidingMotion& motion) {
    const MatrixXd matrix = first_order(motion).matrix;
    if (matrix.rows() == 0) return {};
    const Eigen::EigenSolver<MatrixXd> solver(matrix, false);
    return {solver.eigenvalues().begin(), solver.eigenvalues().end()};
}

SlidingStability classify_modes(const std::vector<std::complex<double>>& eigenvalues, double normal_force) {
    SlidingStability result;
    result.normal_force = normal_force;
    for (const std::complex<double>& value : eigenvalues)
        if (value.imag() >= 0.0) result.modes.push_back({value.real(), value.imag() / base::two_pi});
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

namespace {

// does each motion along the closed contacts move some mass? a row without any may be held by a contact
bool has_inertia(const SlidingMotion& motion) {
    constexpr double massless_share = 1e-14;  // [1] of the largest pivot
    if (motion.mass.rows() == motion.normals.cols()) return true;
    MatrixXd mass = motion.mass;
    if (motion.normals.cols() > 0) {
        const MatrixXd along = model::orthogonal_complement(motion.normals);
        mass = model::reduced(along, motion.mass, along);
    }
    const Eigen::VectorXd pivots = mass.ldlt().vectorD();
    return pivots.minCoeff() > massless_share * pivots.maxCoeff();
}

}  // namespace

SteadySliding steady_sliding(const model::Structure& structure, parameters::Direction direction) {
    model::expect_one_tangent(structure, "the stability of steady sliding");
    std::vector<double> ratios =
        model::sliding_ratios(structure, direction == parameters::Direction::going ? 1.0 : -1.0);
    model::ClosedContacts found = model::closed_contacts(structure, ratios);
    const Eigen::Index dofs = model::dofs_of(structure);
    const auto count = static_cast<Eigen::Index>(found.closed.size());
    SlidingMotion motion{structure.mass, structure.damping, structure.stiffness, MatrixXd(dofs, count),
                         MatrixXd(dofs, count)};
    for (Eigen::Index k = 0; k < count; ++k) {
        const std::size_t number = found.closed[static_cast<std::size_t>(k)];
        const model::ContactPoint& contact = structure.contacts[number];
        motion.normals.col(k) = contact.normal;
        motion.forces.col(k) = contact.normal + ratios[number] * contact.tangent;
    }
    if (!has_inertia(motion))
        base::refuse("the stability of steady sliding needs inertia",
                     "a motion that the closed contacts allow moves no mass", "Give each row that can move a mass.");
    return {std::move(found), std::move(ratios), std::move(motion)};
}

SlidingStability sliding_stability(const model::Structure& structure, parameters::Direction direction) {
    const auto [found, ratios, motion] = steady_sliding(structure, direction);
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t number : found.closed)
        least = std::min(least, found.equilibrium.normal_forces(static_cast<Eigen::Index>(number)));
    SlidingStability stability = classify_modes(eigenvalues(motion), least);
    for (std::size_t number = 0; number < structure.contacts.size(); ++number)
        if (std::find(found.closed.begin(), found.closed.end(), number) == found.closed.end())
            stability.open.push_back(number);
    return stability;
}

}  // namespace stridor::analysis
