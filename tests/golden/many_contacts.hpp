#pragma once

#include "golden/results.hpp"

#include <vector>

namespace stridor::golden {

/// Results of the engines that take structures of any size: by events, by steps, and without inertia at contacts.
/// Each has the figures of all its contacts.
std::vector<Result> results_of_many_contacts();

}  // namespace stridor::golden
