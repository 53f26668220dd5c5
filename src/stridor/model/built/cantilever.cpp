#include "stridor/model/built/cantilever.hpp"

#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"

#include <cmath>

namespace stridor::model {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double logarithm_2_of_e = 1.4426950408889634074;

// exp(x); below 1e-300 it is nothing beside what it is added to
double exponential(double x) {
    constexpr double least = -690.0;
    return x < least ? 0.0 : base::power_of_2(logarithm_2_of_e * x);
}

// cos x + 1/cosh x = 0 near x = (k - 1/2) pi, by Newton's steps; the functions' bits are our own
double clamped_free_root(int k) {
    double x = (k - 0.5) * pi;
    for (int step = 0; step < 8; ++step) {
        const double decay = exponential(-x);
        const double secant = 2.0 * decay / (1.0 + decay * decay);  // 1/cosh x
        const double tangent = (1.0 - decay * decay) / (1.0 + decay * decay);
        const base::SineCosine turned = base::sine_cosine_of_turns(x / (2.0 * pi));
        x += (turned.cosine + secant) / (turned.sine + tangent * secant);
    }
    return x;
}

// cosh s - cos s - q (sinh s - sin s), s = root * place: of a beam as long as 1 and of the mean square 1. The growing
// and the decaying exponential stand by themselves, else they would cancel in high modes.
double clamped_free_shape(int k, double place) {
    const double b = clamped_free_root(k);
    const double s = b * place;
    const base::SineCosine end = base::sine_cosine_of_turns(b / (2.0 * pi));
    const base::SineCosine here = base::sine_cosine_of_turns(s / (2.0 * pi));
    const double decay = exponential(-b);
    const double whole = 1.0 - decay * decay + 2.0 * decay * end.sine;     // 2 exp(-b) (sinh b + sin b)
    const double missing = 2.0 * (end.sine - end.cosine - decay) / whole;  // exp(b) (1 - q)
    const double q = 1.0 - missing * decay;
    return 0.5 * (missing * exponential(s - b) + (1.0 + q) * exponential(-s)) - here.cosine + q * here.sine;
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

BeamShape cantilever_shape(const Cantilever& beam, int bending_modes, double place) {
    const base::SineCosine angle = base::sine_cosine_of_degrees(beam.incidence_angle);
    const double mass = beam.mass_per_length * beam.length;
    Eigen::VectorXd bending = Eigen::VectorXd::Zero(bending_modes + 1);
    Eigen::VectorXd axial = bending;
    for (int k = 1; k <= bending_modes; ++k)
        bending(k - 1) = clamped_free_shape(k, place) / std::sqrt(mass);
    axial(bending_modes) = std::sqrt(2.0 / mass) * base::sine_cosine_of_turns(0.25 * place).sine;
    return {angle.cosine * axial - angle.sine * bending, angle.sine * axial + angle.cosine * bending};
}

}  // namespace stridor::model
