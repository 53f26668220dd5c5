#include "stridor/sweep/strokes.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/sweep/evaluate.hpp"
#include "stridor/sweep/starts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

namespace stridor::sweep {

namespace {

using parameters::Case;
using parameters::Direction;

constexpr std::string_view temperature_key = "temperature.value";
constexpr std::string_view preload_key = "contact.preload";
constexpr std::int64_t most_strokes = 1'000'000'000'000;  // exact as a double

// what changes from stroke to stroke, at the beginning of one
struct SlowState {
    double warmth = 0.0;  // [degC] above the case's own temperature
    double depth = 0.0;   // [m] worn
};

void expect_positive(double value, std::string_view name) {
    if (!(value > 0.0) || !std::isfinite(value))
        base::refuse("the " + std::string(name) + " is " + base::shortest(value), "it must be above 0", "");
}

void expect_plan(const Case& base, const StrokePlan& plan) {
    if (plan.strokes < 1 || plan.strokes > most_strokes)
        base::refuse("the number of strokes is " + std::to_string(plan.strokes), "it must be from 1 to 1e12", "");
    expect_positive(plan.duration, "time of a stroke");
    if (plan.pause != 0.0) expect_positive(plan.pause, "pause after a stroke");
    if (!plan.heating && !plan.wear)
        base::refuse("strokes change nothing", "neither heating nor wear is given",
                     "Give a thermal resistance, or a wear rate.");
    if (plan.heating) {
        expect_positive(plan.heating->resistance, "thermal resistance");
        expect_positive(plan.heating->time, "thermal time");
        if (!parameters::belongs(base, temperature_key))
            base::refuse("heating changes nothing", "nothing of this case follows the temperature",
                         "Give it a table in [temperature], or a pair that is known over the temperature.");
    }
    if (plan.wear) {
        expect_positive(plan.wear->rate, "wear rate");
        expect_positive(plan.wear->area, "worn area");
        expect_positive(plan.wear->interference, "interference");
        if (!parameters::is_preloaded(base))
            base::refuse("wear changes nothing", "the structure is pressed by its load or its gaps",
                         "Press it by contact.preload.");
    }
}

// 1 - exp(-x) for x >= 0, with the same bits on every machine; its relative error is below 1e-12
double decayed(double x) {
    if (x > 1e-3) return 1.0 - base::exponential(-x);
    return x * (1.0 - x / 2.0 * (1.0 - x / 3.0 * (1.0 - x / 4.0 * (1.0 - x / 5.0))));
}

// (1 - q^m)/(1 - q) for q = exp(-x): the sum of m terms
double geometric_sum(double x, double m) {
    return decayed(m * x) / decayed(x);
}

// what `count` strokes of this friction power make of it, each with its pause
SlowState after(const SlowState& state, double power, double count, const StrokePlan& plan) {
    SlowState next = state;
    if (plan.heating) {
        const double sliding = plan.duration / plan.heating->time, resting = plan.pause / plan.heating->time;
        const double rise = plan.heating->resistance * power * decayed(sliding) * base::exponential(-resting);
        const double cycle = sliding + resting;
        next.warmth = state.warmth * base::exponential(-count * cycle) + rise * geometric_sum(cycle, count);
    }
    if (plan.wear) next.depth += plan.wear->rate * power * plan.duration * count / plan.wear->area;
    return next;
}

double preload_share(const SlowState& state, const StrokePlan& plan) {
    return plan.wear ? 1.0 - state.depth / plan.wear->interference : 1.0;
}

bool is_near(const SlowState& a, const SlowState& b, const StrokePlan& plan, const StrokeOptions& options) {
    return std::abs(b.warmth - a.warmth) <= options.heating_step &&
           std::abs(preload_share(b, plan) - preload_share(a, plan)) <= options.wear_step * preload_share(a, plan);
}

// the most strokes, one at least, after which the state is still near
std::int64_t longest_step(const SlowState& state, double power, std::int64_t most, const StrokePlan& plan,
                          const StrokeOptions& options) {
    std::int64_t near = 1, far = most + 1;
    while (far - near > 1) {
        const std::int64_t middle = near + (far - near) / 2;
        const SlowState there = after(state, power, static_cast<double>(middle), plan);
        (is_near(state, there, plan, options) ? near : far) = middle;
    }
    return near;
}

bool have_same_verdicts(const ComputedStroke& a, const ComputedStroke& b) {
    return std::ranges::equal(a.cells, b.cells, has_same_verdict);
}

bool has_result(const ComputedStroke& stroke) {
    return std::isfinite(stroke.friction_power);
}

class StrokeRunner {
public:
    StrokeRunner(const StrokeHistory& history, const StrokeOptions& options) : history_(history), options_(options) {}

    // nothing where there is no such case: `refusal` says why
    std::optional<ComputedStroke> run(std::int64_t number, const SlowState& state) {
        const double share = preload_share(state, history_.plan);
        const double temperature = history_.base.temperature.value + state.warmth;
        const std::optional<Case> c = case_at(temperature, share);
        if (!c) return std::nullopt;
        const Attempt run = attempted(*c);
        ComputedStroke stroke{number, temperature, state.depth, share, std::numeric_limits<double>::quiet_NaN(), {}};
        for (const Direction direction : history_.directions)
            stroke.cells.push_back(cell_of(*c, direction, run));
        if (run.status == Status::done) stroke.friction_power = power_of(*c, run);
        return stroke;
    }

    const std::string& refusal() const { return refusal_; }

private:
    std::optional<Case> case_at(double temperature, double share) {
        if (!(share > 0.0)) {
            refusal_ = "the interference is worn off";
            return std::nullopt;
        }
        try {
            return case_of_stroke(history_.base, temperature, share);
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::input) throw;
            refusal_ = error.what();
            return std::nullopt;
        }
    }

    Attempt attempted(const Case& c) {
        std::optional<Attempt> run = attempt(c, {}, options_.stop, workspace_);
        if (!run || options_.stop.stop_requested())
            throw Error(ErrorKind::interrupted, {"the strokes were not run to their end", "it was interrupted", ""});
        return std::move(*run);
    }

    // the losses of a run that ended with a proof are those until then: it is run on
    double power_of(const Case& c, const Attempt& run) {
        if (run.motion.outcome.time >= c.run.duration) return run.motion.energy.friction_loss / c.run.duration;
        Case whole = c;
        whole.run.early_ending = parameters::EarlyEnding::never;
        const Attempt on = attempted(whole);
        return on.status == Status::done ? on.motion.energy.friction_loss / c.run.duration
                                         : std::numeric_limits<double>::quiet_NaN();
    }

    const StrokeHistory& history_;
    const StrokeOptions& options_;
    integration::Workspace workspace_;
    std::string refusal_;
};

// a power that goes on in a straight line from the stroke before
double power_over(const std::vector<ComputedStroke>& strokes, std::int64_t count) {
    const ComputedStroke& here = strokes.back();
    if (strokes.size() < 2 || !have_same_verdicts(strokes[strokes.size() - 2], here)) return here.friction_power;
    const ComputedStroke& before = strokes[strokes.size() - 2];
    // the mean of `count` strokes, of which this is the first
    const double ratio = 0.5 * static_cast<double>(count - 1) / static_cast<double>(here.number - before.number);
    return std::max(0.0, here.friction_power + ratio * (here.friction_power - before.friction_power));
}

SlowState state_of(const ComputedStroke& stroke, const Case& base) {
    return {stroke.temperature - base.temperature.value, stroke.worn_depth};
}

// the next stroke that is computed, behind the last one with the present verdicts
struct Change {
    ComputedStroke last;
    ComputedStroke first;
};

// nothing where the case ends with the present stroke
std::optional<Change> next_of(StrokeRunner& runner, const StrokeHistory& history, const StrokeOptions& options) {
    const StrokePlan& plan = history.plan;
    const ComputedStroke& here = history.strokes.back();
    const SlowState state = state_of(here, history.base);
    std::int64_t count = longest_step(state, here.friction_power, plan.strokes - here.number, plan, options);
    const double power = power_over(history.strokes, count);
    const auto run = [&](std::int64_t more) {
        return runner.run(here.number + more, after(state, power, static_cast<double>(more), plan));
    };
    std::optional<ComputedStroke> next = run(count);
    for (; !next && count > 1; next = run(count))
        count /= 2;
    if (!next) return std::nullopt;
    Change change{here, std::move(*next)};
    if (have_same_verdicts(here, change.first)) return change;
    while (change.first.number - change.last.number > 1) {
        const std::int64_t middle = change.last.number + (change.first.number - change.last.number) / 2;
        std::optional<ComputedStroke> between = run(middle - here.number);
        STRIDOR_EXPECT(between);
        (have_same_verdicts(*between, here) ? change.last : change.first) = std::move(*between);
    }
    return change;
}

}  // namespace

Case case_of_stroke(const Case& base, double temperature, double preload_share) {
    Case c = base;
    if (temperature != base.temperature.value) parameters::set_quantity(c, std::string(temperature_key), temperature);
    if (preload_share == 1.0) return c;
    for (const std::string& key : parameters::single_keys(c, preload_key))
        parameters::set_quantity(c, key, preload_share * parameters::get_quantity(base, key));
    return c;
}

StrokeHistory run_strokes(const Case& base, const StrokePlan& plan, const StrokeOptions& options) {
    expect_plan(base, plan);
    StrokeHistory history{base, plan, parameters::judged_directions(base.drive), {}, {}};
    StrokeRunner runner(history, options);
    history.strokes.push_back(*runner.run(1, {}));
    while (has_result(history.strokes.back()) && history.strokes.back().number < plan.strokes) {
        std::optional<Change> next = next_of(runner, history, options);
        if (!next) {
            history.ended = "stroke " + std::to_string(history.strokes.back().number + 1) + ": " + runner.refusal();
            return history;
        }
        if (next->last.number > history.strokes.back().number) history.strokes.push_back(std::move(next->last));
        history.strokes.push_back(std::move(next->first));
        if (options.progress) options.progress(history.strokes.back().number, plan.strokes);
    }
    const ComputedStroke& last = history.strokes.back();
    if (!has_result(last)) history.ended = "stroke " + std::to_string(last.number) + ": " + last.cells.front().message;
    return history;
}

std::vector<StrokeStretch> stretches_of(const StrokeHistory& history, std::size_t direction) {
    std::vector<StrokeStretch> stretches;
    for (std::size_t k = 0; k < history.strokes.size(); ++k)
        if (k == 0 || !has_same_verdict(history.strokes[k].cells[direction], history.strokes[k - 1].cells[direction]))
            stretches.push_back({k, k});
        else
            stretches.back().last = k;
    return stretches;
}

}  // namespace stridor::sweep
