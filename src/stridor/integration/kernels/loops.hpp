#pragma once

#include "stridor/integration/exact/kernel.hpp"
#include "stridor/integration/moreau/row_kernel.hpp"
#include "stridor/integration/taylor/series_kernel.hpp"

namespace stridor::integration {

/// The inner loops of all engines for one instruction set.
struct Loops {
    Kernel exact_2, exact_3;  // of two and of three degrees of freedom
    RowKernel rows;
    SeriesKernel series;
};

}  // namespace stridor::integration
