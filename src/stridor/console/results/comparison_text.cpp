#include "stridor/console/results/comparison_text.hpp"

#include "stridor/console/results/text_table.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/sweep/cell_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace stridor::console {

namespace {

using classification::ComparedFigure;
using classification::ComparedSound;

constexpr std::size_t least_width = 12;  // [1] letters of a column
constexpr std::size_t most_width = 30;

// what is too long loses its middle, which says least of a path or a cell
std::string shortened(const std::string& text, std::size_t width) {
    if (width_of(text) <= width) return text;
    const auto cut = [](std::string part) {
        while (!part.empty() && (static_cast<unsigned char>(part.front()) & 0xC0U) == 0x80U)
            part.erase(0, 1);
        return part;
    };
    std::size_t head = width / 2 - 1;
    while (head > 0 && (static_cast<unsigned char>(text[head]) & 0xC0U) == 0x80U)
        --head;
    return text.substr(0, head) + "..." + cut(text.substr(text.size() - (width - width / 2 - 2)));
}

// columns as wide as what stands in them, within limits
std::string columns_text(TextTable table) {
    for (std::size_t k = 1; k < table.columns.size(); ++k) {
        std::size_t width = least_width;
        for (const std::vector<std::string>& row : table.rows)
            width = std::clamp(width_of(row[k]), width, most_width);
        for (std::vector<std::string>& row : table.rows)
            row[k] = shortened(row[k], width);
        table.columns[k].width = 2 + width;
    }
    return text_of(table);
}

std::string distance_text(const ComparedSound& first, const ComparedSound& other) {
    if (is_silent(first.profile) || is_silent(other.profile)) return "-";
    return fmt::format("{:.2f}", classification::likeness(first.profile, other.profile).distance);
}

// those that tell two sounds apart most, each in its words
template <typename Words>
std::string differences(const classification::Likeness& likeness, const Words& words) {
    std::string text;
    for (const classification::FigureDifference& each :
         std::span(likeness.differences).first(std::min<std::size_t>(3, likeness.differences.size()))) {
        std::string name(each.name);
        std::replace(name.begin(), name.end(), '_', ' ');
        if (each.share >= 0.1) text += (text.empty() ? "" : ", ") + words(name, each);
    }
    return text;
}

// "dominant frequency (62 %)"
std::string reasons_text(const ComparedSound& first, const ComparedSound& other) {
    return differences(classification::likeness(first.profile, other.profile),
                       [](const std::string& name, const classification::FigureDifference& each) {
                           return fmt::format("{} ({:.0f} %)", name, 100.0 * each.share);
                       });
}

// "squeal (going), none (coming)"; "-" where it is not known
std::string contact_words(const classification::KnownContact& contact) {
    if (contact.verdicts.empty()) return "-";
    std::string text;
    for (const classification::Verdict& verdict : contact.verdicts) {
        text += (text.empty() ? "" : ", ") + std::string(classification::name(verdict.category));
        if (verdict.evidence.phase != record::Phase::all)
            text += fmt::format(" ({})", record::phase_names[static_cast<std::size_t>(verdict.evidence.phase)]);
    }
    return text;
}

// "dominant frequency 425 -> 431 Hz"
std::string differences_text(const classification::Likeness& likeness) {
    const std::string text =
        differences(likeness, [](const std::string& name, const classification::FigureDifference& each) {
            return fmt::format("{} {:.3g} -> {:.3g}{}", name, each.first, each.second, after_number(each.unit));
        });
    return text.empty() ? "nothing" : text;
}

std::string search_words(const io::MatchReport& report) {
    const hearing::SoundSearchResult& result = report.result;
    std::string text = fmt::format("listened to {} of {} cells", result.heard, sweep::cell_count(report.study));
    if (result.ruled_out > 0) text += fmt::format("; {} ruled out by the store", result.ruled_out);
    if (result.without_result > 0) text += fmt::format("; {} without a result", result.without_result);
    return text + "\n";
}

}  // namespace

std::string comparison_text(std::span<const ComparedSound> sounds) {
    TextTable table{{left("")}};
    table.columns.resize(sounds.size() + 1);
    const auto add = [&](std::string head, const auto& cell) {
        table.rows.push_back({std::move(head)});
        for (const ComparedSound& sound : sounds)
            table.rows.back().push_back(cell(sound));
    };
    add("", [](const ComparedSound& s) { return s.label; });
    add("from", [](const ComparedSound& s) { return s.origin; });
    add("rate", [](const ComparedSound& s) { return fmt::format("{:g} Hz", s.rate); });
    add("duration", [](const ComparedSound& s) { return fmt::format("{:.4g} s", s.length); });
    add("category by ear", [](const ComparedSound& s) { return std::string(classification::name(s.heard.category)); });
    add("category by contact states", [](const ComparedSound& s) { return contact_words(s.contact); });
    for (const ComparedFigure& figure : classification::compared_figures()) {
        const auto is_known = [&](const ComparedSound& s) { return figure_text(figure, s) != "-"; };
        if (std::none_of(sounds.begin(), sounds.end(), is_known)) continue;
        add(std::string(figure.words), [&](const ComparedSound& s) { return figure_text(figure, s); });
        if (figure.name == "level")
            add("  reference", [](const ComparedSound& s) { return signal::level_unit(s.analysis.unit).substr(3); });
    }
    add("distance from the first", [&](const ComparedSound& s) { return distance_text(sounds.front(), s); });
    std::string text = columns_text(std::move(table));
    for (std::size_t k = 1; k < sounds.size(); ++k)
        if (const std::string reasons = reasons_text(sounds.front(), sounds[k]); !reasons.empty())
            text += fmt::format("{}{} differs from {} by {}\n", k == 1 ? "\n" : "", sounds[k].label,
                                sounds.front().label, reasons);
    return text;
}

std::string match_name(const sweep::Study& study, const hearing::SoundMatch& match) {
    const sweep::CellPlace place = sweep::place_of(study, match.cell.index);
    const auto direction = static_cast<std::size_t>(study.directions[place.direction]);
    return sweep::cell_name(study, place) + ",direction=" + std::string(parameters::direction_names[direction]);
}

std::string match_text(const io::MatchReport& report) {
    const sweep::Study& study = report.study;
    std::string text = fmt::format("{}: {} by ear\n{}: x is {}, y is {}; {}\n{}\n", report.recording.name,
                                   classification::name(report.recording.heard.category), report.chart,
                                   study.x.parameter, study.y.parameter, report.motion, search_words(report));
    TextTable table{{right("", 3), right("distance", 10), left("  by ear", 11), left("contact", 9), left("cell", 40),
                     left("  what differs", 1)}};
    for (std::size_t k = 0; k < report.result.best.size(); ++k) {
        const hearing::SoundMatch& match = report.result.best[k];
        add_row(table, k + 1, fmt::format("{:.3f}", match.likeness.distance),
                fmt::format("  {}", classification::name(match.cell.heard)), classification::name(match.cell.contact),
                match_name(study, match), "  " + differences_text(match.likeness));
    }
    return text + text_of(table);
}

}  // namespace stridor::console
