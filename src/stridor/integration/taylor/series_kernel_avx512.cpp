#include "stridor/integration/taylor/series_kernel.hpp"

#define STRIDOR_ISA avx512
#define STRIDOR_WIDTH 8
#include "stridor/integration/taylor/series_kernel.inl"
