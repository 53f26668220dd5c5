#include "stridor/integration/exact/kernel.hpp"

#define STRIDOR_ISA avx512
#define STRIDOR_WIDTH 8
#include "stridor/integration/exact/kernel.inl"
