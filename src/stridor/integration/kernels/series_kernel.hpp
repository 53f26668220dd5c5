#pragma once

#include "stridor/integration/kernels/instruction_set.hpp"
#include "stridor/integration/kernels/lanes.hpp"

#include <array>
#include <cstddef>

namespace stridor::integration {

/// Places in a block that are looked at together.
inline constexpr std::size_t block_places = 8;
using BlockPlaces = std::array<double, block_places>;

/// The equations whose series is wanted. All modes are filled up with zeros to whole registers, and so are the rows of
/// `inverse`.
struct SeriesProblem {
    std::size_t modes;         // in registers
    std::size_t rows;          // constraints
    const Lanes* square;       // [rad²/s²] ω², shape [mode]
    const Lanes* damping;      // [1/s] shape [mode], or [mode][mode] by number and register
    std::size_t damped_modes;  // of the second shape; 0: it is the first
    const Lanes* load;         // [N/√kg] shape [mode]
    const Lanes* constraint;   // R', shape [row][mode]
    const Lanes* push;         // B', shape [row][mode]
    const Lanes* inverse;      // (R'B)^-1, shape [column][row]
    const double* drive;       // [1] share of the surface's velocity in each row, shape [row]
    const double* surface;     // [m/s] coefficients of V
    double step;               // [s] h
    // forces eliminated, where all modes and all rows are in one register each; else null: what each number of q and
    // of v, the surface's acceleration and the load add to {acceleration; forces}, shape [2 numbers + 2][2]
    const Lanes* eliminated = nullptr;
    std::size_t numbers = 0;  // modes
    // adds to the acceleration what the coefficients found so far tell of springs and of friction that changes
    // with the slip velocity; null where there is neither. The forces of this coefficient are not among them.
    void (*rub)(void* friction, std::size_t coefficient, Lanes* acceleration) = nullptr;
    void* friction = nullptr;
};

/// Where the coefficients go; the first ones of q and v are given.
struct SeriesRoom {
    Lanes* q;             // shape [order + 2][mode]
    Lanes* v;             // [1/s] likewise
    Lanes* force;         // [N] shape [order + 1][row]
    Lanes* acceleration;  // of one coefficient, shape [mode]
    Lanes* right;         // of one coefficient, shape [2][row]
};

/// The inner loops of a Taylor block, compiled once per instruction set. All give the same bits: each number is
/// computed by the same additions and multiplications in the same order, only more of them at a time.
struct SeriesKernel {
    /// Computes the coefficients up to `order`, as `TaylorBlock` has them.
    void (*expand)(const SeriesProblem& problem, int order, const SeriesRoom& room);

    /// Computes values[place][mode] of so many coefficients, shape [count][mode], at several places.
    void (*evaluate)(const Lanes* coefficients, std::size_t count, std::size_t modes, const BlockPlaces& places,
                     Lanes* values);

    /// Computes two series of so many coefficients at one place, shape [mode].
    void (*evaluate_state)(const Lanes* q, const Lanes* v, std::size_t count, std::size_t modes, double place,
                           Lanes* q_there, Lanes* v_there);
};

/// Returns the loops for an instruction set of this machine.
const SeriesKernel& series_kernel(InstructionSet set = widest_instruction_set());

}  // namespace stridor::integration
