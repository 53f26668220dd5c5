#include "stridor/integration/taylor/series_kernel.hpp"

#define STRIDOR_ISA baseline
#define STRIDOR_WIDTH 2
#include "stridor/integration/taylor/series_kernel.inl"
