#include "stridor/integration/kernels/loops.hpp"

#define STRIDOR_ISA avx512
#define STRIDOR_WIDTH 8
#include "stridor/integration/kernels/loops.inl"
