#pragma once

#include "stridor/model/contact/contact_forces.hpp"
#include "stridor/parameters/drive.hpp"

#include <cstddef>
#include <vector>

namespace stridor::integration {

/// The imposed tangential motion x2(t) of the plate, prepared for a time step h.
///
/// Displacement increments are computed without cancellation and are pure functions of the step's number, so that
/// the same run has the same bits however it is cut into blocks.
class ImposedMotion {
public:
    /// `step` [s] is h; `increment` alone needs it. `until` [s] is as far as the motion is asked for.
    ImposedMotion(const parameters::Drive& drive, double step, double until = 0.0);

    /// Returns V(t), as the drive describes it.
    const parameters::VelocityProfile& profile() const { return profile_; }

    /// Returns velocity and acceleration at time t [s].
    model::SurfaceMotion at(double time) const;

    /// Returns x2((k+1) h) - x2(k h) [m].
    double increment(long k) const;

private:
    double cornered_position(double time) const;
    std::size_t corner_before(double time) const;

    parameters::VelocityProfile profile_;
    double step_;                    // [s]
    double chord_;                   // [m] steady: V h; harmonic: V/(pi f) sin(pi f h)
    std::vector<double> positions_;  // [m] x2 at the corners
};

/// Returns the force of a drive by force at time t [s], in N: F cos(2 pi (f t + turns)), with the turns at the start.
/// It grows by half a cosine over the ramp from the start on, so that nothing jumps. 0 of any other drive.
double imposed_force(const parameters::Drive& drive, double time);

}  // namespace stridor::integration
