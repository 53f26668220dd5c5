#pragma once

// Requests as JSON. Private to this folder, so that nlohmann's types stay out of other headers.

#include "stridor/base/json.hpp"
#include "stridor/explorer/world.hpp"
#include "stridor/sweep/study.hpp"

#include <optional>
#include <string>
#include <vector>

namespace stridor::explorer {

using base::Json;

/// The largest values that a request may ask for.
inline constexpr double longest_run = 60.0;  // [s] simulated; longer of own structures that are slow
inline constexpr int most_chart_points = 256;

/// Returns the JSON object in a text. Throws `Error` (input) for any other text.
Json parse_body(const std::string& text);

/// Returns a member of an object that is text. This and the next four throw `Error` (input) if the member is of another
/// type, or missing without a default.
std::string text_in(const Json& object, const std::string& name, std::optional<std::string> otherwise = std::nullopt);

/// Returns a member that is a number.
double number_in(const Json& object, const std::string& name, std::optional<double> otherwise = std::nullopt);

/// Returns a member that is a whole number of at most 1e9 in size.
int whole_in(const Json& object, const std::string& name, std::optional<int> otherwise = std::nullopt);

/// Returns a member that is true or false; false if it is missing.
bool flag_in(const Json& object, const std::string& name);

/// Returns a member that is an object; it lives as long as the outer one.
const Json& object_in(const Json& object, const std::string& name);

/// Returns the "set" of a request: overrides as in the command line's `--set`. A request never names a file.
std::vector<std::string> overrides_in(const Json& body);

/// Returns the case of a request: its preset with its overrides. Throws `Error` (input) for an invalid case, or one
/// that runs too long.
parameters::Case case_in(const World& world, const Json& body);

/// Returns the chart of a request, both directions. The case's own values may contradict each other if the axes replace
/// them.
sweep::Study study_in(const World& world, const Json& body);

/// Returns a chart with its default axes: preload over kinetic friction, as in Figure 8, linear.
Json default_chart();

/// Returns the axes of a file's chart and the first quantity it draws, with as many points as may be explored.
Json chart_of(const sweep::Study& study);

}  // namespace stridor::explorer
