#pragma once

#include "stridor/analysis/evidence.hpp"
#include "stridor/analysis/rates.hpp"
#include "stridor/classification/verdict.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/record/tally.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace stridor::classification {

// Contacts that dig in: the way they are dragged presses them harder and harder (sprag-slip).
//
// While a contact sticks its normal force follows the way x along a straight line, N = N0 + (dN/dx) x, for the
// structure is linear. With mu_s (dN/dx) above |dT/dx| the stick never ends. The real part flips over, wears or breaks
// (Spurr 1961).

/// Returns why a contact locks, "locks: N rises from 8 N to 494 N over 50 mm and goes on by 9.72 N/mm (proven)", or
/// `std::nullopt` if it does not. It locks if it sticks for good and
///
///     N rises with the way under a constant drive, or
///     N exceeds `lock_force` times the preload
std::optional<std::string> locking(const analysis::Evidence& evidence, const parameters::Thresholds& thresholds);

/// Returns a warning about a contact that does not lock, yet whose N exceeds `lock_force` times its preload while it
/// mostly sticks or slides; else `std::nullopt`. If the contact alternates, N swings with the vibration and shows
/// nothing about the way.
std::optional<std::string> pressing_warning(const analysis::Evidence& evidence,
                                            const parameters::Thresholds& thresholds);

/// Least share of the load [1] that must be free at once if a release is to count as one of the interface, not of
/// nodes.
inline constexpr double most_of_the_load = 0.5;

/// The verdict on one interface of several contacts in one phase.
struct InterfaceVerdict {
    Verdict whole;                                 // `evidence.contact` is the noisy contact with most friction power
    std::vector<std::optional<Verdict>> contacts;  // shape [its contacts]; `std::nullopt` for an unloaded one
    analysis::Interface figures;
    double free_together = 0.0;  // [1] of the load of the noisy contacts; NaN without any
    bool differs = false;        // its loaded contacts have unlike categories
};

/// Returns the verdict of interface number `interface`, by these rules:
///
///     a contact with less than `analysis::least_load` of the mean load has no verdict
///     every loaded contact is none               none    a category is never a mean of verdicts
///     otherwise                                          by `classify`, from what the noisy contacts do together:
///       rates                                            theirs, weighted by load
///       regularity, period, releases                     those of the one that turns most power into heat
///       stick predominates, yet less than
///       `most_of_the_load` of it is free at once         no creak: nodes slip one by one
///
/// See docs/methods/verdict.md.
InterfaceVerdict classify_interface(const record::Tally& phase, std::size_t interface,
                                    const parameters::Thresholds& thresholds, const ContactNames& names = {});

/// The verdicts of all contacts in a phase.
struct PhaseVerdicts {
    // of the loudest interface (`loudness`), the first of equals; an interface whose figures lie too near to a
    // threshold may be as loud as any but a squeal, so that no quieter one speaks for the phase
    Verdict whole;
    std::vector<std::optional<Verdict>> contacts;  // shape [contact]; `std::nullopt` for an unloaded one
    std::vector<InterfaceVerdict> interfaces;      // of interfaces with several contacts
};

/// Returns the verdicts of one phase. A contact that shares its interface with no other is an interface by itself.
PhaseVerdicts classify_all(const record::Tally& phase, const parameters::Thresholds& thresholds,
                           const ContactNames& names = {});

}  // namespace stridor::classification
