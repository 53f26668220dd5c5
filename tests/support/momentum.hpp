#pragma once

#include "stridor/integration/run/motion.hpp"
#include "stridor/model/built/case_structure.hpp"
#include "stridor/model/linear/complement.hpp"
#include "stridor/parameters/rules/engines.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace stridor::support {

/// How well the momentum of all bodies balances over the judged time of a run.
///
///     M (v1 - v0) + C (u1 - u0) + integral of (K u - f0) = sum over contacts of n P + t Q
///
/// with the impulses P of the normal forces, impacts included, as the loads of the record have them. Along directions
/// that no tangent pushes nothing else is left. The integral is that of the run's own trace, by trapezoids: of a motion
/// at omega their error is (omega h)^2 / 12 of it.
struct Balance {
    double residual = 0.0;  // [N*s] largest along a direction that no tangent pushes
    double impulses = 0.0;  // [N*s] sum of those of all contacts
    bool separates = false;
};

/// Most of the residual beside the impulses: omega h of the fastest modes is some 1e-2, and that makes 1e-5, of several
/// springs together.
inline constexpr double trapezoids = 2e-4;

/// What is to be traced of a run of constant drive, so that its momentum may be balanced.
inline record::Request request_of_balance(const parameters::Case& c, double interval) {
    record::Request request;
    request.trace = {.from = c.run.duration - c.run.window, .to = c.run.duration, .interval = interval};
    return request;
}

/// Row values of one sample of a trace.
inline Eigen::VectorXd at(const std::vector<std::vector<double>>& samples, std::size_t n) {
    Eigen::VectorXd values(static_cast<Eigen::Index>(samples.size()));
    for (std::size_t row = 0; row < samples.size(); ++row)
        values(static_cast<Eigen::Index>(row)) = samples[row][n];
    return values;
}

/// Trapezoids over time, in units of the trace's interval.
inline Eigen::VectorXd sum_of(const std::vector<std::vector<double>>& samples) {
    Eigen::VectorXd sum(static_cast<Eigen::Index>(samples.size()));
    for (std::size_t row = 0; row < samples.size(); ++row) {
        double all = -0.5 * (samples[row].front() + samples[row].back());
        for (const double each : samples[row])
            all += each;
        sum(static_cast<Eigen::Index>(row)) = all;
    }
    return sum;
}

/// What contacts have pushed over a run with the trace of `request_of_balance`, as bodies, springs, dashpots and loads
/// tell it: the left side of the balance. Shape [row].
inline Eigen::VectorXd pushed_by_contacts(const parameters::Case& c, const model::Structure& structure,
                                          const record::Trace& trace, double interval) {
    const std::size_t last = trace.time.size() - 1;
    // where contacts have no inertia momentum is that of the modes that keep theirs
    const Eigen::VectorXd gained = parameters::is_without_inertia(c)
                                       ? Eigen::VectorXd(interval * sum_of(trace.acceleration))
                                       : Eigen::VectorXd(at(trace.velocity, last) - at(trace.velocity, 0));
    return structure.mass * gained + structure.damping * (at(trace.displacement, last) - at(trace.displacement, 0)) +
           interval * (structure.stiffness * sum_of(trace.displacement)) -
           (trace.time.back() - trace.time.front()) * structure.load;
}

/// The balance of a run with the trace of `request_of_balance`.
inline Balance balance_of(const parameters::Case& c, const integration::Motion& motion, double interval) {
    const model::Structure structure = model::structure_of(c);
    Eigen::VectorXd rest = pushed_by_contacts(c, structure, motion.record.trace, interval);
    Balance balance;
    Eigen::MatrixXd tangents(rest.size(), static_cast<Eigen::Index>(structure.contacts.size()));
    for (std::size_t k = 0; k < structure.contacts.size(); ++k) {
        const record::ContactTally& tally = motion.record.phases.front().contacts[k];
        rest -= tally.load.normal_impulse * structure.contacts[k].normal;
        balance.impulses += tally.load.normal_impulse;
        tangents.col(static_cast<Eigen::Index>(k)) = structure.contacts[k].tangent;
        balance.separates |= tally.judged_time[model::index_of(model::ContactState::separation)] > 0.0;
    }
    balance.residual = (model::orthogonal_complement(tangents).transpose() * rest).cwiseAbs().maxCoeff();
    return balance;
}

/// How far the momentum of a run of one contact, traced from its beginning to its end, is from what friction pushes
/// [N*s]: largest along a direction that the normal does not push. Over a whole run of constant drive the work of the
/// drive is V times the impulse of friction, impacts included, whether or not the engine records impulses.
inline double friction_residual(const parameters::Case& c, const integration::Motion& motion, double interval) {
    const model::Structure structure = model::structure_of(c);
    const model::ContactPoint& contact = structure.contacts.front();
    const double friction_impulse = motion.energy.drive_work / c.drive.velocity;
    const Eigen::VectorXd rest =
        pushed_by_contacts(c, structure, motion.record.trace, interval) - friction_impulse * contact.tangent;
    return (model::orthogonal_complement(contact.normal).transpose() * rest).cwiseAbs().maxCoeff();
}

}  // namespace stridor::support
