#pragma once

#include "golden/values.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/integration/run/motion.hpp"
#include "stridor/record/tally.hpp"

namespace stridor::golden {

/// Adds the times of a contact in each state, and the instants of its changes.
void add(Values& values, const record::ContactTally& contact);

/// Adds how a contact ends.
void add_ending(Values& values, const record::ContactTally& contact);

/// Adds the vibration of a phase, judged and closing part.
void add_vibration(Values& values, const record::Tally& tally);

/// Adds a verdict with the figures it rests on.
void add(Values& values, const classification::Verdict& verdict);

/// Adds the outcome of a run, its energy balance, and how it ended early.
void add(Values& values, const integration::Motion& motion);

/// Adds the history of a contact.
void add(Values& values, const record::ContactHistory& history);

/// Adds the samples of all degrees of freedom.
void add_motion(Values& values, const record::Trace& trace);

/// Adds the samples of a contact.
void add(Values& values, const record::ContactTrace& contact);

}  // namespace stridor::golden
