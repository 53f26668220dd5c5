#include "stridor/integration/kernels/loops.hpp"

#define STRIDOR_ISA avx2
#define STRIDOR_WIDTH 4
#include "stridor/integration/kernels/loops.inl"
