// Sinusoidal: x2 = A sin(2 pi f t), so x2(t+h) - x2(t) = 2 A sin(pi f h) cos(2 pi f (t + h/2)), exact and free of
// cancellation. Sampled: V linear between samples, x2 its integral.

#include "stridor/integration/imposed_motion.hpp"

#include "stridor/base/elementary.hpp"

#include <algorithm>

namespace stridor::integration {

using parameters::DriveKind;

namespace {

constexpr double two_pi = 6.283185307179586476925;

}  // namespace

ImposedMotion::ImposedMotion(const parameters::Drive& drive, double step)
    : kind_(drive.kind),
      step_(step),
      velocity_(drive.velocity),
      frequency_(drive.frequency),
      chord_(drive.velocity * step) {
    if (kind_ == DriveKind::sinusoidal) {
        velocity_ = drive.amplitude * two_pi * drive.frequency;
        chord_ = 2.0 * drive.amplitude * base::sine_cosine_of_turns(0.5 * drive.frequency * step).sine;
    }
    if (kind_ != DriveKind::sampled) return;
    times_ = drive.times;
    velocities_ = drive.velocities;
    positions_.assign(times_.size(), 0.0);
    for (std::size_t k = 1; k < times_.size(); ++k)
        positions_[k] = positions_[k - 1] + 0.5 * (velocities_[k] + velocities_[k - 1]) * (times_[k] - times_[k - 1]);
}

std::size_t ImposedMotion::sample_before(double time) const {
    const auto after = std::upper_bound(times_.begin(), times_.end(), time);
    const auto number = static_cast<std::size_t>(after - times_.begin());
    return std::clamp<std::size_t>(number, 1, times_.size() - 1) - 1;
}

double ImposedMotion::sampled_position(double time) const {
    const std::size_t k = sample_before(time);
    const double slope = (velocities_[k + 1] - velocities_[k]) / (times_[k + 1] - times_[k]);
    const double since = time - times_[k];
    return positions_[k] + since * (velocities_[k] + 0.5 * slope * since);
}

model::SurfaceMotion ImposedMotion::at(double time) const {
    if (kind_ == DriveKind::constant) return {velocity_, 0.0};
    if (kind_ == DriveKind::sinusoidal) {
        const base::SineCosine angle = base::sine_cosine_of_turns(frequency_ * time);
        return {velocity_ * angle.cosine, -velocity_ * two_pi * frequency_ * angle.sine};
    }
    const std::size_t k = sample_before(time);
    const double slope = (velocities_[k + 1] - velocities_[k]) / (times_[k + 1] - times_[k]);
    return {velocities_[k] + slope * (time - times_[k]), slope};
}

double ImposedMotion::increment(long k) const {
    const auto number = static_cast<double>(k);
    switch (kind_) {
        case DriveKind::constant:
            return chord_;
        case DriveKind::sinusoidal:
            return chord_ * base::sine_cosine_of_turns(frequency_ * step_ * (number + 0.5)).cosine;
        case DriveKind::sampled:
            return sampled_position((number + 1.0) * step_) - sampled_position(number * step_);
    }
    return 0.0;
}

}  // namespace stridor::integration
