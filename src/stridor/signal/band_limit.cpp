// The acceleration u" of a motion with impacts is a density with pulses. Over one interval from t₀ to t₁ = t₀ + h, with
// s = (t - t₀)/h, three of its moments are wanted:
//
//     ∫u" dt   = v₁ - v₀                     exact, whatever happened in between
//     ∫s u" dt = v₁ - (u₁ - u₀)/h            exact likewise
//     q = ∫s(1 - s) u" dt                    from a₀, a₁ and where the jump must lie to give the first two
//
// Pulses at the instants t₀ - h, t₀, t₁, t₁ + h with the weights
//
//     (0, v₁ - v₀ - m₁, m₁, 0) - q/4 (1, -1, -1, 1),   m₁ = ∫s u" dt
//
// have the same moments up to the third about the middle, so their spectrum differs from that of
// u" by O((ωh)³) only, however the motion jumps; a slow motion's by O((ωh)⁴). Their running sum is the velocity
// between the instants,
//
//     Vₖ₊½ = (uₖ₊₁ - uₖ)/h + (qₖ₋₁ - qₖ₊₁)/4,
//
// which cannot drift. A long low pass then takes the even samples down to the output's rate.

#include "stridor/signal/band_limit.hpp"

#include "stridor/base/check.hpp"

#include <algorithm>
#include <cmath>

namespace stridor::signal {

namespace {

// how far dv may be from the trapezoid of a₀ and a₁, as a share of it, before something must have jumped in between
constexpr double smoothness = 1e-2;

// output samples on either side that both low passes together reach, and some more
constexpr double reach_of_low_pass = 100.0;

struct Interval {
    double dv;     // [m/s] change of the velocity
    double first;  // [m/s] ∫s u" dt
    double ha0;    // [m/s] h a₀
    double ha1;    // [m/s] h a₁
};

// q with a jump J = dv - h(a₀ θ + a₁ (1 - θ)) at s = θ, the acceleration being a₀ before and a₁ after it
double curvature_with_jump(const Interval& i, double theta) {
    const double jump = i.dv - (i.ha0 * theta + i.ha1 * (1.0 - theta));
    const double before = theta * theta * (0.5 - theta / 3.0);
    return jump * theta * (1.0 - theta) + i.ha0 * before + i.ha1 * (1.0 / 6.0 - before);
}

bool is_inside(double theta) {
    return theta >= 0.0 && theta <= 1.0;
}

// where one jump explains both moments: a quadratic equation in θ; with several jumps, their centre
double place_of_jump(const Interval& i) {
    const double a = -0.5 * (i.ha0 - i.ha1);
    const double b = i.dv - i.ha1;
    const double c = 0.5 * i.ha1 - i.first;
    const double discriminant = b * b - 4.0 * a * c;
    if (discriminant >= 0.0) {
        const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
        if (q != 0.0 && is_inside(c / q)) return c / q;
        if (a != 0.0 && is_inside(q / a)) return q / a;
    }
    const double pulse = i.dv - 0.5 * (i.ha0 + i.ha1);
    return std::clamp((i.first - i.ha0 / 6.0 - i.ha1 / 3.0) / pulse, 0.0, 1.0);
}

double curvature(const Interval& i) {
    const double pulse = i.dv - 0.5 * (i.ha0 + i.ha1);
    if (std::abs(pulse) <= smoothness * (std::abs(i.ha0) + std::abs(i.ha1))) return (i.ha0 + i.ha1) / 12.0;
    return curvature_with_jump(i, place_of_jump(i));
}

// whole number of input samples per sample of the rate in between, which is at least twice the output's
int first_step(double interval, double rate) {
    return std::max(1, static_cast<int>(std::floor(0.5 / (interval * rate) + 1e-9)));
}

// the first low pass only keeps clear what the second one lets through
LowPass first_low_pass(double interval, double rate) {
    return {0.45 * rate * interval, 1.0 / first_step(interval, rate) - 0.5 * rate * interval};
}

LowPass second_low_pass(RateRatio ratio) {
    // the lower rate is the output's
    const double output = 1.0 / ratio.down;
    return {0.45 * output, 0.5 * output};
}

RateRatio second_ratio(double interval, double rate) {
    return rate_ratio(1.0 / (interval * first_step(interval, rate)), rate);
}

}  // namespace

BandLimiter::BandLimiter(double interval, double rate, MotionQuantity quantity)
    : interval_(interval),
      share_(interval * rate),
      quantity_(quantity),
      coarse_({1, first_step(interval, rate)}, first_low_pass(interval, rate)),
      fine_(second_ratio(interval, rate), second_low_pass(second_ratio(interval, rate))) {
    STRIDOR_EXPECT(interval > 0.0 && 4.0 * interval * rate <= 1.0 + 1e-9);
}

// the velocity or acceleration at the instant between the second and the third of the last four means
void BandLimiter::add_mean(double mean) {
    std::rotate(means_.begin(), means_.begin() + 1, means_.end());
    means_.back() = mean;
    // the first two belong to the time before the first sample
    if (++mean_count_ < 3) return;
    points_.push_back(quantity_ == MotionQuantity::acceleration
                          ? (means_[2] - means_[1]) / interval_
                          : (13.0 * (means_[1] + means_[2]) - (means_[0] + means_[3])) / 24.0 - first_velocity_);
}

void BandLimiter::add_interval(double slope, double kink) {
    std::rotate(kinks_.begin(), kinks_.begin() + 1, kinks_.end());
    kinks_.back() = kink;
    add_mean(slope_ + 0.25 * (kinks_[0] - kinks_[2]));
    slope_ = slope;
}

void BandLimiter::add_sample(double displacement, double velocity, double acceleration) {
    if (samples_++ == 0) {
        // before the beginning the velocity is what it is there
        first_velocity_ = slope_ = velocity;
        means_.fill(velocity);
    } else {
        const double slope = (displacement - displacement_) / interval_;
        const Interval i{velocity - velocity_, velocity - slope, interval_ * acceleration_, interval_ * acceleration};
        add_interval(slope, curvature(i));
    }
    displacement_ = displacement;
    velocity_ = velocity;
    acceleration_ = acceleration;
}

// takes the points down to the output's rate
std::vector<double> BandLimiter::filtered() {
    std::vector<double> output = fine_.push(coarse_.push(points_));
    points_.clear();
    if (quantity_ == MotionQuantity::velocity)
        for (double& sample : output)
            sample += first_velocity_;
    produced_ += output.size();
    return output;
}

std::vector<double> BandLimiter::push(const MotionSamples& motion) {
    STRIDOR_EXPECT(motion.displacement.size() == motion.velocity.size());
    STRIDOR_EXPECT(motion.displacement.size() == motion.acceleration.size());
    for (std::size_t k = 0; k < motion.displacement.size(); ++k)
        add_sample(motion.displacement[k], motion.velocity[k], motion.acceleration[k]);
    return filtered();
}

std::vector<double> BandLimiter::finish() {
    if (samples_ == 0) return {};
    const std::size_t before = produced_;
    const auto count = static_cast<std::size_t>(std::floor(static_cast<double>(samples_ - 1) * share_ + 1e-6)) + 1;
    // after the end the velocity stays what it is there, for as long as the low passes reach
    const auto reach = static_cast<std::size_t>(std::ceil(reach_of_low_pass / share_));
    for (std::size_t k = 0; k < reach; ++k)
        add_interval(velocity_, 0.0);
    std::vector<double> output = filtered();
    output.resize(count - before);
    return output;
}

}  // namespace stridor::signal
