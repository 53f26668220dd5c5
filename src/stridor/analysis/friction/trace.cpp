#include "stridor/analysis/friction/trace.hpp"

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

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

struct DropFigures {
    ForceDrop drop;
    Release release;
};

// white noise from second differences, which know nothing of slow changes; the median knows nothing of drops
double noise_of(std::span<const double> values) {
    std::vector<double> differences;
    for (std::size_t k = 1; k + 1 < values.size(); ++k)
        differences.push_back(std::abs(values[k - 1] - 2.0 * values[k] + values[k + 1]));
    std::erase_if(differences, [](double d) { return !std::isfinite(d); });
    return differences.empty() ? 0.0 : 1.4826 * quantile(std::move(differences), 0.5) / std::sqrt(6.0);
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
    expect_valid(measurement);
    const std::vector<double> r = force_ratios(measurement, options);
    const double level = quantile(magnitudes(r), 0.95);
    const double noise = noise_of(r);
    const std::vector<ForceStretch> stretches = force_stretches(measurement, r, options);

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
