#include "stridor/drawing/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stridor::drawing {

namespace {

double nice_step(double least) {
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= least * (1.0 - axis_slack)) return factor * power;
    return 10.0 * power;
}

std::string minus_sign(std::string number) {
    if (!number.empty() && number.front() == '-') number.replace(0, 1, "−");
    return number;
}

// the power of ten, a multiple of three, that keeps labels short
int common_exponent(double largest) {
    if (largest == 0.0 || (largest >= 0.01 && largest < 1e4)) return 0;
    return 3 * static_cast<int>(std::floor(std::log10(largest) / 3.0));
}

TickSet linear_ticks(const Extent& range, double length, double spacing) {
    const double span = range.to - range.from;
    const auto count = [&](double step) {
        return std::floor(range.to / step + axis_slack) - std::ceil(range.from / step - axis_slack) + 1.0;
    };
    double step = nice_step(span * std::min(1.0, spacing / length));
    // a single number is no scale: rather a little tight
    for (int tries = 0; tries < 4 && count(step) < 2.0; ++tries)
        step = nice_step(0.4 * step);  // the next finer one
    TickSet set;
    set.exponent = common_exponent(std::max(std::abs(range.from), std::abs(range.to)));
    const double unit = std::pow(10.0, set.exponent);
    const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step / unit) + axis_slack)));
    const double first = std::ceil(range.from / step - axis_slack);
    for (double k = first; k < first + count(step); k += 1.0) {
        const double value = k == 0.0 ? 0.0 : k * step;  // no "-0"
        set.ticks.push_back({value, minus_sign(fmt::format("{:.{}f}", value / unit, decimals)), TickSize::major});
    }
    return set;
}

StyledText decade_label(double value, int decade) {
    if (decade >= -3 && decade <= 4) return minus_sign(fmt::format("{:.{}f}", value, std::max(0, -decade)));
    const long factor = std::lround(value / std::pow(10.0, decade));
    const StyledText power =
        StyledText("10") + StyledText(minus_sign(fmt::format("{}", decade)), TextStyle::superscript);
    return factor == 1 ? power : StyledText(fmt::format("{}·", factor)) + power;
}

TickSet logarithmic_ticks(const Extent& range, double length, double spacing) {
    const double decades = std::log10(range.to / range.from);
    const double decade_length = length / decades;
    // how many of 1, 2, 5 (or 1, 2, 3, 5) fit into a decade: the narrowest gap decides
    const bool has_room_for_three = decade_length * std::log10(2.0) >= spacing;
    TickSet set;
    for (int decade = static_cast<int>(std::floor(std::log10(range.from))); decade <= std::log10(range.to) + axis_slack;
         ++decade)
        for (int factor = 1; factor <= 9; ++factor) {
            const double value = factor * std::pow(10.0, decade);
            if (value < range.from * (1.0 - axis_slack) || value > range.to * (1.0 + axis_slack)) continue;
            const bool is_major = factor == 1 || (has_room_for_three && (factor == 2 || factor == 5));
            set.ticks.push_back({value, is_major ? decade_label(value, decade) : StyledText(),
                                 is_major ? TickSize::major : TickSize::minor});
        }
    const auto majors = std::count_if(set.ticks.begin(), set.ticks.end(),
                                      [](const Tick& tick) { return tick.size == TickSize::major; });
    // within one decade there may be no round number: count evenly instead
    return majors >= 2 ? set : linear_ticks(range, length, 1.5 * spacing);
}

}  // namespace

TickSet ticks(const PanelAxis& axis, double length, double spacing) {
    if (!axis.ticks.empty()) return {axis.ticks, 0};
    return axis.scale == AxisScale::linear ? linear_ticks(axis.range, length, spacing)
                                           : logarithmic_ticks(axis.range, length, spacing);
}

double position(const PanelAxis& axis, double value) {
    const auto [from, to] = axis.range;
    return axis.scale == AxisScale::linear ? (value - from) / (to - from)
                                           : std::log(value / from) / std::log(to / from);
}

double value_at_position(const PanelAxis& axis, double share) {
    const auto [from, to] = axis.range;
    return axis.scale == AxisScale::linear ? from + share * (to - from) : from * std::pow(to / from, share);
}

StyledText axis_title(const StyledText& label, std::string_view unit, int exponent) {
    StyledText inside = unit_text(unit);
    if (exponent != 0) {
        const StyledText power =
            StyledText("10") + StyledText(minus_sign(fmt::format("{}", exponent)), TextStyle::superscript);
        inside = is_empty(inside) ? power : power + " " + inside;
    }
    return is_empty(inside) ? label : label + " [" + inside + "]";
}

}  // namespace stridor::drawing
