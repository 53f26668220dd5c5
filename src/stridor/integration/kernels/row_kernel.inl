// The loops of row_kernel.hpp, part of kernels/loops.inl. Lanes are independent, so compilers make vectors
// of them without a change of bits.

namespace stridor::integration::STRIDOR_ISA {

namespace {

// so many blocks share one pass over the rows, and their sums do not wait for each other
constexpr std::size_t blocks_at_once = 4;

template <std::size_t count>
inline void add_products(const RowBlocks& rows, std::size_t block, const double* x, double* partial) {
    const double* numbers = rows.numbers + block * rows.rows * row_lanes;
    const double* with = x + block * row_lanes;
    for (const std::size_t row : rows.which) {
        double sum[row_lanes];
        for (std::size_t lane = 0; lane < row_lanes; ++lane)
            sum[lane] = partial[row * row_lanes + lane];
        for (std::size_t k = 0; k < count; ++k)
            for (std::size_t lane = 0; lane < row_lanes; ++lane)
                sum[lane] += numbers[(k * rows.rows + row) * row_lanes + lane] * with[k * row_lanes + lane];
        for (std::size_t lane = 0; lane < row_lanes; ++lane)
            partial[row * row_lanes + lane] = sum[lane];
    }
}

void multiply(const RowBlocks& rows, const double* x, double* partial) {
    for (const std::size_t row : rows.which)
        for (std::size_t lane = 0; lane < row_lanes; ++lane)
            partial[row * row_lanes + lane] = 0.0;
    std::size_t block = 0;
    for (; block + blocks_at_once <= rows.blocks; block += blocks_at_once)
        add_products<blocks_at_once>(rows, block, x, partial);
    for (; block < rows.blocks; ++block)
        add_products<1>(rows, block, x, partial);
}

template <std::size_t count>
inline void add_shares(const RowBlocks& rows, std::size_t block, const double* share, double* sum) {
    const double* numbers = rows.numbers + block * rows.rows * row_lanes;
    double total[count][row_lanes] = {};
    for (const std::size_t row : rows.which)
        for (std::size_t k = 0; k < count; ++k)
            for (std::size_t lane = 0; lane < row_lanes; ++lane)
                total[k][lane] += numbers[(k * rows.rows + row) * row_lanes + lane] * share[row];
    for (std::size_t k = 0; k < count; ++k)
        for (std::size_t lane = 0; lane < row_lanes; ++lane)
            sum[(block + k) * row_lanes + lane] = total[k][lane];
}

void combine(const RowBlocks& rows, const double* share, double* sum) {
    std::size_t block = 0;
    for (; block + blocks_at_once <= rows.blocks; block += blocks_at_once)
        add_shares<blocks_at_once>(rows, block, share, sum);
    for (; block < rows.blocks; ++block)
        add_shares<1>(rows, block, share, sum);
}

void subtract(const double* __restrict from, double share, double* __restrict to, std::size_t size) {
    for (std::size_t first = 0; first < size; first += row_lanes)
        for (std::size_t lane = 0; lane < row_lanes; ++lane)
            to[first + lane] -= share * from[first + lane];
}

}  // namespace

}  // namespace stridor::integration::STRIDOR_ISA
