#include "stridor/report/design_report.hpp"

#include "stridor/base/json.hpp"
#include "stridor/base/text.hpp"
#include "stridor/classification/interface_rules.hpp"
#include "stridor/drawing/picture.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/pictures/many_contacts.hpp"
#include "stridor/pictures/picture_files.hpp"
#include "stridor/pictures/stability.hpp"
#include "stridor/pictures/time_history.hpp"
#include "stridor/report/first_page.hpp"
#include "stridor/report/sketch.hpp"
#include "stridor/report/verdict_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

namespace stridor::report {

namespace {

using classification::Verdict;

std::string number_or_dash(double value, const char* format) {
    return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : std::string("-");
}

Section verdict_section(const DesignResults& results) {
    Section section{"The verdict in figures"};
    section.table.columns = {
        "direction",  "category",   "slip",      "stick",
        "separation", "regularity", "frequency", std::string(analysis::level_title(results.design))};
    for (const Verdict& verdict : results.verdicts) {
        const analysis::Evidence& e = verdict.evidence;
        section.table.rows.push_back(
            {phase_name(verdict), std::string(classification::word(verdict)),
             number_or_dash(100.0 * e.rates.slip, "{:.1f} %"), number_or_dash(100.0 * e.rates.stick, "{:.1f} %"),
             number_or_dash(100.0 * e.rates.separation, "{:.1f} %"), number_or_dash(e.alternation.regularity, "{:.3f}"),
             number_or_dash(e.alternation.frequency, "{:.1f} Hz"),
             number_or_dash(e.levels.joint.decibels, "{:.1f} dB")});
        std::string why = "Why " + phase_name(verdict) + ": ";
        for (std::size_t k = 0; k < verdict.reasons.size(); ++k)
            why += (k > 0 ? "; " : "") + verdict.reasons[k];
        section.paragraphs.push_back(why + ".");
        for (const std::string& warning : verdict.warnings)
            section.paragraphs.push_back("Warning: " + warning + ".");
    }
    section.paragraphs.push_back("Judged by the noisiest of its runs: " + judged_words(results.standing.space) + ".");
    section.paragraphs.emplace_back("The shares in the table are of the whole window, reversals included. " +
                                    std::string(analysis::level_note(results.design)));
    return section;
}

// what was counted in each phase of the design, by the phase's name
std::vector<std::pair<std::string, const record::Tally*>> tallies_of(const DesignResults& results) {
    std::vector<std::pair<std::string, const record::Tally*>> all;
    for (const DesignMotion& motion : results.motions)
        for (const record::Phase phase : motion.phases)
            for (const record::Tally& tally : motion.motion.record.phases)
                if (tally.phase == phase || tally.phase == record::Phase::all)
                    all.emplace_back(record::phase_names[static_cast<std::size_t>(phase)], &tally);
    return all;
}

// the contacts of highest level that a table has room for, in their order
std::vector<std::size_t> loudest(const record::Tally& phase, std::size_t contacts) {
    constexpr std::size_t most = 16;  // [1] rows of a phase
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t k = 0; k < contacts; ++k)
        order.emplace_back(-analysis::evidence(phase, k).levels.joint.decibels, k);
    std::stable_sort(order.begin(), order.end());
    std::vector<std::size_t> shown;
    for (std::size_t k = 0; k < std::min(most, contacts); ++k)
        shown.push_back(order[k].second);
    std::sort(shown.begin(), shown.end());
    return shown;
}

// of several contacts each by itself, in each phase
Section contacts_section(const DesignResults& results) {
    const parameters::Case& c = results.design;
    Section section{"Each contact"};
    section.table.columns = {"contact",    "direction", "category", "slip",      "stick",
                             "separation", "level",     "preload",  "mu_d, mu_s"};
    for (const auto& [name, tally] : tallies_of(results)) {
        const record::Tally& phase = *tally;
        const classification::PhaseVerdicts all =
            classification::classify_all(phase, c.verdict, classification::contact_names(c));
        const std::vector<std::size_t> shown = loudest(phase, all.contacts.size());
        if (shown.size() < all.contacts.size())
            section.paragraphs.push_back(
                fmt::format("Shown of {} are the {} contacts of highest level, {}; `stridor "
                            "simulate` prints all.",
                            all.contacts.size(), shown.size(), name));
        for (const std::size_t k : shown) {
            const analysis::Evidence e = analysis::evidence(phase, k);
            const parameters::Contact laws = parameters::contact_of(c, k);
            section.table.rows.push_back(
                {parameters::contact_name(c, k), name,
                 all.contacts[k] ? std::string(classification::word(*all.contacts[k])) : "unloaded",
                 number_or_dash(100.0 * e.rates.slip, "{:.1f} %"), number_or_dash(100.0 * e.rates.stick, "{:.1f} %"),
                 number_or_dash(100.0 * e.rates.separation, "{:.1f} %"),
                 number_or_dash(e.levels.joint.decibels, "{:.1f} dB"), fmt::format("{:.4g} N", laws.preload),
                 fmt::format("{:g}, {:g}", laws.kinetic_friction, laws.static_friction)});
        }
        for (const classification::InterfaceVerdict& interface : all.interfaces)
            section.paragraphs.push_back(fmt::format(
                "Of {} contacts as a whole contact {} leads, {}, with most friction power of the noisy ones.{}",
                interface.figures.contacts.size(), parameters::contact_name(c, interface.whole.evidence.contact), name,
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

// where the ear says otherwise than the motion: both side by side, why both stand, and which counts
void put_ear_beside(Section& section, const DesignResults& results) {
    for (const DesignSound& sound : results.sounds)
        for (const Verdict& verdict : results.verdicts) {
            const std::string_view way = parameters::direction_names[static_cast<std::size_t>(sound.direction)];
            if (phase_name(verdict) != way || sound.wav.empty() || sound.heard.category == verdict.category) continue;
            section.table.rows.push_back({std::string(way),
                                          std::string(classification::word(verdict)) + ": " + verdict.reasons.back(),
                                          heard_words(sound)});
        }
    if (section.table.rows.empty()) return;
    section.table.columns = {"direction", "by the motion: this counts", "by ear"};
    section.paragraphs.push_back(fmt::format(
        "Motion and ear differ here, and both stand. The motion is judged by when the contacts change between slip, "
        "stick and separation, wherever one listens. The ear hears one point ({}) and judges its tones and jerks: a "
        "strong jerk in each period sounds like a creak, however steady the period is. The motion's verdict counts: "
        "headline, chart and advice rest on it. The ear's tells what a vibration sensor at that point would hear.",
        results.heard));
}

Section sound_section(const DesignResults& results) {
    Section section{"What it sounds like"};
    const bool is_of_contact = !parameters::has_plate(results.design) && !results.heard.empty() &&
                               std::isdigit(static_cast<unsigned char>(results.heard.front())) != 0;
    section.paragraphs.push_back("The motion made audible: " + std::string(is_of_contact ? "contact " : "") +
                                 results.heard +
                                 ". Each sound is as loud as its file allows, whatever its level; the part itself "
                                 "radiates in its own way.");
    for (const DesignSound& sound : results.sounds) {
        const std::string label(parameters::direction_names[static_cast<std::size_t>(sound.direction)]);
        if (sound.wav.empty())
            section.paragraphs.push_back(label + ": " + heard_words(sound));
        else
            section.sounds.push_back({label, heard_words(sound), sound.wav});
    }
    put_ear_beside(section, results);
    return section;
}

// a picture without what stands elsewhere: its title, and in its first paragraph the case
std::string svg_of(drawing::Scene scene) {
    scene.title = {};
    if (!scene.caption.empty()) scene.caption.erase(scene.caption.begin());
    return drawing::render(scene, drawing::Format::svg);
}

// "Motion while coming"
std::string motion_heading(const DesignResults& results, const DesignMotion& motion) {
    if (results.motions.size() == 1) return "Motion";
    return "Motion while " + std::string(record::phase_names[static_cast<std::size_t>(motion.phases.front())]);
}

Section motion_section(const DesignResults& results, const DesignMotion& shown) {
    constexpr double half_a_sheet = 170.0;  // [mm]
    const record::Record& kept = shown.motion.record;
    const bool shows_many = pictures::shows_many_contacts(results.design);
    pictures::TimeHistoryOptions options;
    constexpr double zoom = 0.02;  // [s]
    if (!shows_many) options.zoom = pictures::busiest_stretch(shown.of, kept.histories, zoom);
    const drawing::Scene scene =
        shows_many ? pictures::motion_scene(shown.of, kept, "") : pictures::time_history(shown.of, kept, options);
    Section section{
        motion_heading(results, shown),
        {},
        svg_of(scene),
        shows_many
            ? "Shares of the contact states and mean normal forces of all contacts, and their states over time."
            : "Imposed velocity, accelerations and contact states over time, and a short stretch of them beside."};
    section.fills_sheet = scene.height > half_a_sheet;
    return section;
}

Section stability_section(const analysis::StabilityScan& scan) {
    return {"Stability of steady sliding",
            {},
            svg_of(pictures::stability(scan)),
            "Frequencies and growth rates of the sliding modes over " + scan.key + "."};
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
    constexpr double never = 2.0;  // [1] beyond the range
    std::vector<std::pair<double, std::size_t>> order;
    for (const advice::ParameterMargin& margin : advice.margins) {
        const advice::VerdictChange* change = advice::nearest_change(advice.space, margin);
        order.emplace_back(change == nullptr ? never : std::abs(change->share - advice.space.origin[margin.parameter]),
                           margin.parameter);
    }
    std::sort(order.begin(), order.end());
    HtmlTable table{{"parameter", "now", "looked at", "changes below", "changes above"}, {}};
    for (const auto& [far, parameter] : order) {
        const advice::ParameterMargin& margin = advice.margins[parameter];
        const std::string& key = advice.space.parameters[parameter].key;
        const auto words = [&](const advice::ScanSide& side) {
            if (!side.change) return std::string(side.last == margin.value ? "not looked at" : "no change");
            return measured(key, side.change->value) + " (" +
                   std::string(sweep::word(advice::overall(side.change->beyond))) + ")";
        };
        table.rows.push_back({key, measured(key, margin.value),
                              fmt::format("{:.4g} to {}", margin.below.last, measured(key, margin.above.last)),
                              words(margin.below), words(margin.above)});
    }
    return table;
}

std::vector<Section> advice_sections(const advice::Advice& advice) {
    Section margins{"How far it is from another verdict"};
    margins.table = margin_table(advice);
    margins.paragraphs.emplace_back("Each quantity alone, the nearest change first. The worst direction is named. " +
                                    advice::scan_words());
    if (advice.changes.empty()) return {std::move(margins)};
    Section changes{"All changes that make it quiet"};
    changes.paragraphs.emplace_back(
        "Smallest first. The distance is the share of its range that a quantity has to go.");
    changes.table.columns = {"distance", "change", "verified by"};
    for (const advice::DesignChange& each : advice.changes)
        changes.table.rows.push_back({fmt::format("{:.3f}", each.distance), change_words(advice.space, each),
                                      fmt::format("{} quiet runs", each.runs)});
    return {std::move(margins), std::move(changes)};
}

// each value with what it is; matrices are for programs, and stand in what is saved
Section file_section(const DesignResults& results) {
    const parameters::Case& c = results.design;
    constexpr std::size_t longest = 1'000'000;  // [byte]
    Section section{"The case"};
    std::string about;
    if (!results.author.empty() || !results.part.empty())
        about = fmt::format("\n[document]\nauthor = {}\npart = {}\n", base::Json(results.author).dump(),
                            base::Json(results.part).dump());
    section.code = results.command;
    section.file = {"case.toml", io::case_toml(c, {io::Comments::beside, {}}) + about,
                    io::case_toml(c, {io::Comments::none, {}}) + about};
    section.paragraphs.emplace_back("Everything above follows from these values, by this command:");
    if (section.file.saved.size() > longest) {
        section.file.saved = section.file.text;
        section.paragraphs.emplace_back("Its matrices are too large to be saved from here.");
    } else if (parameters::has_given_structure(c)) {
        section.paragraphs.emplace_back("The file that can be saved from the HTML report holds its matrices, too.");
    }
    return section;
}

Section sketch_section(const parameters::Case& c) {
    return {"The model",
            {},
            sketch_svg(c),
            "Joints, pressed on one plate that moves under them, held at angles by springs and dampers."};
}

// pictures of the motion, and of its stability
std::vector<Section> picture_sections(const DesignResults& results) {
    std::vector<Section> sections;
    for (const DesignMotion& motion : results.motions) {
        const bool is_kept = !motion.motion.record.trace.time.empty() || pictures::shows_many_contacts(results.design);
        if (is_kept) sections.push_back(motion_section(results, motion));
    }
    if (results.stability && !results.stability->key.empty()) sections.push_back(stability_section(*results.stability));
    if (!results.without_stability.empty())
        sections.push_back({"Stability of steady sliding", {results.without_stability}});
    return sections;
}

std::vector<Section> figure_sections(const DesignResults& results) {
    std::vector<Section> sections{verdict_section(results)};
    if (parameters::contact_count(results.design) > 1) sections.push_back(contacts_section(results));
    if (results.advice)
        for (Section& section : advice_sections(*results.advice))
            sections.push_back(std::move(section));
    return sections;
}

}  // namespace

Report design_report(const DesignResults& results) {
    Report report = first_page(results);
    std::vector<Section>& sections = report.sections;
    if (parameters::has_several_joints(results.design)) sections.push_back(sketch_section(results.design));
    if (!results.sounds.empty())
        sections.push_back(sound_section(results));
    else if (!results.without_sound.empty())
        sections.push_back({"What it sounds like", {results.without_sound}});
    // pictures as tall as a sheet stand behind what fills the sheet before
    std::vector<std::vector<Section>> parts{picture_sections(results), figure_sections(results)};
    if (!parts.front().empty() && parts.front().front().fills_sheet) std::swap(parts.front(), parts.back());
    for (std::vector<Section>& part : parts)
        for (Section& section : part)
            sections.push_back(std::move(section));
    sections.push_back(file_section(results));
    return report;
}

}  // namespace stridor::report
