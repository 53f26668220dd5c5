#include "stridor/console/results/advice_text.hpp"

#include "stridor/console/terminal.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace stridor::console {

namespace {

using advice::Advice;
using advice::DesignChange;
using advice::DesignSpace;
using advice::DesignVerdict;
using advice::ParameterMargin;
using advice::VerdictChange;

std::string with_unit(const DesignSpace& space, std::size_t parameter, const std::string& number) {
    const std::string_view unit = parameters::unit_of(space.parameters[parameter].key);
    return unit == "1" ? number : number + " " + std::string(unit);
}

std::string measured(const DesignSpace& space, std::size_t parameter, double value) {
    return with_unit(space, parameter, fmt::format("{:.4g}", value));
}

// "none", "both squeal", or where the phases differ "going squeal, coming none"
std::string verdict_words(const DesignSpace& space, const DesignVerdict& verdict) {
    std::string text;
    bool are_equal = true;
    for (std::size_t k = 0; k < space.phases.size(); ++k) {
        const std::string_view word = sweep::word(verdict.phases[k]);
        are_equal = are_equal && word == sweep::word(verdict.phases.front());
        text += fmt::format("{}{} {}", k > 0 ? ", " : "",
                            record::phase_names[static_cast<std::size_t>(space.phases[k])], word);
    }
    const std::string first(sweep::word(verdict.phases.front()));
    if (!are_equal) return text;
    if (advice::is_quiet(verdict)) return advice::slips_quietly(verdict) ? first : first + " (sticks)";
    return space.phases.size() == 2 ? "both " + first : first;
}

std::string change_words(const DesignSpace& space, const ParameterMargin& margin, const advice::ScanSide& side) {
    if (side.change)
        return measured(space, margin.parameter, side.change->value) + " " + verdict_words(space, side.change->beyond);
    return "-";
}

std::string quiet_words(const DesignSpace& space, const ParameterMargin& margin) {
    std::string text;
    for (const advice::ScanSide* side : {&margin.below, &margin.above})
        if (side->quiet) text += (text.empty() ? "" : ", ") + measured(space, margin.parameter, side->quiet->value);
    return text.empty() ? "-" : text;
}

// columns padded to their widest entry; the first row is the heading
std::string columns(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths;
    for (const std::vector<std::string>& row : rows) {
        widths.resize(std::max(widths.size(), row.size()), 0);
        for (std::size_t k = 0; k < row.size(); ++k)
            widths[k] = std::max(widths[k], row[k].size());
    }
    std::string text;
    for (std::size_t line = 0; line < rows.size(); ++line) {
        std::string padded;
        for (std::size_t k = 0; k < rows[line].size(); ++k)
            padded += fmt::format("{:<{}}{}", rows[line][k], widths[k], k + 1 < rows[line].size() ? "  " : "");
        padded.erase(padded.find_last_not_of(' ') + 1);
        text += (line == 0 ? styled(padded, Style::bold, STDOUT_FILENO) : padded) + "\n";
    }
    return text;
}

// why a parameter cannot go on
std::string ends(const Advice& advice) {
    std::string text;
    for (const ParameterMargin& margin : advice.margins)
        for (const advice::ScanSide* side : {&margin.below, &margin.above})
            if (side->end == advice::ScanEnd::invalid)
                text += fmt::format("{} ends at {}: {}\n", advice.space.parameters[margin.parameter].key,
                                    measured(advice.space, margin.parameter, side->last), side->reason);
    return text;
}

std::string margins_table(const Advice& advice) {
    const DesignSpace& space = advice.space;
    const bool was_quiet = advice::is_quiet(advice.present);
    std::vector<std::vector<std::string>> rows{{"parameter", "now", "changes below", "changes above"}};
    if (!was_quiet) rows.front().push_back("quiet at");
    for (const ParameterMargin& margin : advice.margins) {
        rows.push_back({space.parameters[margin.parameter].key, measured(space, margin.parameter, margin.value),
                        change_words(space, margin, margin.below), change_words(space, margin, margin.above)});
        if (!was_quiet) rows.back().push_back(quiet_words(space, margin));
    }
    return columns(rows) + ends(advice);
}

std::string setting_words(const DesignSpace& space, const DesignChange& change) {
    std::string text;
    for (const advice::ParameterChange& each : change.set) {
        text += fmt::format("{}{} {:.4g} -> {}", text.empty() ? "" : ", ", space.parameters[each.parameter].key,
                            each.from, with_unit(space, each.parameter, fmt::format("{:.6g}", each.to)));
    }
    return text;
}

std::string changes_list(const Advice& advice) {
    const DesignSpace& space = advice.space;
    if (advice.changes.empty())
        return "no change within these ranges was verified to be quiet; --over KEY=FROM:TO looks elsewhere.\n";
    std::vector<std::vector<std::string>> rows{{"", "distance", "quiet with"}};
    for (std::size_t k = 0; k < advice.changes.size(); ++k)
        rows.push_back({k == advice.recommended ? "*" : "", fmt::format("{:.3f}", advice.changes[k].distance),
                        setting_words(space, advice.changes[k]) +
                            (advice::slips_quietly(advice.changes[k].verdict) ? "" : " (it then sticks throughout)")});
    const DesignChange& best = advice.changes[*advice.recommended];
    return columns(rows) +
           fmt::format(
               "\n* advised: {}\n  verified by {} runs: quiet from every start, and with 1 % more and less of each\n",
               advice::settings_of(space, best), best.runs);
}

// the parameters that a design as a whole is nearest through, the largest parts first
std::string parts(const DesignSpace& space, const advice::NearestDesign& nearest) {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t k = 0; k < space.parameters.size(); ++k)
        order.emplace_back(-std::abs(nearest.shares[k] - space.origin[k]), k);
    std::sort(order.begin(), order.end());
    std::string text;
    for (std::size_t k = 0; k < std::min<std::size_t>(3, order.size()); ++k) {
        const std::size_t parameter = order[k].second;
        if (order[k].first == 0.0) break;
        text += fmt::format(
            "{}{} {}", text.empty() ? "" : ", ", space.parameters[parameter].key,
            measured(space, parameter, advice::value_at(space.parameters[parameter], nearest.shares[parameter])));
    }
    return text;
}

std::string nearest_line(const Advice& advice) {
    const char* wanted = advice::is_quiet(advice.present) ? "noisy" : "quiet";
    if (!advice.nearest) return fmt::format("as a whole: no {} design was found within these ranges\n", wanted);
    return fmt::format("as a whole: {} at a distance of {:.3f}, mostly through {}\n", wanted, advice.nearest->distance,
                       parts(advice.space, *advice.nearest));
}

std::string ranking_line(const Advice& advice) {
    if (!advice::is_quiet(advice.present) || advice.ranking.empty()) return "";
    std::string text = "nearest to another verdict: ";
    for (std::size_t k = 0; k < std::min<std::size_t>(3, advice.ranking.size()); ++k) {
        const std::size_t parameter = advice.ranking[k];
        const VerdictChange& change = *advice::nearest_change(advice.space, advice.margins[parameter]);
        text += fmt::format("{}{} ({:.3f})", k > 0 ? ", " : "", advice.space.parameters[parameter].key,
                            std::abs(change.share - advice.space.origin[parameter]));
    }
    return text + "\n";
}

std::string percent(const advice::Estimate& estimate) {
    return fmt::format("{:.2f} % ({:.2f} to {:.2f} %)", 100.0 * estimate.share, 100.0 * estimate.low,
                       100.0 * estimate.high);
}

std::string chance_lines(const advice::Chance& chance) {
    std::string text = "\nchance of noise within";
    for (std::size_t k = 0; k < chance.tolerances.size(); ++k) {
        const advice::Tolerance& each = chance.tolerances[k];
        const std::string_view unit = parameters::unit_of(each.key);
        text += fmt::format("{}{} +- {:.4g}{}{}", k > 0 ? ", " : " ", each.key, each.tolerance,
                            unit == "1" ? "" : " " + std::string(unit),
                            each.spread == advice::Spread::normal ? " (normal)" : "");
    }
    text += fmt::format(":\n  {}, 95 % confidence, {} samples\n", percent(chance.noise), chance.samples);
    for (std::size_t k = 0; k < sweep::verdict_words.size(); ++k)
        if (chance.by_verdict[k].share > 0.0)
            text += fmt::format("  {:<10} {}\n", sweep::verdict_words[k], percent(chance.by_verdict[k]));
    return text;
}

}  // namespace

std::string advice_text(const Advice& advice) {
    const DesignSpace& space = advice.space;
    std::string text = styled(space.base.title.empty() ? "case" : space.base.title, Style::bold, STDOUT_FILENO) + "\n";
    text += "now: " + verdict_words(space, advice.present) +
            (advice.present.message.empty() ? "" : " (" + advice.present.message + ")") + "\n\n";
    text += margins_table(advice) + "\n" + ranking_line(advice) + nearest_line(advice);
    if (!advice::is_quiet(advice.present)) text += "\n" + changes_list(advice);
    if (advice.chance) text += chance_lines(*advice.chance);
    text +=
        "\ndistances are shares of the ranges that were looked at; a verdict is the model's. Islands narrower than "
        "the\n"
        "scan may be missed.\n";
    return text;
}

}  // namespace stridor::console
