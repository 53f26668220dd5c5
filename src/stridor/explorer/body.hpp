#pragma once

// Requests as JSON. Private to this folder: nlohmann's types stay out of the headers others see.

#include "stridor/base/json.hpp"
#include "stridor/explorer/world.hpp"
#include "stridor/sweep/study.hpp"

#include <optional>
#include <string>
#include <vector>

namespace stridor::explorer {

using base::Json;

/// Most that a request may ask for.
inline constexpr double longest_run = 60.0;  // [s] simulated; longer of own structures that are slow
inline constexpr int most_chart_points = 256;

/// Throws `Error` (input) for text that is no JSON object.
Json parse_body(const std::string& text);

/// A member of an object that is text. This and the next four throw `Error` (input) where the member is of another
/// type, or missing without a default.
std::string text_in(const Json& object, const std::string& name, std::optional<std::string> otherwise = std::nullopt);

/// A member that is a number.
double number_in(const Json& object, const std::string& name, std::optional<double> otherwise = std::nullopt);

/// A member that is a whole number of at most 1e9 in size.
int whole_in(const Json& object, const std::string& name, std::optional<int> otherwise = std::nullopt);

/// A member that is true or false; false where it is missing.
bool flag_in(const Json& object, const std::string& name);

/// A member that is an object; it lives as long as the outer one.
const Json& object_in(const Json& object, const std::string& name);

/// The "set" of a request: overrides as the command line's `--set` takes them. A file is never named by a request.
std::vector<std::string> overrides_in(const Json& body);

/// The case of a request: its preset with its overrides. Throws `Error` (input) for what is no case, or runs too long.
parameters::Case case_in(const World& world, const Json& body);

/// The chart of a request, both directions; the case's values need not fit together where the axes replace them.
sweep::Study study_in(const World& world, const Json& body);

/// A chart with its default axes: preload over kinetic friction, as in Figure 8, linear.
Json default_chart();

/// The axes of a file's chart and the first quantity it draws, with as many points as may be explored.
Json chart_of(const sweep::Study& study);

}  // namespace stridor::explorer
