#pragma once

#include "stridor/analysis/stability_scan.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/record/trace.hpp"
#include "stridor/sweep/study.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Ranges as a command line says them: KEY=FROM:TO, and what may follow (docs/guide/commands.md).
namespace stridor::io {

/// "mu_d=0.2:0.8:30" is "mu_d" and "0.2", "0.8", "30", without blanks around them. The parts look into the text.
struct RangeText {
    std::string_view key;
    std::vector<std::string_view> parts;
};

/// Nothing where the text has no '='.
std::optional<RangeText> split_range(std::string_view text);

/// The ends of a range [the unit asked for].
struct RangeEnds {
    double from;
    double to;
};

/// Reads both ends; each may carry its unit, and a unit at the last end alone is that of both: "1:40 N". Throws `Error`
/// (input).
RangeEnds read_range_ends(std::string_view from, std::string_view to, std::string_view unit);

/// Points from 2 to `most`; nothing for any other text.
std::optional<int> read_points(std::string_view text, int most);

/// Points of an axis whose text says none: as `stridor init noise-chart` has them, and of a diagram over one axis.
inline constexpr int usual_points = 40;
inline constexpr int usual_points_alone = 200;

/// An axis as a command line says it: KEY=FROM:TO, KEY=FROM:TO:POINTS or KEY=FROM:TO:POINTS:SCALE.
///
/// KEY is what `advice::quantity_key_called` understands ("contact.preload", "preload", "F", "joint.lip2.F"). Ends are
/// in its unit or carry one; a unit at the last end alone is that of both ("1:40 N"). The scale is "linear" or "log";
/// without one it is that of the quantity's usual range, or linear where an end has no logarithm. `points` are taken
/// where the text says none.
/// `option` is what messages call it: "--x". Throws `Error` (input).
sweep::Axis read_axis_text(const parameters::Case& c, const std::string& text, int points, const std::string& option);

/// Returns the text of an axis, which reads back as the same.
std::string write_axis_text(const sweep::Axis& axis);

/// Reads "key=from:to[:points]", the ends with units if they have one. Throws `Error` (input) for anything else.
analysis::ScanRange read_scan_range(const std::string& over);

/// Which samples of a motion are wanted, as a command line says it: times with their units.
struct TraceTexts {
    std::string from{};  // empty: the beginning
    std::string to{};    // empty: the end
    std::string interval = "20 us";
};

/// The samples that the texts ask for. Throws `Error` (input) for what is no time, for a trace without samples, and for
/// more than two million of them: a trace is kept in memory.
record::TraceRequest trace_request(const TraceTexts& texts, const parameters::Case& c);

}  // namespace stridor::io
