#pragma once

#include "stridor/analysis/alternation.hpp"
#include "stridor/analysis/levels.hpp"
#include "stridor/analysis/rates.hpp"
#include "stridor/record/tally.hpp"

namespace stridor::analysis {

/// The figures of one phase of a run: all that a verdict by contact states is made from.
struct Evidence {
    record::Phase phase = record::Phase::all;
    double window_time = 0.0;  // [s] time in the window
    double judged_time = 0.0;  // [s] of it, time that was judged
    Rates rates;               // whole window
    Rates judged_rates;        // judged part: reversals cut
    Alternation alternation;   // judged part
    Levels levels;             // judged part
};

Evidence evidence(const record::Tally& tally);

}  // namespace stridor::analysis
