#pragma once

#include "stridor/drawing/scene.hpp"

#include <vector>

namespace stridor::drawing {

/// A value may miss the end of an axis by rounding, by this share of it, and still belong to it.
inline constexpr double axis_slack = 1e-9;

/// The ticks of an axis and the power of ten its numbers are counted in.
struct TickSet {
    std::vector<Tick> ticks;
    int exponent = 0;  // [1] labels show value / 10^exponent
};

/// Ticks of an axis that is `length` mm long, labelled ones at least about `spacing` mm apart.
///
/// Linear: steps of 1, 2 or 5 times a power of ten. Logarithmic: decades, with 2 and 5 where there is room, minor ticks
/// at the other whole multiples. Large and small numbers of a linear axis are counted in a power of ten.
/// Ticks that the axis brings along are taken as they are.
TickSet ticks(const PanelAxis& axis, double length, double spacing);

/// Share of the axis' length at which a value lies: 0 at `from`, 1 at `to`, measured in the axis' own scale.
double position(const PanelAxis& axis, double value);

/// The value at a share of the axis' length; the inverse of `position`.
double value_at_position(const PanelAxis& axis, double share);

/// The axis' title: label and unit in brackets, the unit with the power of ten.
StyledText axis_title(const StyledText& label, std::string_view unit, int exponent);

}  // namespace stridor::drawing
