#include "stridor/console/results/advice_text.hpp"

#include "stridor/base/text.hpp"
#include "stridor/console/results/text_table.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/parameters/fields/case_key.hpp"

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
    return number + after_number(parameters::unit_of(space.parameters[parameter].key));
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

// what was found to one side; nothing is said of what nobody looked at
std::string change_words(const DesignSpace& space, const ParameterMargin& margin, const advice::ScanSide& side) {
    if (side.change)
        return measured(space, margin.parameter, side.change->value) + " " + verdict_words(space, side.change->beyond);
    return side.last == margin.value ? "not looked at" : "no change";
}

// "0.6 to 60 N"
std::string looked_at(const DesignSpace& space, const ParameterMargin& margin) {
    return fmt::format("{:.4g} to {}", margin.below.last, measured(space, margin.parameter, margin.above.last));
}

std::string quiet_words(const DesignSpace& space, const ParameterMargin& margin) {
    std::string text;
    for (const advice::ScanSide* side : {&margin.below, &margin.above})
        if (side->quiet) text += (text.empty() ? "" : ", ") + measured(space, margin.parameter, side->quiet->value);
    return text.empty() ? "nowhere" : text;
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
    TextTable table{{left("parameter"), left("now"), left("looked at"), left("changes below"), left("changes above")}};
    table.heading = Style::bold;
    if (!was_quiet) table.columns.push_back(left("slides quietly at"));
    for (const ParameterMargin& margin : advice.margins) {
        add_row(table, space.parameters[margin.parameter].key, measured(space, margin.parameter, margin.value),
                looked_at(space, margin), change_words(space, margin, margin.below),
                change_words(space, margin, margin.above));
        if (!was_quiet) table.rows.back().push_back(quiet_words(space, margin));
    }
    return text_of(table) + ends(advice) + advice::scan_words() + "\n";
}

std::string setting_words(const DesignSpace& space, const DesignChange& change) {
    std::string text;
    for (const advice::ParameterChange& each : change.set) {
        text += fmt::format("{}{} {:.4g} -> {}", text.empty() ? "" : ", ", space.parameters[each.parameter].key,
                            each.from, with_unit(space, each.parameter, fmt::format("{:.6g}", each.to)));
    }
    return text;
}

// "going and coming, from rest, sliding and stuck"
std::string judged_words(const DesignSpace& space) {
    std::vector<std::string> ways;
    for (const record::Phase phase : space.phases)
        if (phase != record::Phase::all) ways.emplace_back(record::phase_names[static_cast<std::size_t>(phase)]);
    std::vector<std::string> starts;
    for (const parameters::Initial start : advice::starts_of(space))
        starts.emplace_back(sweep::start_names()[static_cast<std::size_t>(start)]);
    return (ways.empty() ? "" : base::listed(ways) + ", ") + "from " + base::listed(starts);
}

std::string changes_list(const Advice& advice) {
    const DesignSpace& space = advice.space;
    if (advice.changes.empty())
        return "no change within these ranges was verified to be quiet; --over KEY=FROM:TO looks elsewhere.\n";
    TextTable table{{left(""), left("distance"), left("quiet with")}};
    table.heading = Style::bold;
    for (std::size_t k = 0; k < advice.changes.size(); ++k)
        add_row(table, k == advice.recommended ? "*" : "", fmt::format("{:.3f}", advice.changes[k].distance),
                setting_words(space, advice.changes[k]) +
                    (advice::slips_quietly(advice.changes[k].verdict) ? "" : " (it then sticks throughout)"));
    const DesignChange& best = advice.changes[*advice.recommended];
    return text_of(table) +
           fmt::format(
               "\n* advised: {}\n  verified by {} runs of {} designs: quiet {}, and with 1 % more and less of each\n",
               advice::settings_of(space, best), best.runs, best.designs, judged_words(space)) +
           (advice.changed ? "  with it: " + advice::changed_words(*advice.changed) + "\n" : "");
}

std::string nearest_line(const Advice& advice) {
    const bool was_quiet = advice::is_quiet(advice.present);
    if (!advice.nearest)
        return fmt::format("all parameters together: no {} design was found within these ranges\n",
                           was_quiet ? "other than quiet" : "quiet");
    return fmt::format("all parameters together: {} with {}\n",
                       was_quiet ? verdict_words(advice.space, advice.nearest->verdict) : "quiet",
                       advice::nearest_words(advice.space, *advice.nearest));
}

std::string ranking_line(const Advice& advice) {
    if (!advice::is_quiet(advice.present) || advice.ranking.empty()) return "";
    std::string text = "nearest to another verdict: ";
    for (std::size_t k = 0; k < std::min<std::size_t>(3, advice.ranking.size()); ++k) {
        const std::size_t parameter = advice.ranking[k];
        const VerdictChange& change = *advice::nearest_change(advice.space, advice.margins[parameter]);
        text += fmt::format("{}{} at {}", k > 0 ? ", " : "", advice.space.parameters[parameter].key,
                            with_unit(advice.space, parameter, fmt::format("{:.5g}", change.value)));
    }
    return text + "\n";
}

std::string percent(const advice::Estimate& estimate) {
    return fmt::format("{:.2f} % ({:.2f} to {:.2f} %)", 100.0 * estimate.share, 100.0 * estimate.low,
                       100.0 * estimate.high);
}

std::string chance_lines(const advice::Chance& chance, const parameters::Case& base) {
    std::string text = fmt::format("\nchance of noise within{}", chance.is_default ? " usual tolerances," : "");
    for (std::size_t k = 0; k < chance.tolerances.size(); ++k) {
        const advice::Tolerance& each = chance.tolerances[k];
        text += fmt::format("{}{} +- {:.4g}{}{}", k > 0 ? ", " : " ", each.key, each.tolerance,
                            after_number(parameters::unit_of(each.key)),
                            each.spread == advice::Spread::normal ? " (normal)" : "");
    }
    text += fmt::format(":\n  {}, 95 % confidence, {} samples\n", percent(chance.noise), chance.samples);
    if (const auto narrowed = advice::narrowed_frictions(base); chance.is_default && !narrowed.empty())
        text += fmt::format(
            "  {} varied by less than usual, so that mu_d stays below mu_s; more friction is judged above\n",
            base::listed(narrowed));
    for (std::size_t k = 0; k < sweep::verdict_words.size(); ++k)
        if (chance.by_verdict[k].share > 0.0)
            text += fmt::format("  {:<10} {}\n", sweep::verdict_words[k], percent(chance.by_verdict[k]));
    return text;
}

}  // namespace

std::string advice_text(const Advice& advice) {
    const DesignSpace& space = advice.space;
    std::string text = styled(space.base.title.empty() ? "case" : space.base.title, Style::bold, STDOUT_FILENO) + "\n";
    text +=
        advice::headline(advice) + (advice.present.message.empty() ? "" : " (" + advice.present.message + ")") + "\n";
    if (advice.near)
        for (const std::string& words : advice::turn_words(space, *advice.near))
            text += "  " + words + "\n";
    text += "judged " + judged_words(space) + "\n\n" + margins_table(advice) + "\n" + ranking_line(advice) +
            nearest_line(advice);
    if (!advice::is_quiet(advice.present)) text += "\n" + changes_list(advice);
    if (advice.chance) text += chance_lines(*advice.chance, space.base);
    text +=
        "\ndistances are shares of what was looked at; a verdict is the model's. Islands narrower than "
        "the\n"
        "scan may be missed.\n";
    return text;
}

}  // namespace stridor::console
