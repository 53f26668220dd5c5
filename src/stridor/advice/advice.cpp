#include "stridor/advice/advice.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/parameters/fields/case_key.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace stridor::advice {

namespace {

// a parameter whose nearest change is nearer comes first; without one it has no rank
std::vector<std::size_t> ranked_by_change(const DesignSpace& space, std::span<const ParameterMargin> margins) {
    std::vector<std::pair<double, std::size_t>> order;
    for (const ParameterMargin& margin : margins)
        if (const VerdictChange* change = nearest_change(space, margin))
            order.emplace_back(std::abs(change->share - space.origin[margin.parameter]), margin.parameter);
    std::sort(order.begin(), order.end());
    std::vector<std::size_t> ranking;
    for (const auto& [far, parameter] : order)
        ranking.push_back(parameter);
    return ranking;
}

bool concerns_the_same(const DesignChange& a, const DesignChange& b) {
    return std::equal(a.set.begin(), a.set.end(), b.set.begin(), b.set.end(),
                      [](const auto& x, const auto& y) { return x.parameter == y.parameter; });
}

// About how many designs each stage judges: medians of the cases of Table 1 and the soft parts. What deviates shows in
// the display of progress alone, as a share that waits at the end of a stage or skips to it.
std::array<double, advice_stage_names.size()> expected_designs(std::size_t parameters, std::size_t samples) {
    constexpr double designs_per_margin = 82.0;
    constexpr double designs_per_direction = 500.0;  // of the search for the nearest design, up to five directions
    constexpr double designs_of_changes = 1500.0;
    const auto number = static_cast<double>(parameters);
    return {designs_per_margin * number, designs_per_direction * std::min(number, 5.0),
            parameters > 1 ? designs_of_changes : 100.0, static_cast<double>(samples)};
}

// tells the share of the work that is done
class Watch {
public:
    Watch(const AdviceOptions& options, const DesignSpace& space, DesignRunner& runner)
        : options_(options),
          runner_(runner),
          expected_(expected_designs(space.free.size(), options.tolerances.empty() ? 0 : options.chance.samples)) {
        for (double& each : expected_)
            each *= static_cast<double>(space.runs.size());
    }

    void begin(AdviceStage stage) {
        if (!options_.progress) return;
        const std::size_t before = runner_.runs();
        runner_.on_progress([this, stage, before](std::size_t runs) {
            options_.progress({stage, runs, share(static_cast<std::size_t>(stage), runs - before)});
        });
    }

    // a stage that is not needed
    void skip(AdviceStage stage) { expected_[static_cast<std::size_t>(stage)] = 0.0; }

private:
    double share(std::size_t stage, std::size_t runs) {
        double done = std::min(static_cast<double>(runs), expected_[stage]);
        double total = 0.0;
        for (std::size_t k = 0; k < expected_.size(); ++k) {
            if (k < stage) done += expected_[k];
            total += expected_[k];
        }
        shown_ = std::max(shown_, total > 0.0 ? done / total : 1.0);
        return shown_;
    }

    const AdviceOptions& options_;
    DesignRunner& runner_;
    std::array<double, advice_stage_names.size()> expected_;
    double shown_ = 0.0;
};

// smallest first, each once, and which to recommend
void put_in_order(Advice& advice) {
    std::stable_sort(advice.changes.begin(), advice.changes.end(),
                     [](const auto& a, const auto& b) { return a.distance < b.distance; });
    // a pair may have turned out to be one parameter, known already
    std::vector<DesignChange> distinct;
    for (DesignChange& change : advice.changes)
        if (std::none_of(distinct.begin(), distinct.end(),
                         [&](const DesignChange& nearer) { return concerns_the_same(nearer, change); }))
            distinct.push_back(std::move(change));
    advice.changes = std::move(distinct);
    if (const DesignChange* best = recommended(advice.changes))
        advice.recommended = static_cast<std::size_t>(best - advice.changes.data());
}

void find_changes(Advice& advice, DesignRunner& runner) {
    advice.changes = single_changes(advice.space, advice.margins, Sticking::refused, runner);
    std::vector<DesignChange> joint = joint_changes(advice.space, advice.margins, advice.nearest, runner);
    if (advice.changes.empty() && joint.empty())
        advice.changes = single_changes(advice.space, advice.margins, Sticking::accepted, runner);
    for (const DesignChange& change : advice.changes)
        advice.ranking.push_back(change.set.front().parameter);
    std::move(joint.begin(), joint.end(), std::back_inserter(advice.changes));
}

// the chance of noise of a case: within what was asked for, or within what parts of its kind usually have
std::optional<Chance> chance_within(const parameters::Case& c, std::span<const AskedTolerance> asked,
                                    const AdviceOptions& options, DesignRunner& runner) {
    const std::vector<Tolerance> spreads = asked.empty() ? default_tolerances(c) : tolerances(c, asked);
    if (spreads.empty()) return std::nullopt;
    ChanceOptions sampling = options.chance;
    if (asked.empty()) sampling.samples = default_samples;
    Chance result = chance(spreads, sampling, runner);
    result.is_default = asked.empty();
    return result;
}

// of the design as it is: that a noisy one is noisy within usual tolerances, too, is no news
std::optional<Chance> chance_of(const Advice& advice, const AdviceOptions& options, DesignRunner& runner) {
    if (options.tolerances.empty() && !is_quiet(advice.present)) return std::nullopt;
    return chance_within(advice.space.base, options.tolerances, options, runner);
}

// what was asked for, as far as a case can have it: of a changed design a tolerance may leave the field's range
std::span<const AskedTolerance> possible(const parameters::Case& c, std::span<const AskedTolerance> asked) {
    try {
        tolerances(c, asked);
        return asked;
    } catch (const Error&) {
        return {};
    }
}

}  // namespace

DesignStanding standing_of(const parameters::Case& c, Look look, const AdviceOptions& options) {
    DesignStanding design{design_space(c, {}, options.runs), {}, {}};
    DesignRunner runner(design.space, options.crew, options.stop);
    design.present = runner.judge(std::span(&design.space.origin, 1)).front();
    if (look == Look::around && is_quiet(design.present)) design.near = neighbourhood(design.space, runner);
    return design;
}

std::string headline(const Advice& advice) {
    return headline(advice.space, advice.present, advice.near);
}

std::string headline(const DesignStanding& design) {
    return headline(design.space, design.present, design.near);
}

namespace {

// stage by stage; `advice` has what is known at any time
void work_out(Advice& advice, AdviceStage& stage, const AdviceOptions& options, DesignRunner& runner) {
    Watch watch(options, advice.space, runner);
    const auto begin = [&](AdviceStage next) { watch.begin(stage = next); };
    begin(AdviceStage::margins);
    advice.present = runner.judge(std::span(&advice.space.origin, 1)).front();
    const bool was_quiet = is_quiet(advice.present);
    if (was_quiet) advice.near = neighbourhood(advice.space, runner);
    MarginSearch found = find_margins(advice.space, advice.present, runner);
    advice.margins = std::move(found.margins);
    if (found.stopped) throw Error(*found.stopped);
    if (was_quiet) watch.skip(AdviceStage::changes);
    begin(AdviceStage::nearest);
    advice.nearest =
        nearest_design(advice.space, advice.margins, was_quiet ? Wanted::not_quiet : Wanted::quiet, runner);
    begin(AdviceStage::changes);
    if (was_quiet)
        advice.ranking = ranked_by_change(advice.space, advice.margins);
    else
        find_changes(advice, runner);
    begin(AdviceStage::chance);
    advice.chance = chance_of(advice, options, runner);
}

// where the recommended change leads, as if it were the case
void look_at_changed(Advice& advice, const AdviceOptions& options, DesignRunner& runner) {
    const DesignChange& change = advice.changes[*advice.recommended];
    parameters::Case c = advice.space.base;
    std::vector<Design::Setting> settings;
    for (const ParameterChange& each : change.set) {
        settings.push_back({advice.space.parameters[each.parameter].key, each.to});
        parameters::set_quantity(c, settings.back().key, settings.back().value);
    }
    runner.set_out_from(std::move(settings));
    runner.on_progress([&options](std::size_t runs) {
        if (options.progress) options.progress({AdviceStage::chance, runs, 1.0});
    });
    ChangedDesign& changed = advice.changed.emplace();
    changed.standing = {design_space(c, {}, options.runs), change.verdict, {}};
    changed.standing.near = neighbourhood(changed.standing.space, runner);
    changed.chance = chance_within(c, possible(c, options.tolerances), options, runner);
}

}  // namespace

Advice advise(const parameters::Case& c, const AdviceOptions& options) {
    Advice advice;
    advice.space = design_space(c, options.over, options.runs);
    tolerances(c, options.tolerances);  // what is wrong with them is said before the work
    DesignRunner runner(advice.space, options.crew, options.stop);
    AdviceStage stage = AdviceStage::margins;
    try {
        work_out(advice, stage, options, runner);
        put_in_order(advice);
        if (advice.recommended) look_at_changed(advice, options, runner);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::interrupted || options.when_stopped == WhenStopped::refused) throw;
        advice.stopped_in = stage;
        put_in_order(advice);
    }
    advice.runs = runner.runs();
    return advice;
}

std::string changed_words(const ChangedDesign& changed) {
    const std::string text = headline(changed.standing);
    if (!changed.chance) return text;
    const Estimate& noise = changed.chance->noise;
    const bool is_narrowed = changed.chance->is_default && !narrowed_frictions(changed.standing.space.base).empty();
    return text + fmt::format("; chance of noise within {} {:.2g} % ({:.2g} to {:.2g} %){}",
                              changed.chance->is_default ? "usual tolerances" : "these tolerances", 100.0 * noise.share,
                              100.0 * noise.low, 100.0 * noise.high,
                              is_narrowed ? ", friction varied by less than usual since mu_d stays below mu_s" : "");
}

std::string settings_of(const DesignSpace& space, const DesignChange& change) {
    std::string text;
    for (const ParameterChange& each : change.set)
        text += (text.empty() ? "--set " : " --set ") + space.parameters[each.parameter].key + "=" +
                base::shortest(each.to);
    return text;
}

}  // namespace stridor::advice
