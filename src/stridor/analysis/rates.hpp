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

/// Returns the shares of the times spent in each state [s] in their total; all NaN if the total is zero.
Rates rates(const std::array<double, model::contact_states>& time);

/// Returns the standard errors of the judged shares of a contact [1]: their scatter because the judged time is only a
/// piece of the motion.
///
/// The judged stretches are cut into groups of their parts, 6 to 16 in all. Groups at the same place of several
/// stretches are compared, so that a change with the drive's velocity within each stretch is not an error; the groups
/// of a single stretch are compared with their mean. The result is the standard error of a mean of independent groups:
/// a motion with a memory longer than a group has a larger one.
///
/// Zero for a proven limit cycle, and where the shares never change. NaN without a complete stretch.
Rates share_errors(const record::ContactTally& tally);

// The contacts of one interface as a whole. The share of one node of a finely meshed interface does not converge, so
// the whole is weighed by the load of its contacts.

/// A contact that carries less than this share of the mean load of its interface's contacts [1] is unloaded and has no
/// verdict: with five contacts that is less than 1 % of the whole load. A share of the whole load would leave no
/// contact of some hundred equal ones.
inline constexpr double least_load = 0.05;

/// The load of one contact in the judged part.
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

/// Returns interface number `interface` of a phase. If no contact of it carries a load, each has an equal share.
Interface interface_of(const record::Tally& tally, std::size_t interface);

/// Returns how much of the load of `some` contacts is free (not stuck) while one of them is free [1]: the mean over
/// their free time, weighted by load. 1: all slip at once; the share of one: they slip one by one. NaN if none is ever
/// free. `some` numbers them within the interface.
double free_together(const record::InterfaceTally& tally, const Interface& whole, std::span<const std::size_t> some);

}  // namespace stridor::analysis
