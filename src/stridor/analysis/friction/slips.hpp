#pragma once

#include "stridor/analysis/friction/falls.hpp"
#include "stridor/model/laws/friction.hpp"

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace stridor::analysis {

/// The rig that measures: a slider of mass m, held by a spring k and a dashpot c, and dragged with the velocity V by
/// friction T. The force of the spring is what is recorded:
///
///     m x'' + c x' + k x = T        F = k x        w = V - x'
struct MeasuringRig {
    double mass = std::numeric_limits<double>::quiet_NaN();       // [kg] NaN: to be fitted
    double stiffness = std::numeric_limits<double>::quiet_NaN();  // [N/m] NaN: to be fitted
    double damping = 0.0;                                         // [N*s/m]
};

/// A recorded slip, from the end of the climb before it to its lowest force.
struct RecordedSlip {
    std::vector<double> force;  // [N] of the spring against the slip, shape [sample]
    double rate = 1.0;          // [Hz]
    double velocity = 0.0;      // [m/s] of the drive
    double normal_force = 1.0;  // [N]
    double onset = 0.0;         // [s] about when it lets go, after the first sample
    double limit = 0.0;         // [N] about the force at which it does
    double climb = 0.0;         // [N/s] about how fast the force grew before
};

/// Returns the slip of a fall of the force, shape [sample], of this direction; with no sample where it is too short to
/// tell anything.
RecordedSlip recorded_slip(const Fall& fall, std::span<const double> force, double rate);

/// Spring force [N] and its rate [N/s] at some times, shape [time].
struct SlipTrack {
    std::vector<double> force;
    std::vector<double> rate;
};

/// How a slip begins, and how finely it is followed.
struct SlipStart {
    double velocity = 0.0;  // [m/s] of the drive
    double limit = 0.0;     // [N] friction as it lets go
    double step = 1e-4;     // [s]
};

/// Returns the spring's force at times [s] that count from where the contact lets go and rise.
///
/// Before, the spring is wound up at the drive's velocity; then friction is the limit times the law's resistance, whose
/// mu_s is 1; once the slider is as fast as the drive it sticks again. Runge and Kutta's method of order 4 with steps
/// that begin at the release: so the force is smooth in all numbers. Between steps it is Hermite's cubic.
SlipTrack slip_track(const model::FrictionLaw& law, const MeasuringRig& rig, const SlipStart& start,
                     std::span<const double> times);

}  // namespace stridor::analysis
