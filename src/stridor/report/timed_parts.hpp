#pragma once

#include "stridor/advice/advice.hpp"
#include "stridor/report/design_results.hpp"
#include "stridor/sweep/run.hpp"

#include <functional>
#include <stop_token>

/// The parts of a report that may take long. Each has a longest time; a part that did not end in it is left out, and
/// the report says so.
namespace stridor::report {

/// The usual longest time of a part.
inline constexpr PartTime longest_part{60.0};

/// Runs a part with a token that stops it when `asked` does, or when its time is up. Returns whether it ended before.
/// Throws the part's errors, and `Error` (interrupted) if `asked` stopped it.
bool ends_within(PartTime longest, const std::stop_token& asked,
                 const std::function<void(const std::stop_token&)>& part);

/// Adds the sound of each direction.
void add_sounds(DesignResults& results, const std::stop_token& stop, PartTime longest);

/// Adds a chart: with a quarter of the points of each axis, then with half of them, then with all, as far as the time
/// allows.
void add_chart(DesignResults& results, const sweep::Study& study, const sweep::RunOptions& options, PartTime longest);

/// Adds advice, or the results so far when the time is up.
void add_advice(DesignResults& results, advice::AdviceOptions options, PartTime longest);

}  // namespace stridor::report
