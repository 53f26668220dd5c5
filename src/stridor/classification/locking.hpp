#pragma once

#include "stridor/analysis/evidence.hpp"
#include "stridor/parameters/case.hpp"

#include <optional>
#include <string>

/// Contacts that dig in: the way they are dragged presses them harder and harder (sprag-slip).
///
/// While a contact sticks its normal force follows the way x along a straight line, N = N0 + (dN/dx) x, for the
/// structure is linear. With mu_s (dN/dx) above |dT/dx| the stick never ends. The real part flips over, wears or breaks
/// (Spurr 1961).
namespace stridor::classification {

/// Why a contact locks, "locks: N rises from 8 N to 494 N over 50 mm and goes on by 9.72 N/mm (proven)"; nothing if it
/// does not. It locks if it sticks for good and
///
///     N rises with the way under a constant drive, or
///     N exceeds `lock_force` times the preload
std::optional<std::string> locking(const analysis::Evidence& evidence, const parameters::Thresholds& thresholds);

/// What is said of a contact that does not lock, yet whose N exceeds `lock_force` times its preload, while it mostly
/// sticks or slides; else nothing. Where it alternates N swings with the vibration, and says nothing of the way.
std::optional<std::string> pressing_warning(const analysis::Evidence& evidence,
                                            const parameters::Thresholds& thresholds);

}  // namespace stridor::classification
