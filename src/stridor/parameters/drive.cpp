#include "stridor/parameters/drive.hpp"

#include "stridor/base/elementary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stridor::parameters {

namespace {

// x2 = A sin(2 pi f t)
VelocityProfile sinusoidal(const Drive& drive) {
    VelocityProfile profile;
    profile.velocity = drive.amplitude * base::two_pi * drive.frequency;
    profile.frequency = drive.frequency;
    profile.amplitude = drive.amplitude;
    profile.turns = turns_at_start(drive);
    return profile;
}

// There and back as rigs move: from rest to V in `ramp`, V, and to rest in `ramp`, within half a period; then -V. The
// corners of a slope through zero would be none: standing still is written at both ends alone.
VelocityProfile trapezoidal_from_rest(const Drive& drive, double until) {
    const double half_period = 0.5 / drive.frequency;
    const auto halves = static_cast<long>(std::floor(until / half_period)) + 1;
    VelocityProfile profile;
    const auto turn = [&](double time, double velocity) {
        if (!profile.times.empty() && time <= profile.times.back()) return;  // a triangle has one corner at its top
        profile.times.push_back(time);
        profile.velocities.push_back(velocity);
    };
    turn(0.0, 0.0);
    for (long half = 0; half < halves; ++half) {
        const double velocity = half % 2 == 0 ? drive.velocity : -drive.velocity;
        turn(static_cast<double>(half) * half_period + drive.ramp, velocity);
        turn(static_cast<double>(half + 1) * half_period - drive.ramp, velocity);
    }
    turn(static_cast<double>(halves) * half_period, 0.0);
    return profile;
}

// what is left of corners from a time on, which is 0 then
VelocityProfile begun_at(const VelocityProfile& whole, double begin) {
    VelocityProfile rest;
    for (std::size_t k = 0; k < whole.times.size(); ++k) {
        if (whole.times[k] <= begin) continue;
        if (rest.times.empty()) {
            const double from = whole.times[k - 1];
            const double share = (begin - from) / (whole.times[k] - from);
            rest.times.push_back(0.0);
            rest.velocities.push_back(whole.velocities[k - 1] +
                                      share * (whole.velocities[k] - whole.velocities[k - 1]));
        }
        rest.times.push_back(whole.times[k] - begin);
        rest.velocities.push_back(whole.velocities[k]);
    }
    return rest;
}

VelocityProfile trapezoidal(const Drive& drive, double until) {
    const double begin = turns_at_start(drive) / drive.frequency;
    if (begin == 0.0) return trapezoidal_from_rest(drive, until);
    return begun_at(trapezoidal_from_rest(drive, until + begin), begin);
}

}  // namespace

double turns_at_start(const Drive& drive) {
    const bool repeats = repetition_rate(drive) > 0.0 || is_by_force(drive);
    const double turns = repeats ? drive.phase / 360.0 : 0.0;
    return turns - std::floor(turns);
}

std::string_view kind_name(const Drive& drive) {
    return drive_names[static_cast<std::size_t>(drive.kind)];
}

VelocityProfile velocity_profile(const Drive& drive, double until) {
    switch (drive.kind) {
        case DriveKind::sinusoidal:
            return sinusoidal(drive);
        case DriveKind::constant:
            return {.velocity = drive.velocity, .times = {}, .velocities = {}};
        case DriveKind::sampled:
            return {.times = drive.times, .velocities = drive.velocities};
        case DriveKind::trapezoidal:
            return trapezoidal(drive, until);
        case DriveKind::force:
            return {.times = {}, .velocities = {}};
    }
    return {};
}

bool is_steady(const Drive& drive) {
    return drive.kind == DriveKind::constant;
}

bool has_one_phase(const Drive& drive) {
    return is_steady(drive) || is_by_force(drive);
}

bool is_by_force(const Drive& drive) {
    return drive.kind == DriveKind::force;
}

double repetition_rate(const Drive& drive) {
    const bool repeats = drive.kind == DriveKind::sinusoidal || drive.kind == DriveKind::trapezoidal;
    return repeats ? drive.frequency : 0.0;
}

bool is_of_file(const Drive& drive) {
    return drive.kind == DriveKind::sampled;
}

Direction steady_direction(const Drive& drive) {
    return drive.velocity > 0.0 ? Direction::going : Direction::coming;
}

std::vector<Direction> judged_directions(const Drive& drive) {
    if (has_one_phase(drive)) return {steady_direction(drive)};
    return {Direction::going, Direction::coming};
}

double greatest_speed(const Drive& drive) {
    if (is_of_file(drive)) return std::numeric_limits<double>::quiet_NaN();
    const VelocityProfile profile = velocity_profile(drive);
    double peak = std::abs(profile.velocity);
    for (const double velocity : profile.velocities)
        peak = std::max(peak, std::abs(velocity));
    return peak;
}

}  // namespace stridor::parameters
