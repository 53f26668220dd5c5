#include "stridor/integration/run/imposed_motion.hpp"

#include "stridor/base/elementary.hpp"

#include <algorithm>

// Harmonic: x2 = A sin(2 pi f t), so x2(t+h) - x2(t) = 2 A sin(pi f h) cos(2 pi f (t + h/2)), exact and free of
// cancellation. Cornered: V linear between corners, x2 its integral.
namespace stridor::integration {

namespace {}  // namespace

ImposedMotion::ImposedMotion(const parameters::Drive& drive, double step, double until)
    : profile_(parameters::velocity_profile(drive, until)),
      step_(step),
      chord_(profile_.velocity * step) {
    if (profile_.frequency > 0.0)
        chord_ = 2.0 * profile_.amplitude * base::sine_cosine_of_turns(0.5 * profile_.frequency * step).sine;
    const std::vector<double>& t = profile_.times;
    const std::vector<double>& v = profile_.velocities;
    positions_.assign(t.size(), 0.0);
    for (std::size_t k = 1; k < t.size(); ++k)
        positions_[k] = positions_[k - 1] + 0.5 * (v[k] + v[k - 1]) * (t[k] - t[k - 1]);
}

std::size_t ImposedMotion::corner_before(double time) const {
    const std::vector<double>& t = profile_.times;
    const auto after = std::upper_bound(t.begin(), t.end(), time);
    const auto number = static_cast<std::size_t>(after - t.begin());
    return std::clamp<std::size_t>(number, 1, t.size() - 1) - 1;
}

double ImposedMotion::cornered_position(double time) const {
    const std::size_t k = corner_before(time);
    const std::vector<double>& t = profile_.times;
    const std::vector<double>& v = profile_.velocities;
    const double slope = (v[k + 1] - v[k]) / (t[k + 1] - t[k]);
    const double since = time - t[k];
    return positions_[k] + since * (v[k] + 0.5 * slope * since);
}

model::SurfaceMotion ImposedMotion::at(double time) const {
    if (profile_.frequency > 0.0) {
        const base::SineCosine angle = base::sine_cosine_of_turns(profile_.frequency * time + profile_.turns);
        return {profile_.velocity * angle.cosine, -profile_.velocity * base::two_pi * profile_.frequency * angle.sine};
    }
    if (profile_.times.empty()) return {profile_.velocity, 0.0};
    const std::size_t k = corner_before(time);
    const std::vector<double>& t = profile_.times;
    const std::vector<double>& v = profile_.velocities;
    const double slope = (v[k + 1] - v[k]) / (t[k + 1] - t[k]);
    return {v[k] + slope * (time - t[k]), slope};
}

double ImposedMotion::increment(long k) const {
    const auto number = static_cast<double>(k);
    if (profile_.frequency > 0.0)
        return chord_ * base::sine_cosine_of_turns(profile_.frequency * step_ * (number + 0.5) + profile_.turns).cosine;
    if (profile_.times.empty()) return chord_;
    return cornered_position((number + 1.0) * step_) - cornered_position(number * step_);
}

double imposed_force(const parameters::Drive& drive, double time) {
    if (!parameters::is_by_force(drive)) return 0.0;
    const double turns = drive.frequency * time + parameters::turns_at_start(drive);
    const double whole = drive.force * base::sine_cosine_of_turns(turns).cosine;
    if (time >= drive.ramp) return whole;
    return whole * 0.5 * (1.0 - base::sine_cosine_of_turns(0.5 * time / drive.ramp).cosine);
}

}  // namespace stridor::integration
