#pragma once

#include "stridor/analysis/stability_scan.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/record/trace.hpp"
#include "stridor/sweep/study.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Ranges as a command line writes them: KEY=FROM:TO and further parts (docs/guide/commands.md).
namespace stridor::io {

/// The parts of a range: "mu_d=0.2:0.8:30" is "mu_d" and "0.2", "0.8", "30", without blanks. They point into the text.
struct RangeText {
    std::string_view key;
    std::vector<std::string_view> parts;
};

/// Returns the parts of a range, or `std::nullopt` if the text has no '='.
std::optional<RangeText> split_range(std::string_view text);

/// The ends of a range [the unit asked for].
struct RangeEnds {
    double from;
    double to;
};

/// Reads both ends; each may have its unit, and a unit at the last end alone counts for both: "1:40 N". Throws `Error`
/// (input).
RangeEnds read_range_ends(std::string_view from, std::string_view to, std::string_view unit);

/// Reads points from 2 to `most`; returns `std::nullopt` for any other text.
std::optional<int> read_points(std::string_view text, int most);

/// The points of an axis whose text has none: those of `stridor init noise-chart`, and of a diagram over one axis.
inline constexpr int usual_points = 40;
inline constexpr int usual_points_alone = 200;

/// Reads an axis as a command line writes it: KEY=FROM:TO, KEY=FROM:TO:POINTS or KEY=FROM:TO:POINTS:SCALE.
///
/// KEY is any name that `advice::quantity_key_called` understands ("contact.preload", "preload", "F", "joint.lip2.F").
/// Ends are in its unit or have one; a unit at the last end alone counts for both ("1:40 N"). The scale is "linear" or
/// "log"; without one it is that of the quantity's usual range, or linear if an end has no logarithm. `points` are used
/// if the text has none. `option` is its name in messages: "--x". Throws `Error` (input).
sweep::Axis read_axis_text(const parameters::Case& c, const std::string& text, int points, const std::string& option);

/// Returns the text of an axis, which reads back as the same.
std::string write_axis_text(const sweep::Axis& axis);

/// Reads "key=from:to[:points]", the ends with units if they have one. Throws `Error` (input) for any other text.
analysis::ScanRange read_scan_range(const std::string& over);

/// The requested samples of a motion, as a command line writes them: times with their units.
struct TraceTexts {
    std::string from{};  // empty: the beginning
    std::string to{};    // empty: the end
    std::string interval = "20 us";
};

/// Returns the request for these samples. Throws `Error` (input) for a text that is not a time, for a trace without
/// samples, and for more than two million of them: a trace is kept in memory.
record::TraceRequest trace_request(const TraceTexts& texts, const parameters::Case& c);

}  // namespace stridor::io
