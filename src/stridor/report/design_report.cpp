#include "stridor/report/design_report.hpp"

#include "stridor/base/version.hpp"
#include "stridor/classification/interface_rules.hpp"
#include "stridor/drawing/palette.hpp"
#include "stridor/drawing/picture.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/parameters/case_key.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/pictures/many_contacts.hpp"
#include "stridor/pictures/noise_chart.hpp"
#include "stridor/pictures/parts/category_colours.hpp"
#include "stridor/pictures/parts/design_mark.hpp"
#include "stridor/pictures/picture_files.hpp"
#include "stridor/pictures/stability.hpp"
#include "stridor/pictures/time_history.hpp"
#include "stridor/report/sketch.hpp"
#include "stridor/report/structure_sketch.hpp"
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
    const bool is_own = results.design.own_structure != nullptr;
    Section section{"Verdict"};
    section.table.columns = {"direction",  "category",   "slip",      "stick",
                             "separation", "regularity", "frequency", is_own ? "level" : "joint level"};
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
                                    std::string(is_own ? analysis::contact_level_note : analysis::level_note));
    return section;
}

// the friction that a contact rubs with, and what presses it
parameters::Contact laws_of(const parameters::Case& c, std::size_t contact) {
    return c.own_structure ? parameters::contact_of(c, contact) : parameters::alone(c, contact).contact;
}

// of several contacts each by itself, in each phase
Section contacts_section(const DesignResults& results) {
    const parameters::Case& c = results.design;
    Section section{"Each contact"};
    section.table.columns = {"contact",    "direction", "category", "slip",      "stick",
                             "separation", "level",     "preload",  "mu_d, mu_s"};
    for (const record::Tally& phase : results.motion.record.phases) {
        const classification::PhaseVerdicts all = classification::classify_all(phase, c.verdict);
        for (std::size_t k = 0; k < all.contacts.size(); ++k) {
            const analysis::Evidence e = analysis::evidence(phase, k);
            const parameters::Contact laws = laws_of(c, k);
            section.table.rows.push_back(
                {parameters::contact_name(c, k),
                 std::string(record::phase_names[static_cast<std::size_t>(phase.phase)]),
                 all.contacts[k] ? std::string(classification::name(all.contacts[k]->category)) : "unloaded",
                 number_or_dash(100.0 * e.rates.slip, "{:.1f} %"), number_or_dash(100.0 * e.rates.stick, "{:.1f} %"),
                 number_or_dash(100.0 * e.rates.separation, "{:.1f} %"),
                 number_or_dash(e.levels.joint.decibels, "{:.1f} dB"), fmt::format("{:.4g} N", laws.preload),
                 fmt::format("{:g}, {:g}", laws.kinetic_friction, laws.static_friction)});
        }
        for (const classification::InterfaceVerdict& interface : all.interfaces)
            section.paragraphs.push_back(fmt::format(
                "Of {} contacts as a whole {} leads, with most friction power of the noisy ones.{}",
                interface.figures.contacts.size(), parameters::contact_name(c, interface.whole.evidence.contact),
                interface.differs ? " The contacts differ." : ""));
    }
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

Section sound_section(const DesignResults& results) {
    Section section{"What it sounds like"};
    const bool has_several = parameters::contact_count(results.design) > 1 || results.design.own_structure;
    section.paragraphs.emplace_back(
        (has_several ? "The motion made audible: " + results.heard + ". "
                     : std::string("The motion of the joint along the plate, made audible. ")) +
        "Each sound is as loud as its file allows, whatever its level; the part itself radiates in its own way.");
    for (const DesignSound& sound : results.sounds) {
        const std::string label(parameters::direction_names[static_cast<std::size_t>(sound.direction)]);
        if (sound.wav.empty())
            section.paragraphs.push_back(label + ": " + heard_words(sound));
        else
            section.sounds.push_back({label, heard_words(sound), sound.wav});
    }
    return section;
}

Section motion_section(const DesignResults& results) {
    if (pictures::shows_many_contacts(results.design))
        return {
            "Motion",
            {},
            drawing::render(pictures::motion_scene(results.design, results.motion.record, ""), drawing::Format::svg),
            "Shares of the contact states and mean normal forces of all contacts, and their states over time."};
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

// everything follows from its values; matrices of a large structure stay where they are
Section file_section(const parameters::Case& c) {
    constexpr std::size_t longest = 1'000'000;  // [byte]
    Section section{"The case as a file"};
    std::string text = io::case_toml(c, {io::Comments::none, {}});
    if (text.size() > longest) {
        section.paragraphs.push_back(
            fmt::format("Its matrices are too large to stand here: {}, structure.content = {}.",
                        c.own_structure->origin, parameters::content_hash(*c.own_structure)));
        return section;
    }
    section.paragraphs.emplace_back("Everything above follows from these values.");
    section.file = {"case.toml", std::move(text)};
    return section;
}

std::string sketch_caption(const parameters::Case& c) {
    if (c.own_structure)
        return "The model: " + c.own_structure->origin +
               ", a linear structure with its contacts, on a surface that moves under it.";
    if (!c.further_joints.empty())
        return "The model: joints, pressed on one plate that moves under them, held at angles by springs and dampers.";
    return "The model: a joint, pressed on a plate that moves under it, held at an angle by springs and dampers.";
}

std::string foot(const parameters::Case& c) {
    const bool has_several = parameters::contact_count(c) > 1;
    const std::string model =
        c.own_structure ? "a linear structure with " + std::string(has_several ? "points" : "one point") + " of contact"
        : has_several   ? "joints on one plate, one point of contact each"
                        : "one joint, one plate, one point of contact";
    return "A category names a pattern of vibration of a " + std::string(c.own_structure ? "" : "small ") + "model (" +
           model + "), not a sound pressure in a car. What the model does not hold, such as wear, temperature, " +
           (has_several || c.own_structure ? "" : "several contacts ") +
           "and the radiation of sound, is not in this verdict either.";
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
    report.sketch = results.design.own_structure ? structure_sketch_svg(results.design) : sketch_svg(results.design);
    report.sketch_caption = sketch_caption(results.design);
    report.sections.push_back(verdict_section(results));
    if (parameters::contact_count(results.design) > 1) report.sections.push_back(contacts_section(results));
    if (!results.sounds.empty())
        report.sections.push_back(sound_section(results));
    else if (!results.without_sound.empty())
        report.sections.push_back({"What it sounds like", {results.without_sound}});
    if (results.chart) report.sections.push_back(chart_section(*results.chart));
    if (results.advice)
        for (Section& section : advice_sections(*results.advice))
            report.sections.push_back(std::move(section));
    else if (!results.without_advice.empty())
        report.sections.push_back({"What to change", {results.without_advice}});
    const bool has_motion = !results.motion.record.trace.time.empty() || pictures::shows_many_contacts(results.design);
    if (has_motion) report.sections.push_back(motion_section(results));
    if (results.stability && !results.stability->key.empty())
        report.sections.push_back(stability_section(*results.stability));
    report.sections.push_back(parameter_section(results.design));
    report.sections.push_back(file_section(results.design));
    report.sections.push_back(origin_section(results));
    report.foot = foot(results.design);
    return report;
}

}  // namespace stridor::report
