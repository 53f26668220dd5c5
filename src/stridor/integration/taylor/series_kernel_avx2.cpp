#include "stridor/integration/taylor/series_kernel.hpp"

#define STRIDOR_ISA avx2
#define STRIDOR_WIDTH 4
#include "stridor/integration/taylor/series_kernel.inl"
