#include "stridor/analysis/sliding_stability.hpp"

#include "stridor/base/decompositions.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/model/contact_state.hpp"
#include "stridor/model/linear/complement.hpp"
#include "stridor/model/linear/linearised.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace stridor::analysis {

namespace {

bool slower(const Eigenmode& a, const Eigenmode& b) {
    return a.frequency != b.frequency ? a.frequency < b.frequency : a.growth < b.growth;
}

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;

// undamped motions without friction that keep the contacts closed
struct FreeModes {
    std::vector<double> frequencies;  // [Hz]
    MatrixXd shapes;                  // phi, shape [dof][mode]
};

FreeModes free_modes(const model::SlidingMotion& motion, const MatrixXd& directions) {
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(
        model::reduced(directions, motion.stiffness, directions), model::reduced(directions, motion.mass, directions));
    FreeModes modes{{}, directions * solver.eigenvectors()};
    for (const double squared : solver.eigenvalues())
        modes.frequencies.push_back(std::sqrt(std::max(0.0, squared)) / base::two_pi);
    return modes;
}

// the largest row becomes 1
VectorXcd normalised(const VectorXcd& shape) {
    Index largest = 0;
    shape.cwiseAbs().maxCoeff(&largest);
    return shape / shape(largest);
}

double energy_of(const MatrixXd& matrix, const VectorXcd& shape) {
    return shape.dot(matrix.cast<std::complex<double>>() * shape).real();
}

void add_contributions(SlidingMode& mode, const FreeModes& free, const MatrixXd& mass) {
    const VectorXcd amounts = free.shapes.transpose() * (mass * mode.shape);
    const VectorXcd projections = free.shapes.transpose() * mode.shape;
    const double all = amounts.squaredNorm();
    const double size = mode.shape.squaredNorm();
    for (Index k = 0; k < amounts.size(); ++k) {
        mode.energy_shares.push_back(std::norm(amounts(k)) / all);
        mode.mac.push_back(std::norm(projections(k)) / (free.shapes.col(k).squaredNorm() * size));
    }
}

// what friction and damping add to the growth, from the balance of power
void add_growths(SlidingMode& mode, const SteadySliding& sliding, const model::Structure& structure) {
    const model::SlidingMotion& motion = sliding.motion;
    const std::complex<double> lambda = mode.eigenvalue;
    const double rate = std::norm(lambda);
    const double energy = 0.25 * (rate * energy_of(motion.mass, mode.shape) + energy_of(motion.stiffness, mode.shape));
    mode.contact_growth.assign(structure.contacts.size(), 0.0);
    // a motion that neither moves nor strains anything has no growth to share
    if (energy == 0.0) return;
    mode.damping_growth = -0.25 * rate * energy_of(motion.damping, mode.shape) / energy;
    if (sliding.found.closed.empty()) return;
    VectorXcd rest = lambda * lambda * (motion.mass * mode.shape) + lambda * (motion.damping * mode.shape) +
                     motion.stiffness * mode.shape;
    const auto slip_of = [&](const Eigen::VectorXd& tangent) -> std::complex<double> {
        return lambda * tangent.cast<std::complex<double>>().dot(mode.shape);
    };
    // by their states
    std::vector<std::complex<double>> states(structure.contacts.size());
    for (const model::SlidingState& state : motion.states) {
        const std::complex<double> z = state.rate_by_slip * slip_of(state.tangent) / (lambda - state.rate);
        states[state.contact] = state.force * z;
        rest -= states[state.contact] * state.tangent;
    }
    const MatrixXd coupling = motion.held.transpose() * motion.forces;
    const VectorXcd normal_forces =
        coupling.cast<std::complex<double>>().partialPivLu().solve(motion.held.transpose() * rest);
    for (Index k = 0; k < normal_forces.size(); ++k) {
        const std::size_t contact = sliding.found.closed[static_cast<std::size_t>(k)];
        const std::complex<double> friction = sliding.ratios[contact] * normal_forces(k) + states[contact];
        const std::complex<double> slip = slip_of(structure.contacts[contact].tangent);
        mode.contact_growth[contact] = 0.25 * (friction * std::conj(slip)).real() / energy;
    }
}

// the numbers of one of each conjugate pair, fastest growth first
std::vector<Index> by_growth(const VectorXcd& values) {
    std::vector<Index> numbers;
    for (Index k = 0; k < values.size(); ++k)
        if (values(k).imag() >= 0.0) numbers.push_back(k);
    std::stable_sort(numbers.begin(), numbers.end(),
                     [&](Index a, Index b) { return values(a).real() > values(b).real(); });
    return numbers;
}

}  // namespace

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
    if (!(normal_force > 0.0))
        result.kind = StabilityKind::locked;
    else if (fastest->growth > model::growth_rounding(eigenvalues))
        result.kind = fastest->frequency > 0.0 ? StabilityKind::flutter : StabilityKind::divergence;
    return result;
}

SteadySliding steady_sliding(const model::Structure& structure, parameters::Direction direction, double speed) {
    model::expect_one_tangent(structure, "the stability of steady sliding");
    const double velocity = direction == parameters::Direction::going ? speed : -speed;
    std::vector<double> ratios = model::sliding_ratios(structure, velocity);
    model::ClosedContacts found = model::closed_contacts(structure, ratios);
    std::vector<model::ContactState> states(structure.contacts.size(), model::ContactState::separation);
    for (const std::size_t number : found.closed)
        states[number] = model::ContactState::slip;
    model::SlidingMotion motion =
        model::sliding_motion(model::linearised_at(structure, found.equilibrium.displacement), states, ratios);
    add_slopes(motion, structure, states, velocity, found.equilibrium.normal_forces);
    if (!has_inertia(motion))
        base::refuse("the stability of steady sliding needs inertia",
                     "a motion that the closed contacts allow moves no mass", "Give each row that can move a mass.");
    return {std::move(found), std::move(ratios), std::move(motion)};
}

double sliding_speed(const parameters::Drive& drive) {
    const double speed = std::abs(parameters::velocity_profile(drive).velocity);
    return speed > 0.0 ? speed : 1.0;
}

SlidingStability sliding_stability(const model::Structure& structure, parameters::Direction direction, double speed) {
    const auto [found, ratios, motion] = steady_sliding(structure, direction, speed);
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t number : found.closed)
        least = std::min(least, found.equilibrium.normal_forces(static_cast<Eigen::Index>(number)));
    SlidingStability stability = classify_modes(eigenvalues(motion), least);
    for (std::size_t number = 0; number < structure.contacts.size(); ++number)
        if (std::find(found.closed.begin(), found.closed.end(), number) == found.closed.end())
            stability.open.push_back(number);
    return stability;
}

std::vector<std::size_t> by_share(const SlidingMode& mode) {
    std::vector<std::size_t> numbers(mode.energy_shares.size());
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    std::stable_sort(numbers.begin(), numbers.end(),
                     [&](std::size_t a, std::size_t b) { return mode.energy_shares[a] > mode.energy_shares[b]; });
    return numbers;
}

SlidingModes sliding_modes(const model::Structure& structure, parameters::Direction direction, std::size_t most,
                           double speed) {
    const SteadySliding sliding = steady_sliding(structure, direction, speed);
    const model::FirstOrderMotion first = first_order(sliding.motion);
    const Index free = first.directions.cols();
    if (free == 0) return {};
    const FreeModes reference = free_modes(sliding.motion, first.directions);
    const Eigen::EigenSolver<MatrixXd> solver(first.matrix);
    const VectorXcd values = solver.eigenvalues();
    const MatrixXcd vectors = solver.eigenvectors();
    constexpr double rounding = 1e-9;  // of the largest eigenvalue, as `classify_modes` has it
    const double least = rounding * values.cwiseAbs().maxCoeff();
    SlidingModes result{reference.frequencies, {}};
    for (const Index number : by_growth(values)) {
        const bool is_wanted = result.modes.empty() || values(number).real() > least;
        if (!is_wanted || result.modes.size() >= most) break;
        SlidingMode mode;
        mode.eigenvalue = values(number);
        mode.shape = normalised(first.directions * vectors.col(number).head(free));
        add_contributions(mode, reference, sliding.motion.mass);
        add_growths(mode, sliding, structure);
        result.modes.push_back(std::move(mode));
    }
    return result;
}

}  // namespace stridor::analysis
