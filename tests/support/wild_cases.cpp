#include "support/wild_cases.hpp"

#include "support/counter_random.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace stridor::support {

namespace {

using namespace parameters;

double any_angle(CounterRandom& random) {
    constexpr std::array<double, 8> special{0.0, 90.0, 180.0, 45.0, 135.0, -90.0, 90.0 + 1e-6, 60.0};
    return random.one_in(3) ? special[random.below(special.size())] : random.between(0.0, 180.0);
}

double damping(CounterRandom& random) {
    return random.one_in(4) ? 0.0 : random.decades(1e-4, 1e4);
}

// [rad/s] of mass 1 and mass 2 on their own springs
double slowest_rate(const Case& c) {
    const double soft = std::min(c.joint().axial_stiffness, c.joint().flexural_stiffness);
    return std::min(std::sqrt(soft / c.joint().mass), std::sqrt(c.plate.stiffness / c.plate.mass));
}

void choose_drive(Case& c, CounterRandom& random) {
    const double speed = random.decades(1e-6, 1e2) * (random.one_in(2) ? 1.0 : -1.0);
    switch (random.below(3)) {
        case 0:
            c.drive.kind = DriveKind::constant;
            c.drive.velocity = speed;
            return;
        case 1: {
            c.drive.kind = DriveKind::sinusoidal;
            const double least = 1.6 / c.run.duration;  // one and a half periods, as a valid case has
            c.drive.frequency = random.decades(least, std::max(2.0 * least, 0.05 * fastest_rate(c)));
            c.drive.amplitude = std::abs(speed) / (6.28 * c.drive.frequency);
            return;
        }
        default: {
            c.drive.kind = DriveKind::sampled;
            const std::size_t count = 2 + random.below(12);
            double time = 0.0;
            for (std::size_t k = 0; k < count; ++k) {
                // stretches of constant velocity, of standing still, and reversals
                const bool repeats = k > 0 && random.one_in(4);
                const double velocity = repeats            ? c.drive.velocities.back()
                                        : random.one_in(5) ? 0.0
                                                           : speed * random.between(-1.0, 1.0);
                c.drive.times.push_back(time);
                c.drive.velocities.push_back(velocity);
                time += random.decades(1e-4, 1.0);
            }
            const double stretch = c.run.duration * (1.0 + random.between(0.0, 0.1)) / c.drive.times.back();
            for (double& t : c.drive.times)
                t *= stretch;
            c.drive.times.back() = std::max(c.drive.times.back(), c.run.duration);
        }
    }
}

}  // namespace

double fastest_rate(const Case& c) {
    const double stiff = std::max(c.joint().axial_stiffness, c.joint().flexural_stiffness);
    const double damped = std::max(c.joint().axial_damping, c.joint().flexural_damping);
    const double vibration = std::sqrt((stiff + c.plate.stiffness) / std::min(c.joint().mass, c.plate.mass) *
                                       (1.0 + c.contact().kinetic_friction));
    const double decay =
        (damped + c.plate.damping) / std::min(c.joint().mass, c.plate.mass) * (1.0 + c.contact().kinetic_friction);
    const double drive = c.drive.kind == DriveKind::sinusoidal ? 6.28 * c.drive.frequency : 0.0;
    return std::max({vibration, decay, drive});
}

Case wild_case(std::uint64_t number) {
    CounterRandom random(number);
    Case c;
    c.joint().mass = random.decades(1e-3, 1e2);
    c.joint().axial_stiffness = random.decades(1e3, 1e9);
    c.joint().flexural_stiffness = random.one_in(8) ? c.joint().axial_stiffness : random.decades(1e3, 1e9);
    c.joint().axial_damping = damping(random);
    c.joint().flexural_damping = damping(random);
    c.joint().incidence_angle = any_angle(random);
    c.plate.mass = random.one_in(8) ? c.joint().mass : random.decades(1e-3, 1e2);
    c.plate.stiffness = random.decades(1e3, 1e9);
    c.plate.damping = damping(random);
    c.contact().preload = random.decades(1e-3, 1e5);
    c.contact().static_friction = random.one_in(8) ? 0.0 : random.between(0.0, 3.0);
    c.contact().kinetic_friction = random.one_in(4)   ? c.contact().static_friction
                                   : random.one_in(6) ? 0.0
                                                      : c.contact().static_friction * random.between(0.0, 1.0);
    c.contact().impact =
        std::array{ImpactKind::plastic, ImpactKind::normal_only, ImpactKind::restitution}[random.below(3)];
    c.contact().restitution = random.one_in(6) ? static_cast<double>(random.below(2)) : random.between(0.0, 1.0);
    c.run.initial = std::array{Initial::rest, Initial::stuck, Initial::sliding}[random.below(3)];
    c.run.perturbation = random.one_in(4) ? 0.0 : random.decades(1e-6, 1e2);

    c.contact().kinetic_friction = std::min(c.contact().kinetic_friction, c.contact().static_friction);
    const double most_steps = random.decades(30.0, 3000.0);
    c.run.duration = std::min(20.0 * 6.28 / slowest_rate(c), most_steps / fastest_rate(c));
    c.run.window = c.run.duration;
    choose_drive(c, random);
    c.run.engine = Engine::exact;
    if (random.one_in(5)) {
        c.contact().friction = FrictionKind::directional;
        c.contact().static_friction_coming = c.contact().static_friction * random.between(0.1, 1.0);
        c.contact().kinetic_friction_coming = c.contact().static_friction_coming * random.between(0.0, 1.0);
    }
    return c;
}

}  // namespace stridor::support
