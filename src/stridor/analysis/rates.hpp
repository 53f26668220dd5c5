#pragma once

#include "stridor/model/contact_state.hpp"
#include "stridor/record/tally.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace stridor::analysis {

/// Contact-state rates: the share of a window spent in each state, adding up to 1 (Elmaian et al. 2012, section 3.1).
struct Rates {
    double slip = 0.0;        // [1]
    double stick = 0.0;       // [1]
    double separation = 0.0;  // [1]
};

/// Shares of the total of times spent in each state [s]; all NaN where no time was counted.
Rates rates(const std::array<double, model::contact_states>& time);

/// Standard errors of the judged shares of a contact [1]: by how much they scatter because the judged time is a piece
/// of the motion and not all of it.
///
/// The judged stretches are cut into groups of their parts, 6 to 16 in all. Groups at the same place of several
/// stretches are held against each other, so that what changes with the velocity of the drive within each of them is no
/// error; those of a single stretch against their mean. Standard error of a mean of independent groups: a motion whose
/// memory is longer than a group has a larger one.
///
/// Zero for a proven limit cycle, and where the shares never change. NaN without a complete stretch.
Rates share_errors(const record::ContactTally& tally);

// What the contacts of one interface do as a whole. The share of one node of a finely meshed interface is no converged
// number, so that the whole is weighed by what its contacts carry.

/// A contact that carries less than this share of the mean load of its interface's contacts [1] is unloaded and has no
/// verdict: of five contacts less than 1 % of all. A share of all would leave none of some hundred equal ones.
inline constexpr double least_load = 0.05;

/// What one contact carries in the judged part.
struct CarriedLoad {
    double normal_force = 0.0;    // [N] mean of N
    double share = 0.0;           // [1] of the sum over the interface
    double friction_power = 0.0;  // [W] mean of |T w|
    bool is_loaded = false;       // enough for a verdict
};

/// The contacts of one interface together, in one phase.
struct Interface {
    std::vector<std::size_t> contacts;                                 // their numbers in the structure, rising
    std::vector<CarriedLoad> loads;                                    // shape [its contacts]
    std::array<double, record::interface_state_names.size()> rates{};  // [1] share of the judged time in each state
};

/// Interface number `interface` of a phase. If none of its contacts carries a load, each has an equal share.
Interface interface_of(const record::Tally& tally, std::size_t interface);

/// How much of the load of some of its contacts does not stick while one of them does not [1]: the mean over their free
/// time, weighted by load. 1: all slip at once; the share of one: they slip one by one. NaN where none is ever free.
/// `some` numbers them within the interface.
double free_together(const record::InterfaceTally& tally, const Interface& whole, std::span<const std::size_t> some);

}  // namespace stridor::analysis
