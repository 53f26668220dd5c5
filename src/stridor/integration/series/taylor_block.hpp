#pragma once

#include "stridor/integration/kernels/series_kernel.hpp"
#include "stridor/integration/modal/modal_structure.hpp"
#include "stridor/integration/rules/contact_mode.hpp"
#include "stridor/integration/series/block_order.hpp"
#include "stridor/model/laws/friction_jet.hpp"
#include "stridor/model/laws/spring.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace stridor::integration {

using BlockSeries = std::array<double, block_order + 1>;

/// Above this share of the first a last term is not rounding.
inline constexpr double series_rounding = 1e-17;

/// Returns values of a polynomial at several places at once.
BlockPlaces values_of(std::span<const double> c, const BlockPlaces& x);

/// What each contact does, in the order of a `ModalStructure`.
using ContactSet = std::vector<ContactMode>;

/// The surface's velocity V(t) [m/s] over a block, in powers of theta = t/h.
using SurfaceSeries = std::array<double, block_order + 2>;

/// The motion of one set of contact states over one block of time [0, h], as power series in theta = t/h:
///
///     q_{m+1} = h/(m+1) v_m,  v_{m+1} = h/(m+1) (a_m + B lam_m),  lam_m = (R'B)^-1 (r_m - R' a_m)
///
/// with R = {n_i of the closed; t_i of the stuck}, B = {n_i + ratio_i t_i of the slipping, n_i of the stuck; t_i of
/// the stuck}, a the acceleration without contact forces, r = {0; V_i'}, lam = {N_i; T_i}.
///
/// Where a ratio changes with the slip velocity w_i, T_i = ratio_i(w_i) N_i is a product of series:
///
///     T_m = ratio_0 N_m + sum_{j=1..m} ratio_j N_{m-j}
///
/// ratio_m follows from w_0..w_m (model/laws/friction_jet), w_m from accelerations before m: so the sum is known
/// when N_m is sought, and joins a_m along t_i. B and (R'B)^-1 take the ratios of the block's beginning. The series
/// then ends where that of the ratio does: the block is shortened until its last terms are rounding.
///
/// A spring pushes with -F(e) along its direction. Each coefficient of F follows from e_0..e_m, so from q_0..q_m
/// (model/laws/spring.hpp), and joins a_m. Such a series ends where its last terms are rounding, too, and at
/// the corners of F.
///
/// A law with a friction state z has z_{m+1} = h/(m+1) z'_m, and z'_m follows from w and z up to m: ratio_m does, too.
class TaylorBlock {
public:
    /// `highest` [1]: no expansion goes beyond this order.
    TaylorBlock(const ModalStructure& structure, double step, int highest = block_order);

    double step() const { return step_; }      // [s] the longest block
    double length() const { return length_; }  // [s] h, of the block that was expanded

    /// Chooses what the contacts do. Returns false where R'B is singular: no forces belong to the set.
    bool choose(const ContactSet& set);

    /// Expands up to `order` from a state (shape [mode]) with friction states (shape [contact]); the surface's velocity
    /// belongs to the same instant and to a block of `step()`. Friction that changes with the slip velocity is always
    /// expanded up to the highest order.
    void expand(std::span<const double> q, std::span<const double> v, std::span<const double> friction_states,
                const SurfaceSeries& surface, int order = block_order);

    /// Returns the surface's velocity over the block that was expanded.
    const SurfaceSeries& surface() const { return surface_; }

    /// Returns coefficients of the closed contact's forces on the structure [N]; zero if it is open. That of friction
    /// is zero where it is a constant share of the other.
    const BlockSeries& normal_force(std::size_t contact) const { return normal_[contact]; }
    const BlockSeries& friction_force(std::size_t contact) const { return friction_[contact]; }

    /// Says whether the friction force of a closed contact is a series of its own, and no constant share of the normal
    /// force.
    bool expands_friction(std::size_t contact) const {
        return (*set_)[contact] == ContactMode::stick || !is_state_wise(structure_.contacts[contact].friction);
    }

    /// Returns those of the gap [m] and of the slip velocity [m/s], by sums over the modes.
    BlockSeries gap(std::size_t contact) const;
    BlockSeries slip_velocity(std::size_t contact) const;

    /// Returns the sum of the terms' sizes, which rounding works on: of the force, of the slip velocity.
    double force_scale(std::size_t contact) const;
    double velocity_scale(std::size_t contact) const;

    /// Returns the sum of the terms' sizes in the change of the slip velocity over a block [m/s]: of free motion, which
    /// is the same for every set, and of the whole.
    double free_change_scale(std::size_t contact) const;
    double velocity_change_scale(std::size_t contact) const;

    /// Returns the sum of the terms' sizes in the change of the gap over a block [m], contact forces included.
    double gap_change_scale(std::size_t contact) const;

    /// Computes the state at a place in [0, 1]; shape [mode].
    void state_at(double theta, std::span<double> q, std::span<double> v) const;
    void acceleration_at(double theta, std::span<double> a) const;

    /// Changes the friction states to those at a place in [0, 1]; shape [contact]. An open contact keeps its own.
    void move_friction_states(double theta, std::span<double> friction_states) const;

    /// Velocities at several places at once, each computed as if it were alone; shape [place][mode].
    void velocities_at(const BlockPlaces& theta, std::vector<Lanes>& v) const;

    /// Returns the last place up to which the series is exact to rounding: 1 but for sets near a Painleve
    /// configuration.
    double reach() const;

    /// Returns first place, up to `reach`, at which a slip velocity leaves the stretch of speeds that its friction was
    /// expanded for, or an elongation that of its spring; `reach` if none does.
    double stretch_end(double reach) const;

private:
    // what depends on the set alone
    struct Rows {
        bool is_singular = false;
        std::vector<std::size_t> normal;   // contact of each normal row
        std::vector<std::size_t> tangent;  // contact of each tangential row, behind them
        std::vector<Lanes> constraint;     // R', shape [row][mode]
        std::vector<Lanes> push;           // B', shape [row][mode]
        std::vector<Lanes> inverse;        // (R'B)^-1, shape [column][row]
        std::vector<double> drive;         // [1] share of the surface's velocity, shape [row]
        std::vector<Lanes> eliminated;     // of small structures (series_kernel.hpp), else empty
        std::vector<std::size_t> rubbed;   // normal rows of slips whose ratio changes with the slip velocity

        std::size_t count() const { return normal.size() + tangent.size(); }
    };

    // friction of a slip along the block
    struct Rubbing {
        std::size_t row = 0;  // its normal row
        std::size_t contact = 0;
        model::Slip way = model::Slip::forward;
        double sign = 1.0;        // of the slip velocity
        double state_sign = 1.0;  // of the friction state
        model::FrictionJet jet;
        model::SmoothStretch stretch{};
        double corner_rounding = 0.0;  // [m/s]
        double told_change = 0.0;      // [m/s] of the speed, for which the last terms say whether they have converged
        BlockSeries speed{};           // [m/s]
        BlockSeries ratio{};           // [1]
        BlockSeries state{};           // of friction, as the law has it
        BlockSeries known{};           // [N] of T, without what the normal force of the same power adds
    };

    // elongation of a spring along the block
    struct Stretching {
        BlockSeries elongation{};  // [m]
        BlockSeries force{};       // [N]
        model::SpringTerms terms{};
        double corner_rounding = 0.0;  // [m]
    };

    // does each coefficient add forces that follow from those before: of springs, of friction that changes?
    bool is_expanded_stepwise(const Rows& rows) const { return !rows.rubbed.empty() || !structure_.springs.empty(); }
    Rows prepare(const ContactSet& set) const;
    Rows listed(const ContactSet& set) const;
    Eigen::MatrixXd products(const ContactSet& set, const Rows& rows) const;
    std::vector<Lanes> eliminated(const Rows& rows, const Eigen::MatrixXd& inverse) const;
    std::span<const double> coefficient(const std::vector<Lanes>& series, int m) const {
        return {series[static_cast<std::size_t>(m) * registers_].at, modes_};
    }
    BlockSeries row_series(std::span<const double> row, const std::vector<Lanes>& series) const;
    const std::vector<double>& acceleration_sizes() const;
    const std::vector<double>& constraint_sizes() const;
    SeriesRoom room();
    SeriesProblem problem();
    void store_forces();
    double ratio_at(std::size_t contact, model::Slip way) const;
    Eigen::MatrixXd inverted(const ContactSet& set, Rows& rows) const;
    void expand_rubbing();
    void begin_rubbing();
    void begin_stretching();
    void stretch(std::size_t m, Lanes* acceleration);
    void rub(std::size_t m, Lanes* acceleration);
    double reached_share() const;
    void shorten(double share);

    const ModalStructure& structure_;
    double step_;
    double length_;
    const SeriesKernel& kernel_;
    std::size_t modes_;
    std::size_t registers_;  // that hold the modes
    int highest_;
    int order_ = 0;
    SurfaceSeries surface_{};
    std::map<std::vector<ContactMode>, Rows> prepared_{};
    const Rows* chosen_ = nullptr;     // what is prepared of the set
    const ContactSet* set_ = nullptr;  // its key
    Rows at_ratios_{};                 // the same with the ratios of the block's beginning
    const Rows* rows_ = nullptr;
    std::vector<Rubbing> rubbing_{};
    std::vector<Stretching> stretching_;          // shape [spring]
    std::vector<double> friction_states_;         // at the block's beginning, shape [contact]
    std::vector<Lanes> square_, damping_, load_;  // those of the structure
    std::vector<Lanes> q_, v_, force_;            // shapes [order + 2][mode], [order + 1][row]
    std::vector<Lanes> acceleration_, right_;     // of one coefficient
    mutable std::vector<Lanes> state_;            // q and v at a place
    std::vector<BlockSeries> normal_, friction_;
    // of this expansion, once they were asked for; empty: not yet
    mutable std::vector<double> acceleration_sizes_, constraint_sizes_;
};

}  // namespace stridor::integration
