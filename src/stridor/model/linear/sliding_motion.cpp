#include "stridor/model/linear/sliding_motion.hpp"

#include "stridor/base/decompositions.hpp"
#include "stridor/model/linear/complement.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace stridor::model {

namespace {

constexpr double eigenvalue_rounding = 1e-9;  // [1] of the largest eigenvalue
// [1/s] where nothing has any stiffness
constexpr double smallest_rate = 1.0;

using Eigen::Index;
using Eigen::MatrixXd;

// columns that no contact force moves
MatrixXd forceless(const SlidingMotion& motion, const MatrixXd& right) {
    const MatrixXd coupling = motion.forces.transpose().lazyProduct(motion.held);
    const MatrixXd pushed = motion.forces.transpose().lazyProduct(right);
    return right - motion.held.lazyProduct(coupling.partialPivLu().solve(pushed).eval());
}

}  // namespace

SlidingMotion sliding_motion(const Structure& structure, const std::vector<ContactState>& states,
                             const std::vector<double>& ratios) {
    Index count = 0;
    for (const ContactState state : states)
        count += state == ContactState::separation ? 0 : state == ContactState::stick ? 2 : 1;
    const Index dofs = dofs_of(structure);
    SlidingMotion motion{structure.mass, structure.damping, structure.stiffness, MatrixXd(dofs, count),
                         MatrixXd(dofs, count)};
    Index column = 0;
    for (std::size_t k = 0; k < states.size(); ++k) {
        if (states[k] == ContactState::separation) continue;
        const ContactPoint& contact = structure.contacts[k];
        motion.held.col(column) = motion.forces.col(column) = contact.normal;
        if (states[k] == ContactState::slip) motion.forces.col(column) += ratios[k] * contact.tangent;
        ++column;
        if (states[k] != ContactState::stick) continue;
        motion.held.col(column) = motion.forces.col(column) = contact.tangent;
        ++column;
    }
    return motion;
}

void add_slopes(SlidingMotion& motion, const Structure& structure, const std::vector<ContactState>& states,
                double surface_velocity, const Eigen::VectorXd& normal_forces) {
    for (std::size_t k = 0; k < states.size(); ++k) {
        const ContactPoint& contact = structure.contacts[k];
        if (states[k] != ContactState::slip || is_state_wise(contact.friction)) continue;
        const double w = -contact.drive_share * surface_velocity;
        const double N = normal_forces(static_cast<Index>(k));
        if (has_friction_state(contact.friction) && w != 0.0) {
            // seen from the slip, whose way has a sign
            const double way = w > 0.0 ? 1.0 : -1.0;
            const StateSlopes slopes = state_slopes(contact.friction, std::abs(w));
            motion.damping += N * slopes.resistance_by_speed * contact.tangent * contact.tangent.transpose();
            motion.states.push_back({k, contact.tangent, -way * N * slopes.resistance_by_state, slopes.rate_by_state,
                                     way * slopes.rate_by_speed});
            continue;
        }
        const double slope = slip_ratio_slope(contact.friction, slip_of(w), w);
        motion.damping -= N * slope * contact.tangent * contact.tangent.transpose();
    }
}

bool has_inertia(const SlidingMotion& motion) {
    constexpr double massless_share = 1e-14;  // [1] of the largest pivot
    if (motion.mass.rows() == motion.held.cols()) return true;
    MatrixXd mass = motion.mass;
    if (motion.held.cols() > 0) {
        const MatrixXd along = orthogonal_complement(motion.held);
        mass = reduced(along, motion.mass, along);
    }
    const Eigen::VectorXd pivots = mass.ldlt().vectorD();
    return pivots.minCoeff() > massless_share * pivots.maxCoeff();
}

FirstOrderMotion first_order(const SlidingMotion& motion) {
    const Index free = motion.mass.rows() - motion.held.cols();
    if (free == 0) return {MatrixXd(0, 0), MatrixXd(motion.mass.rows(), 0)};
    const MatrixXd right =
        motion.held.cols() == 0 ? MatrixXd::Identity(free, free) : orthogonal_complement(motion.held);
    const MatrixXd left = motion.held.cols() == 0 ? right : forceless(motion, right);
    const auto along = [&](const MatrixXd& matrix) { return reduced(left, matrix, right); };
    const Eigen::PartialPivLU<MatrixXd> mass(along(motion.mass));
    const MatrixXd stiffness = mass.solve(along(motion.stiffness));
    // positions in units of velocity: the solver's error is a share of the largest entry
    const double rate = std::max(std::sqrt(stiffness.cwiseAbs().rowwise().sum().maxCoeff()), smallest_rate);
    const Index all = 2 * free + static_cast<Index>(motion.states.size());
    MatrixXd matrix = MatrixXd::Zero(all, all);
    matrix.block(0, free, free, free) = rate * MatrixXd::Identity(free, free);
    matrix.block(free, 0, free, free) = -stiffness / rate;
    matrix.block(free, free, free, free) = -mass.solve(along(motion.damping));
    for (Index row = 2 * free; row < all; ++row) {
        const SlidingState& state = motion.states[static_cast<std::size_t>(row - 2 * free)];
        const Eigen::VectorXd given = mass.solve((left.transpose() * state.tangent).eval()) * state.force;
        const Eigen::VectorXd taken = right.transpose() * state.tangent * state.rate_by_slip;
        const bool is_coupled = given.norm() > 0.0 && taken.norm() > 0.0;
        const double unit = is_coupled ? std::sqrt(given.norm() / taken.norm()) : 1.0;
        matrix.block(free, row, free, 1) = given / unit;
        matrix.block(row, free, 1, free) = unit * taken.transpose();
        matrix(row, row) = state.rate;
    }
    return {std::move(matrix), right};
}

std::vector<std::complex<double>> eigenvalues(const SlidingMotion& motion) {
    const MatrixXd matrix = first_order(motion).matrix;
    if (matrix.rows() == 0) return {};
    const Eigen::EigenSolver<MatrixXd> solver(matrix, false);
    return {solver.eigenvalues().begin(), solver.eigenvalues().end()};
}

double growth_rounding(const std::vector<std::complex<double>>& eigenvalues) {
    double largest = 0.0;
    for (const std::complex<double>& value : eigenvalues)
        largest = std::max(largest, std::abs(value));
    return eigenvalue_rounding * largest;
}

}  // namespace stridor::model
