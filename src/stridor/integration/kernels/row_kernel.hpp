#pragma once

#include "stridor/integration/kernels/instruction_set.hpp"

#include <cstddef>
#include <span>

namespace stridor::integration {

/// Modes that stand side by side in `ContactRows`: one register of AVX-512, two of AVX2, four of the baseline.
inline constexpr std::size_t row_lanes = 8;

/// Rows of contacts over blocks of `row_lanes` modes.
struct RowBlocks {
    const double* numbers;  // shape [block][row][lane]
    std::size_t rows;
    std::size_t blocks;
    std::span<const std::size_t> which;  // the rows that take part
};

/// The inner loops of Moreau's time stepping, compiled once per instruction set. All give the same bits: each number is
/// computed by the same additions and multiplications in the same order, only more of them at a time.
struct RowKernel {
    /// Computes partial[row][lane] = sum over blocks of numbers[block][row][lane] x[block][lane].
    void (*multiply)(const RowBlocks& rows, const double* x, double* partial);

    /// Computes sum[block][lane] = sum over rows of share[row] numbers[block][row][lane].
    void (*combine)(const RowBlocks& rows, const double* share, double* sum);

    /// Subtracts: to -= share from, shape [size], a multiple of `row_lanes`.
    void (*subtract)(const double* from, double share, double* to, std::size_t size);
};

/// Returns the loops for an instruction set of this machine.
const RowKernel& row_kernel(InstructionSet set);

}  // namespace stridor::integration
