#pragma once

#include "stridor/integration/kernels/series_kernel.hpp"
#include "stridor/integration/modal/modal_structure.hpp"
#include "stridor/integration/rules/contact_mode.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace stridor::integration {

/// Order of the series of a block: with h = 2/Omega the next term is 2^25/25! = 2e-18 of the first.
inline constexpr int block_order = 24;
using BlockSeries = std::array<double, block_order + 1>;

/// Values of a polynomial at several places at once.
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
class TaylorBlock {
public:
    TaylorBlock(const ModalStructure& structure, double step);

    double step() const { return step_; }  // [s] h

    /// Chooses what the contacts do. Returns false where R'B is singular: no forces belong to the set.
    bool choose(const ContactSet& set);

    /// Expands up to `order` from a state (shape [mode]); the surface's velocity belongs to the same instant.
    void expand(std::span<const double> q, std::span<const double> v, const SurfaceSeries& surface,
                int order = block_order);

    /// Coefficients of the closed contact's forces on the structure [N]; zero if it is open.
    const BlockSeries& normal_force(std::size_t contact) const { return normal_[contact]; }
    const BlockSeries& friction_force(std::size_t contact) const { return friction_[contact]; }

    /// Those of the gap [m] and of the slip velocity [m/s], by sums over the modes.
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

    /// State at a place in [0, 1]; shape [mode].
    void state_at(double theta, std::span<double> q, std::span<double> v) const;
    void acceleration_at(double theta, std::span<double> a) const;

    /// Velocities at several places at once, each computed as if it were alone; shape [place][mode].
    void velocities_at(const BlockPlaces& theta, std::vector<Lanes>& v) const;

    /// Last place up to which the series is exact to rounding: 1 but for sets near a Painleve configuration.
    double reach() const;

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

        std::size_t count() const { return normal.size() + tangent.size(); }
    };

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

    const ModalStructure& structure_;
    double step_;
    const SeriesKernel& kernel_;
    std::size_t modes_;
    std::size_t registers_;  // that hold the modes
    int order_ = 0;
    SurfaceSeries surface_{};
    std::map<std::vector<ContactMode>, Rows> prepared_{};
    const Rows* rows_ = nullptr;
    std::vector<Lanes> square_, damping_, load_;  // those of the structure
    std::vector<Lanes> q_, v_, force_;            // shapes [order + 2][mode], [order + 1][row]
    std::vector<Lanes> acceleration_, right_;     // of one coefficient
    mutable std::vector<Lanes> state_;            // q and v at a place
    std::vector<BlockSeries> normal_, friction_;
    // of this expansion, once they were asked for; empty: not yet
    mutable std::vector<double> acceleration_sizes_, constraint_sizes_;
};

}  // namespace stridor::integration
