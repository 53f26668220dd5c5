#pragma once

#include "stridor/base/decompositions.hpp"
#include "stridor/integration/modal/modal_structure.hpp"
#include "stridor/integration/proofs/lyapunov.hpp"
#include "stridor/integration/rules/contact_mode.hpp"
#include "stridor/integration/run/motion.hpp"
#include "stridor/record/tally.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace stridor::integration {

/// Schur decompositions and Gramians of larger structures cost more than proofs save.
inline constexpr std::size_t most_proven_modes = 100;

/// A set of contact modes over a surface of constant velocity: does it last for ever?
///
/// Within a set the motion is a forced part, linear in time, and a rest e that friction may feed, of which a number
/// e.P e never grows (lyapunov.hpp). If every event function's forced part stays above what that bounds, no contact
/// ever changes. Derivation: lasting_set.cpp.
class LastingSet {
public:
    /// `velocity` [m/s] is the surface's.
    LastingSet(const ModalStructure& structure, std::vector<ContactMode> set, double velocity);

    /// Returns what is known of each contact if the set holds now, at `time` [s], and each has been in its state since
    /// then [s]; shape [contact] in the structure's own order. Nothing is known of the future of any but those whose
    /// margin the forced part itself uses up if the set is not proven to last.
    std::vector<record::Outlook> outlooks(std::span<const double> q, std::span<const double> v, double time,
                                          std::span<const double> since) const;

    /// Returns the bounds of normal forces and slip velocities that hold from now on, if all contacts slip for ever and
    /// something vibrates.
    std::optional<Silence> silence(std::span<const double> q, std::span<const double> v, double time) const;

    const std::vector<ContactMode>& set() const { return set_; }

    /// A whole set that slips: the motion after `duration` [s], and what it leaves behind on the way.
    struct Passed {
        Eigen::VectorXd q, v;             // at its end
        Eigen::VectorXd square_time;      // [m²/s] integral of the square velocity of each channel
        std::vector<record::Load> loads;  // shape [contact]; heat without that of the vibration itself
    };
    Passed pass(std::span<const double> q, std::span<const double> v, double duration);

private:
    // what an event function is made of: value + slope * time + deviation . e
    struct Margin {
        std::size_t contact = 0;
        bool is_normal_force = false;
        bool is_slip_velocity = false;
        double slope = 0.0;         // [N/s], [m/s]
        double slope_zero = 0.0;    // what rounding may make of it
        Eigen::RowVectorXd of_q0;   // value by the coordinates of the forced part
        double constant = 0.0;      // and the rest of it
        Eigen::VectorXd deviation;  // by e
        double gain = 0.0;          // sqrt(c.P⁻¹c)
    };

    struct Now {
        Eigen::VectorXd q0;  // coordinates of the forced part
        Eigen::VectorXd e;
        double size = 0.0;  // sqrt(e.P e)
    };

    void add_margins(const Eigen::MatrixXd& force_rows, double velocity);
    void add_margin(std::size_t contact, const Eigen::RowVectorXd& of_q, const Eigen::RowVectorXd& of_v,
                    double constant);
    void bound_vibration();
    Now now(std::span<const double> q, std::span<const double> v) const;
    double value(const Margin& margin, const Now& now) const;
    bool lasts(const Now& now) const;
    record::Drag drag(const Margin& normal_force, const Now& now, double lasted) const;
    const Eigen::MatrixXd& gramian(std::size_t channel);

    const ModalStructure& structure_;
    std::vector<ContactMode> set_;
    bool is_bounded_ = false;                   // there is a forced part, and e.P e does not grow
    Eigen::VectorXd square_;                    // [1/s²] ω²
    Eigen::MatrixXd damping_;                   // [1/s] C
    Eigen::VectorXd load_;                      // f
    Eigen::MatrixXd rows_;                      // R', constraints
    Eigen::VectorXd row_values_;                // of the closed gaps -g0, of the stuck contacts as they stand
    Eigen::MatrixXd free_;                      // Z, R'Z = 0
    Eigen::MatrixXd forceless_;                 // Y, Y'B = 0
    Eigen::FullPivLU<Eigen::MatrixXd> forced_;  // of [Y'ω²; R']
    Eigen::VectorXd drift_;                     // s, velocity of the forced part
    double velocity_ = 0.0;                     // [m/s] of the surface
    double rate_ = 1.0;                         // [1/s] makes positions comparable with velocities
    Eigen::MatrixXd generator_;                 // [1/s] A
    LastingBound<Eigen::MatrixXd> bound_;       // by e.P e
    std::vector<Margin> margins_;
    std::vector<Eigen::MatrixXd> gramians_;  // shape [channel], made when needed
};

}  // namespace stridor::integration
