#include "stridor/integration/proofs/sliding_growth.hpp"

#include "stridor/base/decompositions.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/model/contact/equilibrium.hpp"
#include "stridor/model/linear/linearised.hpp"
#include "stridor/model/linear/sliding_motion.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace stridor::integration {

namespace {

constexpr double natural_per_doubling = 0.6931471805599453;  // [1] ln 2

using Eigen::Index;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using model::ContactState;
using record::Future;

double slip_share_of(const record::ContactTally& contact) {
    double all = 0.0;
    for (const double time : contact.judged_time)
        all += time;
    return contact.judged_time[model::index_of(ContactState::slip)] / all;
}

bool is_asked(const record::ContactTally& contact, double least_slip) {
    const Future future = contact.ending.outlook.future;
    const bool is_known = future == Future::slides || future == Future::sticks;
    return !is_known && slip_share_of(contact) >= least_slip;
}

// the state in which each contact spent most of the judged time
std::vector<ContactState> usual_states(const record::Tally& tally) {
    std::vector<ContactState> states;
    for (const record::ContactTally& contact : tally.contacts) {
        const auto most = std::max_element(contact.judged_time.begin(), contact.judged_time.end());
        states.push_back(static_cast<ContactState>(most - contact.judged_time.begin()));
    }
    return states;
}

bool has_stick(const std::vector<ContactState>& states) {
    return std::find(states.begin(), states.end(), ContactState::stick) != states.end();
}

// where all of it rests, moving with none of the contacts, of which none sticks
model::Equilibrium rest_of(const model::Structure& structure, const std::vector<ContactState>& states,
                           const std::vector<double>& ratios) {
    model::Structure closed = structure;
    closed.contacts.clear();
    std::vector<double> of_closed;
    for (std::size_t k = 0; k < states.size(); ++k) {
        if (states[k] == ContactState::separation) continue;
        closed.contacts.push_back(structure.contacts[k]);
        of_closed.push_back(ratios[k]);
    }
    return model::equilibrium(closed, of_closed);
}

// [N] of the contacts where all of it rests, shape [contact]; those of open ones are infinite, and all where some stick
std::vector<double> normal_forces(const model::Structure& structure, const std::vector<ContactState>& states,
                                  const std::vector<double>& ratios) {
    std::vector<double> forces(states.size(), std::numeric_limits<double>::infinity());
    if (has_stick(states)) return forces;
    const VectorXd found = rest_of(structure, states, ratios).normal_forces;
    Index row = 0;
    for (std::size_t k = 0; k < states.size(); ++k)
        if (states[k] != ContactState::separation) forces[k] = found(row++);
    return forces;
}

// a disturbance that grows
struct Growing {
    double growth = 0.0;                 // [1/s]; 0: there is nothing to grow from
    std::optional<double> times_larger;  // [1] than now, when a contact first stops slipping; nothing: unknown
};

// [m/s] amplitudes of the vibration, shape [channel]: at the run's end where that is known
VectorXd last_speeds(const record::Tally& tally) {
    const bool has_closing = tally.closing_time > 0.0;
    const std::vector<record::Vibration>& all = has_closing ? tally.closing_vibration : tally.vibration;
    VectorXd speeds(static_cast<Index>(all.size()));
    for (std::size_t k = 0; k < all.size(); ++k)
        speeds(static_cast<Index>(k)) =
            std::sqrt(2.0 * all[k].square_time / (has_closing ? tally.closing_time : tally.vibration_time));
    return speeds;
}

// by how much the fastest disturbance must grow until a contact sticks (w = 0) or lifts off (N = 0)
std::optional<double> times_larger(const model::Structure& structure, const model::SlidingMotion& motion,
                                   const std::vector<ContactState>& states, const std::vector<double>& forces,
                                   const record::Tally& tally, double surface_velocity) {
    const model::FirstOrderMotion first = first_order(motion);
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(first.matrix);
    Index fastest = 0;
    solver.eigenvalues().real().maxCoeff(&fastest);
    const std::complex<double> lambda = solver.eigenvalues()(fastest);
    const VectorXcd shape = first.directions * solver.eigenvectors().col(fastest).head(first.directions.cols());
    const VectorXd speed_shape = structure.measured.size() == 0
                                     ? VectorXd(std::abs(lambda) * shape.cwiseAbs())
                                     : VectorXd(std::abs(lambda) * (structure.measured * shape).cwiseAbs());
    Index channel = 0;
    const double largest = speed_shape.maxCoeff(&channel);
    const double size = last_speeds(tally)(channel) / largest;  // of the disturbance, in shapes
    const VectorXcd rest =
        lambda * lambda * (motion.mass * shape) + lambda * (motion.damping * shape) + motion.stiffness * shape;
    const Eigen::MatrixXd coupling = motion.held.transpose() * motion.forces;
    const VectorXcd pushes = coupling.cast<std::complex<double>>().partialPivLu().solve(motion.held.transpose() * rest);
    double least = std::numeric_limits<double>::infinity();
    Index row = 0;
    for (std::size_t k = 0; k < states.size(); ++k) {
        if (states[k] == ContactState::separation) continue;
        const model::ContactPoint& contact = structure.contacts[k];
        if (states[k] == ContactState::slip) {
            const double slip = std::abs(lambda * contact.tangent.cast<std::complex<double>>().dot(shape));
            least = std::min(
                {least, forces[k] / std::abs(pushes(row)), std::abs(contact.drive_share * surface_velocity) / slip});
        }
        row += states[k] == ContactState::stick ? 2 : 1;
    }
    if (!(size > 0.0) || !std::isfinite(least)) return std::nullopt;
    return std::max(1.0, least / size);
}

bool has_slopes(const model::Structure& structure) {
    return std::any_of(structure.contacts.begin(), structure.contacts.end(),
                       [](const model::ContactPoint& contact) { return !is_state_wise(contact.friction); });
}

// nothing where sliding lasts
std::optional<Growing> growing_near(const model::Structure& structure, const std::vector<ContactState>& states,
                                    const record::Tally& tally, double surface_velocity) {
    const std::vector<double> ratios = model::sliding_ratios(structure, surface_velocity);
    model::SlidingMotion motion = model::sliding_motion(structure, states, ratios);
    if (motion.held.cols() > motion.held.rows() || !has_inertia(motion)) return std::nullopt;
    const std::vector<double> forces = normal_forces(structure, states, ratios);
    if (has_slopes(structure)) {
        // what pushes a contact beside one that sticks is not known
        if (has_stick(states)) return std::nullopt;
        add_slopes(motion, structure, states, surface_velocity,
                   Eigen::Map<const VectorXd>(forces.data(), static_cast<Index>(forces.size())));
    }
    const std::vector<std::complex<double>> values = eigenvalues(motion);
    double fastest = 0.0;
    for (const std::complex<double>& value : values)
        fastest = std::max(fastest, value.real());
    const bool presses = *std::min_element(forces.begin(), forces.end()) > 0.0;
    if (!(fastest > model::growth_rounding(values))) return presses ? std::nullopt : std::optional(Growing{});
    if (!presses) return Growing{fastest, std::nullopt};
    return Growing{fastest, times_larger(structure, motion, states, forces, tally, surface_velocity)};
}

// With springs: small disturbances of a rest that sliding has. Where it has none it does not last. When a growing one
// ends the sliding is not told: it is not small then, and springs that stiffen may hold it.
std::optional<Growing> growing_on_springs(const model::Structure& structure, const std::vector<ContactState>& states,
                                          const record::Tally& tally, double surface_velocity) {
    // beside a contact that sticks they are stretched ever more
    if (has_stick(states)) return std::nullopt;
    const model::Equilibrium rest = rest_of(structure, states, model::sliding_ratios(structure, surface_velocity));
    if (!rest.displacement.allFinite()) return Growing{};
    std::optional<Growing> found =
        growing_near(model::linearised_at(structure, rest.displacement), states, tally, surface_velocity);
    if (found) found->times_larger.reset();
    return found;
}

}  // namespace

void tell_growth(const model::Structure& structure, const SteadyRun& run, std::vector<record::Tally>& phases) {
    if (run.surface_velocity == 0.0 || std::any_of(structure.contacts.begin(), structure.contacts.end(),
                                                   [](const auto& contact) { return has_two_tangents(contact); }))
        return;
    for (record::Tally& tally : phases) {
        const auto is_meant = [&](const record::ContactTally& contact) { return is_asked(contact, run.least_slip); };
        if (std::none_of(tally.contacts.begin(), tally.contacts.end(), is_meant)) continue;
        const auto growing = structure.springs.empty() ? growing_near : growing_on_springs;
        const std::optional<Growing> found = growing(structure, usual_states(tally), tally, run.surface_velocity);
        if (!found) continue;
        for (record::ContactTally& contact : tally.contacts) {
            if (!is_meant(contact)) continue;
            record::Outlook& outlook = contact.ending.outlook;
            outlook.growth = found->growth;
            if (found->times_larger)
                outlook.grown =
                    run.end + base::logarithm_2(*found->times_larger) * natural_per_doubling / found->growth;
        }
    }
}

}  // namespace stridor::integration
