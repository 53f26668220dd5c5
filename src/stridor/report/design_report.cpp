#include "stridor/report/design_report.hpp"

#include "stridor/base/version.hpp"
#include "stridor/chart/gnuplot.hpp"
#include "stridor/chart/noise_chart.hpp"
#include "stridor/chart/stability.hpp"
#include "stridor/chart/time_history.hpp"
#include "stridor/parameters/field.hpp"

#include <fmt/format.h>

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
    section.table.columns = {"phase",      "category",   "slip",      "stick",
                             "separation", "regularity", "frequency", "joint level"};
    for (const Verdict& verdict : results.verdicts) {
        const analysis::Evidence& e = verdict.evidence;
        section.table.rows.push_back(
            {phase_name(verdict), std::string(classification::name(verdict.category)),
             number_or_dash(100.0 * e.rates.slip, "{:.1f} %"), number_or_dash(100.0 * e.rates.stick, "{:.1f} %"),
             number_or_dash(100.0 * e.rates.separation, "{:.1f} %"), number_or_dash(e.alternation.regularity, "{:.3f}"),
             number_or_dash(e.alternation.frequency, "{:.1f} Hz"),
             number_or_dash(e.levels.joint.decibels, "{:.1f} dB")});
        std::string why = phase_name(verdict) + ": ";
        for (std::size_t k = 0; k < verdict.reasons.size(); ++k)
            why += (k > 0 ? "; " : "") + verdict.reasons[k];
        section.paragraphs.push_back(std::move(why));
    }
    section.paragraphs.push_back("A category names a vibration pattern of the model. " +
                                 std::string(analysis::level_note));
    return section;
}

Section motion_section(const DesignResults& results) {
    constexpr double zoom = 0.02;  // [s]
    chart::TimeHistoryOptions options;
    options.zoom = chart::telling_stretch(results.design, zoom);
    return {"Motion",
            {},
            chart::render(chart::time_history(results.design, results.motion.record, options), chart::Format::svg),
            "Imposed velocity, accelerations and contact states over time, and a short stretch of them beside."};
}

Section chart_section(const sweep::SweepResult& result) {
    return {"Noise chart",
            {},
            chart::render(chart::noise_chart(result), chart::Format::svg),
            fmt::format(
                "Category over {} and {}, {} by {} cells, of which {} were computed and the others taken from their "
                "neighbours.",
                result.study.x.parameter, result.study.y.parameter, result.study.x.points, result.study.y.points,
                sweep::computed_count(result))};
}

Section stability_section(const analysis::StabilityScan& scan) {
    std::vector<chart::StabilityCurve> curves;
    for (const analysis::DirectionScan& direction : scan.directions)
        curves.push_back({direction.direction, direction.path});
    return {"Stability of steady sliding",
            {},
            chart::render(chart::stability(scan.key, curves), chart::Format::svg),
            "Frequencies and growth rates of the sliding modes over " + scan.key + "."};
}

std::string change_words(const sweep::DesignSpace& space, const sweep::DesignChange& change) {
    std::string text;
    for (const sweep::ParameterChange& each : change.set)
        text += fmt::format("{}{} {:.4g} -> {:.6g}", text.empty() ? "" : ", ", space.parameters[each.parameter].key,
                            each.from, each.to);
    return text;
}

Section advice_section(const sweep::Advice& advice) {
    Section section{"What keeps it quiet"};
    section.table.columns = {"distance", "change", "verified by"};
    for (const sweep::DesignChange& change : advice.changes)
        section.table.rows.push_back({fmt::format("{:.3f}", change.distance), change_words(advice.space, change),
                                      fmt::format("{} runs, all quiet", change.runs)});
    if (sweep::is_quiet(advice.present))
        section.paragraphs.push_back("The design is quiet as it stands.");
    else if (advice.changes.empty())
        section.paragraphs.push_back("No change within the usual ranges was verified to be quiet.");
    else
        section.paragraphs.push_back(
            "Changes that make every phase quiet, smallest first. Distance is the share of the "
            "usual range that a designer has to go.");
    if (advice.chance)
        section.paragraphs.push_back(fmt::format(
            "Chance of noise within tolerances: {:.2f} % ({:.2f} to {:.2f} %, 95 % confidence).",
            100.0 * advice.chance->noise.share, 100.0 * advice.chance->noise.low, 100.0 * advice.chance->noise.high));
    return section;
}

Section parameter_section(const parameters::Case& c) {
    Section section{"Parameters"};
    section.table.columns = {"key", "symbol", "value", "meaning"};
    for (const parameters::Field& field : parameters::fields())
        if (field.belongs(c) && !field.section.empty())
            section.table.rows.push_back({parameters::key_of(field), std::string(field.symbol),
                                          parameters::value_text(c, field), std::string(field.sentence)});
    return section;
}

std::string category_list(const std::vector<Verdict>& verdicts) {
    std::string text;
    for (const Verdict& verdict : verdicts)
        text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", phase_name(verdict),
                            classification::name(verdict.category));
    return text;
}

}  // namespace

Report design_report(const DesignResults& results) {
    Report report;
    report.title = results.design.title.empty() ? "Rubbing contact" : results.design.title;
    report.subtitle = category_list(results.verdicts);
    report.sections.push_back(verdict_section(results));
    if (!results.motion.record.trace.time.empty()) report.sections.push_back(motion_section(results));
    if (results.chart) report.sections.push_back(chart_section(*results.chart));
    if (results.stability && !results.stability->key.empty())
        report.sections.push_back(stability_section(*results.stability));
    if (results.advice) report.sections.push_back(advice_section(*results.advice));
    report.sections.push_back(parameter_section(results.design));
    Section origin{"Where this comes from"};
    origin.paragraphs.push_back(
        fmt::format("Made by stridor {} ({}). This prints the verdict again:", base::version(), base::commit()));
    origin.code = results.command;
    report.sections.push_back(std::move(origin));
    return report;
}

}  // namespace stridor::report
