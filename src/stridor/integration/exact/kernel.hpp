#pragma once

#include "stridor/integration/exact/tables.hpp"
#include "stridor/integration/instruction_set.hpp"

namespace stridor::integration {

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

    /// Bernstein coefficients of the event functions over the step from s, without the root of the given multiplicity
    /// at the beginning of the last one. Returns a set of bits: those of the functions that may come near zero.
    unsigned (*look)(const Flow& flow, const Lanes& s, int multiplicity, Lanes* bernstein);

    /// The columns of a matrix from coefficients of a series: column j is the sum over k of what[k] series[k].at[j].
    void (*combine)(const Lanes* what, const Lanes* series, int count, Matrix8& result);

    /// The root of a series, its first `multiplicity` coefficients left out, in [from, to], where it falls;
    /// `no_crossing` if it is still positive at `to`. Newton's steps from `start`, halved where they leave the bracket.
    double (*root)(const Lanes* series, int multiplicity, double from, double to, double start, Falling falls);

    /// exp(A h tau) s.
    void (*move)(const Flow& flow, const Lanes& s, double tau, Lanes& result);

    /// y = blocks s: 8 numbers per block.
    void (*apply)(const Matrix8* blocks, int count, const Lanes& s, Lanes* result);

    /// Adds a part of a step, from tau_0 to tau_1, with the weights and lengths of the quadrature already in it.
    void (*add_part)(const Flow& flow, const Lanes& s, double tau_0, double tau_1, Sums& sums);
};

/// The loops for a structure with so many degrees of freedom and a damped basis.
const Kernel& kernel(InstructionSet set, int dofs);

}  // namespace stridor::integration
