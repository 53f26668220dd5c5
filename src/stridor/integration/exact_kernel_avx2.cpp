#include "stridor/integration/exact_kernel.hpp"

#define STRIDOR_ISA avx2
#include "stridor/integration/exact_kernel.inl"
