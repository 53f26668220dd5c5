#pragma once

#include "stridor/crew/crew.hpp"
#include "stridor/sweep/store/keeper.hpp"
#include "stridor/sweep/store/share.hpp"
#include "stridor/sweep/study.hpp"

#include <cstddef>
#include <functional>
#include <stop_token>

namespace stridor::sweep {

/// The progress of a sweep.
struct Progress {
    std::size_t done = 0;   // [1] cells finished, those of earlier runs included
    std::size_t total = 0;  // [1] cells to be computed, as far as known: refinement finds more as it goes
    Counts counts;          // of the finished cells
    double rate = 0.0;      // [1/s] cells finished per second over the last minute of this run
};

/// How a sweep is computed.
struct RunOptions {
    crew::CrewMaker crew = crew::thread_crews();    // who computes
    std::stop_token stop;                           // asks for an early end
    std::function<void(const Progress&)> progress;  // called from the caller's thread, at most ten times a second
    std::function<void()> round;          // called from there, too, when a round of refinement is kept and another
                                          // follows; without it no round waits for the end of the one before
    std::size_t cells_per_commit = 4096;  // [1] finished cells after which they are written,
    double seconds_per_commit = 0.5;      // [s] or time after which: a kill loses no more
    Share share{};                        // compute the cells of this share only
};

/// How a sweep ended.
enum class SweepEnding {
    completed,  // every cell that has to be computed is kept, as far as this share can know
    stopped,    // on request; the finished cells are kept, and the next run goes on
};

/// How a run of a sweep ended.
struct RunReport {
    SweepEnding ending = SweepEnding::completed;
    std::size_t computed = 0;  // [1] cells of this run
    Progress progress;         // at its end
};

/// Computes the cells that are not kept yet, on all processors, and keeps each as it is finished. In a refined study
/// these are only the cells that refinement asks for (refinement.hpp). In a share these are only its own cells, as far
/// as the kept cells show that they are needed.
///
/// A stop request ends it within a fraction of a second with all finished points saved. The same study gives the same
/// cells, bit for bit, for every crew and after any number of stops and kills. Memory depends on the number of cells,
/// never on the simulated time. Throws the errors of the crew, the keeper and the callbacks, once the crew has ended.
RunReport run(const Study& study, CellKeeper& keeper, const RunOptions& options = {});

}  // namespace stridor::sweep
