#include "stridor/analysis/friction_trace.hpp"

#include "stridor/analysis/friction_falls.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stridor::analysis {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t fewest_samples = 16;

// samples [from, to) of one direction
struct ForceStretch {
    std::size_t from = 0;
    std::size_t to = 0;
    int direction = 1;
};

struct DropFigures {
    ForceDrop drop;
    Release release;
};

double quantile(std::vector<double> values, double share) {
    if (values.empty()) return unknown;
    const std::size_t place = base::whole_near(share * static_cast<double>(values.size() - 1), values.size() - 1);
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(place), values.end());
    return values[place];
}

std::vector<double> magnitudes(std::span<const double> values) {
    std::vector<double> result;
    for (const double value : values)
        if (std::isfinite(value)) result.push_back(std::abs(value));
    return result;
}

// white noise from second differences, which know nothing of slow changes; the median knows nothing of drops
double noise_of(std::span<const double> values) {
    std::vector<double> differences;
    for (std::size_t k = 1; k + 1 < values.size(); ++k)
        differences.push_back(std::abs(values[k - 1] - 2.0 * values[k] + values[k + 1]));
    std::erase_if(differences, [](double d) { return !std::isfinite(d); });
    return differences.empty() ? 0.0 : 1.4826 * quantile(std::move(differences), 0.5) / std::sqrt(6.0);
}

void require_finite(std::span<const double> values, const char* name) {
    for (std::size_t k = 0; k < values.size(); ++k)
        if (!std::isfinite(values[k]))
            base::refuse(std::string("sample ") + std::to_string(k + 1) + " of the " + name + " is not a number",
                         "figures made from it would not be either", "Cut it out of the file?");
}

void require_valid(const FrictionMeasurement& m) {
    if (!(m.preload > 0.0) || !std::isfinite(m.preload))
        base::refuse("a preload of " + base::shortest(m.preload) + " N is none", "it must be positive", "");
    if (m.force.size() < fewest_samples)
        base::refuse("the friction force has " + std::to_string(m.force.size()) + " samples",
                     "at least " + std::to_string(fewest_samples) + " are needed", "");
    for (const auto& [values, name] : {std::pair{m.velocity, "velocity"}, {m.normal_force, "normal force"}})
        if (!values.empty() && values.size() != m.force.size())
            base::refuse(std::string("the ") + name + " has another length than the friction force", "", "");
    require_finite(m.force, "friction force");
    require_finite(m.velocity, "velocity");
    require_finite(m.normal_force, "normal force");
}

// T/N with its own sign; NaN where the contact is all but open
std::vector<double> ratios(const FrictionMeasurement& m, const FrictionTraceOptions& options) {
    std::vector<double> r(m.force.size());
    for (std::size_t k = 0; k < r.size(); ++k) {
        const double N = m.normal_force.empty() ? m.preload : m.normal_force[k];
        r[k] = N > options.open_contact * m.preload ? m.force[k] / N : unknown;
    }
    return r;
}

void add_stretch(std::vector<ForceStretch>& stretches, const ForceStretch& stretch) {
    if (stretch.to >= stretch.from + 3) stretches.push_back(stretch);
}

std::vector<ForceStretch> stretches_by_velocity(std::span<const double> velocity, double share) {
    const double least = share * quantile(magnitudes(velocity), 0.95);
    std::vector<ForceStretch> stretches;
    std::size_t begin = 0;
    int direction = 0;
    for (std::size_t k = 0; k <= velocity.size(); ++k) {
        const double v = k < velocity.size() ? velocity[k] : 0.0;
        const int now = std::abs(v) <= least || least == 0.0 ? 0 : (v > 0.0 ? 1 : -1);
        if (now == direction) continue;
        if (direction != 0) add_stretch(stretches, {begin, k, direction});
        begin = k;
        direction = now;
    }
    return stretches;
}

// a reversal lies where the force passed zero last before the other sign grew large
std::vector<ForceStretch> stretches_by_force(std::span<const double> r, double share) {
    const double least = share * quantile(magnitudes(r), 0.95);
    std::vector<ForceStretch> stretches;
    std::size_t begin = 0, zero = 0;
    int direction = 0;
    for (std::size_t k = 0; k < r.size(); ++k) {
        if (!std::isfinite(r[k])) continue;
        if (k > 0 && (r[k] > 0.0) != (r[k - 1] > 0.0)) zero = k;
        const int now = std::abs(r[k]) < least || least == 0.0 ? 0 : (r[k] > 0.0 ? 1 : -1);
        if (now == 0 || now == direction) continue;
        if (direction != 0) {
            add_stretch(stretches, {begin, zero, direction});
            begin = zero;
        }
        direction = now;
    }
    if (direction != 0) add_stretch(stretches, {begin, r.size(), direction});
    return stretches;
}

// --- figures over many

MeasuredCoefficient mean_of(const std::vector<double>& values, double resolution) {
    MeasuredCoefficient result;
    result.count = static_cast<long>(values.size());
    if (values.empty()) return result;
    const auto n = static_cast<double>(values.size());
    double sum = 0.0, squares = 0.0;
    for (const double value : values)
        sum += value;
    result.value = sum / n;
    for (const double value : values)
        squares += (value - result.value) * (value - result.value);
    const double scatter = values.size() > 1 ? squares / (n - 1.0) / n : 0.0;
    result.uncertainty = std::sqrt(scatter + resolution * resolution / 12.0);  // even within one sample
    return result;
}

double variation_of(const std::vector<double>& intervals) {
    if (intervals.size() < 2) return unknown;
    double sum = 0.0, squares = 0.0;
    for (const double interval : intervals)
        sum += interval;
    const double mean = sum / static_cast<double>(intervals.size());
    for (const double interval : intervals)
        squares += (interval - mean) * (interval - mean);
    return std::sqrt(squares / static_cast<double>(intervals.size() - 1)) / mean;
}

// everything found in one stretch
struct StretchFigures {
    ForceStretch stretch;
    std::vector<DropFigures> drops;
    std::vector<double> blocks;   // [1] means of r in tenths of the steady part
    double first_peak = unknown;  // [1] highest r before the steady part
    double sum = 0.0;             // [1] of r over the samples
    double samples = 0.0;
    double distance = 0.0;  // [m]
};

StretchFigures study(const FrictionMeasurement& m, const std::vector<double>& signed_ratio, const ForceStretch& stretch,
                     double threshold, double noise, const FrictionTraceOptions& options) {
    StretchFigures result;
    result.stretch = stretch;
    std::vector<double> r(signed_ratio.begin() + static_cast<std::ptrdiff_t>(stretch.from),
                          signed_ratio.begin() + static_cast<std::ptrdiff_t>(stretch.to));
    for (double& value : r)
        value *= stretch.direction;
    const std::size_t longest = std::max<std::size_t>(1, base::whole_below(options.longest_drop * m.rate, r.size()));
    for (const Fall& fall : falls(r, {threshold, noise, longest})) {
        DropFigures drop{{}, release_of(fall, r)};
        const std::size_t from = stretch.from + fall.onset, to = stretch.from + fall.valley;
        drop.drop = {static_cast<double>(from) / m.rate, static_cast<double>(to - from) / m.rate,
                     stretch.direction * m.force[from], stretch.direction * m.force[to], stretch.direction};
        result.drops.push_back(drop);
    }
    const auto settled = static_cast<std::size_t>(options.settling * static_cast<double>(r.size()));
    const std::size_t block = std::max<std::size_t>(1, (r.size() - settled) / 10);
    double block_sum = 0.0, block_count = 0.0;
    for (std::size_t k = 0; k < r.size(); ++k) {
        if (!m.velocity.empty()) result.distance += std::abs(m.velocity[stretch.from + k]) / m.rate;
        if (!std::isfinite(r[k])) continue;
        result.sum += r[k];
        result.samples += 1.0;
        if (k < settled) {
            if (!(r[k] <= result.first_peak)) result.first_peak = r[k];
            continue;
        }
        block_sum += r[k];
        if (++block_count >= static_cast<double>(block)) {
            result.blocks.push_back(block_sum / block_count);
            block_sum = block_count = 0.0;
        }
    }
    return result;
}

void set_coefficients(FrictionFigures& figures, const std::vector<const StretchFigures*>& stretches, double threshold) {
    std::vector<double> peaks, slips, blocks, first_peaks;
    double resolution = 0.0;
    for (const StretchFigures* stretch : stretches) {
        for (const DropFigures& drop : stretch->drops) {
            peaks.push_back(drop.release.peak);
            slips.push_back(drop.release.kinetic);
            resolution += drop.release.resolution;
        }
        blocks.insert(blocks.end(), stretch->blocks.begin(), stretch->blocks.end());
        if (std::isfinite(stretch->first_peak)) first_peaks.push_back(stretch->first_peak);
    }
    if (!peaks.empty()) {
        figures.static_friction = mean_of(peaks, resolution / static_cast<double>(peaks.size()));
        figures.kinetic_friction = mean_of(slips, 0.0);
        figures.source = KineticSource::slips;
        return;
    }
    figures.kinetic_friction = mean_of(blocks, 0.0);
    if (!blocks.empty()) figures.source = KineticSource::steady_sliding;
    // a static peak is one only if it stands out
    std::erase_if(first_peaks, [&](double peak) { return peak < figures.kinetic_friction.value + threshold; });
    figures.static_friction = mean_of(first_peaks, 0.0);
}

FrictionFigures summary(const std::vector<StretchFigures>& all, int direction, const FrictionMeasurement& m,
                        double threshold) {
    FrictionFigures figures;
    figures.direction = direction;
    std::vector<const StretchFigures*> stretches;
    for (const StretchFigures& stretch : all)
        if (direction == 0 || stretch.stretch.direction == direction) stretches.push_back(&stretch);
    set_coefficients(figures, stretches, threshold);

    double sum = 0.0, samples = 0.0, distance = 0.0, drop_sum = 0.0;
    std::vector<double> intervals;
    for (const StretchFigures* stretch : stretches) {
        sum += stretch->sum;
        samples += stretch->samples;
        distance += stretch->distance;
        figures.moving_time += static_cast<double>(stretch->stretch.to - stretch->stretch.from) / m.rate;
        for (std::size_t k = 0; k < stretch->drops.size(); ++k) {
            const ForceDrop& drop = stretch->drops[k].drop;
            const double size = drop.from - drop.to;
            drop_sum += size;
            ++figures.drops;
            if (!(size <= figures.largest_drop)) figures.largest_drop = size;
            if (k > 0) intervals.push_back(drop.time - stretch->drops[k - 1].drop.time);
        }
    }
    figures.mean_friction = samples > 0.0 ? sum / samples : unknown;
    if (!m.velocity.empty()) figures.distance = distance;
    if (figures.drops > 0) figures.mean_drop = drop_sum / static_cast<double>(figures.drops);
    figures.drop_rate = figures.moving_time > 0.0 ? static_cast<double>(figures.drops) / figures.moving_time : 0.0;
    figures.variation = variation_of(intervals);
    return figures;
}

void add_notes(FrictionTrace& trace, const FrictionMeasurement& m) {
    if (trace.all.drops > 0 && m.rate < 10.0 * trace.all.drop_rate)
        trace.notes.emplace_back(
            "fewer than ten samples lie between drops: some may be missed, and peaks are seen too low");
    long unseen = 0;
    for (const ForceDrop& drop : trace.drops)
        unseen += drop.duration * m.rate < 2.5 ? 1 : 0;
    if (2 * unseen > trace.all.drops)
        trace.notes.emplace_back(
            "most slips are shorter than two samples: the kinetic coefficient is the middle of the drops");
    if (trace.all.drops == 0 && trace.all.static_friction.count == 0)
        trace.notes.emplace_back("no drop and no peak at the beginning: the static coefficient is not to be seen");
}

// rubber under small loads reaches 5; what lies far beyond is another unit, another preload, or no measurement
constexpr double most_friction = 20.0;  // [1]

void expect_plausible(const FrictionFigures& figures) {
    for (const double coefficient :
         {figures.static_friction.value, figures.kinetic_friction.value, figures.mean_friction})
        if (std::abs(coefficient) > most_friction)
            base::refuse(
                "the friction coefficient comes out as " + base::shortest(coefficient),
                "none is beyond " + base::shortest(most_friction),
                "Is the preload right, and is the force in newtons? A reading of an overload must be cut out.");
}

}  // namespace

FrictionTrace friction_trace(const FrictionMeasurement& measurement, const FrictionTraceOptions& options) {
    require_valid(measurement);
    const std::vector<double> r = ratios(measurement, options);
    const double level = quantile(magnitudes(r), 0.95);
    const double noise = noise_of(r);
    const std::vector<ForceStretch> stretches =
        measurement.velocity.empty() ? stretches_by_force(r, options.reversal)
                                     : stretches_by_velocity(measurement.velocity, options.moving_velocity);
    if (std::none_of(r.begin(), r.end(), [](double ratio) { return std::isfinite(ratio); }))
        base::refuse("the contact is open all the time", "its normal force is zero, or far below the preload",
                     "Is the preload right, and is that channel the normal force?");
    if (stretches.empty())
        base::refuse("nothing slides in this trace",
                     measurement.velocity.empty() ? "its friction force is zero" : "its velocity is zero", "");

    FrictionTrace trace;
    trace.threshold = std::max(options.least_drop * level, options.noise_factor * noise);
    trace.noise = noise_of(measurement.force);
    std::vector<StretchFigures> all;
    for (const ForceStretch& stretch : stretches)
        all.push_back(study(measurement, r, stretch, trace.threshold, noise, options));
    for (const StretchFigures& stretch : all)
        for (const DropFigures& drop : stretch.drops)
            trace.drops.push_back(drop.drop);
    trace.all = summary(all, 0, measurement, trace.threshold);
    for (const int direction : {1, -1})
        if (std::any_of(all.begin(), all.end(), [&](const auto& s) { return s.stretch.direction == direction; }))
            trace.directions.push_back(summary(all, direction, measurement, trace.threshold));
    expect_plausible(trace.all);
    add_notes(trace, measurement);
    return trace;
}

std::string vda_condition(double preload, double velocity) {
    const auto is_near = [](double value, double nominal) { return std::abs(value - nominal) <= 0.1 * nominal; };
    for (const double force : {10.0, 40.0})
        for (const double speed : {1e-3, 4e-3})
            if (is_near(preload, force) && is_near(velocity, speed))
                return "VDA 230-206, " + base::shortest(force) + " N, " + base::shortest(1e3 * speed) + " mm/s";
    return {};
}

}  // namespace stridor::analysis
