#pragma once

#include "stridor/model/contact_forces.hpp"
#include "stridor/parameters/case.hpp"

#include <cstddef>
#include <vector>

namespace stridor::integration {

/// The imposed tangential motion x2(t) of the plate, prepared for a time step h.
///
/// Displacement increments are computed without cancellation and are pure functions of the step's number, so that
/// the same run has the same bits however it is cut into blocks.
class ImposedMotion {
public:
    /// `step` [s] is h; `increment` alone needs it.
    ImposedMotion(const parameters::Drive& drive, double step);

    /// Velocity and acceleration at time t [s].
    model::SurfaceMotion at(double time) const;

    /// x2((k+1) h) - x2(k h) [m].
    double increment(long k) const;

private:
    double sampled_position(double time) const;
    std::size_t sample_before(double time) const;

    parameters::DriveKind kind_;
    double step_;                     // [s]
    double velocity_;                 // [m/s] constant: V; sinusoidal: peak of V
    double frequency_;                // [Hz]
    double chord_;                    // [m] constant: V h; sinusoidal: 2 A sin(pi f h)
    std::vector<double> times_;       // [s]
    std::vector<double> velocities_;  // [m/s]
    std::vector<double> positions_;   // [m] x2 at the samples
};

}  // namespace stridor::integration
