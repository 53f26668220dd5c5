// The deviations that tell how long a trace hangs together are those from a line of hats through all samples of a run
// over its speed: they leave a law over the speed out, whichever it is.

#include "stridor/analysis/friction/points.hpp"

#include "stridor/analysis/friction/falls.hpp"
#include "stridor/analysis/friction/stretches.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stridor::analysis {

namespace {

constexpr std::size_t most_parts = 16384;  // of a stretch, whose autocorrelation is found
constexpr double block_factor = 10.0;      // [1] block over the time that hangs together: neighbours share 3 %
constexpr std::size_t fewest_blocks = 8;   // of a stretch, however long it hangs together
constexpr std::size_t most_blocks = 256;   // of a stretch
constexpr double steady = 0.1;             // [1] a stretch whose speeds differ less has one speed
constexpr std::size_t speed_bins = 12;     // within which a trend over the speed is left out
constexpr long fewest_drops = 3;           // of stick-slip
constexpr double least_skewness = 0.5;     // [1] of a saw tooth that falls in a third of its time: 0.7
constexpr double slowest_share = 0.02;     // [1] of the usual speed: a sweep shows friction down to there

// a stretch, its friction and speed counted along its direction
struct SpeedTrace {
    std::vector<double> friction;  // [1] shape [sample]
    std::vector<double> speed;     // [m/s] shape [sample]
};

double mean_between(std::span<const double> values, std::size_t from, std::size_t to) {
    double sum = 0.0;
    for (std::size_t k = from; k < to; ++k)
        sum += values[k];
    return sum / static_cast<double>(to - from);
}

// while the spring is wound up no contact slides: up to where friction first comes near what follows
std::size_t wound_up(std::span<const double> friction) {
    const std::size_t ahead = std::max<std::size_t>(1, friction.size() / 10);
    const std::vector<double> next(friction.begin(), friction.begin() + static_cast<std::ptrdiff_t>(2 * ahead));
    const double level = 0.9 * quantile(next, 0.75);
    for (std::size_t k = 0; k < ahead; ++k)
        if (friction[k] >= level) return k;
    return ahead;
}

SpeedTrace sliding_of(const FrictionRun& run, std::span<const double> r, const ForceStretch& stretch,
                      const FrictionTraceOptions& options) {
    SpeedTrace all;
    for (std::size_t k = stretch.from; k < stretch.to; ++k) {
        if (!std::isfinite(r[k])) continue;
        all.friction.push_back(stretch.direction * r[k]);
        all.speed.push_back(run.measurement.velocity.empty() ? run.velocity : std::abs(run.measurement.velocity[k]));
    }
    if (all.friction.size() < 4 * fewest_blocks) return {};
    const auto [slowest, fastest] = std::minmax_element(all.speed.begin(), all.speed.end());
    const double late = quantile(all.speed, 0.9), early = quantile(all.speed, 0.1);
    std::size_t from = wound_up(all.friction);
    // the start of a run at one speed has not settled yet; a sweep has its speeds there
    if (late - early <= steady * late)
        from = std::max(from, static_cast<std::size_t>(options.settling * static_cast<double>(all.friction.size())));
    else if (*slowest == *fastest)
        return {};
    all.friction.erase(all.friction.begin(), all.friction.begin() + static_cast<std::ptrdiff_t>(from));
    all.speed.erase(all.speed.begin(), all.speed.begin() + static_cast<std::ptrdiff_t>(from));
    return all;
}

SpeedTrace in_parts(const SpeedTrace& sliding, std::size_t samples) {
    SpeedTrace parts;
    for (std::size_t k = 0; k + samples <= sliding.friction.size(); k += samples) {
        parts.friction.push_back(mean_between(sliding.friction, k, k + samples));
        parts.speed.push_back(mean_between(sliding.speed, k, k + samples));
    }
    return parts;
}

// what is left when a straight line over the speed is taken out of each of a dozen shares of the speeds
std::vector<double> deviations(const SpeedTrace& parts) {
    std::vector<std::size_t> order(parts.speed.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        order[k] = k;
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return parts.speed[a] < parts.speed[b]; });
    const double width = parts.speed[order.back()] - parts.speed[order.front()];
    const std::size_t bins = width <= steady * parts.speed[order.back()] ? 1 : speed_bins;
    std::vector<double> result(order.size());
    for (std::size_t bin = 0; bin < bins; ++bin) {
        const std::size_t from = bin * order.size() / bins, to = (bin + 1) * order.size() / bins;
        double v = 0.0, y = 0.0, vv = 0.0, vy = 0.0;
        for (std::size_t k = from; k < to; ++k) {
            v += parts.speed[order[k]];
            y += parts.friction[order[k]];
        }
        v /= static_cast<double>(to - from);
        y /= static_cast<double>(to - from);
        for (std::size_t k = from; k < to; ++k) {
            vv += (parts.speed[order[k]] - v) * (parts.speed[order[k]] - v);
            vy += (parts.speed[order[k]] - v) * (parts.friction[order[k]] - y);
        }
        const double slope = bins > 1 && vv > 0.0 ? vy / vv : 0.0;
        for (std::size_t k = from; k < to; ++k)
            result[order[k]] = parts.friction[order[k]] - y - slope * (parts.speed[order[k]] - v);
    }
    return result;
}

// [1] how many neighbours hang together: 1 + 2 sum of the autocorrelation, whose pairs end at the first below zero
double held_together(std::span<const double> deviation) {
    const std::size_t most = deviation.size() / 2;
    const auto covariance = [&](std::size_t lag) {
        double sum = 0.0;
        for (std::size_t k = 0; k + lag < deviation.size(); ++k)
            sum += deviation[k] * deviation[k + lag];
        return sum;
    };
    const double variance = covariance(0);
    if (!(variance > 0.0)) return 1.0;
    double sum = -1.0;
    for (std::size_t lag = 0; lag + 1 < most; lag += 2) {
        const double pair = (covariance(lag) + covariance(lag + 1)) / variance;
        if (pair <= 0.0) break;
        sum += 2.0 * pair;
    }
    return std::max(1.0, sum);
}

void add_blocks(FrictionPoints& found, const SpeedTrace& sliding, std::size_t run, double rate) {
    const std::size_t samples = sliding.friction.size();
    if (samples < 4 * fewest_blocks) return;
    const std::size_t part = samples / most_parts + 1;
    const double together = held_together(deviations(in_parts(sliding, part))) * static_cast<double>(part);
    const std::size_t least = std::max<std::size_t>(4, samples / most_blocks), most = samples / fewest_blocks;
    const std::size_t block = std::clamp(base::whole_near(block_factor * together, samples), least, most);
    const double time = static_cast<double>(block) / rate;
    found.shortest_block = found.longest_block == 0.0 ? time : std::min(found.shortest_block, time);
    found.longest_block = std::max(found.longest_block, time);
    if (static_cast<double>(most) < block_factor * together)
        found.notes.push_back("the deviations of a stretch hang together for " +
                              base::shortest(std::round(1e3 * together / rate)) +
                              " ms: it is too short for more than " + std::to_string(fewest_blocks) + " means");
    for (std::size_t from = 0; from + block <= samples; from += block) {
        FrictionPoint point;
        for (std::size_t q = 0; q < 4; ++q)
            point.speeds[q] = mean_between(sliding.speed, from + q * block / 4, from + (q + 1) * block / 4);
        point.friction = mean_between(sliding.friction, from, from + block);
        point.run = run;
        found.points.push_back(point);
    }
}

// Slips of all stretches. Falls that hardly stand out are kept out by the trace's threshold.
void add_slips(FrictionPoints& found, const FrictionRun& run, const FrictionTrace& trace,
               const FrictionTraceOptions& options) {
    const FrictionMeasurement& m = run.measurement;
    const std::vector<double> r = force_ratios(m, options);
    const std::size_t longest = std::max<std::size_t>(1, base::whole_below(options.longest_drop * m.rate, r.size()));
    for (const ForceStretch& stretch : force_stretches(m, r, options)) {
        std::vector<double> force;
        for (std::size_t k = stretch.from; k < stretch.to; ++k)
            force.push_back(stretch.direction * m.force[k]);
        for (const Fall& fall : falls(force, {trace.threshold * m.preload, trace.noise, longest})) {
            RecordedSlip slip = recorded_slip(fall, force, m.rate);
            if (slip.force.empty()) continue;
            const std::size_t from = stretch.from + fall.onset, to = stretch.from + fall.valley;
            slip.velocity = m.velocity.empty() ? run.velocity : std::abs(mean_between(m.velocity, from, to));
            slip.normal_force = m.normal_force.empty() ? m.preload : mean_between(m.normal_force, from, to);
            if (slip.velocity > 0.0 && slip.normal_force > 0.0) found.slips.push_back(std::move(slip));
        }
    }
}

// A rig that only rings falls as fast as it climbs. One that sticks climbs for long and falls at once: what the force
// changes within the time of a drop is skewed.
bool has_stick_slip(const FrictionRun& run, const FrictionTrace& trace) {
    if (trace.all.drops < fewest_drops) return false;
    std::vector<double> durations;
    for (const ForceDrop& drop : trace.drops)
        durations.push_back(drop.duration * run.measurement.rate);
    const std::span<const double> force = run.measurement.force;
    const std::size_t lag = std::max<std::size_t>(1, base::whole_near(quantile(durations, 0.5), force.size() / 2));
    const double sign = trace.drops.front().direction;
    double mean = 0.0, squares = 0.0, cubes = 0.0;
    const auto count = static_cast<double>(force.size() - lag);
    for (std::size_t k = 0; k + lag < force.size(); ++k)
        mean += sign * (force[k + lag] - force[k]) / count;
    for (std::size_t k = 0; k + lag < force.size(); ++k) {
        const double change = sign * (force[k + lag] - force[k]) - mean;
        squares += change * change / count;
        cubes += change * change * change / count;
    }
    return cubes < -least_skewness * squares * std::sqrt(squares);
}

void expect_speed(const FrictionRun& run) {
    if (!run.measurement.velocity.empty() || run.velocity > 0.0) return;
    base::refuse("the speed of " + run.name + " is not known", "a law over the speed of slip needs it",
                 "Name its channel with --velocity-channel (its unit must be a velocity's), or give --velocity.");
}

void expect_against_slip(const FrictionRun& run, const FrictionTrace& trace) {
    if (trace.all.mean_friction == 0.0)
        base::refuse("nothing rubs in " + run.name, "its friction force is zero", "Is --channel the friction force?");
    if (!(trace.all.mean_friction < 0.0)) return;
    base::refuse("the friction of " + run.name + " comes out negative, " + base::shortest(trace.all.mean_friction),
                 "it would push", "Do force and velocity count positive the same way? Turn the sign of one.");
}

}  // namespace

double mean_speed(const FrictionPoint& point) {
    return 0.25 * ((point.speeds[0] + point.speeds[1]) + (point.speeds[2] + point.speeds[3]));
}

void add_run(FrictionPoints& found, const FrictionRun& run, std::size_t number, const FrictionTraceOptions& options) {
    const FrictionTrace trace = friction_trace(run.measurement, options);
    expect_against_slip(run, trace);
    const bool sticks = has_stick_slip(run, trace);
    // peaks of a rig that rings are none of the contact
    const bool has_peaks = sticks || trace.all.drops == 0;
    if (has_peaks && trace.all.static_friction.count > found.static_friction.count)
        found.static_friction = trace.all.static_friction;
    if (sticks) {
        if (trace.all.kinetic_friction.count > found.kinetic_friction.count)
            found.kinetic_friction = trace.all.kinetic_friction;
        if (!run.measurement.velocity.empty() || run.velocity > 0.0) add_slips(found, run, trace, options);
        found.notes.push_back(run.name + " has stick-slip: the mean of its force is no friction at its speed");
        return;
    }
    expect_speed(run);
    const std::vector<double> r = force_ratios(run.measurement, options);
    FrictionTraceOptions slow = options;
    slow.moving_velocity = std::min(slow.moving_velocity, slowest_share);
    for (const ForceStretch& stretch : force_stretches(run.measurement, r, slow))
        add_blocks(found, sliding_of(run, r, stretch, options), number, run.measurement.rate);
}

FrictionPoints friction_points(std::span<const FrictionRun> runs, const FrictionTraceOptions& options) {
    FrictionPoints found;
    for (std::size_t number = 0; number < runs.size(); ++number)
        add_run(found, runs[number], number, options);
    return found;
}

}  // namespace stridor::analysis
