#pragma once

#include "stridor/integration/exact/account.hpp"
#include "stridor/integration/proofs/lyapunov.hpp"
#include "stridor/integration/run/motion.hpp"
#include "stridor/record/schedule.hpp"

#include <Eigen/Core>

#include <optional>

namespace stridor::integration {

/// Steady sliding of a structure under a constant drive, and how far from it a motion can still get.
///
/// The distance e from the sliding equilibrium obeys e' = A e. With P of A'P + P A = -Q the number e.P e never grows,
/// and bounds N and w for ever (proofs/lyapunov.hpp).
class Sliding {
public:
    /// `flow` is the slip state of steady sliding; `load_scale` F [N] and `velocity` V [m/s] are those of the run.
    Sliding(const Flow& flow, double load_scale, double velocity);

    /// Returns a proof that the contact slips for ever from this state on, with N > 0 and w != 0; nothing if there is
    /// none.
    std::optional<Silence> silence(const Lanes& s, double time) const;

    /// Adds the vibration of the next `duration` [s] to the account, if it is judged, and moves the state to its end.
    /// Peaks are those of the first thousand steps.
    void pass(const Kernel& kernel, double duration, record::Use use, Lanes& s, Account& account) const;

private:
    static constexpr int most = 2 * (most_coordinates - 1);
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, most, most>;
    using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, most, 1>;

    Vector distance(const Lanes& s) const;

    const Flow& flow_;
    Vector equilibrium_;  // positions and velocities
    Matrix generator_;    // [1/s] A
    LastingBound<Matrix> bound_;
    double normal_force_ = 0.0;   // [N] at the equilibrium
    double slip_velocity_ = 0.0;  // [m/s] |w| there
    double normal_gain_ = 0.0;    // sqrt(c.P⁻¹c) for N
    double velocity_gain_ = 0.0;  // for w
};

}  // namespace stridor::integration
