#pragma once

#include "stridor/sweep/hearing.hpp"
#include "stridor/sweep/run.hpp"
#include "stridor/sweep/study.hpp"

#include <cstddef>
#include <functional>
#include <stop_token>
#include <vector>

namespace stridor::sweep {

struct HearingOptions {
    HearingSettings settings{};
    std::size_t perturb_every = 7;  // [1] every so many runs' sounds are perturbed too; 0: none are
    int threads = 0;                // [1] 0: one per processor this process may use
    std::stop_token stop{};
    std::function<void(const Progress&)> progress{};  // called from the caller's thread, at most ten times a second
};

/// Judges every cell of a study by its contact states and by ear; in index order, empty if it was stopped.
///
/// The same result for any number of threads. A study's refinement is not looked at: every cell is heard. Throws `Error` (input)
/// for a study with several starts, of which one could be heard only, and what `check_audible` throws.
std::vector<HeardSound> hear(const Study& study, const HearingOptions& options);

}  // namespace stridor::sweep
