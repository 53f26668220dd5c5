#include "stridor/report/design_report.hpp"

#include "stridor/base/version.hpp"
#include "stridor/drawing/palette.hpp"
#include "stridor/drawing/picture.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/parameters/case_key.hpp"
#include "stridor/pictures/noise_chart.hpp"
#include "stridor/pictures/parts/category_colours.hpp"
#include "stridor/pictures/parts/design_mark.hpp"
#include "stridor/pictures/stability.hpp"
#include "stridor/pictures/time_history.hpp"
#include "stridor/report/sketch.hpp"
#include "stridor/report/verdict_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace stridor::report {

namespace {

using classification::Verdict;

std::string number_or_dash(double value, const char* format) {
    return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : std::string("-");
}

std::string phase_name(const Verdict& verdict) {
    return std::string(record::phase_names[static_cast<std::size_t>(verdict.evidence.phase)]);
}

Section verdict_section(const DesignResults& results) {
    Section section{"Verdict"};
    section.table.columns = {"direction",  "category",   "slip",      "stick",
                             "separation", "regularity", "frequency", "joint level"};
    for (const Verdict& verdict : results.verdicts) {
        const analysis::Evidence& e = verdict.evidence;
        section.table.rows.push_back(
            {phase_name(verdict), std::string(classification::name(verdict.category)),
             number_or_dash(100.0 * e.rates.slip, "{:.1f} %"), number_or_dash(100.0 * e.rates.stick, "{:.1f} %"),
             number_or_dash(100.0 * e.rates.separation, "{:.1f} %"), number_or_dash(e.alternation.regularity, "{:.3f}"),
             number_or_dash(e.alternation.frequency, "{:.1f} Hz"),
             number_or_dash(e.levels.joint.decibels, "{:.1f} dB")});
        std::string why = "Why " + phase_name(verdict) + ": ";
        for (std::size_t k = 0; k < verdict.reasons.size(); ++k)
            why += (k > 0 ? "; " : "") + verdict.reasons[k];
        section.paragraphs.push_back(why + ".");
    }
    section.paragraphs.emplace_back("The shares in the table are of the whole window, reversals included. " +
                                    std::string(analysis::level_note));
    return section;
}

std::string heard_words(const DesignSound& sound) {
    if (sound.wav.empty()) return "Nothing moves that could be heard.";
    const classification::SoundSegment* loudest = sound.heard.loudest();
    const std::string why =
        loudest == nullptr || loudest->verdict.reasons.empty() ? "" : " (" + loudest->verdict.reasons.back() + ")";
    if (sound.heard.category == classification::Category::none) return "By ear: no noise of its own" + why + ".";
    return "By ear: " + std::string(classification::name(sound.heard.category)) + why + ".";
}

Section sound_section(const std::vector<DesignSound>& sounds) {
    Section section{"What it sounds like"};
    section.paragraphs.emplace_back(
        "The motion of the joint along the plate, made audible. Each sound is as loud as its file allows, whatever its "
        "level; the part itself radiates in its own way.");
    for (const DesignSound& sound : sounds) {
        const std::string label(parameters::direction_names[static_cast<std::size_t>(sound.direction)]);
        if (sound.wav.empty())
            section.paragraphs.push_back(label + ": " + heard_words(sound));
        else
            section.sounds.push_back({label, heard_words(sound), sound.wav});
    }
    return section;
}

Section motion_section(const DesignResults& results) {
    constexpr double zoom = 0.02;  // [s]
    pictures::TimeHistoryOptions options;
    options.zoom = pictures::busiest_stretch(results.design, results.motion.record.histories, zoom);
    return {
        "Motion",
        {},
        drawing::render(pictures::time_history(results.design, results.motion.record, options), drawing::Format::svg),
        "Imposed velocity, accelerations and contact states over time, and a short stretch of them beside."};
}

Section chart_section(const sweep::SweepResult& result) {
    drawing::Scene scene = pictures::noise_chart(result);
    pictures::mark_design(scene, result.study);
    return {
        "Where it is quiet",
        {},
        drawing::render(scene, drawing::Format::svg),
        fmt::format("Category over {} and {}, {} by {} cells in each direction, each a run of its own. {}",
                    result.study.x.parameter, result.study.y.parameter, result.study.x.points, result.study.y.points,
                    sweep::holds_design(result.study) ? "The diamond is the design."
                                                      : "The design lies outside of the chart.")};
}

Section stability_section(const analysis::StabilityScan& scan) {
    std::vector<pictures::StabilityCurve> curves;
    for (const analysis::DirectionScan& direction : scan.directions)
        curves.push_back({direction.direction, direction.path});
    return {"Stability of steady sliding",
            {},
            drawing::render(pictures::stability(scan.key, curves), drawing::Format::svg),
            "Frequencies and growth rates of the sliding modes over " + scan.key + "."};
}

std::string measured(const std::string& key, double value) {
    const std::string_view unit = parameters::unit_of(key);
    return fmt::format("{:.4g}{}", value, unit == "1" ? "" : " " + std::string(unit));
}

std::string change_words(const advice::DesignSpace& space, const advice::DesignChange& change) {
    std::string text;
    for (const advice::ParameterChange& each : change.set)
        text += fmt::format("{}{} from {} to {}", text.empty() ? "" : ", ", space.parameters[each.parameter].key,
                            measured(space.parameters[each.parameter].key, each.from),
                            measured(space.parameters[each.parameter].key, each.to));
    return text;
}

// the parameters whose verdict changes nearest, with where it does
HtmlTable margin_table(const advice::Advice& advice) {
    constexpr std::size_t most_rows = 6;
    std::vector<std::pair<double, std::size_t>> order;
    for (const advice::ParameterMargin& margin : advice.margins)
        if (const advice::VerdictChange* change = advice::nearest_change(advice.space, margin))
            order.emplace_back(std::abs(change->share - advice.space.origin[margin.parameter]), margin.parameter);
    std::sort(order.begin(), order.end());
    HtmlTable table{{"parameter", "now", "changes below", "changes above"}, {}};
    for (std::size_t k = 0; k < std::min(most_rows, order.size()); ++k) {
        const advice::ParameterMargin& margin = advice.margins[order[k].second];
        const std::string& key = advice.space.parameters[margin.parameter].key;
        const auto words = [&](const advice::ScanSide& side) {
            if (!side.change) return std::string("-");
            return measured(key, side.change->value) + " (" +
                   std::string(sweep::word(advice::overall(side.change->beyond))) + ")";
        };
        table.rows.push_back({key, measured(key, margin.value), words(margin.below), words(margin.above)});
    }
    return table;
}

std::vector<Section> advice_sections(const advice::Advice& advice) {
    Section change{"What to change"};
    const bool is_quiet = advice::is_quiet(advice.present);
    if (is_quiet)
        change.paragraphs.emplace_back("Nothing: the design is quiet as it stands.");
    else if (advice.changes.empty())
        change.paragraphs.emplace_back("No change within the usual ranges was verified to be quiet.");
    else {
        const advice::DesignChange& best = advice.changes[advice.recommended.value_or(0)];
        change.paragraphs.push_back("Advised: " + change_words(advice.space, best) +
                                    fmt::format(". This was verified to be quiet by {} runs, from every start and with "
                                                "1 % more and less of each value.",
                                                best.runs));
        change.paragraphs.emplace_back(
            "All changes that were verified, smallest first. The distance is the share of its usual range that a "
            "quantity has to go.");
        change.table.columns = {"distance", "change", "verified by"};
        for (const advice::DesignChange& each : advice.changes)
            change.table.rows.push_back({fmt::format("{:.3f}", each.distance), change_words(advice.space, each),
                                         fmt::format("{} quiet runs", each.runs)});
    }
    Section margins{"How far it is from another verdict"};
    margins.table = margin_table(advice);
    margins.paragraphs.emplace_back(margins.table.rows.empty()
                                        ? "No quantity alone changes the verdict within its usual range."
                                        : "Each quantity alone, the nearest first. The loudest direction is named.");
    if (advice.chance)
        margins.paragraphs.push_back(fmt::format(
            "Chance of noise within tolerances: {:.2f} % ({:.2f} to {:.2f} %, 95 % confidence).",
            100.0 * advice.chance->noise.share, 100.0 * advice.chance->noise.low, 100.0 * advice.chance->noise.high));
    return {std::move(change), std::move(margins)};
}

Section parameter_section(const parameters::Case& c) {
    Section section{"Parameters"};
    section.table.columns = {"key", "symbol", "value", "meaning"};
    for (const std::string& key : parameters::keys_of(c)) {
        const parameters::Field& field = *parameters::field_of(key);
        if (field.section.empty()) continue;
        section.table.rows.push_back(
            {key, std::string(field.symbol), parameters::value_text(c, key), std::string(field.sentence)});
    }
    return section;
}

std::vector<Badge> badges(const std::vector<Verdict>& verdicts) {
    std::vector<Badge> badges;
    for (const Verdict& verdict : verdicts) {
        const drawing::Fill fill = pictures::category_fill(verdict.category);
        badges.push_back({phase_name(verdict), std::string(classification::name(verdict.category)),
                          drawing::hex(fill.colour), drawing::hex(drawing::text_colour_on(fill.colour))});
    }
    return badges;
}

Section origin_section(const DesignResults& results) {
    Section section{"How to get this again"};
    section.paragraphs.push_back(
        fmt::format("Made by stridor {} ({}) with this command:", base::version(), base::commit()));
    section.code = results.command;
    return section;
}

}  // namespace

Report design_report(const DesignResults& results) {
    Report report;
    report.title = results.design.title.empty() ? "Rubbing contact" : results.design.title;
    report.badges = badges(results.verdicts);
    report.lead.push_back(summary(results.verdicts));
    for (const Verdict& verdict : results.verdicts)
        report.lead.push_back(plain_words(verdict));
    report.sketch = sketch_svg(results.design);
    const bool has_several = !results.design.further_joints.empty();
    report.sketch_caption =
        has_several
            ? "The model: joints, pressed on one plate that moves under them, held at angles by springs and dampers."
            : "The model: a joint, pressed on a plate that moves under it, held at an angle by springs and dampers.";
    report.sections.push_back(verdict_section(results));
    if (!results.sounds.empty())
        report.sections.push_back(sound_section(results.sounds));
    else if (!results.without_sound.empty())
        report.sections.push_back({"What it sounds like", {results.without_sound}});
    if (results.chart) report.sections.push_back(chart_section(*results.chart));
    if (results.advice)
        for (Section& section : advice_sections(*results.advice))
            report.sections.push_back(std::move(section));
    else if (!results.without_advice.empty())
        report.sections.push_back({"What to change", {results.without_advice}});
    if (!results.motion.record.trace.time.empty()) report.sections.push_back(motion_section(results));
    if (results.stability && !results.stability->key.empty())
        report.sections.push_back(stability_section(*results.stability));
    report.sections.push_back(parameter_section(results.design));
    Section file{"The case as a file"};
    file.paragraphs.emplace_back("Everything above follows from these values.");
    file.file = {"case.toml", io::case_toml(results.design, {io::Comments::none, {}})};
    report.sections.push_back(std::move(file));
    report.sections.push_back(origin_section(results));
    report.foot = std::string("A category names a pattern of vibration of a small model (") +
                  (has_several ? "joints on one plate, one point of contact each"
                               : "one joint, one plate, one point of contact") +
                  "), not a sound pressure in a car. What the model does not hold, such as wear, temperature, " +
                  (has_several ? "" : "several contacts ") +
                  "and the radiation of sound, is not in this verdict either.";
    return report;
}

}  // namespace stridor::report
