#pragma once

#include "stridor/record/tally.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

/// What the contacts of one interface do as a whole. The share of one node of a finely meshed interface is no converged
/// number, so that the whole is weighed by what its contacts carry.
namespace stridor::analysis {

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
