#pragma once

#include "stridor/drawing/scene.hpp"

#include <vector>

namespace stridor::drawing {

/// The share of an axis by which a value may miss its end through rounding, and still belong to it.
inline constexpr double axis_slack = 1e-9;

/// The ticks of an axis and the power of ten of its numbers.
struct TickSet {
    std::vector<Tick> ticks;
    int exponent = 0;  // [1] labels show value / 10^exponent
};

/// Returns the ticks of an axis that is `length` mm long, labelled ones at least about `spacing` mm apart.
///
/// Linear: steps of 1, 2 or 5 times a power of ten. Logarithmic: decades, with 2 and 5 if there is room, minor ticks at
/// the other whole multiples. Large and small numbers of a linear axis have a power of ten in common. An axis with its
/// own ticks keeps them.
TickSet ticks(const PanelAxis& axis, double length, double spacing);

/// Returns the share of the axis' length at which a value lies: 0 at `from`, 1 at `to`, in the axis' own scale.
double position(const PanelAxis& axis, double value);

/// Returns the value at a share of the axis' length; the inverse of `position`.
double value_at_position(const PanelAxis& axis, double share);

/// Returns the axis' title: label and unit in brackets, the unit with the power of ten.
StyledText axis_title(const StyledText& label, std::string_view unit, int exponent);

}  // namespace stridor::drawing
