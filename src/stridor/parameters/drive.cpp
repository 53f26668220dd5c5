#include "stridor/parameters/drive.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stridor::parameters {

namespace {

constexpr double two_pi = 6.283185307179586476925;

// x2 = A sin(2 pi f t)
VelocityProfile sinusoidal(const Drive& drive) {
    VelocityProfile profile;
    profile.velocity = drive.amplitude * two_pi * drive.frequency;
    profile.frequency = drive.frequency;
    profile.amplitude = drive.amplitude;
    return profile;
}

}  // namespace

std::string_view kind_name(const Drive& drive) {
    return drive_names[static_cast<std::size_t>(drive.kind)];
}

VelocityProfile velocity_profile(const Drive& drive, double) {
    switch (drive.kind) {
        case DriveKind::sinusoidal:
            return sinusoidal(drive);
        case DriveKind::constant:
            return {.velocity = drive.velocity, .times = {}, .velocities = {}};
        case DriveKind::sampled:
            return {.times = drive.times, .velocities = drive.velocities};
    }
    return {};
}

bool is_steady(const Drive& drive) {
    return drive.kind == DriveKind::constant;
}

double repetition_rate(const Drive& drive) {
    return drive.kind == DriveKind::sinusoidal ? drive.frequency : 0.0;
}

bool is_of_file(const Drive& drive) {
    return drive.kind == DriveKind::sampled;
}

Direction steady_direction(const Drive& drive) {
    return drive.velocity > 0.0 ? Direction::going : Direction::coming;
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
