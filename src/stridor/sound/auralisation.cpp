#include "stridor/sound/auralisation.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/elementary.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace stridor::sound {

namespace {

// a Butterworth high pass of second order by the bilinear transform (Oppenheim, Schafer, 7.1),
// its coefficients for b0 = 1
struct HighPass {
    double gain, a1, a2;
};

HighPass high_pass(double frequency, double rate) {
    // tan(pi f / rate)
    const base::SineCosine half = base::sine_cosine_of_turns(0.5 * frequency / rate);
    const double t = half.sine / half.cosine;
    const double scale = 1.0 / (1.0 + std::numbers::sqrt2 * t + t * t);
    return {scale, 2.0 * (t * t - 1.0) * scale, (1.0 - std::numbers::sqrt2 * t + t * t) * scale};
}

// transposed direct form II
void filter(std::vector<double>& samples, const HighPass& h, double (&memory)[2]) {
    for (double& sample : samples) {
        const double in = h.gain * sample;
        const double out = in + memory[0];
        memory[0] = -2.0 * in - h.a1 * out + memory[1];
        memory[1] = in - h.a2 * out;
        sample = out;
    }
}

// the motion of a point, sample by sample; motion of shape [dof][sample]
std::vector<double> weighted(const std::vector<std::vector<double>>& motion, const std::vector<double>& weights) {
    STRIDOR_EXPECT(motion.size() == weights.size());
    std::vector<double> sum(motion.front().size());
    for (std::size_t dof = 0; dof < weights.size(); ++dof) {
        if (weights[dof] == 0.0) continue;
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += weights[dof] * motion[dof][i];
    }
    return sum;
}

}  // namespace

std::vector<Stretch> stretches_of(const record::Schedule& schedule, record::Phase phase, record::Use least) {
    std::vector<Stretch> stretches;
    for (const record::Span& span : schedule.spans) {
        if (span.phase != phase || span.use == record::Use::unused || span.use < least) continue;
        // spans of one phase that touch are one stretch
        if (!stretches.empty() && stretches.back().to == span.from)
            stretches.back().to = span.to;
        else
            stretches.push_back({span.from, span.to});
    }
    return stretches;
}

double heard_until(const AuralisationSettings& settings, double duration) {
    constexpr double lead_out = 0.1;  // [s] some hundred taps at the lowest rate
    double to = 0.0;
    for (const Stretch& stretch : settings.stretches)
        to = std::max(to, stretch.to + lead_out);
    return settings.stretches.empty() ? duration : std::min(duration, to);
}

std::string unit_of(signal::MotionQuantity quantity) {
    return quantity == signal::MotionQuantity::velocity ? "m/s" : "m/s^2";
}

double fade_gain(const Stretch& stretch, double fade, double time) {
    const double inside = std::min(time - stretch.from, stretch.to - time);
    const double length = std::min(fade, 0.5 * (stretch.to - stretch.from));
    if (inside < 0.0) return 0.0;
    return inside >= length ? 1.0 : 0.5 - 0.5 * base::sine_cosine_of_turns(0.5 * inside / length).cosine;
}

Auralisation::Auralisation(AuralisationSettings settings) : settings_(std::move(settings)) {
    STRIDOR_EXPECT(settings_.rate > 0.0 && settings_.high_pass < 0.5 * settings_.rate);
}

record::TraceRequest Auralisation::request(double duration, std::function<void(std::span<const double>)> taker) {
    return {0.0, heard_until(settings_, duration), 1.0 / (settings_.rate * settings_.density),
            [this, taker = std::move(taker)](const record::Trace& trace) { taker(add(trace)); }};
}

std::vector<double> Auralisation::add(const record::Trace& trace) {
    if (trace.time.size() < 2 && !limiter_) return {};
    if (!limiter_) {
        // engines sample at their own steps: the interval is theirs
        const double interval = (trace.time.back() - trace.time.front()) / static_cast<double>(trace.time.size() - 1);
        limiter_.emplace(interval, settings_.rate, settings_.pickup.quantity);
        first_ = trace.time.front();
    }
    const Pickup& pickup = settings_.pickup;
    if (!pickup.weights.empty())
        return heard(
            limiter_->push({weighted(trace.displacement, pickup.weights), weighted(trace.velocity, pickup.weights),
                            weighted(trace.acceleration, pickup.weights)}));
    return heard(limiter_->push({trace.displacement.front(), trace.velocity.front(), trace.acceleration.front()}));
}

std::vector<double> Auralisation::finish() {
    return limiter_ ? heard(limiter_->finish()) : std::vector<double>();
}

// 0 outside the stretches; times only grow
double Auralisation::gain_at(double time) {
    while (stretch_ < settings_.stretches.size() && settings_.stretches[stretch_].to <= time)
        ++stretch_;
    if (stretch_ == settings_.stretches.size()) return 0.0;
    return fade_gain(settings_.stretches[stretch_], settings_.fade, time);
}

std::vector<double> Auralisation::heard(std::vector<double> motion) {
    if (motion.empty()) return {};
    if (settings_.high_pass > 0.0 && !has_begun_) {
        // as if the motion had always been what it is at its beginning
        memory_[1] = high_pass(settings_.high_pass, settings_.rate).gain * motion.front();
        memory_[0] = -memory_[1];
        has_begun_ = true;
    }
    if (settings_.high_pass > 0.0) filter(motion, high_pass(settings_.high_pass, settings_.rate), memory_);
    if (settings_.stretches.empty()) return motion;
    std::vector<double> sound;
    for (const double sample : motion) {
        const double time = first_ + static_cast<double>(count_++) / settings_.rate;
        const double gain = gain_at(time);
        if (stretch_ < settings_.stretches.size() && time >= settings_.stretches[stretch_].from)
            sound.push_back(gain * sample);
    }
    return sound;
}

signal::Signal auralise(const record::Trace& trace, const AuralisationSettings& settings) {
    Auralisation auralisation(settings);
    signal::Signal sound{settings.rate, unit_of(settings.pickup.quantity), auralisation.add(trace)};
    const std::vector<double> rest = auralisation.finish();
    sound.samples.insert(sound.samples.end(), rest.begin(), rest.end());
    return sound;
}

double peak(std::span<const double> samples) {
    double most = 0.0;
    for (const double sample : samples)
        most = std::max(most, std::abs(sample));
    return most;
}

}  // namespace stridor::sound
