#include "stridor/pictures/friction_fit.hpp"

#include "stridor/base/error.hpp"
#include "stridor/drawing/palette.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace stridor::pictures {

namespace {

constexpr std::size_t fit_curve_points = 241;
constexpr double log_speeds_from = 20.0;  // ratio of the ends from which the axis is logarithmic

drawing::Points fit_points() {
    return {{}, {}, drawing::quiet_ink, 2.4, std::nullopt, drawing::Mark::disc};
}

drawing::PanelAxis speed_axis(const analysis::FrictionFit& fit) {
    drawing::PanelAxis axis;
    double low = 0.0, high = 0.0;
    for (const analysis::FrictionPoint& point : fit.data.points) {
        const double speed = analysis::mean_speed(point);
        high = std::max(high, speed);
        if (speed > 0.0) low = low == 0.0 ? speed : std::min(low, speed);
    }
    axis.label = drawing::StyledText("speed of slip ") + drawing::symbol("|w|");
    axis.unit = "m/s";
    axis.range = {0.0, 1.05 * high};
    if (high > log_speeds_from * low) {
        axis.scale = drawing::AxisScale::logarithmic;
        axis.range = {low / 1.2, 1.2 * high};
    }
    return axis;
}

drawing::Line curve_of(const analysis::FittedLaw& law, const drawing::PanelAxis& axis, drawing::Stroke stroke) {
    drawing::Line line{{}, {}, stroke};
    for (std::size_t k = 0; k < fit_curve_points; ++k) {
        const double share = static_cast<double>(k) / static_cast<double>(fit_curve_points - 1);
        const double speed = axis.scale == drawing::AxisScale::logarithmic
                                 ? axis.range.from * std::pow(axis.range.to / axis.range.from, share)
                                 : axis.range.from + share * (axis.range.to - axis.range.from);
        analysis::FrictionPoint point;
        point.speeds.fill(speed);
        line.x.push_back(speed);
        line.y.push_back(analysis::friction_at(law, point));
    }
    return line;
}

drawing::Extent with_air(const std::vector<double>& values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const double air = *high > *low ? 0.08 * (*high - *low) : std::max(1e-3, 0.1 * std::abs(*high));
    return {*low - air, *high + air};
}

void add_points(drawing::Panel& panel, const analysis::FrictionFit& fit, const std::vector<double>& values) {
    drawing::Points points = fit_points();
    for (const analysis::FrictionPoint& point : fit.data.points)
        points.x.push_back(analysis::mean_speed(point));
    points.y = values;
    panel.layers.emplace_back(std::move(points));
}

}  // namespace

drawing::Scene friction_fit(const analysis::FrictionFit& fit, std::size_t law) {
    if (fit.data.points.empty())
        base::refuse("there is nothing to draw", "the runs show no friction over the speed of slip",
                     "Measure while it slides steadily, or leave --figure out.");
    drawing::Panel above, below;
    above.x = below.x = speed_axis(fit);
    above.x.text = drawing::AxisText::hidden;
    above.grid = below.grid = drawing::Grid::both;
    below.row = 1;
    above.y.label = drawing::StyledText("friction ") + drawing::symbol("T") + " / " + drawing::symbol("N");
    below.y.label = "left over";
    above.y.unit = below.y.unit = "1";
    std::vector<double> friction;
    for (const analysis::FrictionPoint& point : fit.data.points)
        friction.push_back(point.friction);
    add_points(above, fit, friction);
    add_points(below, fit, fit.laws[law].residuals);
    below.y.range = with_air(fit.laws[law].residuals);

    drawing::Scene scene;
    std::vector<double> shown = friction;
    const auto add_curve = [&](std::size_t which, drawing::Stroke stroke) {
        drawing::Line line = curve_of(fit.laws[which], above.x, stroke);
        shown.insert(shown.end(), line.y.begin(), line.y.end());
        above.layers.emplace_back(std::move(line));
        scene.legend.push_back({std::string(analysis::fitted_names[fit.laws[which].kind]), stroke});
    };
    add_curve(law, {drawing::accent, 1.6, drawing::Dash::solid});
    std::vector<std::size_t> others = fit.rivals;
    if (law != fit.best) others.push_back(fit.best);
    for (const std::size_t other : others)
        if (other != law) add_curve(other, {drawing::ink, 0.9, drawing::Dash::dashed});
    above.y.range = with_air(shown);
    below.layers.emplace_back(
        drawing::Rule{0.0, drawing::Orientation::horizontal, {drawing::accent, 0.8, drawing::Dash::solid}});
    scene.legend.push_back({"mean of a block", fit_points()});
    scene.title = "Friction over the speed of slip";
    scene.caption = {drawing::StyledText(analysis::words_of(fit))};
    scene.panels = {std::move(above), std::move(below)};
    scene.row_heights = {1.0, 0.5};
    scene.width = 120.0;
    scene.height = 110.0;
    return scene;
}

}  // namespace stridor::pictures
