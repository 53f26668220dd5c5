#pragma once

#include <optional>
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

}  // namespace stridor::io
