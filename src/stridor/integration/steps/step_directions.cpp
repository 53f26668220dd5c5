// Directions of slip of contacts with two tangents. With e = (cos a, sin a), e' = (-sin a, cos a) a slip has
//
//     T = -mu_d N e,   w = |w| e,   that is   c = e'.w = 0   with   e.w > 0
//
// A turn da of contact l changes T by -mu_d N e' da beside ratio N, whose columns stand in the tableau (D: w of all per
// unit of those). So Newton's method over the angles of all slips has
//
//     dc_k/da_l = -(e_k.w_k) [k = l] - mu_l N_l e'_k.D_kl e'_l
//
// The cone is the circle itself; no polygon stands for it.

#include "stridor/base/decompositions.hpp"
#include "stridor/integration/rules/contact_mode_of.hpp"
#include "stridor/integration/steps/step_contacts.hpp"

#include <algorithm>
#include <cmath>

namespace stridor::integration {

namespace {

using Eigen::Index;
using Plane = std::array<double, 2>;

constexpr double direction_rounding = 1e-12;  // [1] of the largest velocity: across a slip
constexpr int most_turns = 60;                // Newton's steps; each slip of a step mostly needs one or two
constexpr double largest_turn = 0.7;          // [rad] of one of them: from afar Newton's method overshoots

double product(const Plane& a, const Plane& b) {
    return a[0] * b[0] + a[1] * b[1];
}

Plane across(const Plane& direction) {
    return {-direction[1], direction[0]};
}

double length_of(const Plane& a) {
    return std::sqrt(product(a, a));
}

// turned by the angle of tangent `turn`: no sine is needed, and its length is one to rounding
Plane turned(const Plane& direction, double turn) {
    const Plane aside = across(direction);
    const Plane sum{direction[0] + turn * aside[0], direction[1] + turn * aside[1]};
    const double length = length_of(sum);
    return {sum[0] / length, sum[1] / length};
}

}  // namespace

void StepContacts::look_at_plane(std::size_t contact) {
    TriedContact& tried = tried_[contact];
    const std::size_t row = plan_.first[contact];
    tried.mode = set_[contact];
    const bool is_open = tried.mode == ContactMode::open;
    const bool is_stuck = tried.mode == ContactMode::stick;
    const double at_normal = tableau_.follows(row);
    tried.normal = force_[row] = is_open ? 0.0 : at_normal;
    tried.gap_velocity = rate_[row] = is_open ? at_normal : 0.0;
    for (std::size_t tangent = row + 1; tangent < row + 3; ++tangent) {
        const double at_tangent = tableau_.follows(tangent);
        force_[tangent] = is_open ? 0.0 : friction_[tangent] * tried.normal + (is_stuck ? at_tangent : 0.0);
        rate_[tangent] = is_stuck ? 0.0 : at_tangent;
    }
    tried.tangential = length_of({force_[row + 1], force_[row + 2]});
    // of a slip along its direction: below zero where it would turn round
    tried.slip_velocity = is_slip(tried.mode) ? product(direction_[contact], {rate_[row + 1], rate_[row + 2]})
                                              : length_of({rate_[row + 1], rate_[row + 2]});
}

// a stick whose limit broke slips against its force
ContactMode StepContacts::begin_slip(std::size_t contact) {
    const std::size_t row = plan_.first[contact];
    const Plane force{force_[row + 1], force_[row + 2]};
    direction_[contact] = {-force[0] / length_of(force), -force[1] / length_of(force)};
    return ContactMode::slip_forward;
}

// the slips whose direction is not yet that of their velocity; one that turns round becomes a stick first
std::vector<std::size_t> StepContacts::turning() {
    std::vector<std::size_t> found;
    bool is_settled = true;
    for (std::size_t k = 0; k < set_.size(); ++k) {
        if (!plan_.has_two_tangents(k) || !is_slip(set_[k])) continue;
        const std::size_t row = plan_.first[k];
        const Plane w{tableau_.follows(row + 1), tableau_.follows(row + 2)};
        const double aside = product(across(direction_[k]), w);
        if (product(direction_[k], w) < -std::abs(aside)) continue;
        found.push_back(k);
        is_settled = is_settled && std::abs(aside) <= direction_rounding * std::max(speed_, length_of(w));
    }
    if (is_settled) found.clear();
    return found;
}

bool StepContacts::settle_directions() {
    for (int turn = 0; turn < most_turns; ++turn) {
        const std::vector<std::size_t> slips = turning();
        if (slips.empty()) return true;
        const auto count = static_cast<Index>(slips.size());
        Eigen::MatrixXd slope(count, count);
        Eigen::VectorXd aside(count);
        for (Index a = 0; a < count; ++a) {
            const std::size_t k = slips[static_cast<std::size_t>(a)];
            const std::size_t row = plan_.first[k] + 1;
            const Plane w{tableau_.follows(row), tableau_.follows(row + 1)};
            const Plane e = across(direction_[k]);
            aside(a) = product(e, w);
            for (Index b = 0; b < count; ++b) {
                const std::size_t l = slips[static_cast<std::size_t>(b)];
                const std::size_t column = plan_.first[l] + 1;
                const Plane d = across(direction_[l]);
                const double mu = std::abs(slip_ratio(structure_.contacts[l].friction, model::Slip::forward));
                const double moved =
                    e[0] * (tableau_.entry(row, column) * d[0] + tableau_.entry(row, column + 1) * d[1]) +
                    e[1] * (tableau_.entry(row + 1, column) * d[0] + tableau_.entry(row + 1, column + 1) * d[1]);
                slope(a, b) = -mu * tableau_.follows(plan_.first[l]) * moved;
            }
            slope(a, a) -= product(direction_[k], w);
        }
        const Eigen::VectorXd turns = -slope.partialPivLu().solve(aside);
        if (!turns.allFinite()) return false;
        for (Index a = 0; a < count; ++a) {
            const std::size_t k = slips[static_cast<std::size_t>(a)];
            direction_[k] = turned(direction_[k], std::clamp(turns(a), -largest_turn, largest_turn));
            set_directions(k);
        }
    }
    return false;
}

}  // namespace stridor::integration
