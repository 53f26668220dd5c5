#pragma once

#include "stridor/crew/crew.hpp"

/// The crews of this program: each program has these functions in a source of its own.
///
/// The processes of a job run the same command on the same input. One of them leads; the others help it with each work
/// of the command, in the order in which the leading one reaches them.
namespace stridor::app {

/// Returns the maker of crews for this process; `threads` of each process, 0: as many as it may use.
crew::CrewMaker crews(int threads);

/// Says whether this process only helps another one. Such a process reads its input and helps, and writes nothing.
bool only_helps();

/// Helps with a work until it is over.
void help_with(const crew::Work& work, int threads);

}  // namespace stridor::app
