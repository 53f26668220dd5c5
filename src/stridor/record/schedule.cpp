#include "stridor/record/schedule.hpp"

#include <algorithm>
#include <cmath>

namespace stridor::record {

namespace {

using parameters::Case;

// a whole going or coming phase of the drive, wherever the run starts and ends
struct HalfPeriod {
    double from = 0.0;  // [s]
    double to = 0.0;    // [s]
    Phase phase = Phase::going;
};

// x2 = A sin(2 pi f t): V > 0 for f t in (k - 1/4, k + 1/4); `begun` [s] of a period have gone by at t = 0
std::vector<HalfPeriod> harmonic_phases(double frequency, double begun, double duration) {
    std::vector<HalfPeriod> halves;
    const double half_period = 0.5 / frequency;
    const auto count = static_cast<long>(std::ceil((duration + begun) / half_period)) + 2;
    halves.reserve(static_cast<std::size_t>(count));
    for (long k = 0; k < count; ++k) {
        const auto number = static_cast<double>(k);
        halves.push_back({(number - 0.5) * half_period - begun, (number + 0.5) * half_period - begun,
                          k % 2 == 0 ? Phase::going : Phase::coming});
    }
    return halves;
}

// V linear between corners; a phase ends where V changes sign, standing still belongs to the phase before it. The first
// one began `begun` [s] before t = 0.
std::vector<HalfPeriod> cornered_phases(const std::vector<double>& t, const std::vector<double>& v, double begun) {
    std::vector<HalfPeriod> halves;
    double from = 0.0 - begun;
    double sign = 0.0;
    for (std::size_t k = 0; k < t.size(); ++k) {
        const bool turns = v[k] != 0.0 && sign != 0.0 && (v[k] > 0.0) != (sign > 0.0);
        if (turns) {
            const double crossing = t[k - 1] + (t[k] - t[k - 1]) * (v[k - 1] / (v[k - 1] - v[k]));
            halves.push_back({from, crossing, sign > 0.0 ? Phase::going : Phase::coming});
            from = crossing;
        }
        if (v[k] != 0.0) sign = v[k];
    }
    if (sign != 0.0) halves.push_back({from, t.back(), sign > 0.0 ? Phase::going : Phase::coming});
    return halves;
}

void add_span(std::vector<Span>& spans, const Span& span) {
    if (span.to > span.from) spans.push_back(span);
}

void add_phase(std::vector<Span>& spans, const Case& c, const HalfPeriod& half) {
    const double window_from = c.run.duration - c.run.window;
    const double from = std::max(half.from, window_from);
    const double to = std::min(half.to, c.run.duration);
    // half a rounding error of the drive's period must not make a whole phase look cut short
    const double slack = 1e-9 * (half.to - half.from);
    const bool is_complete = half.from >= window_from - slack && half.to <= c.run.duration + slack;
    const double length = half.to - half.from;
    const double settled = is_complete ? std::max(from, half.from + c.verdict.settling * length) : to;
    const double slowing = is_complete ? half.to - c.verdict.reversal * length : to;
    add_span(spans, {std::max(half.from, 0.0), std::min(to, window_from), half.phase, Use::unused});
    add_span(spans, {from, std::min(settled, to), half.phase, Use::counted});
    add_span(spans, {settled, std::min(slowing, to), half.phase, Use::judged});
    add_span(spans, {std::max(slowing, from), to, half.phase, Use::counted});
}

// the last share of the judged time: long enough for an effective value, late enough to be the end
constexpr double closing_share = 0.2;

void add_constant_drive(std::vector<Span>& spans, const Case& c) {
    const double end = c.run.duration;
    const double window_from = end - c.run.window;
    const double judged_from = std::max(window_from, c.verdict.start * end);
    const double closing_from = end - closing_share * (end - judged_from);
    add_span(spans, {0.0, window_from, Phase::all, Use::unused});
    add_span(spans, {window_from, judged_from, Phase::all, Use::counted});
    add_span(spans, {judged_from, closing_from, Phase::all, Use::judged});
    add_span(spans, {closing_from, end, Phase::all, Use::closing});
}

}  // namespace

double end_of(const Schedule& schedule) {
    return schedule.spans.empty() ? 0.0 : schedule.spans.back().to;
}

Schedule schedule(const Case& c) {
    Schedule plan;
    const parameters::Drive drive = parameters::drive_of_run(c);
    if (parameters::has_one_phase(drive)) {
        add_constant_drive(plan.spans, c);
        plan.phases = {Phase::all};
        return plan;
    }
    const parameters::VelocityProfile profile = parameters::velocity_profile(drive, c.run.duration);
    const double turns = parameters::turns_at_start(drive);
    const double begun = turns > 0.0 ? turns / drive.frequency : 0.0;
    const double half_begun = turns > 0.0 ? std::fmod(begun, 0.5 / drive.frequency) : 0.0;
    const std::vector<HalfPeriod> halves = profile.frequency > 0.0
                                               ? harmonic_phases(profile.frequency, begun, c.run.duration)
                                               : cornered_phases(profile.times, profile.velocities, half_begun);
    plan.spans.reserve(4 * halves.size());  // growing would take twice the memory
    for (const HalfPeriod& half : halves)
        add_phase(plan.spans, c, half);
    for (const Phase phase : {Phase::going, Phase::coming}) {
        const bool occurs = std::any_of(plan.spans.begin(), plan.spans.end(), [&](const Span& span) {
            return span.phase == phase && span.use != Use::unused;
        });
        if (occurs) plan.phases.push_back(phase);
    }
    return plan;
}

}  // namespace stridor::record
