#pragma once

#include "stridor/integration/kernels/exact_kernel.hpp"
#include "stridor/integration/kernels/row_kernel.hpp"
#include "stridor/integration/kernels/series_kernel.hpp"

namespace stridor::integration {

/// The inner loops of all engines for one instruction set.
struct Loops {
    Kernel exact_2, exact_3;  // of two and of three degrees of freedom
    RowKernel rows;
    SeriesKernel series;
};

}  // namespace stridor::integration
