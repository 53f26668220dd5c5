#pragma once

#include "stridor/sweep/crew.hpp"
#include "stridor/sweep/study.hpp"

/// Who computes in this program: each program has these functions in a source of its own.
namespace stridor::app {

/// The crews of its sweeps; `threads` of each process, 0: as many as it may use.
sweep::CrewMaker crews(int threads);

/// In a process that only helps another one with this study: does so to the end, and is true then.
bool helps_with(const sweep::Study& study, int threads);

}  // namespace stridor::app
