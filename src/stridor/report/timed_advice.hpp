#pragma once

#include "stridor/advice/advice.hpp"
#include "stridor/report/design_results.hpp"

#include <chrono>

namespace stridor::report {

/// Adds advice to a report's results, or, where its search does not end in time, why there is none.
///
/// Throws `Error` (interrupted) where `options.stop` asked for it.
void add_advice(DesignResults& results, advice::AdviceOptions options, std::chrono::seconds longest);

}  // namespace stridor::report
