// What the lanes of a register should be: the eight numbers of one cell, or eight cells side by side?
//
// One step of the exact engine is s = exp(A h) s, seven columns of a matrix; its bounds and integrals are products
// of the same kind. Cells side by side take their matrix entries lane by lane from tables of their own, for they are
// in contact states of their own; only cells in the same state of the same structure could share them. Eight cells,
// one step each, AVX-512.

#include <benchmark/benchmark.h>

#include <cstdint>
#include <vector>

#if defined(__x86_64__)
#    include <immintrin.h>

namespace stridor {
namespace {

constexpr int cells = 8;
constexpr int numbers = 7;  // of a state; the eighth is unused

struct alignas(64) Matrix {
    double column[numbers][8];
};

// rotations of different pace: states stay of one size
std::vector<Matrix> tables() {
    std::vector<Matrix> result(cells);
    for (int cell = 0; cell < cells; ++cell)
        for (int j = 0; j < numbers; ++j)
            for (int i = 0; i < 8; ++i)
                result[static_cast<std::size_t>(cell)].column[j][i] = i == j ? 1.0 : 1e-9 * (cell + i - j);
    return result;
}

__attribute__((target("avx512f"))) void across_lanes(const Matrix* matrix, double (*state)[8]) {
    for (int cell = 0; cell < cells; ++cell) {
        const double* s = state[cell];
        __m512d sum = _mm512_setzero_pd();
        for (int j = 0; j < numbers; ++j)
            sum = _mm512_add_pd(sum, _mm512_mul_pd(_mm512_load_pd(matrix[cell].column[j]), _mm512_set1_pd(s[j])));
        _mm512_store_pd(state[cell], sum);
    }
}

__attribute__((target("avx512f"))) void side_by_side(const Matrix* matrix, double (*state)[8]) {
    constexpr long long size = sizeof(Matrix);
    const __m512i table = _mm512_set_epi64(7 * size, 6 * size, 5 * size, 4 * size, 3 * size, 2 * size, size, 0);
    __m512d next[numbers];
    for (int i = 0; i < numbers; ++i) {
        __m512d sum = _mm512_setzero_pd();
        for (int j = 0; j < numbers; ++j) {
            const __m512d entry = _mm512_mask_i64gather_pd(_mm512_setzero_pd(), 0xFF, table, &matrix->column[j][i], 1);
            sum = _mm512_add_pd(sum, _mm512_mul_pd(entry, _mm512_load_pd(state[j])));
        }
        next[i] = sum;
    }
    for (int i = 0; i < numbers; ++i)
        _mm512_store_pd(state[i], next[i]);
}

__attribute__((target("avx512f"))) void side_by_side_alike(const Matrix* matrix, double (*state)[8]) {
    __m512d next[numbers];
    for (int i = 0; i < numbers; ++i) {
        __m512d sum = _mm512_setzero_pd();
        for (int j = 0; j < numbers; ++j)
            sum = _mm512_add_pd(sum, _mm512_mul_pd(_mm512_set1_pd(matrix->column[j][i]), _mm512_load_pd(state[j])));
        next[i] = sum;
    }
    for (int i = 0; i < numbers; ++i)
        _mm512_store_pd(state[i], next[i]);
}

template <void (*step)(const Matrix*, double (*)[8])>
void lanes(benchmark::State& run) {
    if (!__builtin_cpu_supports("avx512f")) return run.SkipWithError("not on this machine");
    const std::vector<Matrix> matrices = tables();
    alignas(64) double state[8][8];
    for (auto& row : state)
        for (double& number : row)
            number = 1.0;
    for ([[maybe_unused]] const auto each : run) {
        step(matrices.data(), state);
        benchmark::ClobberMemory();
    }
    run.SetItemsProcessed(run.iterations() * cells);
}
BENCHMARK_TEMPLATE(lanes, across_lanes)->Name("one_cell_across_the_lanes");
BENCHMARK_TEMPLATE(lanes, side_by_side)->Name("cells_side_by_side_in_states_of_their_own");
BENCHMARK_TEMPLATE(lanes, side_by_side_alike)->Name("cells_side_by_side_in_one_state");

}  // namespace
}  // namespace stridor
#endif
