#include "stridor/pictures/friction_fit.hpp"

#include "stridor/analysis/friction/slip_fit.hpp"
#include "stridor/base/error.hpp"
#include "stridor/drawing/palette.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace stridor::pictures {

namespace {

constexpr std::size_t fit_curve_points = 241;
constexpr std::size_t most_drawn_slips = 24;
constexpr double same_drive = 0.02;       // [1] velocities that differ less are one
constexpr double log_speeds_from = 20.0;  // ratio of the ends from which the axis is logarithmic

drawing::Points fit_points(drawing::Colour colour = drawing::quiet_ink) {
    return {{}, {}, colour, 2.4, std::nullopt, drawing::Mark::disc};
}

drawing::PanelAxis speed_axis(std::span<const analysis::FrictionFit> fits) {
    drawing::PanelAxis axis;
    double low = 0.0, high = 0.0;
    for (const analysis::FrictionFit& fit : fits)
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

// friction over the speed of slip, and below what a law leaves of it
struct SpeedPanels {
    drawing::Panel above, below;
    std::vector<double> shown, left;  // [1]
    drawing::Scene scene;
};

SpeedPanels speed_panels(std::span<const analysis::FrictionFit> fits) {
    if (std::all_of(fits.begin(), fits.end(), [](const auto& fit) { return fit.data.points.empty(); }))
        base::refuse("there is nothing to draw", "the runs show no friction over the speed of slip",
                     "Measure while it slides steadily, or leave --figure out.");
    SpeedPanels panels;
    panels.above.x = panels.below.x = speed_axis(fits);
    panels.above.x.text = drawing::AxisText::hidden;
    panels.above.grid = panels.below.grid = drawing::Grid::both;
    panels.below.row = 1;
    panels.above.y.label = drawing::StyledText("friction ") + drawing::symbol("T") + " / " + drawing::symbol("N");
    panels.below.y.label = "left over";
    panels.above.y.unit = panels.below.y.unit = "1";
    return panels;
}

void add_points(SpeedPanels& panels, const analysis::FrictionFit& fit, const std::vector<double>& residuals,
                drawing::Colour colour) {
    drawing::Points points = fit_points(colour), left = fit_points(colour);
    for (const analysis::FrictionPoint& point : fit.data.points) {
        points.x.push_back(analysis::mean_speed(point));
        points.y.push_back(point.friction);
    }
    left.x = points.x;
    left.y = residuals;
    panels.shown.insert(panels.shown.end(), points.y.begin(), points.y.end());
    panels.left.insert(panels.left.end(), left.y.begin(), left.y.end());
    panels.above.layers.emplace_back(std::move(points));
    panels.below.layers.emplace_back(std::move(left));
}

void add_curve(SpeedPanels& panels, const analysis::FittedLaw& law, const std::string& name, drawing::Stroke stroke) {
    drawing::Line line = curve_of(law, panels.above.x, stroke);
    panels.shown.insert(panels.shown.end(), line.y.begin(), line.y.end());
    panels.above.layers.emplace_back(std::move(line));
    panels.scene.legend.push_back({name, stroke});
}

drawing::Scene finished(SpeedPanels panels, drawing::Colour of_points, const std::string& title,
                        const std::string& words) {
    panels.above.y.range = with_air(panels.shown);
    panels.below.y.range = with_air(panels.left);
    panels.below.layers.emplace_back(
        drawing::Rule{0.0, drawing::Orientation::horizontal, {drawing::accent, 0.8, drawing::Dash::solid}});
    drawing::Scene& scene = panels.scene;
    scene.legend.push_back({"mean of a block", fit_points(of_points)});
    scene.title = title;
    scene.caption = {drawing::StyledText(words)};
    scene.panels = {std::move(panels.above), std::move(panels.below)};
    scene.row_heights = {1.0, 0.5};
    scene.width = 120.0;
    scene.height = 110.0;
    return std::move(scene);
}

// the samples of a slip over the time from its release on [ms], over the force at which it let go
struct ReleasedSlip {
    std::vector<double> time, force, left;
};

ReleasedSlip released_slip(const analysis::FrictionFit& fit, std::size_t law, std::size_t number) {
    const analysis::RecordedSlip& slip = fit.data.slips[number];
    const double limit = fit.laws[law].limits[number];
    std::vector<double> times;  // [s]
    for (std::size_t k = 0; k < slip.force.size(); ++k)
        times.push_back(static_cast<double>(k) / slip.rate - fit.laws[law].onsets[number]);
    const std::vector<double> model = analysis::slip_force(fit, law, number, times);
    ReleasedSlip released;
    for (std::size_t k = 0; k < times.size(); ++k) {
        // the climb is long and straight: as much of it as of the slip
        if (times[k] < -times.back()) continue;
        released.time.push_back(1e3 * times[k]);
        released.force.push_back(slip.force[k] / limit);
        released.left.push_back((slip.force[k] - model[k]) / limit);
    }
    return released;
}

// of each velocity of the drive the slip whose release is the middle one
std::vector<std::size_t> typical_slips(const analysis::FrictionFit& fit, std::size_t law) {
    std::vector<std::size_t> order(fit.data.slips.size()), typical;
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto velocity = [&](std::size_t slip) { return fit.data.slips[slip].velocity; };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return velocity(a) < velocity(b); });
    for (std::size_t from = 0, to = 0; from < order.size(); from = to) {
        while (to < order.size() && velocity(order[to]) <= (1.0 + same_drive) * velocity(order[from]))
            ++to;
        const auto at = [&](std::size_t place) { return order.begin() + static_cast<std::ptrdiff_t>(place); };
        const auto middle = at(from + (to - from) / 2);
        std::nth_element(at(from), middle, at(to), [&](std::size_t a, std::size_t b) {
            return fit.laws[law].limits[a] < fit.laws[law].limits[b];
        });
        typical.push_back(*middle);
    }
    return typical;
}

drawing::Line slip_line(const analysis::FrictionFit& fit, std::size_t law, std::size_t slip, drawing::Extent time,
                        drawing::Stroke stroke) {
    drawing::Line line{{}, {}, stroke};
    std::vector<double> times;  // [s]
    for (std::size_t k = 0; k < fit_curve_points; ++k) {
        line.x.push_back(time.from + (time.to - time.from) * static_cast<double>(k) / (fit_curve_points - 1.0));
        times.push_back(1e-3 * line.x.back());
    }
    line.y = analysis::slip_force(fit, law, slip, times);
    for (double& force : line.y)
        force /= fit.laws[law].limits[slip];
    return line;
}

// the law, then those that the data do not tell from it
std::vector<std::size_t> drawn_laws(const analysis::FrictionFit& fit, std::size_t law) {
    std::vector<std::size_t> drawn{law}, others = fit.rivals;
    if (law != fit.best) others.push_back(fit.best);
    std::copy_if(others.begin(), others.end(), std::back_inserter(drawn),
                 [&](std::size_t other) { return other != law; });
    return drawn;
}

// of one of the drawn laws: the law itself stands out
drawing::Stroke stroke_of(std::size_t drawn, std::size_t law) {
    return drawn == law ? drawing::Stroke{drawing::accent, 1.6, drawing::Dash::solid}
                        : drawing::Stroke{drawing::ink, 0.9, drawing::Dash::dashed};
}

drawing::Scene slip_scene(const analysis::FrictionFit& fit, std::size_t law) {
    drawing::Panel above, below;
    drawing::Points samples = fit_points(), left = fit_points();
    const std::size_t count = std::min(most_drawn_slips, fit.data.slips.size());
    for (std::size_t k = 0; k < count; ++k) {
        const ReleasedSlip slip = released_slip(fit, law, k * fit.data.slips.size() / count);
        samples.x.insert(samples.x.end(), slip.time.begin(), slip.time.end());
        samples.y.insert(samples.y.end(), slip.force.begin(), slip.force.end());
        left.y.insert(left.y.end(), slip.left.begin(), slip.left.end());
    }
    left.x = samples.x;
    const auto [first, last] = std::minmax_element(samples.x.begin(), samples.x.end());
    above.x.label = "time from the release on";
    above.x.unit = "ms";
    above.x.range = {*first, *last};
    below.x = above.x;
    above.x.text = drawing::AxisText::hidden;
    above.grid = below.grid = drawing::Grid::both;
    below.row = 1;
    above.y.label = drawing::StyledText("force / force at the release");
    below.y.label = "left over";
    above.y.unit = below.y.unit = "1";
    drawing::Scene scene;
    std::vector<double> shown = samples.y;
    below.y.range = with_air(left.y);
    above.layers.emplace_back(std::move(samples));
    below.layers.emplace_back(std::move(left));
    for (const std::size_t drawn : drawn_laws(fit, law)) {
        const drawing::Stroke stroke = stroke_of(drawn, law);
        for (const std::size_t slip : typical_slips(fit, drawn)) {
            drawing::Line line = slip_line(fit, drawn, slip, above.x.range, stroke);
            shown.insert(shown.end(), line.y.begin(), line.y.end());
            above.layers.emplace_back(std::move(line));
        }
        scene.legend.push_back({std::string(analysis::fitted_names[fit.laws[drawn].kind]), stroke});
    }
    above.y.range = with_air(shown);
    below.layers.emplace_back(
        drawing::Rule{0.0, drawing::Orientation::horizontal, {drawing::accent, 0.8, drawing::Dash::solid}});
    scene.legend.push_back({"sample", fit_points()});
    scene.title = "Slips, and the motion of the rig";
    scene.caption = {drawing::StyledText(analysis::words_of(fit))};
    scene.panels = {std::move(above), std::move(below)};
    scene.row_heights = {1.0, 0.5};
    scene.width = 120.0;
    scene.height = 110.0;
    return scene;
}

}  // namespace

drawing::Scene friction_fit(const analysis::FrictionFit& fit, std::size_t law) {
    if (fit.data.points.empty() && fit.slips > 0) return slip_scene(fit, law);
    SpeedPanels panels = speed_panels({&fit, 1});
    add_points(panels, fit, fit.laws[law].residuals, drawing::quiet_ink);
    for (const std::size_t drawn : drawn_laws(fit, law))
        add_curve(panels, fit.laws[drawn], std::string(analysis::fitted_names[fit.laws[drawn].kind]),
                  stroke_of(drawn, law));
    return finished(std::move(panels), drawing::quiet_ink, "Friction over the speed of slip", analysis::words_of(fit));
}

drawing::Scene friction_over_conditions(const analysis::FrictionOverConditions& over, std::size_t law) {
    const std::vector<analysis::FrictionFit>& fits = over.fits[over.exponents[law]];
    SpeedPanels panels = speed_panels(fits);
    for (std::size_t k = 0; k < fits.size(); ++k) {
        // the yellow end of the map is no line on white
        const double share = fits.size() > 1 ? static_cast<double>(k) / static_cast<double>(fits.size() - 1) : 0.0;
        const drawing::Colour colour = drawing::sequential(0.8 * share);
        const analysis::FittedLaw& here = analysis::law_at(over, law, k);
        add_points(panels, fits[k], here.residuals, colour);
        add_curve(panels, here, over.conditions[k], {colour, 1.4, drawing::Dash::solid});
    }
    const std::string name(analysis::fitted_names[over.whole.laws[law].kind]);
    return finished(std::move(panels), drawing::quiet_ink, "Friction over the speed of slip: " + name,
                    analysis::words_of(over));
}

}  // namespace stridor::pictures
