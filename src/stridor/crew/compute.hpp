#pragma once

#include "stridor/base/error.hpp"
#include "stridor/crew/crew.hpp"

#include <functional>
#include <vector>

namespace stridor::crew {

/// Has a crew compute all these tasks, first those in front, and hands each result over as it comes, in any order.
///
/// `tick` is called ten times a second meanwhile, and once at the end; both calls come from the caller's thread. Where
/// the crew has stopped on request, some results are missing in the end. Throws what failed in the crew.
void compute(Crew& crew, std::vector<Task> tasks, const std::function<void(Result)>& take,
             const std::function<void()>& tick = {});

/// What to throw where the bytes of a result are none that this program writes.
Error damaged_result();

/// So many tasks that are told by their numbers alone: 0, 1, 2, ...
std::vector<Task> numbered_tasks(std::size_t count);

}  // namespace stridor::crew
