#pragma once

#include "stridor/analysis/evidence.hpp"
#include "stridor/classification/verdict.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/record/tally.hpp"

#include <span>
#include <vector>

namespace stridor::classification {

/// Whether predominant stick can be a creak. It cannot if only single nodes of an interface slip.
enum class Creak { possible, impossible };

/// Returns the category of one phase from its contact states (Elmaian et al. 2012, section 3.2), by these rules in this
/// order:
///
///     friction is regularised                    undecided, unless `creeping` asks for a verdict: a contact that
///                                                        creeps has no stick
///     proven to stick for ever, or to slide      none    whatever came before does not come again; what sticks and is
///                                                        pressed harder and harder locks (interface_rules.hpp)
///     slip share >= quiet_slip                   none    it slides: nothing alternates. Where such sliding grows:
///                                                        undecided if that is all it does, else by what alternates.
///                                                        Where it ends again and again: by what alternates
///     stuck throughout                           none    it sticks or locks, unless it is known to slip later
///                                                        (undecided) or
///                                                        slips again and again outside the judged part (creak)
///     stick share >= creak_stick                 creak   stick predominates, and ends least_releases times at least
///                                                        or in a proven limit cycle; else undecided
///     fewer than least_intervals repeats         undecided
///     regularity >= squeal_regularity            squeal  states alternate regularly, in at most squeal_beats
///                                                        unlike beats
///     repetition >= squeal_repetition, and the
///       pattern comes squeal_frequency times a
///       second                                   squeal  of several unequal beats, as proven limit cycles are
///     otherwise                                  squeak
///
/// A share, regularity or repetition that lies nearer to its threshold than least_distance of its errors makes the
/// verdict undecided. Its error is its scatter within the judged time or, if that is more, its change from twice the
/// time step. The error of a proven limit cycle is zero.
///
/// Shares are those of the judged part. Stick dominance comes before regularity because a creak may be regular too.
/// A vibration pattern is named, not a sound: docs/methods/verdict.md says what that leaves out.
Verdict classify(const analysis::Evidence& evidence, const parameters::Thresholds& thresholds,
                 Creak creak = Creak::possible);

/// Returns the verdict of one phase: that of its loudest interface (`loudness`), the first of equals. A contact that
/// shares its interface with no other is an interface by itself. A phase is quiet only if all of its loaded contacts
/// are.
Verdict classify_phase(const record::Tally& phase, const parameters::Thresholds& thresholds,
                       const ContactNames& names = {});

/// Returns the verdict of each phase of a run, in their order.
std::vector<Verdict> classify_phases(std::span<const record::Tally> phases, const parameters::Thresholds& thresholds,
                                     const ContactNames& names = {});

}  // namespace stridor::classification
