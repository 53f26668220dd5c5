#pragma once

#include "stridor/integration/moreau/moreau.hpp"
#include "stridor/record/schedule.hpp"

#include <stop_token>

namespace stridor::integration {

/// Runs Moreau's time stepping at the step h, and once more at 2 h for its times in each state alone
/// (`ContactTally::coarser`): by how much shares change with the step is about their error at h.
///
/// As `integrate_moreau`; a run at 2 h without a result takes that of h away, too.
Motion integrate_moreau_twice(const model::Structure& structure, const parameters::Drive& drive,
                              const InitialState& start, const Moreau& settings, record::Recorder recorder,
                              const std::stop_token& stop = {});

}  // namespace stridor::integration
