#include "stridor/pictures/time_history.hpp"

#include "stridor/base/check.hpp"
#include "stridor/drawing/palette.hpp"
#include "stridor/parameters/rules/engines.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/pictures/contact_states.hpp"
#include "stridor/pictures/parts/field_axis.hpp"
#include "stridor/record/schedule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace stridor::pictures {

namespace {

// one row of panels
struct Curve {
    drawing::StyledText label;
    std::string unit;
    const std::vector<double>* values = nullptr;  // shape [sample]
    double cut = 0.0;                             // [1] share of the samples at either end that may lie beyond the axis
};

// Impact peaks of beta_2 grow without bound as the time step shrinks: an axis that shows them whole shows nothing else.
// The exact engine has none: its impacts take no time.
constexpr double peak_share = 2e-3;

drawing::StyledText body_symbol(std::string_view letter, std::string_view number) {
    return drawing::StyledText(letter, drawing::TextStyle::italic) +
           drawing::StyledText(number, drawing::TextStyle::subscript);
}

// two degrees of freedom a joint, numbered as the contacts, then the plate's; their letters with as many dots as
// derivatives. The only joint is mass 1, and the plate mass 2.
void add_motion(std::vector<Curve>& curves, const std::vector<std::vector<double>>& motion,
                const std::array<std::string_view, 2>& letters, const std::string& unit, double cut = 0.0) {
    const auto& [x, y] = letters;
    const std::size_t joints = motion.size() / 2;
    for (std::size_t dof = 0; dof < motion.size(); ++dof) {
        const bool is_plate = dof == 2 * joints;
        const std::string body = !is_plate ? std::to_string(dof / 2 + 1) : joints == 1 ? "2" : "plate";
        curves.push_back({body_symbol(!is_plate && dof % 2 == 0 ? x : y, body), unit, &motion[dof], cut});
    }
}

// the only contact needs none
drawing::StyledText contact_number(std::size_t contact, std::size_t contacts) {
    if (contacts == 1) return {};
    return drawing::StyledText(std::to_string(contact + 1), drawing::TextStyle::subscript);
}

void add_curves(std::vector<Curve>& curves, const record::Trace& trace, ShownSignal signal, double cut) {
    switch (signal) {
        case ShownSignal::imposed_velocity:
            curves.push_back({drawing::symbol("V"), "m/s", &trace.surface_velocity});
            break;
        case ShownSignal::displacement:
            add_motion(curves, trace.displacement, {"x", "y"}, "m");
            break;
        case ShownSignal::velocity:
            add_motion(curves, trace.velocity, {"ẋ", "ẏ"}, "m/s");
            break;
        case ShownSignal::acceleration:
            add_motion(curves, trace.acceleration, {"ẍ", "ÿ"}, "m/s^2", cut);
            break;
        case ShownSignal::contact_forces:
            for (std::size_t k = 0; k < trace.contacts.size(); ++k) {
                const drawing::StyledText number = contact_number(k, trace.contacts.size());
                curves.push_back({drawing::symbol("N") + number, "N", &trace.contacts[k].normal_force, cut});
                curves.push_back({drawing::symbol("T") + number, "N", &trace.contacts[k].friction_force, cut});
            }
            break;
    }
}

// the rows of an own structure are too many: what its contacts carry is drawn in their place
std::vector<ShownSignal> shown_of(const parameters::Case& c, std::vector<ShownSignal> signals) {
    if (parameters::has_plate(c)) return signals;
    const auto is_of_rows = [](ShownSignal signal) {
        return signal == ShownSignal::displacement || signal == ShownSignal::velocity ||
               signal == ShownSignal::acceleration || signal == ShownSignal::contact_forces;
    };
    if (std::erase_if(signals, is_of_rows) > 0) signals.push_back(ShownSignal::contact_forces);
    return signals;
}

// the values within a stretch of time, without the share `cut` of them at either end, with a little air
drawing::Extent extent(const record::Trace& trace, const Curve& curve, const drawing::Extent& stretch) {
    std::vector<double> values;
    for (std::size_t i = 0; i < std::min(trace.time.size(), curve.values->size()); ++i)
        if (trace.time[i] >= stretch.from && trace.time[i] <= stretch.to && std::isfinite((*curve.values)[i]))
            values.push_back((*curve.values)[i]);
    if (values.empty()) return {-1.0, 1.0};
    const auto skipped = static_cast<std::ptrdiff_t>(curve.cut * static_cast<double>(values.size()));
    const auto low = values.begin() + skipped;
    std::nth_element(values.begin(), low, values.end());
    const double from = *low;
    const auto high = values.end() - 1 - skipped;
    std::nth_element(values.begin(), high, values.end());
    const double to = *high;
    const double air = to > from ? 0.08 * (to - from) : 1.0;
    return {from - air, to + air};
}

// the samples of a stretch and one more at either end; a zoom need not carry the whole trace
drawing::Line line_within(const record::Trace& trace, const Curve& curve, const drawing::Extent& stretch) {
    const auto begin = trace.time.begin();
    const std::ptrdiff_t last = static_cast<std::ptrdiff_t>(std::min(trace.time.size(), curve.values->size()));
    const std::ptrdiff_t from = std::lower_bound(begin, begin + last, stretch.from) - begin;
    const std::ptrdiff_t to = std::upper_bound(begin, begin + last, stretch.to) - begin;
    const std::ptrdiff_t first = std::max<std::ptrdiff_t>(0, from - 1);
    const std::ptrdiff_t end = std::min(last, to + 1);
    const auto values = curve.values->begin();
    return {{begin + first, begin + end}, {values + first, values + end}, {drawing::accent, 0.5, drawing::Dash::solid}};
}

drawing::Panel curve_panel(const record::Trace& trace, const Curve& curve, const drawing::Extent& time) {
    drawing::Panel panel;
    panel.grid = drawing::Grid::both;
    panel.x.range = time;
    panel.x.text = drawing::AxisText::hidden;
    panel.y.label = curve.label;
    panel.y.unit = curve.unit;
    panel.y.range = extent(trace, curve, time);
    panel.layers.emplace_back(line_within(trace, curve, time));
    return panel;
}

// one column of panels: the curves, then the states of each contact
void add_column(drawing::Scene& scene, const record::Record& record, const std::vector<Curve>& curves,
                const drawing::Extent& time) {
    const std::size_t column = scene.column_widths.size();
    scene.column_widths.push_back(column == 0 ? 1.35 : 1.0);
    for (std::size_t row = 0; row <= curves.size(); ++row) {
        drawing::Panel panel =
            row < curves.size() ? curve_panel(record.trace, curves[row], time) : state_panel(record.histories, time);
        panel.row = row;
        panel.column = column;
        // the same curve stands in the first column; its numbers differ, its name does not
        if (column > 0) panel.y.label = {};
        if (column > 0 && row == curves.size()) panel.y.text = drawing::AxisText::hidden;
        scene.panels.push_back(std::move(panel));
    }
}

void mark(drawing::Scene& scene, const drawing::Extent& stretch) {
    for (drawing::Panel& panel : scene.panels)
        if (panel.column == 0)
            panel.layers.insert(panel.layers.begin(), drawing::Boxes{{{stretch, panel.y.range}},
                                                                     {drawing::highlight, drawing::Texture::none, {}}});
}

// the time the trace covers, its last sample's interval included
drawing::Extent traced(const record::Record& record) {
    const std::vector<double>& time = record.trace.time;
    const double last = time.size() > 1 ? 2.0 * time.back() - time[time.size() - 2] : time.back();
    const bool has_history = !record.histories.empty() && !record.histories.front().empty();
    const double end = has_history ? std::min(last, record.histories.front().back().to) : time.back();
    return {time.front(), std::max(time.back(), end)};
}

bool has_impacts(const record::ContactHistory& history) {
    return std::any_of(history.begin(), history.end(), [](const record::ContactInterval& interval) {
        return interval.state != model::ContactState::separation && interval.gap_velocity < 0.0;
    });
}

bool runs_beyond(const drawing::Panel& panel) {
    const auto leaves = [&](const drawing::Layer& layer) {
        const drawing::Line* line = std::get_if<drawing::Line>(&layer);
        return line != nullptr && std::any_of(line->y.begin(), line->y.end(), [&](double value) {
                   return value < panel.y.range.from || value > panel.y.range.to;
               });
    };
    return std::any_of(panel.layers.begin(), panel.layers.end(), leaves);
}

std::string times_text(std::size_t number) {
    return number == 1 ? "once" : number == 2 ? "twice" : fmt::format("{} times", number);
}

// "In b) the contact separates 8 times and sticks twice."
std::string changes_text(const record::ContactHistory& history, const std::string& contact,
                         const drawing::Extent& stretch) {
    std::array<std::size_t, model::contact_states> entries{};
    for (const record::ContactInterval& interval : history)
        if (interval.from > stretch.from && interval.from < stretch.to) ++entries[model::index_of(interval.state)];
    const std::size_t separations = entries[model::index_of(model::ContactState::separation)];
    const std::size_t sticks = entries[model::index_of(model::ContactState::stick)];
    const std::size_t slips = entries[model::index_of(model::ContactState::slip)];
    std::string text;
    const auto add = [&](std::string_view verb, std::size_t number) {
        if (number > 0) text += fmt::format("{}{} {}", text.empty() ? "" : " and ", verb, times_text(number));
    };
    add("separates", separations);
    add("sticks", sticks);
    // a slip follows each of the two but the last
    if (text.empty()) add("begins to slip", slips);
    return "In b) " + contact + " " + (text.empty() ? "does not change its state" : text) + ".";
}

std::string phase_name(const parameters::Case& c, const drawing::Extent& stretch) {
    for (const record::Span& span : record::schedule(c).spans)
        if (stretch.from >= span.from && stretch.to <= span.to && span.phase != record::Phase::all)
            return " (" + std::string(record::phase_names[static_cast<std::size_t>(span.phase)]) + ")";
    return {};
}

// the stretch with the most changes of state so far
struct Busiest {
    drawing::Extent stretch;
    std::size_t changes = 0;

    void look_at(std::span<const record::ContactHistory> histories, const drawing::Extent& within, double length) {
        std::vector<double> times;
        for (const record::ContactHistory& history : histories)
            for (std::size_t k = 1; k < history.size(); ++k)
                if (history[k].from >= within.from && history[k].from <= within.to) times.push_back(history[k].from);
        std::sort(times.begin(), times.end());
        const double fitting = std::min(length, within.to - within.from);
        for (std::size_t first = 0, last = 0; first < times.size(); ++first) {
            while (last < times.size() && times[last] <= times[first] + fitting)
                ++last;
            if (last - first <= changes) continue;
            changes = last - first;
            // amid what it shows
            const double middle = 0.5 * (times[first] + times[last - 1]);
            const double grid = 0.05 * fitting;  // so that its ends are short numbers
            const double from =
                std::clamp(std::round((middle - 0.5 * fitting) / grid) * grid, within.from, within.to - fitting);
            stretch = {from, from + fitting};
        }
    }
};

}  // namespace

drawing::Scene time_history(const parameters::Case& c, const record::Record& record,
                            const TimeHistoryOptions& options) {
    STRIDOR_EXPECT(!record.trace.time.empty());
    std::vector<Curve> curves;
    const bool has_peaks = parameters::engine_of(c) != parameters::Engine::exact &&
                           std::any_of(record.histories.begin(), record.histories.end(), has_impacts);
    for (const ShownSignal signal : shown_of(c, options.signals))
        add_curves(curves, record.trace, signal, has_peaks ? peak_share : 0.0);
    drawing::Extent whole = options.whole;
    if (!(whole.from < whole.to)) whole = traced(record);
    drawing::Scene scene;
    scene.title = c.title.empty() ? drawing::StyledText("Time history") : drawing::StyledText(c.title);
    scene.caption = {conditions(c)};
    scene.row_heights.assign(curves.size(), 1.0);
    scene.row_heights.push_back(0.75 * static_cast<double>(record.histories.size()));
    scene.height = 30.0 + 24.0 * static_cast<double>(curves.size());
    scene.column_widths.clear();
    add_column(scene, record, curves, whole);
    if (options.zoom) {
        add_column(scene, record, curves, *options.zoom);
        for (std::size_t k = 0; k < record.histories.size(); ++k) {
            const bool is_only = record.histories.size() == 1;
            const bool is_named = !is_only && k < parameters::contact_count(c);
            const std::string name = is_named ? " (" + parameters::contact_name(c, k) + ")" : "";
            const std::string contact = is_only ? "the contact" : fmt::format("contact {}{}", k + 1, name);
            scene.caption.emplace_back(changes_text(record.histories[k], contact, *options.zoom));
        }
        mark(scene, *options.zoom);
        scene.panels.front().title = lettered(0, "whole run");
        scene.panels[curves.size() + 1].title = lettered(
            1, fmt::format("{:g} s to {:g} s{}", options.zoom->from, options.zoom->to, phase_name(c, *options.zoom)));
    }
    if (has_peaks && std::any_of(scene.panels.begin(), scene.panels.end(), runs_beyond))
        scene.caption.emplace_back("Impact peaks, whose height follows from the time step, run beyond the axes.");
    return scene;
}

std::optional<drawing::Extent> busiest_stretch(const parameters::Case& c,
                                               std::span<const record::ContactHistory> histories, double length) {
    Busiest judged;
    Busiest any;
    for (const record::Span& span : record::schedule(c).spans)
        if (record::is_judged(span.use)) judged.look_at(histories, {span.from, span.to}, length);
    any.look_at(histories, {0.0, c.run.duration}, length);
    const Busiest& best = judged.changes >= 2 ? judged : any;
    return best.changes > 0 ? std::optional(best.stretch) : std::nullopt;
}

drawing::Extent telling_stretch(const parameters::Case& c, double length) {
    record::Span best;
    for (const record::Span& span : record::schedule(c).spans) {
        if (span.use == record::Use::closing) best.to = span.to;
        if (span.use != record::Use::judged) continue;
        // the second going phase if there is one: the first still feels the start
        if (span.phase == record::Phase::coming && best.to > best.from) continue;
        const bool is_better = best.phase != span.phase || best.from == 0.0 || !(best.to > best.from);
        if (is_better || span.phase == record::Phase::all) best = span;
    }
    if (!(best.to > best.from)) best = {0.0, c.run.duration, record::Phase::all, record::Use::judged};
    const double half = 0.5 * std::min(length, best.to - best.from);
    const double middle = 0.5 * (best.from + best.to);
    return {middle - half, middle + half};
}

}  // namespace stridor::pictures
