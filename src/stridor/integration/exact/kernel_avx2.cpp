#include "stridor/integration/exact/kernel.hpp"

#define STRIDOR_ISA avx2
#define STRIDOR_WIDTH 4
#include "stridor/integration/exact/kernel.inl"
