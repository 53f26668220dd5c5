#pragma once

#include "stridor/parameters/fields/field.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Around which values a quantity of a case is varied. Advice, charts without axes of their own and the sliders of the
/// page take their ranges from here, so that all of them look at the same designs.
namespace stridor::parameters {

/// How far a quantity is varied to both sides of a case's value [1, ratio]: the span of the published charts.
inline constexpr double usual_reach = 10.0;

/// Returns the values between which a quantity of a case is varied, in its unit; nothing for settings of the
/// computation.
///
/// On a logarithmic scale (masses, stiffnesses, dampings, forces, velocities) from a tenth to ten times the case's own
/// value, with its sign. On a linear scale (friction, angles, restitution) the usual range of the field, as wide as the
/// value needs. Zero has no tenth: a quantity that is zero is varied up to the end of its field's usual range, on a
/// linear scale. The temperature of the parts is varied over its table. No end lies where the field allows no value.
std::optional<UsualRange> usual_range(const Case& c, std::string_view key);

/// Returns the keys of what a designer varies in a case: the quantities with a usual range in the field table, but for
/// those that follow the temperature. Each of several joints has its own.
std::vector<std::string> design_keys(const Case& c);

}  // namespace stridor::parameters
