#pragma once

#include "stridor/analysis/alternation.hpp"
#include "stridor/analysis/levels.hpp"
#include "stridor/analysis/rates.hpp"
#include "stridor/record/tally.hpp"

#include <cstddef>
#include <optional>

namespace stridor::analysis {

/// The figures of one contact in one phase of a run: all that a verdict by contact states is made from.
struct Evidence {
    record::Phase phase = record::Phase::all;
    std::size_t contact = 0;     // number among those of the structure
    double window_time = 0.0;    // [s] time in the window
    double judged_time = 0.0;    // [s] of it, time that was judged
    Rates rates;                 // whole window
    Rates judged_rates;          // judged part: reversals cut
    Rates judged_errors;         // standard errors of those (`share_errors`)
    Alternation alternation;     // judged part
    long releases = 0;           // [1] sticks that ended, judged part
    long all_releases = 0;       // [1] the same, whole window
    record::Ending ending;       // of the run, and what is known beyond it
    double preload = 0.0;        // [N] N at rest; 0: not known, or open there
    double largest_force = 0.0;  // [N] judged part, largest N where states and spans end
    // by how much the shares changed from twice the time step, if the engine compared two: about their error
    std::optional<Rates> step_change{};         // whole window
    std::optional<Rates> judged_step_change{};  // judged part
    std::optional<Alternation> coarser{};       // judged part, at twice the time step
    Levels levels;  // of the bodies, judged part; of a contact that slides or sticks for ever its closing part
};

/// Is it proven, or plain from all of the judged time, that the contact sticks for ever?
bool sticks_for_good(const Evidence& evidence);

/// Likewise, that it slides for ever.
bool slides_for_good(const Evidence& evidence);

/// Has the contact left the surface within the judged part or before, without having alternated, and is apart to the
/// end of the run?
bool stays_off(const Evidence& evidence);

/// From what a phase left behind of contact number `contact`.
Evidence evidence(const record::Tally& tally, std::size_t contact);

}  // namespace stridor::analysis
