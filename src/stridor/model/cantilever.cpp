#include "stridor/model/cantilever.hpp"

#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"

#include <cmath>

namespace stridor::model {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double logarithm_2_of_e = 1.4426950408889634074;

// cos x + 1/cosh x = 0 near x = (k - 1/2) pi, by Newton's steps; the functions' bits are our own
double clamped_free_root(int k) {
    double x = (k - 0.5) * pi;
    for (int step = 0; step < 8; ++step) {
        const double decay = base::power_of_2(-logarithm_2_of_e * x);  // exp(-x)
        const double secant = 2.0 * decay / (1.0 + decay * decay);     // 1/cosh x
        const double tangent = (1.0 - decay * decay) / (1.0 + decay * decay);
        const base::SineCosine turned = base::sine_cosine_of_turns(x / (2.0 * pi));
        x += (turned.cosine + secant) / (turned.sine + tangent * secant);
    }
    return x;
}

}  // namespace

double bending_frequency(const Cantilever& beam, int k) {
    const double beta = clamped_free_root(k) / beam.length;
    return beta * beta * std::sqrt(beam.bending_stiffness / beam.mass_per_length);
}

Structure cantilever(const Cantilever& beam, int bending_modes) {
    if (bending_modes < 1)
        throw Error(ErrorKind::input, {"a cantilever of " + std::to_string(bending_modes) + " modes cannot bend", "",
                                       "Take one at least."});
    Structure structure = structure_of_size(bending_modes + 1);
    const base::SineCosine angle = base::sine_cosine_of_degrees(beam.incidence_angle);
    const double mass = beam.mass_per_length * beam.length;
    ContactPoint& tip = structure.contacts.front();
    const auto add = [&](int mode, double omega, double moved, double along, double across) {
        structure.mass(mode, mode) = 1.0;
        structure.stiffness(mode, mode) = omega * omega;
        structure.damping(mode, mode) = 2.0 * beam.damping_ratio * omega;
        tip.tangent(mode) = moved * along;
        tip.normal(mode) = moved * across;
    };
    for (int k = 1; k <= bending_modes; ++k)
        add(k - 1, bending_frequency(beam, k), (k % 2 == 1 ? 2.0 : -2.0) / std::sqrt(mass), -angle.sine, angle.cosine);
    const double axial = 0.5 * pi / beam.length * std::sqrt(beam.axial_stiffness / beam.mass_per_length);
    add(bending_modes, axial, std::sqrt(2.0 / mass), angle.cosine, angle.sine);
    structure.load = -beam.preload * tip.normal;
    tip.friction = beam.friction;
    return structure;
}

}  // namespace stridor::model
