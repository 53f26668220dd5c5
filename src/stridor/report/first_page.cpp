#include "stridor/report/first_page.hpp"

#include "stridor/base/text.hpp"
#include "stridor/base/version.hpp"
#include "stridor/drawing/palette.hpp"
#include "stridor/drawing/picture.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/pictures/noise_chart.hpp"
#include "stridor/pictures/parts/category_colours.hpp"
#include "stridor/pictures/parts/chart_cells.hpp"
#include "stridor/report/sketch.hpp"
#include "stridor/report/structure_sketch.hpp"
#include "stridor/report/verdict_words.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

namespace stridor::report {

namespace {

using advice::Advice;
using classification::Verdict;

constexpr std::size_t most_rows = 4;  // [1] of what to change, which leaves the page one page

// "joint mass 0.1 → 0.135 kg (+35 %)"
std::string step_words(std::string_view key, double from, double to) {
    const std::string_view unit = parameters::unit_of(key);
    std::string text = fmt::format("{} {:.4g} \u2192 {:.4g}{}{}", advice::quantity_words(key), from, to,
                                   unit == "1" ? "" : "\u00A0", unit == "1" ? "" : unit);
    const double percent = 100.0 * (to - from) / std::abs(from);
    if (!std::isfinite(percent)) return text;
    return text + (std::abs(percent) < 10.0 ? fmt::format(" ({:+.2g}\u00A0%)", percent)
                                            : fmt::format(" ({:+.0f}\u00A0%)", percent));
}

std::string steps_words(const advice::DesignSpace& space, const advice::DesignChange& change) {
    std::vector<std::string> words;
    for (const advice::ParameterChange& each : change.set)
        words.push_back(step_words(space.parameters[each.parameter].key, each.from, each.to));
    return base::listed(words);
}

// "How far it is from quiet was not found within 60 s"
std::string unknown_margin(bool was_quiet, PartTime time) {
    return fmt::format("How far it is from {} was not found within {:g}\u00A0s: `--longest` gives it more",
                       was_quiet ? "noise" : "quiet", time.count());
}

// the change of one quantity alone, the nearest that was looked at, with which a phase is quiet no more, or is quiet
std::string margin_words(const Advice& advice, std::size_t phase, const std::optional<PartTime>& time) {
    const bool was_quiet = advice::is_quiet_phase(advice.present, phase);
    const bool is_cut = time && advice.stopped_in == advice::AdviceStage::margins;
    double nearest = std::numeric_limits<double>::infinity();
    std::string words = is_cut ? unknown_margin(was_quiet, *time)
                               : fmt::format("No change of one quantity alone that was looked at makes it {}",
                                             was_quiet ? "noisy" : "quiet");
    for (const advice::ParameterMargin& margin : advice.margins) {
        const auto look = [&](double share, double value, const advice::DesignVerdict& verdict) {
            const double distance = std::abs(share - advice.space.origin[margin.parameter]);
            const bool has_turned = advice::is_quiet_phase(verdict, phase) != was_quiet && !advice::is_invalid(verdict);
            if (!has_turned || !(distance < nearest)) return;
            nearest = distance;
            words = fmt::format("Margin to {}: {}", was_quiet ? sweep::word(verdict.phases[phase]) : "quiet",
                                step_words(advice.space.parameters[margin.parameter].key, margin.value, value));
        };
        for (const advice::ScanPoint& point : margin.scan)
            look(point.share, point.value, point.verdict);
        for (const advice::ScanSide* side : {&margin.below, &margin.above})
            for (const auto* change : {&side->change, &side->quiet})
                if (*change) look((*change)->share, (*change)->value, (*change)->beyond);
    }
    return words + (is_cut && std::isfinite(nearest) ? ", at most." : ".");
}

// of a design on which advice has nothing
std::string missing_margin(const DesignResults& results, std::size_t phase) {
    if (!results.advice_time) return "";
    return unknown_margin(advice::is_quiet_phase(results.standing.present, phase), *results.advice_time) + ".";
}

std::vector<Badge> badges(const DesignResults& results) {
    std::vector<Badge> badges;
    for (std::size_t k = 0; k < results.verdicts.size(); ++k) {
        const Verdict& verdict = results.verdicts[k];
        const bool locks = verdict.quiet == classification::Quiet::locks;
        const drawing::Fill fill = locks ? pictures::locked_fill() : pictures::category_fill(verdict.category);
        const double frequency = verdict.evidence.alternation.frequency;
        const bool is_noisy = verdict.category != classification::Category::none &&
                              verdict.category != classification::Category::undecided;
        const std::string tone = is_noisy && std::isfinite(frequency) ? fmt::format("{:.4g}\u00A0Hz. ", frequency) : "";
        const std::string word(classification::word(verdict));
        badges.push_back({phase_name(verdict), word == "none" ? "quiet" : word, drawing::hex(fill.colour),
                          drawing::hex(drawing::text_colour_on(fill.colour)),
                          tone + (results.advice ? margin_words(*results.advice, k, results.advice_time)
                                                 : missing_margin(results, k))});
    }
    return badges;
}

std::vector<Particular> facts(const DesignResults& results) {
    std::vector<Particular> facts{
        {"Part", results.part},
        {"Author", results.author},
        {"Date", results.date},
        {"Case", results.file},
        {"Made by", fmt::format("Stridor {} ({})", base::version(), base::commit().substr(0, 10))}};
    std::erase_if(facts, [](const Particular& fact) { return fact.value.empty(); });
    return facts;
}

// the picture alone: what it is about, and the case, stand elsewhere
Section chart_section(const sweep::SweepResult& result, const std::string& words) {
    drawing::Scene scene = pictures::noise_chart(result);
    scene.title = {};
    scene.caption.clear();
    pictures::mark_design(scene, result.study);
    const sweep::Study& study = result.study;
    return {
        "Where it is quiet",
        {},
        drawing::render(scene, drawing::Format::svg),
        fmt::format("{} by {} cells in each direction, each run from {}, of which it shows what speaks most for "
                    "noise. {}{}",
                    study.x.points, study.y.points, start_words(study.starts),
                    sweep::holds_design(study) ? "The diamond is the design." : "The design lies outside of the chart.",
                    words.empty() ? words : " " + words)};
}

Section quiet_section(const Advice& advice) {
    Section change{"What to change"};
    if (advice.near && advice.near->turns.empty()) {
        change.paragraphs.push_back(
            fmt::format("Nothing: the design is quiet, and with {:g} % more or less of any one quantity, too.",
                        100.0 * advice::looked_within));
        return change;
    }
    change.paragraphs.push_back(
        fmt::format("The design is quiet, but so close to noise that parts as they are made may not be: within {:g} % "
                    "of one quantity it is no longer quiet. Move it away from what the table names.",
                    100.0 * advice::looked_within));
    change.table.columns = {"with this alone"};
    for (const std::string& words : advice::turn_words(advice.space, *advice.near))
        if (change.table.rows.size() < most_rows) change.table.rows.push_back({words});
    return change;
}

// what was seen to be quiet with one quantity alone, nearest first; nobody verified it
std::vector<std::vector<std::string>> seen_quiet(const Advice& advice) {
    std::vector<std::pair<double, std::string>> seen;
    for (const std::size_t k : advice.space.free) {
        const advice::VerdictChange* quiet = advice::nearest_quiet(advice.space, advice.margins[k]);
        if (quiet == nullptr) continue;
        seen.emplace_back(std::abs(quiet->share - advice.space.origin[k]),
                          step_words(advice.space.parameters[k].key, advice.margins[k].value, quiet->value));
    }
    std::stable_sort(seen.begin(), seen.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::vector<std::string>> rows;
    for (const auto& [far, words] : seen)
        if (rows.size() < most_rows) rows.push_back({words});
    return rows;
}

// of a search that did not end, and verified nothing by then
Section unverified_section(const DesignResults& results) {
    Section change{"What to change", {results.without_advice}};
    change.table.rows = seen_quiet(*results.advice);
    if (change.table.rows.empty()) return change;
    change.table.columns = {"seen to be quiet with this alone, not verified"};
    change.paragraphs.emplace_back(
        "The nearest that was seen by then: each was quiet both ways in one run; its neighbours were not tried.");
    return change;
}

Section noisy_section(const Advice& advice) {
    Section change{"What to change"};
    if (advice.changes.empty()) {
        change.paragraphs.emplace_back("No change within the ranges that were looked at was verified to be quiet.");
        return change;
    }
    const std::size_t best = advice.recommended.value_or(0);
    change.table.columns = {"", "change"};
    change.table.rows.push_back({"advised", steps_words(advice.space, advice.changes[best])});
    for (std::size_t k = 0; k < advice.changes.size() && change.table.rows.size() < most_rows; ++k)
        if (k != best) change.table.rows.push_back({"or", steps_words(advice.space, advice.changes[k])});
    change.paragraphs.push_back(fmt::format(
        "All were run and are quiet, the advised one by {} runs: {}, with 1 % more and less of each value.{}{}",
        advice.changes[best].runs, judged_words(advice.space),
        change.table.rows.size() < advice.changes.size() ? " The smallest are shown; all stand further back." : "",
        advice.stopped_in == advice::AdviceStage::changes ? " Changes of several values were not found in this time."
                                                          : ""));
    if (advice.changed)
        change.paragraphs.push_back("The advised design is " + advice::changed_words(*advice.changed) + ".");
    return change;
}

// "contact.preload 6 +- 1.2 N"
std::string tolerance_words(const std::vector<advice::Tolerance>& tolerances) {
    std::vector<std::string> words;
    for (const advice::Tolerance& each : tolerances)
        words.push_back(fmt::format("{} {:.4g} \u00b1 {}", advice::quantity_words(each.key), each.value,
                                    measured(each.key, each.tolerance)));
    return base::listed(words);
}

// what is no noise and no silence either
std::string open_words(const advice::Chance& chance) {
    const double open = 100.0 * (chance.not_quiet.share - chance.noise.share);
    return open > 0.0 ? fmt::format(", and {:.2g} % undecided, locking or without a result", open) : "";
}

Section change_section(const DesignResults& results) {
    const Advice& advice = *results.advice;
    const bool is_quiet = advice::is_quiet(advice.present);
    if (!is_quiet && advice.stopped_in && advice.changes.empty()) return unverified_section(results);
    Section section = is_quiet ? quiet_section(advice) : noisy_section(advice);
    if (is_quiet && advice.stopped_in)
        section.paragraphs.push_back(
            fmt::format("The chance of noise was not found within {:g} s; `stridor advise` "
                        "takes its time.",
                        results.advice_time.value_or(PartTime(0.0)).count()));
    if (advice.chance)
        section.paragraphs.push_back(fmt::format(
            "Chance of noise: {:.2g} %{} ({:.2g} to {:.2g} %, 95 % confidence, {} designs), where parts lie anywhere "
            "within{} {}.",
            100.0 * advice.chance->noise.share, open_words(*advice.chance), 100.0 * advice.chance->noise.low,
            100.0 * advice.chance->noise.high, advice.chance->samples,
            advice.chance->is_default ? " these usual tolerances:" : "", tolerance_words(advice.chance->tolerances)));
    if (advice.chance && advice.chance->is_default && !advice::narrowed_frictions(advice.space.base).empty())
        section.paragraphs.push_back(
            "Friction is spread by less than usual there, since µd stays below µs: what more friction does is told "
            "above, and no part of the chance.");
    return section;
}

std::string kind_of_structure(const parameters::Case& c) {
    return parameters::names_of_springs(c).empty() ? "a linear structure" : "a structure with springs that stiffen";
}

std::string foot(const parameters::Case& c) {
    const bool has_several = parameters::contact_count(c) > 1;
    const std::string leaning = parameters::names_of_springs(c).empty() ? "" : " on springs that stiffen";
    const std::string model = !parameters::has_plate(c) ? kind_of_structure(c) + " with " +
                                                              (has_several ? "points" : "one point") + " of contact"
                              : has_several ? "joints" + leaning + " on one plate, one point of contact each"
                                            : "one joint" + leaning + ", one plate, one point of contact";
    return "A category names a pattern of vibration of a " + std::string(parameters::has_plate(c) ? "small " : "") +
           "model (" + model +
           "), not a sound pressure in a car. What the model does not hold, such as wear, temperature, " +
           (parameters::has_named_contacts(c) ? "" : "several contacts ") +
           "and the radiation of sound, is not in this verdict either.";
}

std::string sketch_caption(const parameters::Case& c) {
    if (!parameters::has_plate(c))
        return "The model: " + parameters::origin_of(c) + ", " + kind_of_structure(c) +
               " with its contacts, on a surface that moves under it.";
    return "The model: a joint, pressed on a plate that moves under it, held at an angle by springs and dampers.";
}

}  // namespace

Report first_page(const DesignResults& results) {
    const parameters::Case& c = results.design;
    Report page;
    page.title = c.title.empty() ? "Rubbing contact" : c.title;
    page.facts = facts(results);
    page.headline = headline(results);
    page.headline.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(page.headline.front())));
    page.badges = badges(results);
    for (const Verdict& verdict : results.verdicts)
        page.lead.push_back(plain_words(verdict));
    // several joints are wider than this place
    if (!parameters::has_several_joints(c)) {
        page.sketch = parameters::has_plate(c) ? sketch_svg(c) : structure_sketch_svg(c);
        page.sketch_caption = sketch_caption(c);
    }
    if (results.chart)
        page.first.push_back(chart_section(*results.chart, results.about_chart));
    else if (!results.about_chart.empty())
        page.first.push_back({"Where it is quiet", {results.about_chart}});
    if (results.advice)
        page.first.push_back(change_section(results));
    else if (!results.without_advice.empty())
        page.first.push_back({"What to change", {results.without_advice}});
    page.foot = foot(c);
    return page;
}

}  // namespace stridor::report
