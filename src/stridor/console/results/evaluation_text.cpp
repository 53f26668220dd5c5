#include "stridor/console/results/evaluation_text.hpp"

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
    return std::isfinite(share) ? fmt::format("{:.1f} %", 100.0 * share) : "-";
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

std::string confusion_text(const Confusion& table) {
    std::string text = fmt::format("{:>14}", "");
    for (const std::string_view name : classification::category_names)
        text += fmt::format("{:>10}", name);
    text += fmt::format("{:>12}\n", "agreement");
    for (std::size_t truth = 0; truth < table.counts.size(); ++truth) {
        const auto category = static_cast<Category>(truth);
        text += fmt::format("  {:<12}", classification::name(category));
        for (const std::size_t count : table.counts[truth])
            text += fmt::format("{:>10}", count);
        const bool is_decided = category != Category::undecided;
        text += fmt::format("{:>12}\n", is_decided ? percent(classification::agreement_on(table, category)) : "");
    }
    return text;
}

std::string cases_text(const std::vector<hearing::HeardCase>& cases) {
    std::string text =
        fmt::format("Table 1\n\n  {:<8}{:<8}{:<16}{:<11}{}\n", "case", "part", "contact states", "by ear", "why");
    for (const hearing::HeardCase& heard : cases) {
        const auto row = [&](std::string_view name, std::string_view part, std::string_view truth, Category category,
                             std::string_view why) {
            text += fmt::format("  {:<8}{:<8}{:<16}{:<11}{}\n", name, part, truth, classification::name(category), why);
        };
        row(heard.name, "whole", "", heard.whole, heard.reason);
        for (std::size_t direction = 0; direction < heard.phases.size(); ++direction) {
            const hearing::HeardSound& sound = heard.phases[direction];
            row("", parameters::direction_names[direction], classification::name(sound.cell.category), sound.heard,
                sound.reason);
        }
    }
    return text + "\nWhole: the second as it is heard, with its reversals; going, coming: those phases alone.\n";
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

std::string set_title(sweep::PlaneSet set) {
    switch (set) {
        case sweep::PlaneSet::file:
            return "charts of files";
        case sweep::PlaneSet::paper:
            return "the paper's planes";
        case sweep::PlaneSet::soft:
            return "soft parts";
    }
    return "";
}

// the table of each set, where there are several
std::string sets_text(const io::HearingReport& report) {
    const std::vector<sweep::PlaneSet> sets = io::sets_of(report);
    if (sets.size() < 2) return "";
    std::string text;
    for (const sweep::PlaneSet set : sets) {
        const Confusion table = io::confusion(report, set);
        text += fmt::format("\n{}: {} sounds\n\n{}\nagreement {}\n", set_title(set), classification::total(table),
                            confusion_text(table), agreement_text(table));
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

std::string perturbation_row(std::string_view name, const Confusion& table) {
    std::string text = fmt::format("  {:<20}{:>10}{:>10}", name, percent(agreement_of(table)),
                                   percent(classification::mean_agreement(table)));
    for (const Category category : decided_categories)
        text += fmt::format("{:>10}", percent(classification::agreement_on(table, category)));
    return text + fmt::format("{:>11}\n", [&] {
               std::size_t undecided = 0;
               for (const Category category : decided_categories)
                   undecided += table.counts[static_cast<std::size_t>(category)].back();
               return undecided;
           }());
}

std::string perturbed_text(const io::HearingReport& report) {
    const Confusion before = io::perturbed_confusion(report, std::nullopt);
    std::string text = fmt::format("\nEvery {}th run's sounds changed ({} sounds), agreement:\n\n  {:<20}{:>10}{:>10}",
                                   report.options.perturb_every, classification::total(before), "", "all", "mean");
    for (const Category category : decided_categories)
        text += fmt::format("{:>10}", classification::name(category));
    text += fmt::format("{:>11}\n", "undecided") + perturbation_row("unchanged", before);
    for (std::size_t k = 0; k < hearing::perturbations().size(); ++k)
        text += perturbation_row(hearing::perturbations()[k].name, io::perturbed_confusion(report, k));
    return text;
}

std::string number_word(std::size_t number) {
    constexpr std::array words{"no",    "one",   "two",  "three", "four",   "five",  "six",
                               "seven", "eight", "nine", "ten",   "eleven", "twelve"};
    return number < words.size() ? words[number] : std::to_string(number);
}

// how wide a column must be for its words
std::size_t width_of(const std::vector<std::string>& words, std::size_t least) {
    for (const std::string& word : words)
        least = std::max(least, word.size() + 2);
    return least;
}

std::string shares_text(const hearing::RecordingScore& score) {
    std::string text = fmt::format("\n  {:<42}{:>10}{:>9}   {}\n", "", "right", "", "95 %, bootstrap over sources");
    for (const hearing::RightShare& share : score.shares) {
        if (share.count == 0) continue;
        const double all = static_cast<double>(share.right) / static_cast<double>(share.count);
        text += fmt::format("  {:<42}{:>10}{:>9}   {} to {}\n", share.what,
                            fmt::format("{} of {}", share.right, share.count), percent(all), percent(share.low),
                            percent(share.high));
    }
    return text;
}

std::string rows_text(const hearing::RecordingScore& score) {
    std::string text = fmt::format("\n  {:<24}", "expected; by ear:");
    for (const std::string_view name : classification::category_names)
        text += fmt::format("{:>10}", name);
    for (const hearing::HeardRow& row : score.rows) {
        text += fmt::format("\n  {:<24}", row.expected);
        for (const std::size_t count : row.heard)
            text += fmt::format("{:>10}", count);
    }
    return text + "\n";
}

std::string probabilities_text(const hearing::RecordingScore& score, std::size_t count) {
    if (score.bins.empty()) return "";
    std::string text = fmt::format("\n  {:<24}{:>10}{:>10}{:>10}\n", "probability", "clips", "its mean", "right");
    for (const hearing::CalibrationBin& bin : score.bins)
        text += fmt::format("  {:<24}{:>10}{:>10}{:>10}\n", fmt::format("{:.1f} to {:.1f}", bin.from, bin.to),
                            bin.count, percent(bin.probability),
                            percent(static_cast<double>(bin.right) / static_cast<double>(bin.count)));
    text += fmt::format("\n  {:<24}{:>10}{:>10}\n", "decided from", "decided", "right");
    for (const hearing::AbstentionPoint& point : score.decided)
        if (point.decided > 0)
            text += fmt::format("  {:<24}{:>10}{:>10}\n", fmt::format("{:.1f}", point.probability),
                                percent(static_cast<double>(point.decided) / static_cast<double>(count)),
                                percent(static_cast<double>(point.right) / static_cast<double>(point.decided)));
    return text;
}

std::string recordings_text(const std::vector<hearing::HeardRecording>& recordings) {
    std::vector<std::string> names;
    for (const hearing::HeardRecording& recording : recordings)
        names.push_back(std::filesystem::path(recording.expectation.file).filename().string());
    const std::size_t width = width_of(names, 24);
    std::string text =
        fmt::format("  {:<{}}{:<22}{:<11}{:<7}{}\n", "recording", width, "expected", "by ear", "", "why");
    std::size_t right = 0;
    for (std::size_t k = 0; k < recordings.size(); ++k) {
        const hearing::HeardRecording& recording = recordings[k];
        const bool agrees = hearing::is_right(recording);
        right += agrees ? 1 : 0;
        text += fmt::format("  {:<{}}{:<22}{:<11}{:<7}{}\n", names[k], width, recording.expectation.words,
                            classification::name(recording.heard), agrees ? "right" : "wrong", recording.reason);
    }
    text += fmt::format("\n{} of {} as expected. ", right, recordings.size());
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
