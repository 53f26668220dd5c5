#pragma once

#include "stridor/integration/run/initial_state.hpp"
#include "stridor/integration/series/taylor.hpp"
#include "stridor/integration/steps/moreau.hpp"
#include "stridor/model/built/joints_on_plate.hpp"
#include "stridor/record/schedule.hpp"
#include "support/effort.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

/// Structures with several contacts and their runs over a surface of constant velocity, for tests of the engines.
namespace stridor::support {

// places of the states among a contact's shares
inline constexpr std::size_t slip_share = model::index_of(model::ContactState::slip);
inline constexpr std::size_t stick_share = model::index_of(model::ContactState::stick);
inline constexpr std::size_t open_share = model::index_of(model::ContactState::separation);

/// The run came to its end and kept its energy balance.
inline void expect_sound(const integration::Motion& motion) {
    EXPECT_EQ(motion.outcome.reason, integration::Reason::completed);
    EXPECT_LT(std::abs(motion.energy.relative_residual()), 1e-10);
}

/// Shares of the window in each state, shape [contact][state] as `model::index_of`.
inline std::vector<std::array<double, 3>> shares(const integration::Motion& motion) {
    std::vector<std::array<double, 3>> result;
    for (const record::ContactTally& contact : motion.record.phases.front().contacts) {
        const double sum = contact.time[0] + contact.time[1] + contact.time[2];
        result.push_back({contact.time[0] / sum, contact.time[1] / sum, contact.time[2] / sum});
    }
    return result;
}

/// How long a run is, and the last part of it that counts.
struct Watched {
    double duration = 2.0;  // [s]
    double window = 1.0;    // [s]
};

/// The strip of rubber never repeats: its shares are means, which scatter less the longer it is watched.
inline constexpr Watched strip_watched{effort(1.1, 0.3), effort(1.0, 0.2)};
inline constexpr double strip_scatter = effort(0.003, 0.03);  // [1] of its mean shares

inline parameters::Case watched_case(double velocity, const Watched& watched) {
    parameters::Case c;
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = velocity;
    c.run.duration = watched.duration;
    c.run.window = watched.window;
    return c;
}

/// A run by the Taylor engine that keeps its histories.
inline integration::Motion run_taylor(const model::Structure& structure, double velocity,
                                      const integration::InitialState& start, const Watched& watched = {}) {
    const parameters::Case c = watched_case(velocity, watched);
    record::Request request;
    request.history = record::KeepHistory::yes;
    record::Recorder recorder(record::schedule(c), request, model::dofs_of(structure),
                              static_cast<int>(structure.contacts.size()), model::channels_of(structure),
                              model::interfaces_of(structure));
    return integration::integrate_taylor(structure, c.drive, start, {parameters::EarlyEnding::never},
                                         std::move(recorder));
}

inline integration::Motion run_taylor(const model::Structure& structure, double velocity, parameters::Initial initial,
                                      const Watched& watched = {}) {
    return run_taylor(structure, velocity, integration::initial_state(structure, {initial, 0.0}, velocity), watched);
}

/// A run by Moreau's time stepping that keeps its histories.
inline integration::Motion run_moreau(const model::Structure& structure, double velocity,
                                      const integration::InitialState& start, double step,
                                      const Watched& watched = {}) {
    const parameters::Case c = watched_case(velocity, watched);
    record::Request request;
    request.history = record::KeepHistory::yes;
    record::Recorder recorder(record::schedule(c), request, model::dofs_of(structure),
                              static_cast<int>(structure.contacts.size()));
    return integration::integrate_moreau(structure, c.drive, start, {step}, std::move(recorder));
}

inline integration::Motion run_moreau(const model::Structure& structure, double velocity, parameters::Initial initial,
                                      double step, const Watched& watched = {}) {
    return run_moreau(structure, velocity, integration::initial_state(structure, {initial, 0.0}, velocity), step,
                      watched);
}

/// Table 1's joint with other numbers.
inline model::PlateJoint plate_joint(double preload, double kinetic_friction, double angle = 70.0) {
    model::PlateJoint joint;
    joint.joint.incidence_angle = angle;
    joint.contact.preload = preload;
    joint.contact.kinetic_friction = kinetic_friction;
    return joint;
}

/// Joints on Table 1's plate.
inline model::Structure plate_of(const std::vector<model::PlateJoint>& joints) {
    return model::joints_on_plate(joints, parameters::Plate{});
}

/// Painleve's configuration by inertia: n = (0, 1), t = (1, 0), W_nn + mu_d W_nt < 0 for mu_d > 1.25 where it slips
/// backward, that is over a surface with V > 0.
inline model::Structure painleve_example(double kinetic_friction) {
    model::Structure structure = model::structure_of_size(2);
    structure.mass << 1.0, 0.8, 0.8, 1.0;
    structure.stiffness = 100.0 * Eigen::Matrix2d::Identity();
    structure.damping = 0.1 * Eigen::Matrix2d::Identity();
    structure.load << 0.0, -1.0;
    model::ContactPoint& contact = structure.contacts.front();
    contact.normal << 0.0, 1.0;
    contact.tangent << 1.0, 0.0;
    contact.friction = model::Coulomb{1.5, kinetic_friction};
    return structure;
}

/// Code_Aster's SDND106 (V5.01.106): two masses of 5 kg, a spring of 1e4 N/m between, the first pressed on the ground
/// by 1e4 N, mu_s = 0.3, mu_d = 0.2; a force pulls the second. Along and across of the first, along of the second.
inline model::Structure two_masses(double pull) {
    model::Structure structure = model::structure_of_size(3);
    structure.mass.diagonal() << 5.0, 5.0, 5.0;
    structure.stiffness << 1e4, 0, -1e4, 0, 0, 0, -1e4, 0, 1e4;
    structure.load << 0.0, -1e4, pull;
    structure.contacts.front().normal << 0.0, 1.0, 0.0;
    structure.contacts.front().tangent << 1.0, 0.0, 0.0;
    structure.contacts.front().friction = model::Coulomb{0.3, 0.2};
    return structure;
}

}  // namespace stridor::support
