#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// How the workers of a page compute one work together. No module can wait for another one (a page of a file shares no
/// memory), so nobody waits: who owns a work says which results it lacks and ends; others compute them; then it is
/// asked again, from the beginning, with the results at hand. A work of equal text has equal results, so each answer
/// is the same as by one worker.
namespace stridor::crew {

/// Thrown by the crew of an owner that lacks results. It is no error: nothing but the carrier catches it.
struct Lacking {};

/// Lets the crews of this module compute by themselves, which they do to begin with.
void compute_alone();

/// Lets the crews take results from these bytes alone, and throw `Lacking` when they have no more.
void take_results(const std::string& bytes);

/// Returns the tasks that were lacking, dealt out to this many helpers at most.
std::vector<std::string> lacking_tasks(std::size_t helpers);

/// Lets the crew of the work that these tasks belong to compute them, and throw `Lacking` then.
void help_with(const std::string& tasks);

/// Returns the results of these tasks, for `take_results`; several of them may be joined.
std::string helpers_results();

}  // namespace stridor::crew
