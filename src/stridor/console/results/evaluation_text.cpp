#include "stridor/console/results/evaluation_text.hpp"

#include "stridor/console/results/text_table.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/hearing/heard_recordings.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace stridor::console {

namespace {

using classification::Category;
using classification::Confusion;
using hearing::Half;

constexpr std::array decided_categories{Category::none, Category::squeal, Category::squeak, Category::creak};

std::string percent(double share) {
    return number_or_dash(100.0 * share, "{:.1f} %");
}

std::string percent(std::size_t part, std::size_t whole) {
    return percent(static_cast<double>(part) / static_cast<double>(whole));
}

double agreement_of(const Confusion& table) {
    return classification::agreement(classification::decided(table));
}

std::string agreement_text(const Confusion& table) {
    const Confusion decided = classification::decided(table);
    std::size_t same = 0;
    for (std::size_t k = 0; k < decided.counts.size(); ++k)
        same += decided.counts[k][k];
    return fmt::format("{} ({} of {}), mean of the categories {}", percent(classification::agreement(decided)), same,
                       classification::total(decided), percent(classification::mean_agreement(decided)));
}

// a column for each category
void add_categories(TextTable& table, std::span<const std::string_view> names) {
    for (const std::string_view name : names)
        table.columns.push_back(right(name, 10));
}

void add_counts(TextTable& table, std::span<const std::size_t> counts) {
    for (const std::size_t count : counts)
        table.rows.back().push_back(std::to_string(count));
}

std::string confusion_text(const Confusion& table) {
    TextTable lines{{left("", 12)}, "  "};
    add_categories(lines, classification::category_names);
    lines.columns.push_back(right("agreement", 12));
    for (std::size_t truth = 0; truth < table.counts.size(); ++truth) {
        const auto category = static_cast<Category>(truth);
        add_row(lines, classification::name(category));
        add_counts(lines, table.counts[truth]);
        if (category != Category::undecided)
            lines.rows.back().push_back(percent(classification::agreement_on(table, category)));
    }
    return text_of(lines);
}

std::string cases_text(const std::vector<hearing::HeardCase>& cases) {
    TextTable table{{left("case", 8), left("part", 8), left("contact states", 16), left("by ear", 11), left("why", 1)},
                    "  "};
    for (const hearing::HeardCase& heard : cases) {
        add_row(table, heard.name, "whole", "", classification::name(heard.whole), heard.reason);
        for (std::size_t direction = 0; direction < heard.phases.size(); ++direction) {
            const hearing::HeardSound& sound = heard.phases[direction];
            add_row(table, "", parameters::direction_names[direction], classification::name(sound.cell.category),
                    classification::name(sound.heard), sound.reason);
        }
    }
    return "Table 1\n\n" + text_of(table) +
           "\nWhole: the second as it is heard, with its reversals; going, coming: those phases alone.\n";
}

// "creak heard as none 12, undecided 3; squeal heard as squeak 1"
std::string differences_text(const Confusion& table) {
    std::string text;
    for (const Category truth : decided_categories) {
        const auto& row = table.counts[static_cast<std::size_t>(truth)];
        std::string others;
        for (std::size_t heard = 0; heard < row.size(); ++heard)
            if (heard != static_cast<std::size_t>(truth) && row[heard] > 0)
                others += fmt::format("{} {} {}", others.empty() ? "" : ",", classification::category_names[heard],
                                      row[heard]);
        if (others.empty()) continue;
        text += fmt::format("{}{} heard as{}", text.empty() ? "" : "; ", classification::name(truth), others);
    }
    return text;
}

std::string chart_text(const io::HeardChart& chart) {
    const Confusion table = hearing::confusion(chart.sounds);
    std::string text = fmt::format("\n{}: {} sounds, agreement {}\n", chart.study.base.title, chart.sounds.size(),
                                   agreement_text(table));
    const std::string differences = differences_text(table);
    if (!differences.empty()) text += "  " + differences + "\n";
    const std::size_t open = classification::total(table) - classification::total(classification::decided(table));
    if (open > 0) text += fmt::format("  {} undecided by contact states\n", open);
    return text;
}

constexpr std::array set_titles{"charts of files", "the paper's planes", "soft parts"};  // by sweep::PlaneSet

// the table of each set, where there are several
std::string sets_text(const io::HearingReport& report) {
    const std::vector<sweep::PlaneSet> sets = io::sets_of(report);
    if (sets.size() < 2) return "";
    std::string text;
    for (const sweep::PlaneSet set : sets) {
        const Confusion table = io::confusion(report, set);
        text += fmt::format("\n{}: {} sounds\n\n{}\nagreement {}\n", set_titles[static_cast<std::size_t>(set)],
                            classification::total(table), confusion_text(table), agreement_text(table));
    }
    return text;
}

std::string charts_text(const io::HearingReport& report) {
    std::string text;
    std::size_t failed = 0;
    for (const io::HeardChart& chart : report.charts) {
        text += chart_text(chart);
        for (const hearing::HeardSound& sound : chart.sounds)
            failed += sound.cell.status == sweep::Status::done ? 0 : 1;
    }
    text += sets_text(report);
    const Confusion all = io::confusion(report);
    text += fmt::format("\n{} sounds; rows: by contact states, columns: by ear\n\n{}\n", classification::total(all),
                        confusion_text(all));
    text += "agreement " + agreement_text(all) + "\n";
    text += "  even cells " + agreement_text(io::confusion(report, Half::even)) + "\n";
    text += "  odd cells  " + agreement_text(io::confusion(report, Half::odd)) + "\n";
    const std::size_t open = classification::total(all) - classification::total(classification::decided(all));
    text += fmt::format(
        "Undecided by ear is a disagreement. {} sounds are undecided by contact states: nothing to agree with, left "
        "out.\n",
        open);
    if (failed > 0) text += fmt::format("{} cells have no motion and no sound.\n", failed);
    return text;
}

void add_perturbation(TextTable& table, std::string_view name, const Confusion& heard) {
    add_row(table, name, percent(agreement_of(heard)), percent(classification::mean_agreement(heard)));
    std::size_t undecided = 0;
    for (const Category category : decided_categories) {
        table.rows.back().push_back(percent(classification::agreement_on(heard, category)));
        undecided += heard.counts[static_cast<std::size_t>(category)].back();
    }
    table.rows.back().push_back(std::to_string(undecided));
}

std::string perturbed_text(const io::HearingReport& report) {
    const Confusion before = io::perturbed_confusion(report, std::nullopt);
    TextTable table{{left("", 20), right("all", 10), right("mean", 10)}, "  "};
    add_categories(table, std::span(classification::category_names).first(decided_categories.size()));
    table.columns.push_back(right("undecided", 11));
    add_perturbation(table, "unchanged", before);
    for (std::size_t k = 0; k < hearing::perturbations().size(); ++k)
        add_perturbation(table, hearing::perturbations()[k].name, io::perturbed_confusion(report, k));
    return fmt::format("\nEvery {}th run's sounds changed ({} sounds), agreement:\n\n", report.options.perturb_every,
                       classification::total(before)) +
           text_of(table);
}

std::string number_word(std::size_t number) {
    constexpr std::array words{"no",    "one",   "two",  "three", "four",   "five",  "six",
                               "seven", "eight", "nine", "ten",   "eleven", "twelve"};
    return number < words.size() ? words[number] : std::to_string(number);
}

std::string shares_text(const hearing::RecordingScore& score) {
    TextTable table{{left("", 42), right("right", 10), right("", 9), left("   95 %, bootstrap over sources", 1)}, "  "};
    for (const hearing::RightShare& share : score.shares)
        if (share.count > 0)
            add_row(table, share.what, fmt::format("{} of {}", share.right, share.count),
                    percent(share.right, share.count),
                    fmt::format("   {} to {}", percent(share.low), percent(share.high)));
    return "\n" + text_of(table);
}

std::string rows_text(const hearing::RecordingScore& score) {
    TextTable table{{left("expected; by ear:", 24)}, "  "};
    add_categories(table, classification::category_names);
    for (const hearing::HeardRow& row : score.rows) {
        add_row(table, row.expected);
        add_counts(table, row.heard);
    }
    return "\n" + text_of(table);
}

std::string probabilities_text(const hearing::RecordingScore& score, std::size_t count) {
    if (score.bins.empty()) return "";
    TextTable bins{{left("probability", 24), right("clips", 10), right("its mean", 10), right("right", 10)}, "  "};
    for (const hearing::CalibrationBin& bin : score.bins)
        add_row(bins, fmt::format("{:.1f} to {:.1f}", bin.from, bin.to), bin.count, percent(bin.probability),
                percent(bin.right, bin.count));
    TextTable decided{{left("decided from", 24), right("decided", 10), right("right", 10)}, "  "};
    for (const hearing::AbstentionPoint& point : score.decided)
        if (point.decided > 0)
            add_row(decided, fmt::format("{:.1f}", point.probability), percent(point.decided, count),
                    percent(point.right, point.decided));
    return "\n" + text_of(bins) + "\n" + text_of(decided);
}

std::string recordings_text(const std::vector<hearing::HeardRecording>& recordings) {
    TextTable table{{left("recording", 24), left("expected", 22), left("by ear", 11), left("", 7), left("why", 1)},
                    "  "};
    std::size_t agreeing = 0;
    for (const hearing::HeardRecording& recording : recordings) {
        const bool agrees = hearing::is_right(recording);
        const std::string name = std::filesystem::path(recording.expectation.file).filename().string();
        agreeing += agrees ? 1 : 0;
        add_row(table, name, recording.expectation.words, classification::name(recording.heard),
                agrees ? "right" : "wrong", recording.reason);
        table.columns.front().width = std::max(table.columns.front().width, width_of(name) + 2);
    }
    std::string text = text_of(table) + fmt::format("\n{} of {} as expected. ", agreeing, recordings.size());
    constexpr std::size_t few = 20;
    if (recordings.size() < few)
        return text + fmt::format("A smoke test: {} clips are no statistic.\n", number_word(recordings.size()));
    const hearing::RecordingScore score = hearing::score_of(recordings);
    return text + "\n" + shares_text(score) + rows_text(score) + probabilities_text(score, recordings.size());
}

}  // namespace

std::string evaluation_text(const io::HearingReport& report) {
    std::string text;
    if (!report.cases.empty()) text += cases_text(report.cases);
    if (!report.charts.empty()) text += charts_text(report);
    if (!report.charts.empty() && report.options.perturb_every > 0) text += perturbed_text(report);
    if (!report.recordings.empty()) text += (text.empty() ? "" : "\n") + recordings_text(report.recordings);
    return text;
}

std::string check_heading() {
    return fmt::format("  {:<46}{:>14}{:>14}{:>12}{:>10}\n", "", "expected", "computed", "difference", "tolerance");
}

std::string check_row(const verification::Check& check) {
    return fmt::format("  {:<46}{:>14.7g}{:>14.7g}{:>12.2e}{:>10.1e}  {}\n", check.name, check.expected, check.computed,
                       check.computed - check.expected, check.tolerance,
                       check.passes() ? "ok" : styled("FAILS", Style::red, STDOUT_FILENO));
}

}  // namespace stridor::console
