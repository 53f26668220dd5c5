#pragma once

#include "stridor/integration/kernels/instruction_set.hpp"
#include "stridor/integration/kernels/lanes.hpp"
#include "stridor/integration/rules/contact_mode.hpp"

/// What the exact engine prepares once per structure, as plain arrays that every instruction set reads alike.
///
/// Within a contact state the motion is linear: with the state s in eight numbers, s' = A s and s(t) = exp(A t) s(0).
/// The load scale F and the drive travel in the state, so that A depends on neither preload nor velocity:
///
///     closed:  s = (x, y, x', y', F, V, W, 0)    V' = -omega W, W' = omega V (sinusoidal);  V' = W, W' = 0 (otherwise)
///     open:    s = (x, y, x', y', F, g, g', 0)    the drive does not act
///
/// (two degrees of freedom: without y). One step is h = 2/Omega, Omega an upper bound of the fastest rate of the flow,
/// so that sums over A^k h^k / k! converge to rounding within `terms`. A row is a linear functional of s.
namespace stridor::integration {

inline constexpr int terms = 24;  // of the series: 1/24! is far below rounding
inline constexpr int term_blocks = terms / lanes;
inline constexpr int most_tests = 2;  // event functions of a contact state
inline constexpr int most_coordinates = 3;
inline constexpr int most_bodies = 2;
inline constexpr int most_multiplicity = 3;  // of the root an event function begins with

/// No crossing within the step.
inline constexpr double no_crossing = 2.0;

/// y = sum over j of column[j] x[j].
struct alignas(64) Matrix8 {
    Lanes column[lanes];
};

/// Gauss' quadrature on [0, 1]: nodes and weights, exact for polynomials to degree 15.
struct Quadrature {
    Lanes node;    // [1]
    Lanes weight;  // [1]
};

/// A function that stays positive as long as the contact state lasts.
struct EventFunction {
    Lanes row;                    // its value
    Matrix8 series[term_blocks];  // its coefficients over tau = t/h, rows k = 0..terms-1
    Matrix8 bernstein;            // Bernstein coefficients of degree 7 over the step
};

/// One contact state, prepared.
struct Flow {
    ContactMode mode;
    int test_count;                                    // [1]
    int velocity_count;                                // [1] coordinates that move: all but g while closed
    double step;                                       // [s] h
    double surface_rate;                               // [rad/s] omega of a sinusoidal drive, else 0
    double basis[most_coordinates][most_coordinates];  // [1] u = B z
    Quadrature quadrature;                             // over [0, 1]
    EventFunction test[most_tests];                    // slip: N, sigma w; stick: mu_s N - T, mu_s N + T; open: g
    Matrix8 divided[most_multiplicity];  // `bernstein` of the last test without its root at tau = 0 of order 1, 2, 3
    Matrix8 power[terms];                // A^k h^k / k!
    Matrix8 advance;                     // exp(A h)
    Matrix8 velocity[most_coordinates];  // z' at the nodes
    Matrix8 velocity_series[most_coordinates][term_blocks];
    Matrix8 force;  // slip: N, stick: T, at the nodes
    Matrix8 force_series[term_blocks];
    Matrix8 surface;  // V at the nodes
    Matrix8 surface_series[term_blocks];
    Lanes normal_force;    // N as a row
    Lanes friction_force;  // T as a row
};

/// All that does not change between runs that differ in preload, velocity, start or duration only.
struct Flows {
    int dofs;                                            // [1]
    double basis[most_coordinates][most_coordinates];    // [1] u = B z, columns x, (y,) g
    double mass[most_coordinates];                       // [kg] of x, (y,) g
    double damping[most_coordinates][most_coordinates];  // [N*s/m]
    double tangent_on_gap;                               // [1]
    double slip_ratio[contact_modes];                    // [1] T/N while it slips; 0 in other states
    Flow flow[contact_modes];
};

/// Returns the body a degree of freedom belongs to: the rubbing one moves along and across the contact, with the first
/// two.
constexpr int body_of(int dof) {
    return dof < 2 ? 0 : dof - 1;
}

/// Positions of the numbers in a state with so many closed coordinates (dofs - 1).
constexpr int velocity_lane(int closed, int coordinate) {
    return closed + coordinate;
}
constexpr int load_lane(int closed) {
    return 2 * closed;
}
constexpr int surface_lane(int closed) {
    return 2 * closed + 1;
}
constexpr int gap_lane(int closed) {
    return 2 * closed + 1;
}

/// Integrals over nodes, not yet weighted: sums over steps of products of the velocities z' and of
/// powers at the contact.
struct alignas(64) Sums {
    Lanes product[6];         // [m^2/s^2] z'_j z'_k for (j, k) = (0,0), (0,1), (1,1), (0,2), (1,2), (2,2)
    Lanes on_slip;            // [N*m/s] slip: N w
    Lanes on_surface;         // [N*m/s] slip: N V; stick: T V
    Lanes peak[most_bodies];  // [m^2/s^2] largest squares of the velocity of each body (`body_of`)
};

/// Is a function known to be negative at the end of an interval?
enum class Falling { surely, perhaps };

/// The inner loops of the exact engine, compiled once per instruction set. All give the same bits: each number is
/// computed by the same additions and multiplications in the same order, only more of them at a time.
struct Kernel {
    /// Takes up to `steps` whole steps from s, as long as no event function comes near zero; returns their number.
    long (*glide)(const Flow& flow, Lanes& s, long steps, Sums& sums);

    /// Takes one whole step from s whatever the event functions say.
    void (*leap)(const Flow& flow, Lanes& s, Sums& sums);

    /// Computes Bernstein coefficients of the event functions over the step from s, without the root of the given
    /// multiplicity at the beginning of the last one. Returns a set of bits: those of the functions that may come near
    /// zero.
    unsigned (*look)(const Flow& flow, const Lanes& s, int multiplicity, Lanes* bernstein);

    /// Computes the columns of a matrix from coefficients of a series: column j is the sum over k of what[k]
    /// series[k].at[j].
    void (*combine)(const Lanes* what, const Lanes* series, int count, Matrix8& result);

    /// Returns the root of a series, its first `multiplicity` coefficients left out, in [from, to], where it falls;
    /// `no_crossing` if it is still positive at `to`. Newton's steps from `start`, halved where they leave the bracket.
    double (*root)(const Lanes* series, int multiplicity, double from, double to, double start, Falling falls);

    /// Computes exp(A h tau) s.
    void (*move)(const Flow& flow, const Lanes& s, double tau, Lanes& result);

    /// Computes y = blocks s: 8 numbers per block.
    void (*apply)(const Matrix8* blocks, int count, const Lanes& s, Lanes* result);

    /// Adds a part of a step, from tau_0 to tau_1, with the weights and lengths of the quadrature already in it.
    void (*add_part)(const Flow& flow, const Lanes& s, double tau_0, double tau_1, Sums& sums);
};

/// Returns the loops for a structure with so many degrees of freedom and a damped basis.
const Kernel& kernel(InstructionSet set, int dofs);

}  // namespace stridor::integration
