#pragma once

#include "stridor/integration/kernels/instruction_set.hpp"
#include "stridor/integration/run/end_state.hpp"
#include "stridor/integration/run/motion.hpp"
#include "stridor/model/built/rubbing_system.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/record/recorder.hpp"

#include <memory>
#include <stop_token>

namespace stridor::integration {

struct SharedFlows;

/// What runs of many cases, one after the other, may share: it saves time and changes nothing.
struct Workspace {
    std::shared_ptr<SharedFlows> flows;                         // of the exact engine; its first run makes them
    InstructionSet instruction_set = widest_instruction_set();  // of the exact engine's loops
};

/// Runs a case with the engine it names; the one door to all engines. Of several joints, and of a structure of the
/// user's own, `exact` is the Taylor engine. Engines by time steps are run at twice the step, too.
///
/// The case must have no `parameters::findings`. Returns and throws what the engine does.
Motion simulate(const parameters::Case& c, const record::Request& request, std::stop_token stop, Workspace& workspace);

/// Runs a case without a workspace to share.
Motion simulate(const parameters::Case& c, const record::Request& request = {}, std::stop_token stop = {});

/// Goes on with a run of the same case up to `run.duration`, which counts from the run's begin, and the window lies
/// behind `from`: nothing is known of the time before. Each number is that of one run without a break. The engine's
/// proofs begin anew: it runs as with `run.early_ending` = never.
Motion go_on(const parameters::Case& c, const EndState& from, const record::Request& request = {},
             std::stop_token stop = {});

/// A run that was made for its end: its state there, without meaning where the outcome has no result.
struct Ended {
    Outcome outcome;
    EndState state;
};

/// Runs a case to its end, or goes on with a run of it (null: from its start), and returns where it stands there.
Ended run_to_end(const parameters::Case& c, const EndState* from = nullptr, std::stop_token stop = {});

}  // namespace stridor::integration
