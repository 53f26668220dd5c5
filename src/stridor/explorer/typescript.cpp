#include "stridor/explorer/typescript.hpp"

#include "stridor/analysis/evidence.hpp"
#include "stridor/analysis/sliding_stability.hpp"
#include "stridor/base/check.hpp"
#include "stridor/classification/verdict.hpp"
#include "stridor/drawing/palette.hpp"
#include "stridor/drawing/text.hpp"
#include "stridor/integration/run/motion.hpp"
#include "stridor/io/simulation/json_simulation.hpp"
#include "stridor/model/contact_state.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/parameters/fields/contact_field.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/pictures/parts/category_colours.hpp"
#include "stridor/pictures/parts/chart_cells.hpp"
#include "stridor/record/schedule.hpp"
#include "stridor/sweep/cell.hpp"
#include "stridor/sweep/starts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace stridor::explorer {

namespace {

constexpr std::size_t widest = 120;  // columns of a line, as .prettierrc has it

using WordList = std::vector<std::string>;

template <class Range>
WordList words_of(const Range& names) {
    return {names.begin(), names.end()};
}

WordList without(WordList words, std::string_view word) {
    std::erase(words, word);
    return words;
}

std::string opening(std::string_view what, std::string_view name) {
    return fmt::format("/** {} Written by `stridor explore --typescript {}`, not by hand. */\n", what, name);
}

std::string quoted(const std::string& word) {
    return "\"" + word + "\"";
}

// `head` and the words in brackets: on one line where they fit, else below each other
std::string list(const std::string& head, const WordList& words, const std::string& tail) {
    std::string line = head + "[";
    for (const std::string& word : words)
        line += (&word == words.data() ? "" : ", ") + quoted(word);
    line += "]" + tail;
    if (line.size() <= widest) return line + "\n";
    std::string lines = head + "[\n";
    for (const std::string& word : words)
        lines += "  " + quoted(word) + ",\n";
    return lines + "]" + tail + "\n";
}

// a list of words and the type of one of them
std::string words_as_type(std::string_view sentence, const std::string& name, const std::string& type,
                          const WordList& words) {
    return fmt::format("\n/** {} */\n", sentence) + list("export const " + name + " = ", words, " as const;") +
           fmt::format("export type {} = (typeof {})[number];\n", type, name);
}

constexpr std::array texture_names{"plain", "dots", "rising", "falling", "crossed"};  // by drawing::Texture

std::string fill_lines() {
    const std::vector<drawing::Fill> fills = pictures::kind_fills();
    const std::vector<drawing::StyledText> names = pictures::kind_names();
    std::string lines;
    for (std::size_t k = 0; k < fills.size(); ++k) {
        const drawing::Fill& fill = fills[k];
        // a plain ground has no marks to be seen
        const drawing::Colour mark = fill.texture == drawing::Texture::none ? fill.colour : fill.ink;
        lines += fmt::format("  \"{}\": {{ ground: \"{}\", texture: \"{}\", mark: \"{}\" }},\n",
                             drawing::plain_text(names[k]), drawing::hex(fill.colour),
                             texture_names[static_cast<std::size_t>(fill.texture)], drawing::hex(mark));
    }
    return lines;
}

std::string palette() {
    std::string states;
    for (const model::ContactState state :
         {model::ContactState::slip, model::ContactState::stick, model::ContactState::separation})
        states +=
            fmt::format("{}{}: \"{}\"", states.empty() ? "" : ", ", model::contact_state_names[model::index_of(state)],
                        drawing::hex(pictures::state_colour(state)));
    WordList stops;
    for (const drawing::Colour stop : drawing::sequential_stops())
        stops.push_back(drawing::hex(stop));
    return opening("The colours of Stridor's figures.", "palette") +
           "\n/** The ground and the marks of each kind of cell; `failed` has no result. */\n"
           "export const kindFills = {\n" +
           fill_lines() +
           "} as const;\n"
           "\n/** Of each state of the contact. */\n"
           "export const stateColours = { " +
           states +
           " } as const;\n"
           "\n/** The map of figures, from the lowest value to the highest, at equal distances. */\n" +
           list("export const sequentialStops = ", stops, " as const;");
}

// what the numbers of a chart's frame stand for (see answers_chart.cpp)
WordList chart_kinds() {
    WordList kinds = words_of(classification::category_names);
    for (const classification::Quiet quiet : {classification::Quiet::sticks, classification::Quiet::locks}) {
        const sweep::CellVerdict cell{sweep::Status::done, classification::Category::none, quiet};
        kinds.push_back(drawing::plain_text(pictures::kind_names()[pictures::kind_of(cell)]));
    }
    return kinds;
}

// whose velocity is one for ever, and has a sign
WordList steady_drives() {
    WordList names;
    for (std::size_t kind = 0; kind < parameters::drive_names.size(); ++kind) {
        parameters::Drive drive;
        drive.kind = static_cast<parameters::DriveKind>(kind);
        if (parameters::is_steady(drive)) names.emplace_back(parameters::drive_names[kind]);
    }
    return names;
}

WordList figure_names() {
    WordList names;
    for (const sweep::CellFigure& figure : sweep::cell_figures())
        names.emplace_back(figure.name);
    return names;
}

// a type for each record of documents that the program describes
std::string record_types() {
    std::string lines;
    for (const io::DescribedRecord& record : io::simulation_records()) {
        lines += fmt::format("\n/** {} */\nexport interface {} {{\n", record.sentence, record.name);
        for (const io::DescribedMember& member : record.members) {
            const std::string unit = member.unit.empty() ? "" : fmt::format(" [{}]", member.unit);
            lines += fmt::format("  /** {}{} */\n  {}: {};\n", member.sentence, unit, member.key, member.type);
        }
        lines += "}\n";
    }
    return lines;
}

// what an evidence has no number for before anything was judged is null in documents
bool is_always_there(const analysis::EvidenceFigure& figure) {
    analysis::Evidence nothing;
    const double none = analysis::Alternation::unknown;
    nothing.levels = {{none, none, none, none}, {none, none, none, none}};
    return std::isfinite(figure.value(nothing));
}

// the figures of a verdict, each where its key says: "levels.joint.rms" in an object in an object
std::string figures_type() {
    std::string lines = "\n/** The figures of a verdict. */\nexport interface VerdictFigures {\n";
    WordList place;  // the objects that are open
    const auto indent = [&] { return std::string(2 * (place.size() + 1), ' '); };
    for (const analysis::EvidenceFigure& figure : analysis::evidence_figures()) {
        WordList path;  // of the objects that hold it
        std::string_view key = figure.key;
        for (std::size_t dot = key.find('.'); dot != std::string_view::npos; dot = key.find('.')) {
            path.emplace_back(key.substr(0, dot));
            key.remove_prefix(dot + 1);
        }
        const auto shared = static_cast<std::size_t>(
            std::mismatch(place.begin(), place.end(), path.begin(), path.end()).first - place.begin());
        for (; place.size() > shared; lines += indent() + "};\n")
            place.pop_back();
        for (; place.size() < path.size(); place.push_back(path[place.size()]))
            lines += fmt::format("{}{}: {{\n", indent(), path[place.size()]);
        const bool is_count = figure.holds == analysis::EvidenceFigure::Holds::count;
        lines += fmt::format("{0}/** {1}{2} */\n{0}{3}: number{4};\n", indent(), figure.sentence,
                             is_count ? "" : fmt::format(" [{}]", figure.unit), key,
                             is_always_there(figure) ? "" : " | null");
    }
    for (; !place.empty(); lines += indent() + "};\n")
        place.pop_back();
    return lines + "}\n";
}

// what case documents show of a contact of [structure]; what the case says for all, and numbers, are always there
std::string contact_type() {
    std::string lines =
        "\n/** A contact of a structure of the user's own, as [structure] lists it. */\n"
        "export interface OwnContact {\n";
    for (const parameters::ContactField& field : parameters::contact_fields()) {
        if (!parameters::is_shown(field)) continue;
        const bool is_share = field.key == "preload_share";
        const bool is_number = std::holds_alternative<double parameters::OwnContact::*>(field.member);
        const bool is_list =
            std::holds_alternative<std::optional<std::array<double, 3>> parameters::OwnContact::*>(field.member);
        const bool is_always_there = field.key == "name" || field.in_place_of != nullptr || (is_number && !is_share);
        const std::string unit = is_share ? " [N]" : field.unit.empty() ? "" : fmt::format(" [{}]", field.unit);
        lines += fmt::format("  /** {}{} */\n  {}{}: {};\n",
                             is_share ? "preload; none of one that a load or a negative gap presses" : field.sentence,
                             unit, is_share ? "preload" : field.key, is_always_there ? "" : "?",
                             is_list              ? "number[]"
                             : field.unit.empty() ? "string"
                                                  : "number");
    }
    return lines +
           "  /** How far along the line of contacts that is [m], where all are known and differ. */\n"
           "  along_line?: number;\n}\n";
}

std::string words() {
    return opening("The words of answers and requests.", "words") +
           words_as_type("The way the plate moves.", "directions", "Direction", words_of(parameters::direction_names)) +
           words_as_type("The kinds of drive whose velocity is one for ever, and has a sign.", "steadyDrives",
                         "SteadyDrive", steady_drives()) +
           words_as_type("What of a run a verdict is about.", "phases", "Phase", words_of(record::phase_names)) +
           words_as_type("How the values of an axis are spaced.", "scales", "Scale",
                         words_of(parameters::scale_names)) +
           words_as_type("What the contact does.", "contactStates", "ContactState",
                         words_of(model::contact_state_names)) +
           words_as_type("What is heard.", "categories", "Category", words_of(classification::category_names)) +
           words_as_type(
               "Why nothing is heard.", "quietReasons", "QuietReason",
               without(words_of(classification::quiet_names), classification::name(classification::Quiet::no))) +
           words_as_type("What each number in a chart's frame stands for; 255: no result.", "chartKinds", "ChartKind",
                         chart_kinds()) +
           words_as_type("A category, or why there is none.", "verdictWords", "VerdictWord",
                         words_of(sweep::verdict_words)) +
           words_as_type("How a run ended.", "endings", "Ending", words_of(integration::reason_names)) +
           words_as_type("How steady sliding answers to a small push.", "stabilityKinds", "StabilityKind",
                         words_of(analysis::stability_names)) +
           words_as_type("What is known of a cell in numbers.", "figureNames", "FigureName", figure_names()) +
           contact_type() + record_types() + figures_type();
}

}  // namespace

std::string typescript(std::string_view name) {
    STRIDOR_EXPECT(std::find(typescript_names.begin(), typescript_names.end(), name) != typescript_names.end());
    return name == "palette" ? palette() : words();
}

}  // namespace stridor::explorer
